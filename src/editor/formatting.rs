//! The text in the one style: all of it, some lines, what a key has ended.

use super::Analysis;
use assur_syntax::{Token, TokenKind};
use assur_text::source::{Edit, Span};
use std::ops::RangeInclusive;

impl Analysis {
    /// The edits that put the text, or some lines of it, in the one style; none where it does not read.
    #[must_use]
    pub fn formatting(&self, lines: Option<RangeInclusive<usize>>) -> Vec<Edit> {
        if !self.is_read {
            return Vec::new();
        }
        let edits = assur_format::edits_of(&self.source.text, &self.tokens, &self.document);
        match lines {
            Some(lines) => assur_format::touching(&self.source.text, edits, lines),
            None => edits,
        }
    }

    /// The same of what ends at a byte, and of nothing behind it: the line before it after a newline, the statement whose braces are
    /// closed.
    #[must_use]
    pub fn formatting_after(&self, byte: usize) -> Vec<Edit> {
        let before = self.written_before(byte);
        let line = |byte: usize| self.written_before(byte).matches('\n').count() + 1;
        let (lines, end) = if before.ends_with('}') {
            (self.opened_at(byte).map_or(line(byte), line)..=line(byte), byte)
        } else {
            let Some(end) = before.rfind('\n') else { return Vec::new() };
            (line(end)..=line(end), end)
        };
        let mut edits = self.formatting(Some(lines));
        edits.retain(|edit| edit.span.end <= end);
        edits
    }

    fn written_before(&self, byte: usize) -> &str {
        self.source.text.get(..byte).unwrap_or_default()
    }

    /// Where the brace is opened that is closed before a byte.
    fn opened_at(&self, byte: usize) -> Option<usize> {
        let mut open = Vec::new();
        for token in self.tokens.iter().take_while(|token| token.span.end <= byte) {
            match token.kind {
                TokenKind::Brace => open.push(token.span.start),
                TokenKind::BraceEnd if token.span.end == byte => return open.pop(),
                TokenKind::BraceEnd => _ = open.pop(),
                _ => {}
            }
        }
        None
    }
}

// What can be folded away.

/// Braces, and neighbouring lines of comments; each goes over several lines.
#[must_use]
pub fn folds(text: &str, tokens: &[Token]) -> Vec<Span> {
    let mut found = Vec::new();
    let mut open = Vec::new();
    let mut comments: Option<Span> = None;
    let mut is_line_start = true;
    for token in tokens {
        match token.kind {
            TokenKind::Brace => open.push(token.span),
            TokenKind::BraceEnd => found.extend(open.pop().map(|start| start.to(token.span))),
            _ => {}
        }
        match token.kind {
            TokenKind::Comment if is_line_start => {
                comments = Some(comments.map_or(token.span, |before| before.to(token.span)));
            }
            TokenKind::Newline if !is_line_start => {}
            // an empty line, or something else than a comment
            _ => found.extend(comments.take()),
        }
        is_line_start = token.kind == TokenKind::Newline;
    }
    found.extend(comments);
    found.retain(|span| text.get(span.start..span.end).is_some_and(|part| part.contains('\n')));
    found.sort();
    found
}

// Ever larger parts of a text around a place.

impl Analysis {
    /// The word at a byte, what is in brackets around it, with them, the statement, the text: each within the next.
    #[must_use]
    pub fn selections(&self, byte: usize) -> Vec<Span> {
        let holds = |span: Span| span.start <= byte && byte <= span.end;
        let words = self.tokens.iter().filter(|t| t.kind != TokenKind::Newline).map(|t| t.span);
        let statements = self.document.statements.iter().map(|s| s.span);
        let all =
            words.chain(self.brackets()).chain(statements).chain([Span::new(0, self.source.text.len())]);
        let mut around = all.filter(|span| holds(*span)).collect::<Vec<_>>();
        around.sort_by_key(|span| span.end - span.start);
        let mut found: Vec<Span> = Vec::new();
        for span in around {
            let is_larger = |last: &Span| span.start <= last.start && last.end <= span.end && span != *last;
            if found.last().is_none_or(is_larger) {
                found.push(span);
            }
        }
        found
    }

    /// What is between brackets, without them and with them.
    fn brackets(&self) -> Vec<Span> {
        let (mut open, mut found) = (Vec::new(), Vec::new());
        for token in &self.tokens {
            match token.kind {
                TokenKind::Open | TokenKind::Call | TokenKind::Square | TokenKind::Brace => {
                    open.push(token.span)
                }
                TokenKind::Close | TokenKind::SquareEnd | TokenKind::BraceEnd => {
                    if let Some(start) = open.pop() {
                        found.extend([Span::new(start.end, token.span.start), start.to(token.span)]);
                    }
                }
                _ => {}
            }
        }
        found
    }
}
