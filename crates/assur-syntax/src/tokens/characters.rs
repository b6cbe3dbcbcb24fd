//! Tokens by their characters alone.

use super::{Token, TokenKind};
use crate::words::is_name_char;
use assur_text::source::Span;

/// A text and how far it is cut.
pub(super) struct Characters<'t> {
    text: &'t str,
    at: usize,
}

impl<'t> Characters<'t> {
    pub(super) const fn new(text: &'t str) -> Self {
        Self { text, at: 0 }
    }

    /// The first byte that is not cut.
    pub(super) const fn at(&self) -> usize {
        self.at
    }

    /// What is before a place is cut.
    pub(super) const fn go_on(&mut self, at: usize) {
        self.at = at;
    }

    /// Cuts all before a place.
    pub(super) fn until(&mut self, end: usize, found: &mut Vec<Token>) {
        while let Some(rest) = self.text.get(self.at..end)
            && let Some(c) = rest.chars().next()
        {
            let start = self.at;
            let (kind, length) = token(rest, c, found.last().map(|t| t.text(self.text)));
            self.at += length;
            if let Some(kind) = kind {
                found.push(Token { kind, span: Span::new(start, self.at) });
            }
        }
        self.at = self.at.max(end);
    }
}

/// The token that a text begins with, none for blanks, and its length.
fn token(rest: &str, c: char, before: Option<&str>) -> (Option<TokenKind>, usize) {
    let while_ = |holds: fn(char) -> bool| rest.find(|c| !holds(c)).unwrap_or(rest.len());
    let (kind, length) = match c {
        '\n' => (TokenKind::Newline, 1),
        '\r' if rest.starts_with("\r\n") => (TokenKind::Newline, 2),
        '\r' => (TokenKind::Newline, 1),
        c if is_blank(c) => return (None, while_(is_blank).max(c.len_utf8())),
        '/' if rest.starts_with("//") => {
            let line = rest.split(['\n', '\r']).next().unwrap_or(rest);
            (TokenKind::Comment, line.trim_end().len())
        }
        '"' => {
            let line = rest.split(['\n', '\r']).next().unwrap_or(rest);
            let closing = line[1..].find('"').map(|at| at + 2);
            (TokenKind::Text, closing.unwrap_or(line.trim_end().len()))
        }
        ',' => (TokenKind::Comma, 1),
        ';' => (TokenKind::Semicolon, 1),
        ':' if rest.starts_with(":=") => (TokenKind::Infix, 2),
        ':' => (TokenKind::Colon, 1),
        '(' if matches!(before, Some("over" | "under")) => (TokenKind::Call, 1),
        '(' => (TokenKind::Open, 1),
        ')' => (TokenKind::Close, 1),
        '[' => (TokenKind::Square, 1),
        ']' => (TokenKind::SquareEnd, 1),
        '{' => (TokenKind::Brace, 1),
        '}' => (TokenKind::BraceEnd, 1),
        '.' if rest.starts_with("..") => (TokenKind::Infix, 2),
        '.' => (TokenKind::Dot, 1),
        '=' | '<' | '>' => (TokenKind::Infix, while_(|c| matches!(c, '=' | '<' | '>'))),
        '+' | '-' | '−' | '–' | '@' => (TokenKind::Infix, c.len_utf8()),
        '*' | '/' | '·' | '⋅' => (TokenKind::Product, c.len_utf8()),
        '^' => (TokenKind::Power, 1),
        c if c.is_ascii_digit() => (TokenKind::Number, while_(|c| c.is_ascii_digit() || c == '.')),
        c if is_name_char(c) => (TokenKind::Word, while_(is_name_char)),
        c => (TokenKind::Other, c.len_utf8()),
    };
    (Some(kind), length)
}

fn is_blank(c: char) -> bool {
    !matches!(c, '\n' | '\r') && (c.is_whitespace() || c == '\u{FEFF}')
}
