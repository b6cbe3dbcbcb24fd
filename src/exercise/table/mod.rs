//! Tables of comma-separated values: read line by line, so that their length does not matter.

mod error;
mod line;
mod number;

pub use error::TableError;
pub use line::{Cell, Separator, cells};
pub use line::{as_cell, from_cell};
pub use number::PreciseNumber;

use assur_check::{ColumnUse, Row, RowCell, RowColumn};
use assur_syntax::document::{Column, Variants};
use assur_text::source::{Source, Span};
use std::collections::VecDeque;
use std::io::{self, BufRead};
use std::sync::Arc;

/// More bytes than this are not one line of numbers.
const LONGEST_LINE: u64 = 1 << 20;

/// The most lines that a cell in quotes goes on for.
const MOST_JOINED: usize = 8;

/// An error of a table with the line it is about.
pub type Fault = (Source, Box<TableError>);

/// A table that is being read.
pub struct Table<R> {
    pub name: String,
    pub header: Source,
    pub columns: Variants,
    /// The separator of cells.
    pub separator: Separator,
    reader: LineReader<R>,
    line: usize,
    rows: usize,
}

/// The columns of a header, each with what is wrong with it.
pub type Columns = Vec<Result<Column, TableError>>;

/// Lines of a table, not yet divided into cells.
#[derive(Debug, Default)]
pub struct Lines {
    bytes: Vec<u8>,
    /// Where the lines end, with the number of their row and of their line.
    ends: Vec<(usize, usize, usize)>,
}

/// A row of a table, as written.
#[derive(Clone, Copy, Debug)]
pub struct RawRow<'a> {
    /// Counted from 1.
    pub number: usize,
    /// Its line in the file, counted from 1.
    pub line: usize,
    pub bytes: &'a [u8],
}

impl<R: BufRead> Table<R> {
    /// Reads the header.
    ///
    /// # Errors
    /// What cannot be read; the inner error is one of the header.
    pub fn open(name: &str, reader: R) -> io::Result<Result<Self, Fault>> {
        Ok(Self::open_each(name, reader)?.and_then(|(mut table, columns)| {
            match columns.into_iter().collect() {
                Ok(columns) => table.columns.columns = columns,
                Err(error) => return Err((table.header, Box::new(error))),
            }
            Ok(table)
        }))
    }

    /// Reads the header. Each of its columns is readable or not by itself; the table has none yet.
    ///
    /// # Errors
    /// What cannot be read; the inner error is one of the header as a whole.
    pub fn open_each(name: &str, reader: R) -> io::Result<Result<(Self, Columns), Fault>> {
        let mut reader = LineReader { reader, ahead: VecDeque::new() };
        let mut bytes = Vec::new();
        let mut line = 0;
        while bytes.trim_ascii().is_empty() {
            bytes.clear();
            line += 1;
            if reader.line(&mut bytes)? == 0 {
                let error = TableError::Empty { what: "no header", span: None };
                return Ok(Err((Source::new(name, ""), Box::new(error))));
            }
            if bytes.starts_with("\u{feff}".as_bytes()) {
                bytes.drain(..3);
            }
        }
        let more = reader.join(&mut bytes, 0, None)?;
        let text = String::from_utf8_lossy(&bytes).into_owned();
        let header = Source::line(name, text, line);
        line += more;
        let separator = Separator::of(&header.text);
        let first = String::from_utf8_lossy(reader.next()?);
        let first = first.lines().next().unwrap_or_default();
        let found = line::columns(&header.text, separator, line_text(&bytes))
            .and_then(|found| line::separators(&header.text, separator, first).map_or(Ok(found), Err));
        let found = match found {
            Ok(found) => found,
            Err(error) => return Ok(Err((header, Box::new(error)))),
        };
        let columns = Variants::default();
        let table = Self { name: name.to_owned(), header, columns, separator, reader, line, rows: 0 };
        Ok(Ok((table, found)))
    }

    /// Reads the next lines, at most so many; blank ones are left out. Fewer come at the end of the table only.
    ///
    /// # Errors
    /// An error of reading.
    pub fn lines(&mut self, most: usize, lines: &mut Lines) -> io::Result<()> {
        lines.bytes.clear();
        lines.ends.clear();
        while lines.ends.len() < most {
            let start = lines.bytes.len();
            if self.reader.line(&mut lines.bytes)? == 0 {
                break;
            }
            self.line += 1;
            let line = self.line;
            self.line += self.reader.join(&mut lines.bytes, start, Some(self.separator))?;
            if lines.bytes[start..].iter().all(|b| matches!(b, b' ' | b'\t' | b',' | b';')) {
                lines.bytes.truncate(start);
                continue;
            }
            self.rows += 1;
            lines.ends.push((lines.bytes.len(), self.rows, line));
        }
        Ok(())
    }

