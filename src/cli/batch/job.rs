//! One file of a batch with its rows.

use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};

use super::super::args::{Format, ending};
use super::super::error::CliError;
use super::super::files;
use super::super::reply::Status;
use super::super::screen::Screen;
use super::super::stop;
#[cfg(feature = "arrow")]
use super::columns;
use super::layout::{ERROR, EVENT};
use super::rows::{Chunk, Rows};
use crate::exercise::table::{Fault, Lines, Table};
use crate::front::{RowLayout, digits_count};
use crate::pipeline::{Compiled, VariantSolver};
use crate::report::csv::LINE_END;
use crate::report::rows::AnswerColumns;
use assur_check as check;
use assur_check::{ColumnUse, Overrides, RowColumn};
use assur_syntax as syntax;
use assur_syntax::document::Document;
use assur_text::diagnostic::Problems;
use assur_text::source::Source;

/// The first chunk of rows; it grows until a chunk takes its time.
pub const FIRST_CHUNK: usize = 256;
/// Rows in memory at the most, and lines of columns that are written at a time.
pub const LARGEST_CHUNK: usize = 8192;
/// A chunk shorter than this is made larger.
const SHORT: Duration = Duration::from_millis(40);
const BUFFER: usize = 1 << 17;

/// A file that could be read, with its rows.
#[derive(Debug)]
pub struct Job {
    pub source: Source,
    pub document: Arc<Document>,
    /// What replaces the values of all rows.
    pub overrides: Overrides,
    /// The accuracy that is wanted.
    within: Option<f64>,
    rows: Rows,
    pub(super) columns: Arc<[RowColumn]>,
    layout: RowLayout,
    /// There are answers to write: a row could be compiled.
    answered: bool,
    /// What lines of its rows leave out.
    pub left_out: Option<CliError>,
    /// The cells of a key that say of which angles whole turns count.
    turns: Option<String>,
    /// The digits of numbers count.
    pub(super) digits: bool,
}

type Csv = Table<files::TableReader>;
/// Processes a chunk of rows, with their total number if it is known; returns whether to continue.
pub type Work<'a> = dyn FnMut(&Chunk<'_>, Option<usize>) -> Result<bool, CliError> + 'a;

/// Opens a table and reads its header.
pub fn open_table(name: &str) -> Result<Result<Csv, Fault>, CliError> {
    let reader = files::table(name, BUFFER)?;
    Table::open(name, reader).map_err(|error| files::unread_table(name, &error))
}

/// Says what is wrong with one text.
pub fn report(problems: &Problems, source: &Source, screen: &Screen) {
    screen.complain(&screen.diagnostics(problems, source));
}

