//! The least edits from a text to its layout.

use crate::layout::{Layout, is_stuck};
use assur_text::source::{Edit, Span};

/// What of a text is not as it is laid out.
pub(crate) fn changes(layout: &Layout<'_>) -> Vec<Edit> {
    let text = layout.text;
    let newline = if ends_with_return(text) { "\r\n" } else { "\n" };
    let mut edits = Vec::new();
    // a mark of the encoding stays
    let mut from = if text.starts_with('\u{FEFF}') { '\u{FEFF}'.len_utf8() } else { 0 };
    for (number, line) in layout.lines.iter().enumerate() {
        for i in line.pieces.clone() {
            let piece = &layout.pieces[i];
            let at = piece.token.span;
            let newlines = match (i == line.pieces.start, number) {
                (false, _) | (true, 0) => 0,
                (true, _) => 1 + usize::from(line.is_after_empty),
            };
            put(&mut edits, text, Span::new(from, at.start), newline, (newlines, piece.before));
            if is_stuck(piece.token, text) {
                let after = at.start + "//".len();
                edits.push(Edit::new(Span::new(after, after), " "));
            }
            from = at.end;
        }
    }
    if !layout.lines.is_empty() {
        put(&mut edits, text, Span::new(from, text.len()), newline, (1, 0));
    }
    edits
}

/// Whether the first line of a text ends by carriage return and line feed.
fn ends_with_return(text: &str) -> bool {
    text.find('\n').is_some_and(|at| text[..at].ends_with('\r'))
}

/// An edit where there is something else between two tokens than newlines and blanks in the numbers wanted.
fn put(edits: &mut Vec<Edit>, text: &str, at: Span, newline: &str, (newlines, blanks): (usize, usize)) {
    let there = &text.as_bytes()[at.start..at.end];
    let wanted = newlines * newline.len() + blanks;
    let is_so = there.len() == wanted
        && there[..wanted - blanks] == *newline.repeat(newlines).as_bytes()
        && there[wanted - blanks..].iter().all(|&b| b == b' ');
    if !is_so {
        edits.push(Edit::new(at, newline.repeat(newlines) + &" ".repeat(blanks)));
    }
}
