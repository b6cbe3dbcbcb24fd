//! Names of a text: where each is declared and used.

use super::symbols::{Symbol, SymbolKind, symbols};
use assur_check::Use;
use assur_syntax::document::{Document, Statement};
use assur_syntax::{Token, TokenKind};
use assur_text::source::Span;
use indexmap::{IndexMap, IndexSet};
use unicode_normalization::UnicodeNormalization;

#[derive(Clone, Debug, PartialEq)]
pub struct Declaration {
    pub name: String,
    pub kind: SymbolKind,
    /// Where it is declared.
    pub at: Span,
    /// All that declares it.
    pub whole: Span,
    /// The link to which it belongs.
    pub owner: Option<String>,
}

/// The names of a text.
#[derive(Clone, Debug, Default)]
pub struct Names {
    /// By the place of the name in its declaration.
    declared: IndexMap<Span, Declaration>,
    /// The declarations that a use leads to, by the place of the use.
    uses: IndexMap<Span, Vec<Span>>,
}

impl Names {
    pub(super) fn of(text: &str, tokens: &[Token], document: &Document, uses: &[Use]) -> Self {
        let mut names = Self::default();
        symbols(document).iter().for_each(|symbol| names.declare(symbol, None));
        names.declare_columns(document);
        for Use { at, of } in uses {
            let Some(declared) = names.declared.get(of) else { continue };
            for place in places(text, tokens, *at, &declared.name) {
                let known = names.uses.entry(place).or_default();
                if place != *of && !known.contains(of) {
                    known.push(*of);
                }
            }
        }
        names.uses.retain(|_, of| !of.is_empty());
        names.uses.sort_unstable_keys();
        names
    }

    fn declare(&mut self, symbol: &Symbol, owner: Option<&str>) {
        let Symbol { name, kind, whole, at, parts } = symbol;
        let owned = Declaration {
            name: name.clone(),
            kind: *kind,
            at: *at,
            whole: *whole,
            owner: owner.map(str::to_owned),
        };
        self.declared.insert(*at, owned);
        parts.iter().for_each(|part| self.declare(part, Some(name)));
    }

    /// Columns of variants declare what no `given` does.
    fn declare_columns(&mut self, document: &Document) {
        let values = self.declared.values().filter(|d| d.owner.is_none()).map(|d| d.name.clone());
        let mut known = values.collect::<IndexSet<_>>();
        for statement in &document.statements {
            let Statement::Variants(table) = &statement.node else { continue };
            for column in &table.columns {
                if known.insert(column.name.node.clone()) {
                    self.declare(&Symbol::new(&column.name, SymbolKind::Derived, column.name.span), None);
                }
            }
        }
    }

    /// All declarations, in the order of the text.
    pub fn declared(&self) -> impl Iterator<Item = &Declaration> {
        self.declared.values()
    }

    /// All uses, in the order of the text, each with what it leads to.
    pub fn uses(&self) -> impl Iterator<Item = (Span, &[Span])> {
        self.uses.iter().map(|(at, of)| (*at, of.as_slice()))
    }

    /// The name at a byte, or directly before it.
    #[must_use]
    pub fn at(&self, byte: usize) -> Option<Span> {
        let places = || self.uses.keys().chain(self.declared.keys());
        let inside = |span: &&Span| span.start <= byte && byte < span.end;
        let touching = |span: &&Span| span.start <= byte && byte <= span.end;
        places().find(inside).or_else(|| places().find(touching)).copied()
    }

    /// What is declared at a place of a name, or what the name leads to there.
    #[must_use]
    pub fn declarations(&self, name: Span) -> Vec<&Declaration> {
        let used = self.uses.get(&name).into_iter().flatten();
        let own = self.declared.get(&name).into_iter();
        own.chain(used.filter_map(|of| self.declared.get(of))).collect()
    }

    /// Whether a name is declared at its place.
    #[must_use]
    pub fn is_declaration(&self, name: Span) -> bool {
        self.declared.contains_key(&name)
    }

    /// Where what a name stands for is declared and used.
    #[must_use]
    pub fn occurrences(&self, name: Span) -> Vec<Span> {
        let of = self.declarations(name).into_iter().map(|d| d.at).collect::<IndexSet<_>>();
        self.places_of(&of)
    }

    /// Where a name is written, and all that have their meaning by being called alike: a pair and the points that it joins.
    #[must_use]
    pub fn together(&self, name: Span) -> Vec<Span> {
        let mut of = self.declarations(name).into_iter().map(|d| d.at).collect::<IndexSet<_>>();
        let mut next = 0;
        while let Some(&one) = of.get_index(next) {
            next += 1;
            of.extend(self.uses.get(&one).into_iter().flatten().copied());
            for (at, leads_to) in self.uses.iter().filter(|(_, leads_to)| leads_to.contains(&one)) {
                of.extend(leads_to.iter().copied());
                of.extend(self.declared.get(at).map(|d| d.at));
            }
        }
        self.places_of(&of)
    }

    fn places_of(&self, declared: &IndexSet<Span>) -> Vec<Span> {
        let used = self.uses.iter().filter(|(_, of)| of.iter().any(|of| declared.contains(of)));
        let mut all = used.map(|(at, _)| *at).chain(declared.iter().copied()).collect::<Vec<_>>();
        all.sort_unstable();
        all.dedup();
        all
    }
}

/// Where a name is within a place: the word itself; in a text or a comment each time in braces.
fn places(text: &str, tokens: &[Token], at: Span, name: &str) -> Vec<Span> {
    if text.get(at.start..at.end).is_some_and(|written| is_name(written, name)) {
        return vec![at];
    }
    let first = tokens.partition_point(|token| token.span.end <= at.start);
    let within = tokens[first..].iter().take_while(|token| token.span.start < at.end);
    for token in within {
        let written = token.text(text);
        match token.kind {
            TokenKind::Word if is_name(written, name) => return vec![token.span],
            TokenKind::Text | TokenKind::Comment => return in_braces(written, token.span.start, name),
            _ => {}
        }
    }
    Vec::new()
}

/// Whether a word is written for a name, which is in NFC.
fn is_name(written: &str, name: &str) -> bool {
    written == name || !written.is_ascii() && written.nfc().eq(name.chars())
}

/// Where a text has `{name}`.
fn in_braces(text: &str, start: usize, name: &str) -> Vec<Span> {
    let opened = text.match_indices('{').filter_map(|(open, _)| {
        let inside = text.get(open + 1..)?.split_once('}')?.0;
        let word = inside.trim();
        let from = start + open + 1 + (inside.len() - inside.trim_start().len());
        is_name(word, name).then(|| Span::new(from, from + word.len()))
    });
    opened.collect()
}
