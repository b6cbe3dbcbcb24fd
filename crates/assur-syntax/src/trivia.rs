//! Comments and blank lines, by a small scanner beside the grammar.

use super::document::{Statement, Trivia};
use assur_text::diagnostic::Help;
use assur_text::source::{Edit, Span, Spanned};

/// All comments and blank lines of a text.
pub(super) fn scan(text: &str) -> Trivia {
    let mut trivia = Trivia::default();
    let mut start = 0;
    for line in lines(text) {
        if line.trim().is_empty() {
            trivia.blank_lines.push(start);
        } else if let Some(at) = comment(line) {
            trivia.comments.push(Span::new(start + at, start + line.trim_end().len()));
        }
        start += line.len();
    }
    trivia
}

/// The lines of a text with their ends: LF, CR LF or CR.
fn lines(mut text: &str) -> impl Iterator<Item = &str> {
    std::iter::from_fn(move || {
        let at = text.bytes().position(|b| matches!(b, b'\n' | b'\r'));
        let end = at.map_or(text.len(), |at| at + if text[at..].starts_with("\r\n") { 2 } else { 1 });
        let (line, rest) = text.split_at(end);
        text = rest;
        (!line.is_empty()).then_some(line)
    })
}

/// Where the comment of a line begins; slashes in a text begin none.
fn comment(line: &str) -> Option<usize> {
    let mut quoted = false;
    let mut before = None;
    for (at, b) in line.bytes().enumerate() {
        match b {
            b'"' => quoted = !quoted,
            b'/' if !quoted && before == Some(b'/') => return Some(at - 1),
            _ => {}
        }
        before = Some(b);
    }
    None
}

/// The comment lines directly below the title: the problem's text.
pub(super) fn notes(text: &str, statements: &[Spanned<Statement>], trivia: &Trivia) -> Vec<Spanned<String>> {
    let title = statements.iter().find(|s| matches!(s.node, Statement::Title(_)));
    let Some(title) = title else { return Vec::new() };
    let title_end = Line::around(text, title.span.end).end;
    let mut line_end = title_end;
    let mut notes = Vec::new();
    for comment in trivia.comments.iter().filter(|c| c.start > title_end) {
        let between = text.get(line_end..comment.start).unwrap_or_default();
        if !between.trim().is_empty()
            || lines(between).filter(|line| line.ends_with(['\n', '\r'])).count() != 1
        {
            break;
        }
        let written = text.get(comment.start + 2..comment.end).unwrap_or_default();
        let written = written.strip_prefix(' ').unwrap_or(written);
        notes.push(Spanned::new(written.to_owned(), *comment));
        line_end = comment.end;
    }
    notes
}

// Lines of the text, and help that replaces a part of them.

/// The line, or lines, around a place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub(super) start: usize,
    /// Its end, without the line end.
    pub(super) end: usize,
}

impl Line {
    /// The line that holds a byte.
    pub(super) fn around(text: &str, at: usize) -> Self {
        let is_end = |b: &u8| matches!(b, b'\n' | b'\r');
        let bytes = text.as_bytes();
        let at = at.min(bytes.len());
        let start = bytes[..at].iter().rposition(&is_end).map_or(0, |i| i + 1);
        let end = bytes[at..].iter().position(is_end).map_or(bytes.len(), |i| at + i);
        Self { start, end }
    }
}

/// `write: …`: the lines of a place with it replaced.
pub(super) fn corrected(text: &str, at: Span, with: &str) -> Help {
    let there = text.get(at.start..at.end).unwrap_or_default();
    let before = length_alike(there.chars(), with.chars());
    let (there, with) = (&there[before..], &with[before..]);
    let behind = length_alike(there.chars().rev(), with.chars().rev());
    let removed = &there[..there.len() - behind];
    let start = at.start + before;
    let edit = Edit::new(Span::new(start, start + removed.len()), &with[..with.len() - behind]);
    let help = Help::lines(text, at, vec![edit]);
    // a comment that stood there would be lost
    if removed.contains("//") && !with.contains("//") { help.to_string().into() } else { help }
}

/// The bytes that two texts have alike from their beginning.
fn length_alike(a: impl Iterator<Item = char>, b: impl Iterator<Item = char>) -> usize {
    a.zip(b).take_while(|(a, b)| a == b).map(|(a, _)| a.len_utf8()).sum()
}
