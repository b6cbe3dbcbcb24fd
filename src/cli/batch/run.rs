//! A file of a batch, solved row by row and written in order.

use super::super::args::Format;
use super::super::error::CliError;
use super::super::screen::Screen;
use super::super::sink::Sink;
use super::filled::Filled;
use super::idle::Idle;
use super::job::{FIRST_CHUNK, Job, LARGEST_CHUNK, tell, tell_fault};
use super::layout::Layout;
use super::line::Said;
use super::out::Out;
use super::progress::Progress;
use super::stop;
use super::tally::{Kind, Tally};

/// The first chunk of motions under loads.
const FIRST_MOTIONS: usize = 16;
/// Rows of one table to read.
const TABLE_CHUNK: usize = 1000;
/// The number of rows that are explained of those that fail for one reason; the others are named.
const EXPLAINED: usize = 3;

/// A job and what to write of it.
pub struct Run<'a> {
    pub job: &'a Job,
    pub format: Format,
    /// The columns of the answers.
    pub layout: &'a Layout,
    /// Those of the key, where one is wanted.
    pub key: Option<&'a Layout>,
    /// Answers are written as columns.
    pub columns: bool,
    pub screen: &'a Screen,
}

impl<'r> Run<'r> {
    /// Solves all rows in parallel and writes them in order.
    pub fn all(&self, out: &mut Out, key_out: &mut Option<Sink>) -> Result<Tally, CliError> {
        let mut tally = Tally::default();
        let mut progress = None;
        let idle = Idle::default();
        let places = self.layout.places(self.job);
        let key_places = self.key.and_then(|key| key.places(self.job));
        let name = &self.job.source.name;
        let (first, fixed) = self.chunk_sizes();
        self.job.each_chunk(first, fixed, &mut |chunk, total| {
            let progress = progress.get_or_insert_with(|| Progress::new(name, total));
            let mut shown = String::new();
            let mut filled = self.columns.then(|| Filled::of(self.job));
            let mut whole = true;
            for piece in self.chunk(chunk, &idle) {
                if let (Some(all), Some(piece)) = (&mut filled, piece.filled) {
                    all.append(piece);
                }
                let lines = match (&places, self.format) {
                    (Some(places), format) if format.is_read() || format == Format::Csv => {
                        self.layout.placed(&piece.out, places, name)
                    }
                    _ => piece.out,
                };
                if self.format.is_read() {
                    shown += &lines;
                } else {
                    out.write(&lines)?;
                }
                if let (Some(sink), Some(key)) = (key_out.as_mut(), self.key) {
                    let key_lines = key_places.as_ref().map(|places| key.placed(&piece.key, places, name));
                    sink.write(key_lines.as_ref().unwrap_or(&piece.key))?;
                }
                self.tell(piece.said, &mut tally, progress);
                if !piece.whole {
                    whole = false;
                    break;
                }
            }
            if let Some(filled) = filled {
                out.fill(filled)?;
            }
            if self.format.is_read() {
                out.write(self.layout.table(&shown, name, self.format.page(self.screen.look())))?;
            }
            progress.rows(tally.rows());
            Ok(whole && !out.closed() && !stop::wanted())
        })?;
        if tally.rows() == 0
            && !stop::wanted()
            && let Some(fault) = self.job.without_rows()?
        {
            tell_fault(fault, self.screen);
            tally.failed_row(0, "mech::table::empty");
        }
        Ok(tally)
    }

    /// The first chunk of rows, and what each of them has where it must not depend on time: a table to read, or one batch of columns.
    fn chunk_sizes(&self) -> (usize, Option<usize>) {
        match (self.job.moves(), self.columns) {
            (_, false) if self.format.is_read() => (TABLE_CHUNK, Some(TABLE_CHUNK)),
            (true, true) => (FIRST_CHUNK, Some(FIRST_CHUNK)),
            (false, true) => (LARGEST_CHUNK, Some(LARGEST_CHUNK)),
            (true, false) => (FIRST_MOTIONS, None),
            (false, false) => (FIRST_CHUNK, None),
        }
    }

    /// Counts rows; explains the first that fail for a reason.
    fn tell(&self, said: Vec<(usize, Said)>, tally: &mut Tally, progress: &Progress) {
        for (number, said) in said {
            said.reached.iter().for_each(|reached| tally.reached(reached));
            if said.is_nothing() {
                tally.solved();
                continue;
            }
            let fails = said.failed.is_some();
            let failed = said.failed.iter().map(|code| (Kind::Failed, code.clone()));
            let all = failed.chain(said.unmet.then(|| (Kind::Unmet, String::new())));
            let all: Vec<_> = all.chain(said.warned.into_iter().map(|code| (Kind::Warned, code))).collect();
            let explain =
                all.iter().any(|(kind, code)| *kind != Kind::Unmet && tally.said(*kind, code) < EXPLAINED);
            match &said.failed {
                Some(code) => tally.failed_row(number, code),
                None => tally.solved(),
            }
            for (kind, code) in all.iter().skip(usize::from(fails)) {
                tally.note(*kind, number, code);
            }
            if let (true, Some((source, problems))) = (explain, said.problems) {
                let source = source.as_ref().unwrap_or(&self.job.source);
                progress.aside(|| tell(&problems, source, self.screen));
            }
        }
    }
}
