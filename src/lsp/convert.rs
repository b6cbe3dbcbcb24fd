//! Places and edits in the units of the protocol.

use super::error::Failure;
use assur_text::source::{Edit, Encoding, LineColumn, Lines, Span};
use gen_lsp_types::{Position, Range, TextEdit};

/// The place of a range. A column past its line is the line's end; a line past the text, or a column within a character, is an
/// error.
pub fn span(lines: &Lines<'_>, range: Range, encoding: Encoding) -> Result<Span, Failure> {
    let byte = |at: Position| {
        let place = LineColumn { line: index(at.line), column: index(at.character) };
        let found = lines.byte(place, encoding);
        found.ok_or_else(|| Failure::params(format!("there is no place {}:{}", at.line, at.character)))
    };
    let (start, end) = (byte(range.start)?, byte(range.end)?);
    if start <= end {
        Ok(Span::new(start, end))
    } else {
        Err(Failure::params("a range ends before it begins"))
    }
}

fn index(n: u32) -> usize {
    usize::try_from(n).unwrap_or(usize::MAX)
}

/// The range of a place.
pub fn range(lines: &Lines<'_>, span: Span, encoding: Encoding) -> Range {
    let number = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
    let position = |byte: usize| {
        let place = lines.place(byte, encoding);
        Position { line: number(place.line), character: number(place.column) }
    };
    Range { start: position(span.start), end: position(span.end) }
}

/// Edits as the protocol has them.
pub fn edits(lines: &Lines<'_>, edits: &[Edit], encoding: Encoding) -> Vec<TextEdit> {
    let edit =
        |edit: &Edit| TextEdit { range: range(lines, edit.span, encoding), new_text: edit.with.clone() };
    edits.iter().map(edit).collect()
}
