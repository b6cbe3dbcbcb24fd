//! The first line of a table: names with units.

use super::line::{Cell, Separator, cells};
use super::{Columns, TableError};
use assur_syntax::document::{Column, Name};
use assur_text::source::{Span, Spanned};
use assur_text::units::lookup;
use unicode_normalization::UnicodeNormalization;

/// What is wrong where the header separates its cells otherwise than the first row.
pub(super) fn separators(header: &str, separator: Separator, first: &str) -> Option<TableError> {
    let count = |text: &str, separator| cells(text, separator).map_or(0, |cells| cells.len());
    let columns = count(header, separator);
    let fits = |other: &Separator| *other != separator && count(first, *other) == columns;
    let of_row = [Separator::Semicolon, Separator::Tab, Separator::Comma].into_iter().find(fits)?;
    if columns < 2 || count(first, separator) != 1 {
        return None;
    }
    let why = format!(
        "its cells are separated by {}, but those of the rows by {}",
        separator.plural(),
        of_row.plural()
    );
    let names = cells(header, separator).ok()?;
    let names = names.iter().map(|cell| cell.text.as_ref()).collect::<Vec<_>>();
    let help = format!("write: {}", names.join(of_row.text()));
    Some(TableError::Header { why, help, span: Span::new(0, header.len()) })
}

/// The columns of a header; `read` is its line, or what is wrong with it.
pub(super) fn columns(
    text: &str,
    separator: Separator,
    read: Result<&str, (&str, &str)>,
) -> Result<Columns, TableError> {
    let whole = Span::new(0, text.len());
    let wrong = |why: &str, help: &str, span| {
        Err(TableError::Header { why: why.to_owned(), help: help.to_owned(), span })
    };
    if let Err((why, help)) = read {
        return wrong(why, help, whole);
    }
    if text.contains('\r') {
        return wrong(
            "its lines end in lone carriage returns",
            "save the file with line ends LF or CR LF",
            whole,
        );
    }
    let Ok(cells) = cells(text, separator) else {
        return wrong("a quote is not closed", "write names without quotes: `r [mm], n [rpm]`", whole);
    };
    if cells.iter().all(|cell| cell.text.replace(',', ".").parse::<f64>().is_ok()) {
        let help = "add a line above it that names the columns, as in `r [mm], n [rpm]`";
        return wrong("the first line must name the columns, but contains numbers", help, whole);
    }
    Ok(cells.iter().map(|cell| column(text, cell)).collect())
}

/// `r (mm)`
fn in_parentheses(text: &str) -> bool {
    let unit = text.strip_suffix(')').and_then(|text| text.split_once('('));
    unit.is_some_and(|(name, unit)| !name.trim().is_empty() && lookup(unit.trim()).is_ok())
}

/// `r [mm]`
fn column(line: &str, cell: &Cell<'_>) -> Result<Column, TableError> {
    let text = cell.text.as_ref();
    if in_parentheses(text) {
        let why = format!("the unit of `{text}` is in parentheses");
        let help = format!("write: {}", line.replace('(', "[").replace(')', "]"));
        return Err(TableError::Header { why, help, span: cell.span });
    }
    let wrong = |why: String| {
        let help = "write a name with its unit in brackets, as in `r [mm]`".to_owned();
        Err(TableError::Header { why, help, span: cell.span })
    };
    let (name, unit) = match text.split_once('[') {
        Some((name, rest)) => match rest.trim_end().strip_suffix(']') {
            Some(unit) if !unit.trim().is_empty() => (name.trim(), Some(unit.trim())),
            _ => return wrong(format!("the bracket of `{text}` is not closed, or empty")),
        },
        None => (text, None),
    };
    if name.is_empty() {
        return wrong("a name is missing".to_owned());
    }
    // places within a cell are those of the words as they stand in the line
    let place = |word: &str, from: usize| {
        let at = line[from..cell.span.end]
            .find(word)
            .map_or(cell.span, |i| Span::new(from + i, from + i + word.len()));
        (at, at.end)
    };
    let (at, end) = place(name, cell.span.start);
    let name = Name::new(name.nfc().collect(), at);
    Ok(Column { name, unit: unit.map(|unit| Spanned::new(unit.to_owned(), place(unit, end).0)) })
}