    /// What is wrong where no row was found.
    #[must_use]
    pub fn without_rows(&self) -> Option<Fault> {
        let span = Some(Span::new(0, self.header.text.len()));
        let error = || Box::new(TableError::Empty { what: "no rows", span });
        (self.rows == 0).then(|| (self.header.clone(), error()))
    }
}

/// Lines of a text, some of them read ahead.
struct LineReader<R> {
    reader: R,
    ahead: VecDeque<Vec<u8>>,
}

impl<R: BufRead> LineReader<R> {
    /// Reads a line without its end; 0 at the end of the text.
    fn line(&mut self, bytes: &mut Vec<u8>) -> io::Result<usize> {
        match self.ahead.pop_front() {
            Some(line) => {
                bytes.extend_from_slice(&line);
                Ok(line.len() + 1)
            }
            None => read_line(&mut self.reader, bytes),
        }
    }

    /// What comes next, as far as it is there.
    fn next(&mut self) -> io::Result<&[u8]> {
        match self.ahead.front() {
            Some(line) => Ok(line),
            None => self.reader.fill_buf(),
        }
    }

    /// Joins a line that ends within quotes with those that follow, by blanks: how many. Where the quotes do not close, they are one
    /// too many and the line stays as it is.
    fn join(&mut self, bytes: &mut Vec<u8>, start: usize, separator: Option<Separator>) -> io::Result<usize> {
        let is_open = |text: &[u8]| text.contains(&b'"') && line::ends_in_quotes(text, separator);
        if !is_open(&bytes[start..]) {
            return Ok(0);
        }
        let mut joined = bytes[start..].to_vec();
        let mut taken: Vec<Vec<u8>> = Vec::new();
        while taken.len() < MOST_JOINED && is_open(&joined) {
            let mut next = Vec::new();
            if self.line(&mut next)? == 0 {
                break;
            }
            joined.push(b' ');
            joined.extend_from_slice(&next);
            taken.push(next);
        }
        let is_read = std::str::from_utf8(&joined)
            .is_ok_and(|text| cells(text, separator.unwrap_or_else(|| Separator::of(text))).is_ok());
        if is_read {
            bytes.truncate(start);
            bytes.append(&mut joined);
            return Ok(taken.len());
        }
        for line in taken.into_iter().rev() {
            self.ahead.push_front(line);
        }
        Ok(0)
    }
}

/// Reads a line without its end; 0 at the end of the text.
fn read_line(reader: &mut impl BufRead, bytes: &mut Vec<u8>) -> io::Result<usize> {
    let read = io::Read::take(&mut *reader, LONGEST_LINE).read_until(b'\n', bytes)?;
    if bytes.ends_with(b"\n") {
        bytes.pop();
        if bytes.ends_with(b"\r") {
            bytes.pop();
        }
    } else if is_cut(read) {
        // one line stays one line: it is reported by its beginning
        reader.skip_until(b'\n')?;
    }
    Ok(read)
}

/// Whether a line of that length is not read to its end.
const fn is_cut(length: usize) -> bool {
    length as u64 >= LONGEST_LINE
}

/// The text of a line, or what is wrong with it and what to do.
fn line_text(bytes: &[u8]) -> Result<&str, (&'static str, &'static str)> {
    if is_cut(bytes.len()) {
        return Err(("it is longer than 1 MiB", "leave out what is not part of the table"));
    }
    std::str::from_utf8(bytes).map_err(|_| ("it is not UTF-8 text", "save the file in the encoding UTF-8"))
}

impl Lines {
    /// How many there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// The line of this index.
    #[must_use]
    pub fn get(&self, index: usize) -> Option<RawRow<'_>> {
        let &(end, number, line) = self.ends.get(index)?;
        let start = index.checked_sub(1).map_or(0, |before| self.ends[before].0);
        Some(RawRow { number, line, bytes: &self.bytes[start..end] })
    }
}

