//! A piece of text that no rule read.

use super::phrase::What;
use crate::prepare::whole_end;
use crate::recover::instead;
use crate::trivia::corrected;
use crate::words::{self, Grammar, Rule, is_name_char, is_reserved};
use assur_text::diagnostic::{Diagnosis, Help};
use assur_text::source::Span;
use pest::Parser;
use pest::error::{ErrorVariant, InputLocation};

/// A piece of text, and where and why reading it alone fails.
#[derive(Clone)]
pub(super) struct Case<'a> {
    pub(super) text: &'a str,
    pub(super) slice: &'a str,
    /// Where the piece begins in the text.
    pub(super) offset: usize,
    /// What it should be.
    pub(super) what: What,
    /// Where in the piece reading stopped: the first byte that fits nothing.
    pub(super) fail: usize,
    /// What would have fitted there.
    pub(super) expected: Vec<Rule>,
    /// A repair need not make the piece read: it is enough that reading comes further.
    on_the_way: bool,
}

impl<'a> Case<'a> {
    pub(super) fn new(text: &'a str, slice: &'a str, offset: usize, what: What) -> Self {
        let mut case =
            Self { text, slice, offset, what, fail: slice.len(), expected: Vec::new(), on_the_way: false };
        if let Err(error) = Grammar::parse(what.rule(), slice) {
            case.fail = place(&error).min(slice.len());
            if let ErrorVariant::ParsingError { positives, .. } = error.variant {
                case.expected = positives;
            }
        }
        case
    }

    /// The same piece, which is repaired by one mistake of several.
    pub(super) fn on_the_way(&self) -> Self {
        Self { on_the_way: true, ..self.clone() }
    }

    /// Whether a text reads as what this should be. What begins with the word of a member stays one: it is not corrected
    /// to a point of that name.
    pub(super) fn reads(&self, text: &str) -> bool {
        if self.on_the_way {
            return text.len().saturating_sub(self.fail_of(text)) < self.slice.len() - self.fail;
        }
        let Ok(mut pairs) = Grammar::parse(self.what.rule(), text) else { return false };
        let word = self.token(0);
        let begins = self.what == What::Member && words::is_member(word) && text.starts_with(word);
        let mut point = || pairs.next().and_then(|whole| whole.into_inner().next());
        !begins || point().is_none_or(|member| member.as_rule() != Rule::m_point)
    }

    /// Where reading a text as what this should be stops.
    pub(super) fn fail_of(&self, text: &str) -> usize {
        Grammar::parse(self.what.rule(), text).err().map_or(text.len(), |error| place(&error))
    }

    /// The piece with a part replaced.
    pub(super) fn with(&self, start: usize, end: usize, new: &str) -> String {
        let part = |range: Option<&'a str>| range.unwrap_or_default();
        format!("{}{new}{}", part(self.slice.get(..start)), part(self.slice.get(end..)))
    }

    /// The author's lines with a part of the piece replaced, as a help.
    pub(super) fn help(&self, start: usize, end: usize, new: &str) -> Help {
        corrected(self.text, self.span(start, end - start), new)
    }

    /// The place of some bytes of the piece.
    pub(super) fn span(&self, start: usize, length: usize) -> Span {
        Span::new(self.offset + start, self.offset + whole_end(self.slice, start + length))
    }

    /// The word or the sign at a byte; empty at the end.
    pub(super) fn token(&self, at: usize) -> &'a str {
        let rest = self.slice.get(at..).unwrap_or_default();
        let name = rest.find(|c| !is_name_char(c)).unwrap_or(rest.len());
        let sign = rest.chars().next().map_or(0, char::len_utf8);
        if rest.starts_with(char::is_whitespace) { "" } else { &rest[..name.max(sign)] }
    }

    /// Every word with its first byte, outside texts and comments.
    pub(super) fn words(&self) -> Vec<(usize, &'a str)> {
        let mut found = Vec::new();
        let mut start = 0;
        for line in self.slice.split_inclusive('\n') {
            let code = line.split_once("//").map_or(line, |(code, _)| code);
            let mut from = None;
            let ends = code.char_indices().chain(std::iter::once((code.len(), ' ')));
            let mut quoted = false;
            for (at, c) in ends {
                quoted ^= c == '"';
                match (from, is_name_char(c) && !quoted) {
                    (None, true) => from = Some(at),
                    (Some(first), false) => {
                        found.push((start + first, &code[first..at]));
                        from = None;
                    }
                    _ => {}
                }
            }
            start += line.len();
        }
        found
    }

    /// The words and signs that would have fitted where reading stopped.
    pub(super) fn literals(&self) -> Vec<String> {
        let mut found = Vec::new();
        for expected in self.expected.iter().flat_map(|rule| words::expected(*rule)) {
            if let words::Expected::Literal(word) = expected {
                found.push(word);
            }
        }
        found.sort();
        found.dedup();
        found
    }

    /// What is to be written in a place, if the text reads with it: `new` as written, `wanted` as it is called.
    pub fn instead(&self, (start, end): (usize, usize), new: &str, wanted: &str) -> Option<Diagnosis> {
        let found = self.slice.get(start..end).unwrap_or_default().trim();
        let reads = self.reads(&self.with(start, end, new));
        reads.then(|| instead(found, wanted, self.span(start, end - start), self.help(start, end, new)))
    }
}

/// The first byte that fits nothing.
fn place(error: &pest::error::Error<Rule>) -> usize {
    match error.location {
        InputLocation::Pos(at) | InputLocation::Span((at, _)) => at,
    }
}

// Names in two pieces: with a hyphen, or with a blank.

/// `left-arm`, `right arm`: the pieces joined by `_`.
pub(super) fn explain(case: &Case<'_>) -> Option<Diagnosis> {
    let words = case.words();
    let near = words.windows(2).filter(|pair| pair[0].0 <= case.fail);
    near.rev().take(4).find_map(|pair| joined(case, pair[0], pair[1]))
}

fn joined(case: &Case<'_>, first: (usize, &str), second: (usize, &str)) -> Option<Diagnosis> {
    let (start, end) = (first.0, second.0 + second.1.len());
    let between = case.slice.get(start + first.1.len()..second.0)?;
    let wanted = format!("{}_{}", first.1, second.1);
    let hyphen = between.trim() == "-";
    // the first word is that of the statement
    let names = start > 0 && first.1.starts_with(char::is_alphabetic) && !is_reserved(first.1);
    let apart = hyphen || (!between.is_empty() && between.bytes().all(|b| b == b' '));
    if !names || !apart || !(declares(case, start) && hyphen || stands_elsewhere(case, &wanted)) {
        return None;
    }
    case.instead((start, end), &wanted, &wanted)
}

/// Whether the piece declares what it names there: a name follows the word of the statement, or the number of a link.
fn declares(case: &Case<'_>, start: usize) -> bool {
    let before = case.slice.get(..start).unwrap_or_default();
    let mut words = before.split_whitespace().skip(1);
    words.all(|word| word.bytes().all(|b| b.is_ascii_digit()))
}

/// Whether the text has a name outside the piece.
fn stands_elsewhere(case: &Case<'_>, name: &str) -> bool {
    let end = case.offset + case.slice.len();
    let parts = [case.text.get(..case.offset), case.text.get(end..)];
    parts.into_iter().flatten().any(|part| part.split(|c| !is_name_char(c)).any(|word| word == name))
}
