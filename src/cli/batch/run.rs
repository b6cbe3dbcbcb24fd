//! A file of a batch, solved row by row and written in order.

use super::super::{args::Format, error::CliError, screen::Screen, sink::Sink, stop};
use super::filled::{Filled, Out};
use super::job::{FIRST_CHUNK, Job, LARGEST_CHUNK, report};
use super::layout::Layout;
use super::line::RowMessages;
use super::piece::SolverPool;
use assur_solve::measure::accuracy::AchievedAccuracy;
use assur_text::source::shown_in_line;
use indexmap::IndexMap;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
use std::time::{Duration, Instant};

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
        let idle = SolverPool::default();
        let places = self.layout.places(self.job);
        let key_places = self.key.and_then(|key| key.places(self.job));
        let name = &self.job.source.name;
        if let (Some(sink), Some(key), Some(turns)) = (key_out.as_mut(), self.key, self.job.turns()) {
            let placed = key_places.as_ref().map(|places| key.placed(&turns, places, name));
            sink.write(placed.as_ref().unwrap_or(&turns))?;
        }
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
                    (Some(places), Format::Csv) => self.layout.placed(&piece.out, places, name),
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
                self.report(piece.said, &mut tally, progress);
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
    fn report(&self, said: Vec<(usize, RowMessages)>, tally: &mut Tally, progress: &Progress) {
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
                progress.aside(|| report(&problems, source, self.screen));
            }
        }
    }
}

// How far a batch is: on a terminal, and only where it takes its time.

/// Before this nothing is shown.
const PATIENCE: Duration = Duration::from_secs(1);

/// A line on standard error that counts rows.
pub struct Progress {
    started: Instant,
    name: String,
    total: Option<u64>,
    terminal: bool,
    bar: Option<ProgressBar>,
}

impl Progress {
    /// Counts the rows of a file; `total` where that is known.
    pub fn new(name: &str, total: Option<usize>) -> Self {
        Self {
            started: Instant::now(),
            name: name.to_owned(),
            total: total.and_then(|n| u64::try_from(n).ok()),
            terminal: std::io::stderr().is_terminal(),
            bar: None,
        }
    }

    /// Says how many rows are done.
    pub fn rows(&mut self, done: usize) {
        if !self.terminal || self.started.elapsed() < PATIENCE {
            return;
        }
        let bar = self.bar.get_or_insert_with(|| bar(&self.name, self.total));
        bar.set_position(u64::try_from(done).unwrap_or(u64::MAX));
    }

    /// Calls `print`, which writes on standard error, without disturbing the line.
    pub fn aside(&self, print: impl FnOnce()) {
        match &self.bar {
            Some(bar) => bar.suspend(print),
            None => print(),
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

fn bar(name: &str, total: Option<u64>) -> ProgressBar {
    let (bar, template) = match total {
        Some(total) => (ProgressBar::new(total), "{msg}: {pos} of {len} rows {wide_bar} {eta}"),
        None => (ProgressBar::new_spinner(), "{msg}: {pos} rows, {per_sec}"),
    };
    bar.set_draw_target(ProgressDrawTarget::stderr());
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style);
    }
    bar.set_message(shown_in_line(name).into_owned());
    bar
}

// The outcomes of the rows, in one line.

/// The number of rows that are named; the others are counted.
const NAMED: usize = 12;

/// The stage of what is wrong with a line of a table.
const TABLE: &str = "mech::table::";

/// The kinds of outcomes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// The row has no answers, or not all.
    Failed,
    /// An expectation of the row is not met.
    Unmet,
    /// Something is to be said of the row.
    Warned,
}

#[derive(Clone, Debug, Default)]
struct Group {
    count: usize,
    first: Vec<usize>,
}

/// The outcomes of the rows.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    solved: usize,
    failed: usize,
    groups: IndexMap<(Kind, String), Group>,
    /// The accuracy that was wanted, and the greatest error of all rows.
    reached: Option<(f64, f64)>,
}

impl Tally {
    /// Counts a row with answers.
    pub const fn solved(&mut self) {
        self.solved += 1;
    }

    /// Counts a row without.
    pub fn failed_row(&mut self, row: usize, code: &str) {
        self.failed += 1;
        self.note(Kind::Failed, row, code);
    }

    /// Keeps the greatest error of all rows.
    pub fn reached(&mut self, row: &AchievedAccuracy) {
        let worst = self.reached.map_or(0.0, |r| r.1);
        self.reached = Some((row.within, row.error.max(worst)));
    }

    /// Notes what is to be said of a row. Returns how often it has been said.
    pub fn note(&mut self, kind: Kind, row: usize, code: &str) {
        // whatever is wrong with a line of a table, it cannot be read
        let code = if code.starts_with(TABLE) { TABLE } else { code };
        let group = self.groups.entry((kind, code.to_owned())).or_default();
        group.count += 1;
        if group.first.len() < NAMED {
            group.first.push(row);
        }
    }

    /// How often something has been said.
    pub fn said(&self, kind: Kind, code: &str) -> usize {
        let code = if code.starts_with(TABLE) { TABLE } else { code };
        self.groups.get(&(kind, code.to_owned())).map_or(0, |g| g.count)
    }

    pub const fn failed(&self) -> usize {
        self.failed
    }

    pub const fn rows(&self) -> usize {
        self.solved + self.failed
    }

    /// Adds the numbers of another file.
    pub const fn add(&mut self, other: &Self) {
        self.solved += other.solved;
        self.failed += other.failed;
    }

    /// `126 solved, 2 failed`
    pub fn in_short(&self) -> String {
        let failed = if self.failed > 0 { format!(", {} failed", self.failed) } else { String::new() };
        format!("{} solved{failed}", self.solved)
    }

    /// `126 solved, 2 do not close: rows 17, 90`
    pub fn summary(&self) -> String {
        let mut parts = vec![format!("{} solved", self.solved)];
        for kind in [Kind::Failed, Kind::Unmet, Kind::Warned] {
            for ((_, code), group) in self.groups.iter().filter(|((k, _), _)| *k == kind) {
                parts.push(group.words(kind, code));
            }
        }
        if let Some((within, worst)) = self.reached {
            parts.push(format!("within {within:.0e}: greatest error of all rows {worst:.0e}"));
        }
        parts.join(", ")
    }
}

impl Group {
    fn words(&self, kind: Kind, code: &str) -> String {
        let one = self.count == 1;
        let what = match (kind, code.strip_prefix("mech::").unwrap_or(code)) {
            (Kind::Failed, "assembly::does_not_close" | "assembly::not_found") => {
                if one {
                    "does not close".to_owned()
                } else {
                    "do not close".to_owned()
                }
            }
            (Kind::Failed, code) if code.starts_with("table::") => "cannot be read".to_owned(),
            (Kind::Failed, code) => format!("failed ({code})"),
            (Kind::Unmet, _) => "with expectations not met".to_owned(),
            (Kind::Warned, code) => format!("with a warning ({code})"),
        };
        let rows: Vec<String> = self.first.iter().map(ToString::to_string).collect();
        let more = self.count - self.first.len();
        let more = if more > 0 { format!(" and {more} more") } else { String::new() };
        format!("{} {what}: row{} {}{more}", self.count, if one { "" } else { "s" }, rows.join(", "))
    }
}
