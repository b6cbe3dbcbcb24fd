//! What can be folded away.

use assur_syntax::{Token, TokenKind};
use assur_text::source::Span;

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