/// The first two cells that may be one number with a decimal comma, as that number. One cell too many may be just that:
/// then only a single decimal before the last cell speaks for a comma.
fn decimal_comma(text: &str, cells: &[Cell<'_>], separator: Separator, one_more: bool) -> Option<String> {
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    let glued = |pair: &&[Cell<'_>]| {
        let [whole, decimals] = pair else { return false };
        let between = text.get(whole.span.end..decimals.span.start);
        between == Some(",") && digits(whole.text.trim_start_matches('-')) && digits(&decimals.text)
    };
    let single = |pair: &&[Cell<'_>]| !one_more || pair[1].text.len() == 1;
    let looked_at = if one_more { cells.len() - 1 } else { cells.len() };
    let mut pairs = cells[..looked_at].windows(2).filter(glued);
    let pair = pairs.find(single).filter(|_| separator == Separator::Comma)?;
    Some(format!("{}.{}", pair[0].text, pair[1].text))
}

/// A row in numbers, and what the column `variant` calls it.
#[derive(Default)]
pub struct Read<'a> {
    pub row: Row,
    pub label: Option<String>,
    /// Its cells as written.
    pub cells: Vec<Cell<'a>>,
}

impl<'a> RawRow<'a> {
    /// The text of the line.
    ///
    /// # Errors
    /// It is not UTF-8, or too long.
    pub fn text(&self, table: &str) -> Result<&'a str, Fault> {
        line_text(self.bytes).map_err(|(why, help)| {
            let text = String::from_utf8_lossy(self.bytes);
            let span = Span::new(0, text.len());
            let error = TableError::Line { line: self.line, why: why.to_owned(), help, span };
            (Source::line(table, text, self.line), Box::new(error))
        })
    }

    /// Reads the row.
    ///
    /// # Errors
    /// Cells that are missing, too many, or no numbers: the first of them.
    pub fn read(
        &self,
        table: &str,
        columns: &Arc<[RowColumn]>,
        separator: Separator,
    ) -> Result<Read<'a>, Fault> {
        let mut read = Read::default();
        self.read_in(table, columns, separator, &mut read).map(|()| read)
    }

    /// As [`RawRow::read`], in the memory of another row.
    ///
    /// # Errors
    /// As [`RawRow::read`]; what was read is then no row.
    pub fn read_in(
        &self,
        table: &str,
        columns: &Arc<[RowColumn]>,
        separator: Separator,
        read: &mut Read<'a>,
    ) -> Result<(), Fault> {
        let fault = |text: &str, error| (Source::line(table, text, self.line), Box::new(error));
        let line = self.line;
        let text = self.text(table)?;
        let Read { row, label, cells } = read;
        line::cells_in(text, separator, cells).map_err(|span| {
            let help = "write numbers without quotes, and a quote within a text twice";
            fault(text, TableError::Line { line, why: "a quote is not closed".to_owned(), help, span })
        })?;
        self.fits(text, cells, columns, separator).map_err(|e| fault(text, e))?;
        *label = None;
        row.begin(columns);
        for (i, (cell, column)) in cells.iter().zip(columns.iter()).enumerate() {
            if column.what == ColumnUse::Label {
                *label = Some(cell.text.clone().into_owned());
                row.label.clone_from(label);
                row.push(RowCell::default());
                continue;
            }
            let written = PreciseNumber::read(&cell.text, separator).map_err(|(why, help)| {
                let name = column.name.clone();
                fault(text, TableError::Number { line, column: i + 1, name, why, help, span: cell.span })
            })?;
            row.push(RowCell {
                value: column.unit.to_si(written.value),
                digit: column.unit.to_si(written.digit),
            });
        }
        Ok(())
    }

    fn fits(
        &self,
        text: &str,
        cells: &[Cell<'_>],
        columns: &[RowColumn],
        separator: Separator,
    ) -> Result<(), TableError> {
        let line = self.line;
        if let Some(extra) = cells.get(columns.len()) {
            let count = columns.len();
            let plural = if count == 1 { "" } else { "s" };
            let one_more = cells.len() == count + 1;
            let help = match decimal_comma(text, cells, separator, one_more) {
                Some(number) => {
                    format!("use a decimal point, as in `{number}`, or separate the cells by semicolons")
                }
                None if one_more => {
                    format!("leave `{}` out, or name a column for it in the header", extra.text)
                }
                None => "write one number per column".to_owned(),
            };
            return Err(TableError::TooMany {
                line,
                found: cells.len(),
                columns: format!("{count} column{plural}"),
                help,
                span: Span::new(extra.span.start, text.len()),
            });
        }
        let empty = |i: &usize| cells.get(*i).is_none_or(|cell| cell.text.is_empty());
        let Some(missing) = (0..columns.len()).find(empty) else { return Ok(()) };
        let span = cells.get(missing).map_or(Span::new(0, text.len()), |c| c.span);
        Err(TableError::Missing { line, column: missing + 1, name: columns[missing].name.clone(), span })
    }
}