/// Says what is wrong with a table.
fn tell_fault((source, error): Fault, screen: &Screen) {
    let mut problems = Problems::new();
    problems.push(*error);
    report(&problems, &source, screen);
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
        report(&problems, &source, screen);
        if problems.has_errors() {
            return Ok(Err(Status::Wrong));
        }
        if !overrides.values.is_empty() {
            let (_, found) = check::check(&document, overrides);
            if Status::of(&found) == Status::Unusable {
                report(&found, &source, screen);
                return Ok(Err(Status::Unusable));
            }
        }
        let (rows, columns) = match table {
            Some(name) => match outer(&document, overrides, name, screen)? {
                Ok(found) => found,
                Err(fault) => {
                    tell_fault(fault, screen);
                    return Ok(Err(Status::Wrong));
                }
            },
            None => own(&source, &document, overrides, screen),
        };
        let overrides = overrides.clone();
        let Some(columns) = columns else {
            // where the table is fine, the `given` that it replaces is not
            report(&check::check(&document, &overrides).1, &source, screen);
            return Ok(Err(Status::Wrong));
        };
        let columns = Arc::from(columns);
        let (layout, answered, digits) = (RowLayout::default(), false, digits_count(&document));
        let (left_out, turns) = (None, None);
        let mut job = Self {
            source,
            document,
            overrides,
            within,
            rows,
            columns,
            layout,
            answered,
            left_out,
            turns,
            digits,
        };
        let (has_rows, first) = job.first_row()?;
        if !has_rows && let Some(fault) = job.without_rows()? {
            tell_fault(fault, screen);
            return Ok(Err(Status::Wrong));
        }
        if let Some(compiled) = first {
            (job.layout, job.answered) = (RowLayout::of(&compiled, false), true);
            job.left_out = CliError::left_out(&compiled.mechanism);
            job.turns = job.layout.answers.counted_turns(&compiled.mechanism);
        }
        Ok(Ok(job))
    }

    /// Whether there are rows, and the first that can be compiled.
    fn first_row(&self) -> Result<(bool, Option<Compiled>), CliError> {
        let mut family = self.family(None);
        let (mut has_rows, mut found) = (false, None);
        self.each_chunk(FIRST_CHUNK, None, &mut |chunk, _| {
            has_rows |= chunk.len() > 0;
            let inputs = (0..chunk.len()).filter_map(|i| chunk.get(i, (&self.columns, false), None).ok());
            found = inputs.filter_map(|i| family.compile(&i.row).0).next();
            Ok(found.is_none() && !stop::wanted())
        })?;
        Ok((has_rows, found))
    }

    /// Solves its rows one after another, for one format or for all.
    pub fn family(&self, format: Option<Format>) -> VariantSolver<'_> {
        let family =
            VariantSolver::new(&self.document, &self.overrides).within(self.within).watched(&goes_on);
        let all = matches!(format, None | Some(Format::Json | Format::Jsonl));
        if all { family } else { family.for_answers() }
    }

    /// Whether it follows a motion under loads.
    pub fn moves(&self) -> bool {
        self.layout.answers.moves()
    }

    /// The headers of its lines.
    pub fn headers(&self, key: bool) -> Vec<String> {
        let mut headers = vec!["row".to_owned()];
        headers.extend(self.label().map(|_| "variant".to_owned()));
        if !key {
            headers.extend(self.givens().map(|(_, column)| column.header()));
        }
        // an answer key is read by this name
        let pose = self.answers().filter(|_| !key).map_or("pose", AnswerColumns::pose_header);
        headers.push(pose.to_owned());
        let events = self.answers().is_some_and(|answers| !key && answers.names_events());
        headers.extend(events.then(|| EVENT.to_owned()));
        headers.extend(self.answers().into_iter().flat_map(|a| a.headers(key)));
        if !key {
            headers.push(ERROR.to_owned());
        }
        headers
    }

    /// The line of a key that says of which angles whole turns count; none where of none.
    pub fn turns(&self) -> Option<String> {
        let label = if self.label().is_some() { "," } else { "" };
        self.turns.as_ref().map(|cells| format!("turns,{label}{cells}{LINE_END}"))
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
    pub fn answers(&self) -> Option<&AnswerColumns> {
        self.answered.then_some(&self.layout.answers)
    }

    /// The columns of its answers; none where none of its rows has any.
    pub const fn layout(&self) -> &RowLayout {
        &self.layout
    }

    /// Calls `work` on its rows, chunk by chunk, until that says it is enough. Without a size of its own a chunk is as
    /// large as takes a while.
    pub fn each_chunk(
        &self,
        first: usize,
        fixed: Option<usize>,
        work: &mut Work<'_>,
    ) -> Result<(), CliError> {
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
            #[cfg(feature = "arrow")]
            Rows::Columns(name) => {
                let mut started = Instant::now();
                let next = |before: usize| {
                    if before > 0 {
                        size = grown(size, started.elapsed());
                    }
                    started = Instant::now();
                    size
                };
                columns::each_chunk(name, &self.columns, next, work)
            }
            Rows::Csv(name) => {
                // the header is known to be fine
                let Ok(mut table) = open_table(name)? else { return Ok(()) };
                let separator = table.separator;
                let mut lines = Lines::default();
                loop {
                    let started = Instant::now();
                    table.lines(size, &mut lines).map_err(|error| files::unread_table(name, &error))?;
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
            #[cfg(feature = "arrow")]
            Rows::Columns(name) => {
                let error = crate::exercise::table::TableError::Empty { what: "no rows", span: None };
                Ok(Some((Source::new(name.as_str(), ""), Box::new(error))))
            }
            _ => Ok(None),
        }
    }
}

/// The feature that a kind of files with columns takes.
const fn feature_of(ending: &str) -> Option<(&'static str, bool)> {
    match ending.as_bytes() {
        b"arrow" | b"arrows" | b"feather" => Some(("arrow", cfg!(feature = "arrow"))),
        b"parquet" => Some(("parquet", cfg!(feature = "parquet"))),
        _ => None,
    }
}

/// Whether a name is that of a file with columns.
pub fn has_columns(name: &str) -> bool {
    ending(name).and_then(feature_of).is_some()
}

/// That feature, where this build does not have it.
pub fn lacking(name: &str) -> Option<&'static str> {
    ending(name).and_then(feature_of).filter(|(_, has)| !has).map(|(feature, _)| feature)
}

/// Rows and their columns, where these fit.
type Found = (Rows, Option<Vec<RowColumn>>);

/// Those of a separate table.
fn outer(
    document: &Document,
    overrides: &Overrides,
    name: &str,
    screen: &Screen,
) -> Result<Result<Found, Fault>, CliError> {
    if let Some(feature) = lacking(name) {
        return Err(CliError::NoColumns { name: name.to_owned(), feature });
    }
    #[cfg(feature = "arrow")]
    if has_columns(name) {
        let reader = columns::open(name)?;
        return Ok(columns::header(document, name, &reader).and_then(|table| {
            let (columns, problems) = check::columns(document, overrides, &table.columns);
            report(&problems, &table.header, screen);
            let wrong = columns.as_ref().and_then(|c| columns::wrong_kind(&table.header, &reader, c));
            wrong.map_or_else(|| Ok((Rows::Columns(name.to_owned()), columns)), Err)
        }));
    }
    if Path::new(name).exists() && !Path::new(name).is_file() {
        return Err(CliError::ReadTwice { name: name.to_owned() });
    }
    Ok(open_table(name)?.map(|table| {
        let (columns, problems) = check::columns(document, overrides, &table.columns);
        report(&problems, &table.header, screen);
        (Rows::Csv(name.to_owned()), columns)
    }))
}

/// Those of a file itself.
fn own(source: &Source, document: &Document, overrides: &Overrides, screen: &Screen) -> Found {
    let Some(table) = check::table(document) else { return (Rows::One, Some(Vec::new())) };
    let (columns, problems) = check::columns(document, overrides, table);
    report(&problems, source, screen);
    let columns: Option<Arc<[RowColumn]>> = columns.map(Arc::from);
    let rows = columns.as_ref().map(|c| check::file_rows(table, c)).unwrap_or_default();
    (Rows::Own(rows), columns.map(|c| c.to_vec()))
}

/// A motion goes on until a signal comes.
fn goes_on(_: f64, _: f64) -> bool {
    !stop::wanted()
}
