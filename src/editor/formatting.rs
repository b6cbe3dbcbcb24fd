//! The text in the one style: all of it, some lines, what a key has ended.

use super::Analysis;
use assur_syntax::TokenKind;
use assur_text::source::Edit;
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
