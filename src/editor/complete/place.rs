//! A place in a text: the statement it is in, and the braces and calls around it.

use super::super::Analysis;
use super::{Completion, CompletionKind};
use assur_syntax::{Token, TokenKind, parse_with_tokens};
use assur_text::language::{Dimension, FUNCTIONS, Function, PROPERTIES, PropertyValue, SHAPES, UNITS, WORDS};
use assur_text::source::{Source, Span};
use assur_text::units::{Unit, lookup};
use indexmap::{IndexMap, IndexSet};
use std::fmt::Write;
use std::sync::LazyLock;

/// What is before a place.
pub struct Place<'a> {
    text: &'a str,
    tokens: &'a [Token],
    /// The kind of the token before it, on the same line.
    pub before: Option<TokenKind>,
    /// The first token of the statement or member.
    head: Option<usize>,
    /// The first tokens of the statements in whose braces it is, from outside.
    around: Vec<Option<usize>>,
    /// The functions in whose brackets it is, from outside, each with the number of arguments before it.
    calls: Vec<(Option<usize>, usize)>,
}

impl<'a> Place<'a> {
    /// That of a byte between tokens.
    pub fn of(analysis: &'a Analysis, byte: usize) -> Self {
        let count = analysis.tokens.partition_point(|token| token.span.end <= byte);
        let tokens = &analysis.tokens[..count];
        let text = &analysis.source.text;
        let mut place =
            Self { text, tokens, before: None, head: None, around: Vec::new(), calls: Vec::new() };
        tokens.iter().enumerate().for_each(|(index, token)| place.pass(index, *token));
        place
    }

    fn pass(&mut self, index: usize, token: Token) {
        match token.kind {
            TokenKind::Newline | TokenKind::Semicolon => {
                let goes_on = matches!(
                    self.before,
                    Some(TokenKind::Comma | TokenKind::Infix | TokenKind::Colon | TokenKind::Hyphen)
                );
                if goes_on {
                    return;
                }
                (self.head, self.before) = (None, None);
                self.calls.clear();
                return;
            }
            TokenKind::Comment => return,
            TokenKind::Brace => {
                self.around.push(self.head.take());
                self.calls.clear();
            }
            TokenKind::BraceEnd => self.head = self.around.pop().flatten(),
            TokenKind::Open | TokenKind::Call => {
                // in a line that does not read yet no bracket is known to be that of a call
                let touches = |word: &usize| {
                    let word = self.tokens[*word];
                    word.kind == TokenKind::Word && word.span.end == token.span.start
                };
                self.calls.push((index.checked_sub(1).filter(touches), 0));
            }
            TokenKind::Close => _ = self.calls.pop(),
            TokenKind::Comma => self.calls.iter_mut().last().into_iter().for_each(|call| call.1 += 1),
            _ => {}
        }
        if self.head.is_none() && !matches!(token.kind, TokenKind::Brace) {
            self.head = Some(index);
        }
        self.before = Some(token.kind);
    }

    /// Whether a statement or a member begins here.
    pub fn begins(&self) -> bool {
        self.head.is_none()
    }

    fn word(&self, index: Option<usize>) -> &'a str {
        index.and_then(|index| self.tokens.get(index)).map_or("", |token| token.text(self.text))
    }

    /// The first word of the statement or member.
    pub fn head(&self) -> &'a str {
        self.word(self.head)
    }

    /// The first word of the statement in whose braces this is.
    pub fn body(&self) -> &'a str {
        self.around.last().map_or("", |head| self.word(*head))
    }

    /// The link in whose braces this is.
    pub fn link(&self) -> Option<&'a str> {
        let head = (*self.around.last()?)?;
        if self.word(Some(head)) == "ground" {
            return Some("ground");
        }
        // a number may come before the name
        let words = self.tokens[head + 1..].iter().filter(|token| token.kind == TokenKind::Word);
        words.map(|token| token.text(self.text)).next()
    }

    /// The `n`th token before the place, as it is written; the last one is the first.
    pub fn back(&self, n: usize) -> &'a str {
        let before = self.tokens.iter().rev().filter(|token| token.kind != TokenKind::Comment);
        before.skip(n - 1).map(|token| token.text(self.text)).next().unwrap_or_default()
    }

    /// The line of the first word of the statement.
    pub fn line(&self) -> Span {
        let start =
            self.head.and_then(|head| self.tokens.get(head)).map_or(self.text.len(), |t| t.span.start);
        let end = self.text[start..].find('\n').map_or(self.text.len(), |length| start + length);
        Span::new(start, end)
    }

    /// The words of the statement so far.
    pub fn words(&self) -> impl Iterator<Item = &'a str> {
        let from = self.head.unwrap_or(self.tokens.len());
        self.tokens[from..].iter().map(|token| token.text(self.text))
    }

    /// The innermost function in whose brackets this is, with the number of arguments before it.
    pub fn call(&self) -> Option<(&'a str, usize)> {
        let (name, count) = self.calls.iter().rev().find(|(name, _)| name.is_some())?;
        Some((self.word(*name), *count))
    }
}

// Examples of the tables as texts with places to fill.

/// All examples of the tables, made once.
static ALL: LazyLock<IndexMap<&'static str, String>> = LazyLock::new(|| {
    let words = WORDS.iter().flat_map(|(_, all)| all.iter()).map(|row| row.example);
    let properties = PROPERTIES.iter().flat_map(|(_, all)| all.iter()).map(|row| row.example);
    let functions = FUNCTIONS.iter().map(|row| row.usage);
    words.chain(properties).chain(functions).map(|example| (example, made(example))).collect()
});

