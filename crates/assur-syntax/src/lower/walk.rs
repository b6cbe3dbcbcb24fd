//! Walking over pest's pairs.

use crate::document::Name;
use crate::prepare::{FILL, whole_end};
use crate::words::Rule;
use assur_text::source::{Span, Spanned};
use pest::iterators::{Pair, Pairs};
use std::iter::Peekable;
use unicode_normalization::UnicodeNormalization;

/// A pair of the grammar.
pub(super) type P<'i> = Pair<'i, Rule>;

/// The parts of a pair, without punctuation and without slips that were corrected.
pub(super) struct Parts<'i> {
    pairs: Peekable<Pairs<'i, Rule>>,
}

impl<'i> Parts<'i> {
    pub(super) fn of(pair: P<'i>) -> Self {
        Self { pairs: pair.into_inner().peekable() }
    }

    fn skip(&mut self) {
        while self.pairs.peek().is_some_and(|p| is_plumbing(p.as_rule())) {
            self.pairs.next();
        }
    }

    pub(super) fn any(&mut self) -> Option<P<'i>> {
        self.skip();
        self.pairs.next()
    }

    /// The rule of the next part.
    pub(super) fn peek(&mut self) -> Option<Rule> {
        self.skip();
        self.pairs.peek().map(Pair::as_rule)
    }

    /// Whether the next part is of that rule and reads so.
    pub(super) fn is(&mut self, rule: Rule, text: &str) -> bool {
        self.skip();
        self.pairs.peek().is_some_and(|p| p.as_rule() == rule && p.as_str() == text)
    }

    /// What the next part is read as, if it is of that rule.
    pub(super) fn take_as<T>(&mut self, rule: Rule, read: impl Fn(&str) -> Option<T>) -> Option<Spanned<T>> {
        self.skip();
        let pair = self.pairs.peek().filter(|p| p.as_rule() == rule)?;
        let found = Spanned::new(read(pair.as_str())?, span(pair));
        self.pairs.next();
        Some(found)
    }

    /// The next part, if it is of that rule.
    pub(super) fn take(&mut self, rule: Rule) -> Option<P<'i>> {
        self.skip();
        self.pairs.next_if(|p| p.as_rule() == rule)
    }

    /// Passes over a word; says whether it stood there.
    pub(super) fn word(&mut self, rule: Rule) -> bool {
        self.take(rule).is_some()
    }

    /// The next part, if it is a name.
    pub(super) fn name(&mut self) -> Option<Name> {
        self.take(Rule::ident).map(|p| name(&p))
    }

    /// The name after a word, if the word stands there.
    pub(super) fn name_behind(&mut self, word: Rule) -> Option<Name> {
        if self.word(word) { self.name() } else { None }
    }
}

/// Punctuation says nothing that the rules do not say; slips are reported by a pass of their own.
fn is_plumbing(rule: Rule) -> bool {
    matches!(
        rule,
        Rule::p_dot
            | Rule::p_dots
            | Rule::p_comma
            | Rule::p_dash
            | Rule::p_close
            | Rule::p_equals
            | Rule::p_colon
            | Rule::p_brace
            | Rule::p_end
            | Rule::lenient_colon_for_equals
            | Rule::lenient_equals_for_colon
            | Rule::lenient_late_brace
            | Rule::lenient_missing_brace
            | Rule::EOI
    )
}

/// Where a pair stands, without the blanks that pest leaves at its end.
pub(super) fn span(pair: &P<'_>) -> Span {
    let at = pair.as_span();
    let blank = |c| matches!(c, ' ' | '\n' | FILL);
    let end = at.start() + at.as_str().trim_end_matches(blank).len();
    if at.as_str().ends_with(';') {
        // A body without its closing brace may hold separators at its end.
        return Span::new(at.start(), end_of_last(pair));
    }
    Span::new(at.start(), whole_end(pair.get_input(), end))
}

/// The end of the last pair within a pair.
fn end_of_last(pair: &P<'_>) -> usize {
    let mut last = pair.clone();
    loop {
        let inner = last.clone().into_inner().rev().find(|p| p.as_rule() != Rule::lenient_missing_brace);
        match inner {
            Some(inner) => last = inner,
            None => return whole_end(pair.get_input(), last.as_span().end()),
        }
    }
}

/// The name that an atomic pair holds, in NFC.
pub(super) fn name(pair: &P<'_>) -> Name {
    Spanned::new(nfc(pair.as_str()), span(pair))
}

/// A text in NFC.
pub(super) fn nfc(text: &str) -> String {
    if text.is_ascii() { text.to_owned() } else { text.nfc().collect() }
}

/// The text of an atomic pair.
pub(super) fn text(pair: &P<'_>) -> Spanned<String> {
    Spanned::new(pair.as_str().to_owned(), span(pair))
}
