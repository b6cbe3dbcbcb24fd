//! The text as tokens that lose nothing: what is between two of them is blanks.
//!
//! Most tokens are found by their characters. What depends on the place is taken from the grammar's pairs: where a unit ends, whether
//! a sign is a prefix, whether a bracket is that of a call. In a part that does not read the characters alone decide.

mod characters;

use crate::prepare::whole_end;
use crate::words::Rule;
use assur_text::source::Span;
use characters::Characters;
use pest::iterators::Pairs;

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TokenKind {
    /// A word of the language, or a name.
    Word,
    /// The digits of a number, without sign and unit.
    Number,
    /// A unit, in one piece: `N*m`.
    Unit,
    /// A text with its quotes.
    Text,
    /// From the slashes to the end of the line, without blanks at the end.
    Comment,
    /// The end of a line.
    Newline,
    /// `,`
    Comma,
    /// `;`
    Semicolon,
    /// `:`
    Colon,
    /// `.` between a thing and its part.
    Dot,
    /// `(`
    Open,
    /// `(` directly after a function.
    Call,
    /// `)`
    Close,
    /// `[`
    Square,
    /// `]`
    SquareEnd,
    /// `{`
    Brace,
    /// `}`
    BraceEnd,
    /// A sign before its operand.
    Prefix,
    /// `=`, `+`, comparisons, `@`, `..`, and `-` between numbers or what a pair joins.
    Infix,
    /// `-` between two points: `A-B`.
    Hyphen,
    /// `and`, `or`
    Joining,
    /// `*`, `/`
    Product,
    /// `^`
    Power,
    /// A character of no token.
    Other,
}

/// A token and its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Token {
    pub kind: TokenKind,
    pub span: Span,
}

impl Token {
    #[must_use]
    pub fn text(self, text: &str) -> &str {
        text.get(self.span.start..self.span.end).unwrap_or_default()
    }
}

/// The tokens of a text.
pub(super) fn tokens(text: &str, read: &str, pairs: Pairs<'_, Rule>) -> Vec<Token> {
    let mut found = Vec::with_capacity(text.len() / 4);
    let mut characters = Characters::new(text);
    // the end of two points with a hyphen
    let mut points_end = 0;
    for pair in pairs.flatten() {
        let rule = pair.as_rule();
        let at = pair.as_span();
        let kind = match rule {
            Rule::bar | Rule::beside => {
                points_end = at.end();
                continue;
            }
            Rule::p_dash if at.start() < points_end => TokenKind::Hyphen,
            Rule::number | Rule::count => TokenKind::Number,
            Rule::unit => TokenKind::Unit,
            Rule::string => TokenKind::Text,
            Rule::ident | Rule::pose_name => TokenKind::Word,
            Rule::row_name if at.as_str().starts_with('"') => TokenKind::Text,
            Rule::row_name => TokenKind::Word,
            Rule::sign => TokenKind::Prefix,
            Rule::joining => TokenKind::Joining,
            Rule::p_dash | Rule::loose | Rule::compare => TokenKind::Infix,
            Rule::tight if at.as_str() == "^" => TokenKind::Power,
            Rule::tight => TokenKind::Product,
            Rule::arguments => TokenKind::Call,
            _ => continue,
        };
        let end = if rule == Rule::arguments { at.start() + 1 } else { whole_end(read, at.end()) };
        // a name within a name of its own rule is one token
        if at.start() >= characters.at() && at.start() < end {
            characters.until(at.start(), &mut found);
            found.push(Token { kind, span: Span::new(at.start(), end) });
            characters.go_on(end);
        }
    }
    characters.until(text.len(), &mut found);
    found
}
