//! What is at a place: a name, or a word of the language from its tables.

use super::complete::Place as Surroundings;
use super::{Analysis, Results};
use assur_syntax::{Token, TokenKind};
use assur_text::language::{CODES, Function, PROPERTIES, Place, Property, WORDS, Word};
use assur_text::source::Span;
use assur_text::units::lookup;

/// A text for a place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hover {
    pub at: Span,
    pub text: String,
}

impl Analysis {
    /// What is at a byte: a name, a unit, a function, or a word of the language.
    #[must_use]
    pub fn hover(&self, byte: usize, results: Option<&Results>) -> Option<Hover> {
        self.about(byte, results).or_else(|| self.of_language(byte))
    }

    fn of_language(&self, byte: usize) -> Option<Hover> {
        let index = self.tokens.iter().position(|t| t.span.start <= byte && byte < t.span.end)?;
        let token = self.tokens[index];
        if token.kind == TokenKind::Comment {
            return self.code(token.span, byte);
        }
        let text = match token.kind {
            TokenKind::Unit => unit(token.text(&self.source.text)),
            TokenKind::Word if self.is_call(index) => function(token.text(&self.source.text)),
            TokenKind::Word => self.property(token).map(property).or_else(|| self.word(index)),
            _ => None,
        };
        text.map(|text| Hover { at: token.span, text })
    }

    /// The page of the code of a diagnostic that a comment names.
    fn code(&self, comment: Span, byte: usize) -> Option<Hover> {
        let is_part = |c: char| c.is_ascii_alphanumeric() || matches!(c, ':' | '_');
        let (before, behind) = self.written(comment).split_at_checked(byte - comment.start)?;
        let start = byte - (before.len() - before.trim_end_matches(is_part).len());
        let end = byte + (behind.len() - behind.trim_start_matches(is_part).len());
        let written = self.written(Span::new(start, end));
        let code = CODES.iter().find(|row| row.code == written.trim_end_matches(':'))?;
        Some(Hover { at: Span::new(start, start + code.code.len()), text: code.page.to_owned() })
    }

    /// A property in the braces of its statement.
    fn property(&self, token: Token) -> Option<&'static Property> {
        let place = Surroundings::of(self, token.span.start);
        let tables = PROPERTIES.iter().filter(|(word, _)| word.split(' ').next() == Some(place.body()));
        let own = || tables.flat_map(|(_, all)| all.iter());
        place.begins().then(own)?.find(|row| row.name == self.written(token.span))
    }

    fn is_call(&self, index: usize) -> bool {
        self.tokens.get(index + 1).is_some_and(|next| next.kind == TokenKind::Call)
    }

    /// A word at the head of a statement or a member. Elsewhere it may be a name.
    fn word(&self, index: usize) -> Option<String> {
        let mut before = self.tokens[..index].iter().rev();
        let begins =
            |t: &Token| matches!(t.kind, TokenKind::Newline | TokenKind::Semicolon | TokenKind::Brace);
        if !before.next().is_none_or(begins) {
            return None;
        }
        let open = self.tokens[..index].iter().fold(0_usize, |open, token| match token.kind {
            TokenKind::Brace => open + 1,
            TokenKind::BraceEnd => open.saturating_sub(1),
            _ => open,
        });
        let may_be = |place: Place| match place {
            Place::Statement | Place::Pair => open == 0,
            Place::Member | Place::CamMember => open > 0,
            _ => false,
        };
        let written = self.tokens[index].text(&self.source.text);
        let tables = WORDS.iter().filter(|(place, _)| may_be(*place));
        let row = tables.flat_map(|(_, table)| table.iter()).find(|row| row.word == written)?;
        Some(page(row))
    }
}

fn page(row: &Word) -> String {
    let example = if row.example.is_empty() { String::new() } else { code(row.example) };
    format!("{example}{}", row.means)
}

fn property(row: &Property) -> String {
    format!("{}{}: {}", code(row.example), row.means, row.takes)
}

fn function(name: &str) -> Option<String> {
    let row = Function::named(name)?.row();
    let means =
        row.forms.iter().map(|form| format!("- {}: {}\n", form.gives, form.means)).collect::<String>();
    Some(code(row.usage) + means.trim_end())
}

/// `` `N*m`: torque, 1 N*m``
fn unit(word: &str) -> Option<String> {
    let unit = lookup(word).ok()?;
    let dimension = unit.dimension.name().map(|name| format!(": {name}")).unwrap_or_default();
    let si = unit.dimension.si_text();
    let factor = if unit.text == si { String::new() } else { format!(", {} {si}", unit.factor) };
    Some(format!("`{word}`{dimension}{}", factor.trim_end()))
}

fn code(text: &str) -> String {
    format!("```mech\n{text}\n```\n")
}
