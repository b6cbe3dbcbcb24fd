//! A place in a text: the statement it is in, and the braces and calls around it.

use super::super::Analysis;
use assur_syntax::{Token, TokenKind};
use assur_text::source::Span;

/// What is before a place.
pub struct Place<'a> {
    text: &'a str,
    tokens: &'a [Token],
    /// The kind of the token before it, on the same line.
    pub before: Option<TokenKind>,
    /// The first token of the statement or member.
    head: Option<usize>,
    /// The first tokens of the statements in whose braces it is, from outside.
    around: Vec<Option<usize>>,
    /// The functions in whose brackets it is, from outside, each with the number of arguments before it.
    calls: Vec<(Option<usize>, usize)>,
}

impl<'a> Place<'a> {
    /// That of a byte between tokens.
    pub fn of(analysis: &'a Analysis, byte: usize) -> Self {
        let count = analysis.tokens.partition_point(|token| token.span.end <= byte);
        let tokens = &analysis.tokens[..count];
        let text = &analysis.source.text;
        let mut place =
            Self { text, tokens, before: None, head: None, around: Vec::new(), calls: Vec::new() };
        tokens.iter().enumerate().for_each(|(index, token)| place.pass(index, *token));
        place
    }

    fn pass(&mut self, index: usize, token: Token) {
        match token.kind {
            TokenKind::Newline | TokenKind::Semicolon => {
                let goes_on = matches!(
                    self.before,
                    Some(TokenKind::Comma | TokenKind::Infix | TokenKind::Colon | TokenKind::Hyphen)
                );
                if goes_on {
                    return;
                }
                (self.head, self.before) = (None, None);
                self.calls.clear();
                return;
            }
            TokenKind::Comment => return,
            TokenKind::Brace => {
                self.around.push(self.head.take());
                self.calls.clear();
            }
            TokenKind::BraceEnd => self.head = self.around.pop().flatten(),
            TokenKind::Open | TokenKind::Call => {
                // in a line that does not read yet no bracket is known to be that of a call
                let touches = |word: &usize| {
                    let word = self.tokens[*word];
                    word.kind == TokenKind::Word && word.span.end == token.span.start
                };
                self.calls.push((index.checked_sub(1).filter(touches), 0));
            }
            TokenKind::Close => _ = self.calls.pop(),
            TokenKind::Comma => self.calls.iter_mut().last().into_iter().for_each(|call| call.1 += 1),
            _ => {}
        }
        if self.head.is_none() && !matches!(token.kind, TokenKind::Brace) {
            self.head = Some(index);
        }
        self.before = Some(token.kind);
    }

    /// Whether a statement or a member begins here.
    pub fn begins(&self) -> bool {
        self.head.is_none()
    }

    fn word(&self, index: Option<usize>) -> &'a str {
        index.and_then(|index| self.tokens.get(index)).map_or("", |token| token.text(self.text))
    }

    /// The first word of the statement or member.
    pub fn head(&self) -> &'a str {
        self.word(self.head)
    }

    /// The first word of the statement in whose braces this is.
    pub fn body(&self) -> &'a str {
        self.around.last().map_or("", |head| self.word(*head))
    }

    /// The link in whose braces this is.
    pub fn link(&self) -> Option<&'a str> {
        let head = (*self.around.last()?)?;
        if self.word(Some(head)) == "ground" {
            return Some("ground");
        }
        // a number may come before the name
        let words = self.tokens[head + 1..].iter().filter(|token| token.kind == TokenKind::Word);
        words.map(|token| token.text(self.text)).next()
    }

    /// The `n`th token before the place, as it is written; the last one is the first.
    pub fn back(&self, n: usize) -> &'a str {
        let before = self.tokens.iter().rev().filter(|token| token.kind != TokenKind::Comment);
        before.skip(n - 1).map(|token| token.text(self.text)).next().unwrap_or_default()
    }

    /// The line of the first word of the statement.
    pub fn line(&self) -> Span {
        let start =
            self.head.and_then(|head| self.tokens.get(head)).map_or(self.text.len(), |t| t.span.start);
        let end = self.text[start..].find('\n').map_or(self.text.len(), |length| start + length);
        Span::new(start, end)
    }

    /// The words of the statement so far.
    pub fn words(&self) -> impl Iterator<Item = &'a str> {
        let from = self.head.unwrap_or(self.tokens.len());
        self.tokens[from..].iter().map(|token| token.text(self.text))
    }

    /// The innermost function in whose brackets this is, with the number of arguments before it.
    pub fn call(&self) -> Option<(&'a str, usize)> {
        let (name, count) = self.calls.iter().rev().find(|(name, _)| name.is_some())?;
        Some((self.word(*name), *count))
    }
}
