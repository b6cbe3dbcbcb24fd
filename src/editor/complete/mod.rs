//! What may be written at a place.

mod names;
mod place;

use super::{Analysis, Results};
use assur_syntax::TokenKind;
use assur_text::source::Span;
pub(super) use place::Place;
pub(super) use place::alike as units_alike;

/// What a completion is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CompletionKind {
    /// A word of the language.
    Word,
    /// A whole statement or member.
    Snippet,
    /// A property in braces.
    Property,
    Function,
    Unit,
    Name,
    Value,
}

/// Something that may be written.
#[derive(Clone, Debug, PartialEq)]
pub struct Completion {
    /// What is shown, and by which it is found.
    pub label: String,
    /// What is inserted; places to fill are `${1:like this}` in a snippet.
    pub insert: String,
    /// Whether it has places to fill.
    pub is_snippet: bool,
    pub kind: CompletionKind,
    pub means: String,
    pub at: Span,
}

impl Completion {
    fn plain(label: &str, kind: CompletionKind, means: &str) -> Self {
        Self {
            label: label.to_owned(),
            insert: label.to_owned(),
            is_snippet: false,
            kind,
            means: means.to_owned(),
            at: Span::default(),
        }
    }

    fn snippet(label: &str, kind: CompletionKind, means: &str, example: &str) -> Self {
        Self { insert: place::of(example), is_snippet: true, ..Self::plain(label, kind, means) }
    }
}

impl Analysis {
    /// What may be written at a byte, in place of the word that ends there.
    #[must_use]
    pub fn complete(&self, byte: usize, results: Option<&Results>) -> Vec<Completion> {
        let touched = self.tokens.iter().find(|t| t.span.start < byte && byte <= t.span.end);
        let begun = touched.filter(|t| matches!(t.kind, TokenKind::Word | TokenKind::Unit));
        if begun.is_none() && touched.is_some_and(|t| matches!(t.kind, TokenKind::Text | TokenKind::Comment))
        {
            return Vec::new();
        }
        let at = Span::new(begun.map_or(byte, |token| token.span.start), byte);
        let place = Place::of(self, at.start);
        let found = self.offered(&place, results);
        found.into_iter().map(|one| Completion { at, ..one }).collect()
    }

    fn offered(&self, place: &Place<'_>, results: Option<&Results>) -> Vec<Completion> {
        match place.before {
            Some(TokenKind::Dot) => self.parts(place),
            Some(TokenKind::Number) => [place::offered(self, place), names::within()].concat(),
            Some(TokenKind::Square) => place::offered(self, place),
            _ if place.back(1) == "as" => place::offered(self, place),
            _ if place.begins() => names::beginnings(place),
            _ => {
                let mut found = self.names_at(place);
                found.extend(self.expected_value(place, results));
                found.extend(names::within());
                found
            }
        }
    }
}
