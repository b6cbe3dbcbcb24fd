//! A line of comma-separated values, RFC 4180. A cell does not go over the end of its line, so that a quote too much
//! spoils one line and no more.

use assur_text::source::Span;
use std::borrow::Cow;

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
