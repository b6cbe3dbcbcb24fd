//! One file of a batch with its rows.

use std::fs::File;
use std::io::BufReader;
use std::sync::Arc;
use std::time::{Duration, Instant};

use super::super::args::Format;
use super::super::error::CliError;
use super::super::reply::Status;
use super::super::screen::Screen;
use super::idle::Idle;
use super::layout::{ERROR, EVENT, Layout};
use super::line::Said;
use super::progress::Progress;
use super::rows::{Chunk, Rows};
use super::sink::Sink;
use super::stop;
use super::tally::{Kind, Tally};
use crate::exercise::table::{Fault, Lines, Table};
use crate::pipeline::VariantSolver;
use crate::report::rows::AnswerColumns;
use assur_check as check;
use assur_check::{ColumnUse, Overrides, RowColumn};
use assur_syntax as syntax;
use assur_syntax::document::Document;
use assur_text::diagnostic::Problems;
use assur_text::source::Source;

/// The first chunk of rows; it grows until a chunk takes its time.
const FIRST_CHUNK: usize = 256;
/// The same of motions under loads.
const FIRST_MOTIONS: usize = 16;
/// Rows in memory at the most.
const LARGEST_CHUNK: usize = 8192;
/// A chunk shorter than this is made larger.
const SHORT: Duration = Duration::from_millis(40);
/// Rows of one table to read.
const TABLE_CHUNK: usize = 1000;
/// The number of rows that are explained of those that fail for one reason; the others are named.
const EXPLAINED: usize = 3;
const BUFFER: usize = 1 << 17;

/// A file that could be read, with its rows.
#[derive(Debug)]
pub struct Job {
    /// Its text.
    pub source: Source,
    /// Its contents.
    pub document: Arc<Document>,
    /// What replaces the values of all rows.
    pub overrides: Overrides,
    /// The accuracy that is wanted.
    within: Option<f64>,
    rows: Rows,
    pub(super) columns: Arc<[RowColumn]>,
    answers: Option<AnswerColumns>,
}

type Csv = Table<BufReader<File>>;
/// Processes a chunk of rows, with their total number if it is known; returns whether to continue.
type Work<'a> = dyn FnMut(&Chunk<'_>, Option<usize>) -> Result<bool, CliError> + 'a;

/// Opens a table and reads its header.
pub fn open_table(name: &str) -> Result<Result<Csv, Fault>, CliError> {
    let fail = |error: std::io::Error| match error.kind() {
        std::io::ErrorKind::NotFound => CliError::Missing { name: name.to_owned() },
        _ => CliError::Unreadable { name: name.to_owned(), why: error.to_string() },
    };
    let file = File::open(name).map_err(fail)?;
    Table::open(name, BufReader::with_capacity(BUFFER, file)).map_err(fail)
}

/// Says what is wrong with one text.
fn tell(problems: &Problems, source: &Source, screen: &Screen) {
    screen.complain(&screen.diagnostics(problems, source));
}

fn tell_fault((source, error): Fault, screen: &Screen) {
    let mut problems = Problems::new();
    problems.push(*error);
    tell(&problems, &source, screen);
}

impl Job {
    /// Reads a file and the header of its table; a status if either has an error, or a value of `--set`, which is
    /// reported.
    pub fn new(
        source: Source,
        overrides: &Overrides,
        table: Option<&str>,
        within: Option<f64>,
        screen: &Screen,
    ) -> Result<Result<Self, Status>, CliError> {
        let (document, problems) = syntax::parse(&source);
        let document = Arc::new(document);
        tell(&problems, &source, screen);
        if problems.has_errors() {
            return Ok(Err(Status::Wrong));
        }
        if !overrides.values.is_empty() {
            let (_, found) = check::check(&document, overrides);
            if Status::of(&found) == Status::Unusable {
                tell(&found, &source, screen);
                return Ok(Err(Status::Unusable));
            }
        }
        let (rows, columns) = match table {
            Some(name) => match open_table(name)? {
                Ok(table) => {
                    let (columns, problems) = check::columns(&document, overrides, &table.columns);
                    tell(&problems, &table.header, screen);
                    (Rows::Csv(name.to_owned()), columns)
                }
                Err(fault) => {
                    tell_fault(fault, screen);
                    return Ok(Err(Status::Wrong));
                }
            },
            None => match check::table(&document) {
                Some(table) => {
                    let (columns, problems) = check::columns(&document, overrides, table);
                    tell(&problems, &source, screen);
                    let columns: Option<Arc<[RowColumn]>> = columns.map(Arc::from);
                    let rows = columns.as_ref().map(|c| check::file_rows(table, c)).unwrap_or_default();
                    (Rows::Own(rows), columns.map(|c| c.to_vec()))
                }
                None => (Rows::One, Some(Vec::new())),
            },
        };
        let overrides = overrides.clone();
        let Some(columns) = columns else {
            // where the table is fine, the `given` that it replaces is not
            tell(&check::check(&document, &overrides).1, &source, screen);
            return Ok(Err(Status::Wrong));
        };
        let columns = Arc::from(columns);
        let mut job = Self { source, document, overrides, within, rows, columns, answers: None };
        job.answers = job.first_answers()?;
        Ok(Ok(job))
    }

    /// The columns of the first row that has some.
    fn first_answers(&self) -> Result<Option<AnswerColumns>, CliError> {
        let mut family = self.family();
        let mut found = None;
        self.each_chunk(FIRST_CHUNK, None, &mut |chunk, _| {
            let inputs = (0..chunk.len()).filter_map(|i| chunk.get(i, &self.columns, None).ok());
            found =
                inputs.filter_map(|i| family.compile(&i.row).0).map(|c| AnswerColumns::of(&c.model())).next();
            Ok(found.is_none() && !stop::wanted())
        })?;
        Ok(found)
    }

