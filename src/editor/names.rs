//! Names of a text: where each is declared and used.

use super::Analysis;
use super::symbols::{Symbol, SymbolKind, symbols};
use assur_check::Use;
use assur_syntax::document::{Document, Statement};
use assur_syntax::{Token, TokenKind, is_reserved};
use assur_text::diagnostic::Problem;
use assur_text::source::{Edit, Source, Span, edited};
use indexmap::{IndexMap, IndexSet};
use miette::Severity;
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

// Other names: all places of a name that change with it, and whether the meaning stays.

impl Analysis {
    /// The name at a byte, if it can have another one; else why not.
    ///
    /// # Errors
    ///
    /// A word of the language, or nothing that has a name.
    pub fn renamable(&self, byte: usize) -> Result<Span, String> {
        let name = self.names.at(byte).filter(|name| !self.names.declarations(*name).is_empty());
        let name = name.ok_or_else(|| "there is no name here".to_owned())?;
        if self.written(name) == "ground" {
            return Err("`ground` is a keyword".to_owned());
        }
        Ok(name)
    }

    /// The edits that give the name at a byte another one, everywhere. A name that joins others gives it to them too: a pair
    /// to the points that are found by its name.
    ///
    /// # Errors
    ///
    /// What the text with the new name would be wrong with, or that it would mean something else.
    pub fn rename(&self, byte: usize, name: &str) -> Result<Vec<Edit>, String> {
        let places = self.names.together(self.renamable(byte)?);
        if is_reserved(name) {
            return Err(format!("`{name}` is a keyword and cannot be a name"));
        }
        let edits = places.into_iter().map(|at| Edit::new(at, name)).collect::<Vec<_>>();
        let after = Self::of(Source::new(&*self.source.name, edited(&self.source.text, &edits)));
        if let Some(problem) = self.new_error(&after) {
            return Err(problem.to_string());
        }
        if !is_moved(&self.names, &after.names, &edits) {
            return Err(format!("`{name}` would mean something else in this file"));
        }
        Ok(edits)
    }

    /// What is written in a place.
    pub(super) fn written(&self, at: Span) -> &str {
        self.source.text.get(at.start..at.end).unwrap_or_default()
    }

    /// An error of another text of which this one has fewer.
    fn new_error<'a>(&self, after: &'a Self) -> Option<&'a dyn Problem> {
        let mut known = IndexMap::<_, usize>::new();
        errors(self).for_each(|problem| *known.entry(code(problem)).or_default() += 1);
        errors(after).find(|problem| match known.get_mut(&code(*problem)) {
            Some(left) if *left > 0 => {
                *left -= 1;
                false
            }
            _ => true,
        })
    }
}

fn errors(analysis: &Analysis) -> impl Iterator<Item = &dyn Problem> {
    let all = analysis.problems.sorted().into_iter();
    all.filter(|problem| problem.severity().is_none_or(|severity| severity == Severity::Error))
}

fn code(problem: &dyn Problem) -> Option<String> {
    problem.code().map(|code| code.to_string())
}

/// Whether all names are used and declared where they were, each place moved as the edits move it.
fn is_moved(before: &Names, after: &Names, edits: &[Edit]) -> bool {
    let moved = |at: Span| {
        let grown = |edit: &Edit| edit.with.len() as isize - (edit.span.end - edit.span.start) as isize;
        let shift = edits.iter().filter(|e| e.span.start < at.start).map(grown).sum::<isize>();
        let own = edits.iter().filter(|e| e.span == at).map(grown).sum::<isize>();
        Span::new(at.start.saturating_add_signed(shift), at.end.saturating_add_signed(shift + own))
    };
    let declared = before.declared().map(|d| moved(d.at)).eq(after.declared().map(|d| d.at));
    let uses = before.uses().map(|(at, of)| (moved(at), of.iter().map(|of| moved(*of)).collect::<Vec<_>>()));
    declared && uses.eq(after.uses().map(|(at, of)| (at, of.to_vec())))
}
