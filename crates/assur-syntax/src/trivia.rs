//! Comments and blank lines, by a small scanner beside the grammar.

use super::document::{Statement, Trivia};
use super::line::Line;
use assur_text::source::{Span, Spanned};

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