    /// Solves its rows one after another.
    pub fn family(&self) -> VariantSolver<'_> {
        VariantSolver::new(&self.document, &self.overrides).within(self.within).watched(&goes_on)
    }

    /// Whether it follows a motion under loads.
    pub fn moves(&self) -> bool {
        self.answers.as_ref().is_some_and(AnswerColumns::moves)
    }

    /// The headers of its lines.
    pub fn headers(&self, key: bool) -> Vec<String> {
        let mut headers = vec!["row".to_owned()];
        headers.extend(self.label().map(|_| "variant".to_owned()));
        if !key {
            headers.extend(self.givens().map(|(_, column)| column.header()));
        }
        // an answer key is read by this name
        let pose = self.answers.as_ref().filter(|_| !key).map_or("pose", AnswerColumns::pose_header);
        headers.push(pose.to_owned());
        let events = self.answers.as_ref().is_some_and(|answers| !key && answers.names_events());
        headers.extend(events.then(|| EVENT.to_owned()));
        headers.extend(self.answers.iter().flat_map(|a| a.headers(key)));
        if !key {
            headers.push(ERROR.to_owned());
        }
        headers
    }

    /// The columns of the table that are shown next to the answers.
    pub fn givens(&self) -> impl Iterator<Item = (usize, &RowColumn)> {
        self.columns.iter().enumerate().filter(|(_, c)| c.what == ColumnUse::Given)
    }

    /// The column that names the rows.
    pub fn label(&self) -> Option<usize> {
        self.columns.iter().position(|c| c.what == ColumnUse::Label)
    }

    /// The columns of its answers, where one of its rows has any.
    pub const fn answers(&self) -> Option<&AnswerColumns> {
        self.answers.as_ref()
    }

    /// Calls `work` on its rows, chunk by chunk, until that says it is enough. Without a size of its own a chunk is as
    /// large as takes a while.
    fn each_chunk(&self, first: usize, fixed: Option<usize>, work: &mut Work<'_>) -> Result<(), CliError> {
        let mut size = fixed.unwrap_or(first);
        let grown = |size: usize, taken: Duration| {
            if fixed.is_none() && taken < SHORT { (2 * size).min(LARGEST_CHUNK) } else { size }
        };
        match &self.rows {
            Rows::One => work(&Chunk::One, Some(1)).map(drop),
            Rows::Own(rows) => {
                let mut before = 0;
                while before < rows.len() {
                    let started = Instant::now();
                    let end = (before + size).min(rows.len());
                    if !work(&Chunk::Own { rows: &rows[before..end], before }, Some(rows.len()))? {
                        break;
                    }
                    before = end;
                    size = grown(size, started.elapsed());
                }
                Ok(())
            }
            Rows::Csv(name) => {
                // the header is known to be fine
                let Ok(mut table) = open_table(name)? else { return Ok(()) };
                let separator = table.separator;
                let mut lines = Lines::default();
                loop {
                    let started = Instant::now();
                    let why =
                        |e: std::io::Error| CliError::Unreadable { name: name.clone(), why: e.to_string() };
                    table.lines(size, &mut lines).map_err(why)?;
                    if lines.is_empty() {
                        return Ok(());
                    }
                    let chunk = Chunk::Csv { lines, table: name, separator };
                    let more = work(&chunk, None)?;
                    let Chunk::Csv { lines: read, .. } = chunk else { return Ok(()) };
                    lines = read;
                    if !more {
                        return Ok(());
                    }
                    size = grown(size, started.elapsed());
                }
            }
        }
    }

    /// What is wrong with a table without rows.
    fn without_rows(&self) -> Result<Option<Fault>, CliError> {
        match &self.rows {
            Rows::Csv(name) => Ok(open_table(name)?.ok().and_then(|table| table.without_rows())),
            Rows::Own(rows) if rows.is_empty() => {
                let error = crate::exercise::table::TableError::Empty { what: "no rows", span: None };
                Ok(Some((self.source.clone(), Box::new(error))))
            }
            _ => Ok(None),
        }
    }
}

/// A motion goes on until a signal comes.
fn goes_on(_: f64, _: f64) -> bool {
    !stop::wanted()
}

/// A job and what to write of it.
pub struct Run<'a> {
    /// The job.
    pub job: &'a Job,
    /// How.
    pub format: Format,
    /// The columns of the answers.
    pub layout: &'a Layout,
    /// Those of the key, where one is wanted.
    pub key: Option<&'a Layout>,
    /// Where diagnostics go.
    pub screen: &'a Screen,
}

impl<'r> Run<'r> {
    /// Solves all rows in parallel and writes them in order.
    pub fn all(&self, out: &mut Sink, key_out: &mut Option<Sink>) -> Result<Tally, CliError> {
        let mut tally = Tally::default();
        let mut progress = None;
        let idle = Idle::default();
        let places = self.layout.places(self.job);
        let key_places = self.key.and_then(|key| key.places(self.job));
        let name = &self.job.source.name;
        let fixed = self.format.is_read().then_some(TABLE_CHUNK);
        let first = if self.job.moves() { FIRST_MOTIONS } else { FIRST_CHUNK };
        self.job.each_chunk(first, fixed, &mut |chunk, total| {
            let progress = progress.get_or_insert_with(|| Progress::new(name, total));
            let mut shown = String::new();
            let mut whole = true;
            for piece in self.chunk(chunk, &idle) {
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
