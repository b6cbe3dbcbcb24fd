//! What each word is, for its colour.

use super::{Analysis, SymbolKind};
use assur_syntax::{Token, TokenKind};
use assur_text::language::{Function, PROPERTIES, WORDS};
use assur_text::source::Span;

/// The kinds of coloured parts, by the names that editors have for them.
pub const TOKEN_COLOURS: [&str; 12] = [
    "keyword",
    "number",
    "string",
    "comment",
    "type",
    "function",
    "variable",
    "parameter",
    "class",
    "property",
    "interface",
    "event",
];

/// A part of the text in one line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Coloured {
    pub at: Span,
    /// Its kind, a place in [`TOKEN_COLOURS`].
    pub colour: usize,
    /// Whether it is a name where it is declared.
    pub is_declaration: bool,
}

impl Analysis {
    /// All words, numbers, units, texts and comments.
    #[must_use]
    pub fn coloured(&self) -> Vec<Coloured> {
        let all = self.tokens.iter().enumerate();
        let coloured = |(index, token): (usize, &Token)| {
            let name = self.colour(index, *token)?;
            let colour = TOKEN_COLOURS.iter().position(|known| *known == name)?;
            Some(Coloured { at: token.span, colour, is_declaration: self.names.is_declaration(token.span) })
        };
        all.filter_map(coloured).collect()
    }

    fn colour(&self, index: usize, token: Token) -> Option<&'static str> {
        Some(match token.kind {
            TokenKind::Number => "number",
            TokenKind::Unit => "type",
            TokenKind::Text => "string",
            TokenKind::Comment => "comment",
            TokenKind::Joining => "keyword",
            TokenKind::Word => match self.names.declarations(token.span).first() {
                Some(declared) => of_name(declared.kind),
                None => self.of_word(index, token)?,
            },
            _ => return None,
        })
    }

    fn of_word(&self, index: usize, token: Token) -> Option<&'static str> {
        let text = token.text(&self.source.text);
        let is_call = self.tokens.get(index + 1).is_some_and(|next| next.kind == TokenKind::Call);
        let is_property = || PROPERTIES.iter().flat_map(|(_, all)| all.iter()).any(|row| row.name == text);
        let is_word = || WORDS.iter().flat_map(|(_, all)| all.iter()).any(|row| row.word == text);
        if is_call && Function::named(text).is_some() {
            Some("function")
        } else {
            (is_word() || is_property()).then_some("keyword")
        }
    }
}

const fn of_name(kind: SymbolKind) -> &'static str {
    match kind {
        SymbolKind::Given => "parameter",
        SymbolKind::Derived | SymbolKind::Answer => "variable",
        SymbolKind::Link | SymbolKind::Wheel | SymbolKind::Element => "class",
        SymbolKind::Point | SymbolKind::Shape => "property",
        SymbolKind::Pair | SymbolKind::Group => "interface",
        SymbolKind::Load | SymbolKind::Pose | SymbolKind::Event => "event",
    }
}
