//! A line of comma-separated values, RFC 4180. Lines within quotes are joined before, where the quotes close soon: a quote too
//! much spoils one line and no more.

use super::{Columns, TableError};
use assur_syntax::document::{Column, Name};
use assur_text::source::{Span, Spanned, shown};
use assur_text::units::lookup;
use std::borrow::Cow;
use unicode_normalization::UnicodeNormalization;

/// What separates cells, found in the header.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Separator {
    /// `,`: numbers have a decimal point.
    Comma,
    /// `;`, as spreadsheets write where the comma is the decimal sign: numbers may have either.
    Semicolon,
    /// A tabulator: the same.
    Tab,
}

impl Separator {
    /// That of a header: a semicolon or a tabulator where there is one outside quotes.
    #[must_use]
    pub fn of(header: &str) -> Self {
        let mut quoted = false;
        for c in header.chars() {
            match c {
                '"' => quoted = !quoted,
                ';' if !quoted => return Self::Semicolon,
                '\t' if !quoted => return Self::Tab,
                _ => {}
            }
        }
        Self::Comma
    }

    const fn sign(self) -> u8 {
        self.text().as_bytes()[0]
    }

    /// The sign, as a text.
    pub(super) const fn text(self) -> &'static str {
        match self {
            Self::Comma => ",",
            Self::Semicolon => ";",
            Self::Tab => "\t",
        }
    }

    /// Several of it, in words.
    pub(super) const fn plural(self) -> &'static str {
        match self {
            Self::Comma => "commas",
            Self::Semicolon => "semicolons",
            Self::Tab => "tabulators",
        }
    }
}

/// A cell: its text without quotes and blanks around it, and its place in the line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cell<'a> {
    pub text: Cow<'a, str>,
    pub span: Span,
}

/// The cells of a line; an error is the place of a quote that is not closed.
///
/// # Errors
/// The place of a quote that is not closed, or with something other than a separator after it.
pub fn cells(line: &str, separator: Separator) -> Result<Vec<Cell<'_>>, Span> {
    let mut cells = Vec::with_capacity(8);
    cells_in(line, separator, &mut cells).map(|()| cells)
}

/// As [`cells`], in the memory of a list.
pub(super) fn cells_in<'l>(
    line: &'l str,
    separator: Separator,
    cells: &mut Vec<Cell<'l>>,
) -> Result<(), Span> {
    cells.clear();
    let mut start = 0;
    loop {
        let (cell, next) = cell(line, start, separator.sign())?;
        cells.push(cell);
        match next {
            Some(next) => start = next,
            None => return Ok(()),
        }
    }
}

/// The cell that begins here, and where the next one does.
fn cell(line: &str, start: usize, sign: u8) -> Result<(Cell<'_>, Option<usize>), Span> {
    let bytes = line.as_bytes();
    let quote = start + bytes[start..].iter().take_while(|b| **b == b' ').count();
    if bytes.get(quote) == Some(&b'"') {
        return quoted(line, quote, sign);
    }
    let end = bytes[start..].iter().position(|b| *b == sign).map_or(line.len(), |i| start + i);
    let text = line[start..end].trim();
    let from = start + (line[start..end].len() - line[start..end].trim_start().len());
    let cell = Cell { text: Cow::Borrowed(text), span: Span::new(from, from + text.len()) };
    Ok((cell, (end < line.len()).then_some(end + 1)))
}

fn quoted(line: &str, quote: usize, sign: u8) -> Result<(Cell<'_>, Option<usize>), Span> {
    let unclosed = Span::new(quote, line.len());
    let mut text = String::new();
    let mut rest = quote + 1;
    loop {
        let close = rest + line[rest..].find('"').ok_or(unclosed)?;
        text.push_str(&line[rest..close]);
        rest = close + 1;
        if line[rest..].starts_with('"') {
            text.push('"');
            rest += 1;
            continue;
        }
        let blank = line[rest..].len() - line[rest..].trim_start_matches(' ').len();
        let next = rest + blank;
        let cell = Cell { text: Cow::Owned(text.trim().to_owned()), span: Span::new(quote, rest) };
        return match line.as_bytes().get(next) {
            None => Ok((cell, None)),
            Some(b) if *b == sign => Ok((cell, Some(next + 1))),
            Some(_) => Err(Span::new(quote, line.len())),
        };
    }
}

/// Whether a line ends within the quotes of a cell; without a separator any of them ends a cell.
pub(super) fn ends_in_quotes(line: &[u8], separator: Option<Separator>) -> bool {
    let ends_cell = |b: u8| match separator {
        Some(separator) => b == separator.sign(),
        None => matches!(b, b',' | b';' | b'\t'),
    };
    let (mut begins, mut quoted) = (true, false);
    for &b in line {
        match b {
            // two quotes within quotes close and open them
            b'"' if quoted => (quoted, begins) = (false, true),
            b'"' if begins => (quoted, begins) = (true, false),
            b' ' => {}
            b if !quoted => begins = ends_cell(b),
            _ => {}
        }
    }
    quoted
}

// The first line of a table: names with units.

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

// Texts that a spreadsheet would run: written with an apostrophe before them, and read without it. Controls are spelt out.

/// What begins a formula.
const BEGINS: [char; 6] = ['=', '+', '-', '@', '\t', '\n'];

/// A text as a cell that no spreadsheet runs; numbers stay as they are.
#[must_use]
pub fn as_cell(text: &str) -> Cow<'_, str> {
    if text.starts_with(BEGINS) && text != "-" && text.parse::<f64>().is_err() {
        Cow::Owned(format!("'{}", shown(text)))
    } else {
        shown(text)
    }
}

/// The text of such a cell.
#[must_use]
pub fn from_cell(cell: &str) -> &str {
    cell.strip_prefix('\'').filter(|text| text.starts_with(BEGINS)).unwrap_or(cell)
}
