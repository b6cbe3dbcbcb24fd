//! Ever larger parts of a text around a place.

use super::Analysis;
use assur_syntax::TokenKind;
use assur_text::source::Span;

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