/// An example of the tables whose names and numbers are places to fill.
pub fn of(example: &str) -> String {
    ALL.get(example).cloned().unwrap_or_else(|| example.to_owned())
}

fn made(example: &str) -> String {
    // the tables have a sentence in place of rows
    if let Some((before, _)) = example.split_once("{ then ") {
        return format!("{}{{\n\t$0\n}}", made(before));
    }
    let (_, tokens, _) = parse_with_tokens(&Source::new("", example));
    let (mut out, mut end, mut places) = (String::new(), 0, 0);
    for (index, token) in tokens.iter().enumerate() {
        out.push_str(&escaped(example.get(end..token.span.start).unwrap_or_default()));
        let text = token.text(example);
        // a rod or a disc is mostly the name of a link
        let is_shape = SHAPES.iter().any(|row| row.word == text);
        let is_word = if is_shape { example.starts_with("mass ") } else { is_word(text) };
        let is_name = token.kind == TokenKind::Word && index > 0 && !is_word;
        if is_name || token.kind == TokenKind::Number {
            places += 1;
            // writing to a text cannot fail
            _ = write!(out, "${{{places}:{}}}", escaped(text));
        } else {
            out.push_str(&escaped(text));
        }
        end = token.span.end;
    }
    out + &escaped(example.get(end..).unwrap_or_default())
}

fn is_word(text: &str) -> bool {
    let is_property = || PROPERTIES.iter().flat_map(|(_, all)| all.iter()).any(|p| p.name == text);
    WORDS.iter().flat_map(|(_, all)| all.iter()).any(|row| row.word == text)
        || Function::named(text).is_some()
        || is_property()
}

fn escaped(text: &str) -> String {
    text.replace('\\', "\\\\").replace('$', "\\$").replace('}', "\\}")
}

// Units after a number.

/// The units that fit; all where the place does not tell.
pub fn offered(analysis: &Analysis, place: &Place<'_>) -> Vec<Completion> {
    let wanted = wanted(place);
    let own = analysis.tokens.iter().filter(|t| t.kind == TokenKind::Unit);
    let own = own.map(|t| t.text(&analysis.source.text));
    let all = own.chain(KNOWN.iter().map(String::as_str)).collect::<IndexSet<_>>().into_iter();
    let fitting = all.filter_map(|text| {
        let unit = lookup(text).ok()?;
        let fits = wanted.is_none_or(|wanted| unit.dimension.fits(wanted));
        let means = unit.dimension.name().unwrap_or_default();
        fits.then(|| Completion::plain(text, CompletionKind::Unit, means))
    });
    fitting.collect()
}

/// Other units of the dimension of one, each with its factor.
pub fn alike(own: &Unit) -> Vec<(&'static str, f64)> {
    let mut found: Vec<(&str, f64)> = Vec::new();
    for text in KNOWN.iter() {
        let Ok(unit) = lookup(text) else { continue };
        let is_new = unit.factor != own.factor && found.iter().all(|(_, factor)| *factor != unit.factor);
        if is_new && unit.dimension == own.dimension {
            found.push((text, unit.factor));
        }
    }
    found
}

/// Units of one word, and those of several as the tables of the language use them.
static KNOWN: LazyLock<Vec<String>> = LazyLock::new(|| {
    let words = WORDS.iter().flat_map(|(_, all)| all.iter()).map(|row| row.example);
    let properties = PROPERTIES.iter().flat_map(|(_, all)| all.iter()).map(|row| row.example);
    let lines =
        words.map(str::to_owned).chain(properties.map(|example| format!("brake M on d {{ {example} }}")));
    let text = lines.collect::<Vec<_>>().join("\n");
    let (_, tokens, _) = parse_with_tokens(&Source::new("", &*text));
    let of_examples = tokens.iter().filter(|t| t.kind == TokenKind::Unit).map(|t| t.text(&text).to_owned());
    UNITS.iter().map(|unit| unit.text.to_owned()).chain(of_examples).collect()
});

/// What the place takes, where the tables say so.
fn wanted(place: &Place<'_>) -> Option<Dimension> {
    let tables = PROPERTIES.iter().filter(|(word, _)| word.split(' ').next() == Some(place.body()));
    let property = tables.flat_map(|(_, all)| all.iter()).find(|row| row.name == place.head());
    if let Some(row) = property {
        return match row.takes {
            PropertyValue::Any(d)
            | PropertyValue::Positive(d)
            | PropertyValue::NotNegative(d)
            | PropertyValue::Two(d)
            | PropertyValue::Word(_, d) => Some(d),
            PropertyValue::Flag | PropertyValue::FlagOr(_) | PropertyValue::Block(_) => None,
        };
    }
    match (place.body(), place.head(), place.words().any(|word| word == "=")) {
        (_, "mass", _) => Some(Dimension::MASS),
        (_, "weight", _) | ("", "force", true) => Some(Dimension::FORCE),
        (_, "inertia", _) => Some(Dimension::INERTIA),
        ("", "torque", true) => Some(Dimension::TORQUE),
        ("", "gravity", _) => Some(Dimension::ACCELERATION),
        ("", "link", _) | ("ground" | "link", ..) if place.words().all(|word| word != "along") => {
            Some(Dimension::LENGTH)
        }
        ("ground" | "link", ..) => Some(Dimension::ANGLE),
        _ => None,
    }
}
