//! Rows of variants that the command line names: of a table in a file of its own, or of the table in the problem.

use crate::cli::batch::open_table;
use crate::cli::error::CliError;
use crate::cli::files::unread_table;
use crate::exercise::table::{Fault, Lines, TableError};
use crate::pipeline::row_words;
use assur_check::{self as check, FileRow, Overrides};
use assur_syntax::document::Document;
use assur_text::diagnostic::{Problems, did_you_mean};
use assur_text::source::{Source, Span};
use std::sync::Arc;

/// Rows that are read at a time.
const CHUNK: usize = 1000;
/// Names of rows in a help.
const MOST: usize = 12;

/// Which rows are wanted.
#[derive(Clone, Copy, Debug)]
pub struct RowsWanted<'a> {
    /// The name of a table of its own.
    pub variants: Option<&'a str>,
    /// Names or numbers of rows.
    pub row: &'a [String],
    /// Without names all rows of the file's own table; else the file as written.
    pub all: bool,
}

/// What is taken of a file: it as written, or with a row of variants.
#[derive(Default)]
pub struct ChosenRow {
    /// The values from outside.
    pub overrides: Overrides,
    /// `row 3 (r = 120 mm)`; empty where no row is.
    pub words: String,
    /// Its name, or its number.
    pub name: String,
    /// Its place in the file's own table.
    span: Option<Span>,
    /// What was found on reading the file, where that ends with it.
    pub problems: Problems,
}

impl ChosenRow {
    /// The file as written, of which this was found on reading.
    pub fn as_written(overrides: Overrides, problems: Problems) -> Self {
        Self { overrides, problems, ..Self::default() }
    }

    /// What was found, with the row for which it holds.
    pub fn reported(&self, problems: Problems) -> Problems {
        if self.words.is_empty() { problems } else { problems.of_row(&self.words, self.span) }
    }
}

/// Why there are no rows.
pub enum Refused {
    /// What is wrong with a table, or with the file.
    Table(Source, Problems),
    Cli(CliError),
}

impl From<CliError> for Refused {
    fn from(error: CliError) -> Self {
        Self::Cli(error)
    }
}

impl From<Fault> for Refused {
    fn from((source, error): Fault) -> Self {
        Self::Table(source, Problems::of([*error]))
    }
}

/// What is taken of a document: the rows that are named, else all of a table in a file of its own, else it as written.
pub fn chosen_rows(
    wanted: RowsWanted<'_>,
    overrides: &Overrides,
    source: &Source,
    document: &Document,
) -> Result<Vec<ChosenRow>, Refused> {
    let all = wanted.all && check::table(document).is_some();
    let rows = match wanted.variants {
        Some(name) => of_table(name, document, overrides, source)?,
        None if wanted.row.is_empty() && !all => {
            return Ok(vec![ChosenRow::as_written(overrides.clone(), Problems::new())]);
        }
        None => own(document, overrides, source)?,
    };
    let chosen = if wanted.row.is_empty() { (0..rows.len()).collect() } else { chosen(wanted.row, &rows)? };
    let drawn = chosen.into_iter().map(|i| {
        let FileRow { row, label, span } = rows[i].clone();
        let words = row_words(i + 1, label.as_deref(), &row.words());
        let name = label.unwrap_or_else(|| (i + 1).to_string());
        let overrides = Overrides { values: overrides.values.clone(), row };
        let span = wanted.variants.is_none().then_some(span);
        ChosenRow { overrides, words, name, span, problems: Problems::new() }
    });
    Ok(drawn.collect())
}

/// The rows of the file's own table.
fn own(document: &Document, overrides: &Overrides, source: &Source) -> Result<Vec<FileRow>, Refused> {
    let table = check::table(document).ok_or_else(|| CliError::NoTable { name: source.name.clone() })?;
    let (columns, problems) = check::columns(document, overrides, table);
    let Some(columns) = columns else { return Err(refused(document, overrides, (source, source), problems)) };
    let rows = check::file_rows(table, &columns.into());
    if rows.is_empty() {
        let empty = TableError::Empty { what: "no rows", span: None };
        return Err(Refused::Table(source.clone(), Problems::of([empty])));
    }
    Ok(rows)
}

/// The rows of a table in a file of its own.
fn of_table(
    name: &str,
    document: &Document,
    overrides: &Overrides,
    source: &Source,
) -> Result<Vec<FileRow>, Refused> {
    let mut table = open_table(name)??;
    let (columns, problems) = check::columns(document, overrides, &table.columns);
    let Some(columns) = columns else {
        return Err(refused(document, overrides, (source, &table.header), problems));
    };
    let columns = Arc::from(columns);
    let (mut lines, mut rows) = (Lines::default(), Vec::new());
    loop {
        table.lines(CHUNK, &mut lines).map_err(|error| unread_table(name, &error))?;
        if lines.is_empty() {
            break;
        }
        for raw in (0..lines.len()).filter_map(|i| lines.get(i)) {
            let read = raw.read(name, &columns, table.separator)?;
            rows.push(FileRow { row: read.row, label: read.label, span: Span::new(0, 0) });
        }
    }
    table.without_rows().map_or(Ok(rows), |fault| Err(fault.into()))
}

/// Where the table is fine, the `given` that it replaces is not.
fn refused(
    document: &Document,
    overrides: &Overrides,
    (source, header): (&Source, &Source),
    problems: Problems,
) -> Refused {
    if problems.is_empty() {
        Refused::Table(source.clone(), check::check(document, overrides).1)
    } else {
        Refused::Table(header.clone(), problems)
    }
}

/// The rows of these names or numbers, each once.
fn chosen(names: &[String], rows: &[FileRow]) -> Result<Vec<usize>, CliError> {
    let mut chosen = Vec::new();
    for name in names {
        let labelled = rows.iter().position(|row| row.label.as_deref() == Some(name));
        let numbered = || name.parse::<usize>().ok()?.checked_sub(1).filter(|i| *i < rows.len());
        let found = labelled.or_else(numbered).ok_or_else(|| no_row(name, rows))?;
        if !chosen.contains(&found) {
            chosen.push(found);
        }
    }
    Ok(chosen)
}

fn no_row(name: &str, rows: &[FileRow]) -> CliError {
    let labels: Vec<&str> = rows.iter().filter_map(|row| row.label.as_deref()).collect();
    let numbers = format!("the rows are 1 to {}", rows.len());
    let help = match did_you_mean(name, labels.iter().copied()).first() {
        Some(near) => format!("did you mean `{near}`?"),
        None if labels.is_empty() => numbers,
        None => {
            let shown: Vec<String> = labels.iter().take(MOST).map(|label| format!("`{label}`")).collect();
            let more = if labels.len() > MOST { ", …" } else { "" };
            format!("{numbers}, with the names {}{more}", shown.join(", "))
        }
    };
    CliError::NoRow { name: name.to_owned(), help }
}
