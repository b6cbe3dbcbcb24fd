//! What the error productions caught: read again alone to learn where it fails, and corrected on trial to learn how.
//!
//! A repair is proposed only if the corrected text reads.

mod brackets;
mod case;
mod commas;
mod first_word;
mod foreign;
mod harmonic;
mod meant;
mod of_pair;
mod phrase;
mod range;
mod separator;
mod several;
mod swap;
mod unnamed;
mod within;

pub(super) use phrase::What;

use super::document::{Bad, Name};
use super::trivia::{Line, corrected};
use super::words::{self, Expected, is_name_char, is_reserved};
use assur_text::diagnostic::{Diagnosis, Help, Problems, did_you_mean};
use assur_text::language::{Place, words_of};
use assur_text::source::Span;
use case::Case;
use std::collections::BTreeSet;
use unicode_normalization::UnicodeNormalization;

/// The mistakes of a file that are looked into: repairs are tried, which takes time, and nobody reads more.
const EXPLAINED: usize = 200;

/// The correction, if it reads.
fn explain(case: &Case<'_>) -> Option<Diagnosis> {
    foreign::comment_of_semicolon(case)
        .or_else(|| foreign::adjective(case))
        .or_else(|| first_word::explain(case))
        .or_else(|| unnamed::explain(case))
        .or_else(|| within::equals_of_expect(case))
        .or_else(|| foreign::explain(case))
        .or_else(|| commas::explain(case))
        .or_else(|| separator::statements(case))
        .or_else(|| range::explain(case))
        .or_else(|| swap::of_without_brackets(case))
        .or_else(|| of_pair::explain(case))
        .or_else(|| meant::explain(case))
        .or_else(|| case::explain(case))
        .or_else(|| phrase::explain(case))
        .or_else(|| within::explain(case))
        .or_else(|| separator::members(case))
        .or_else(|| brackets::explain(case))
        .or_else(|| swap::explain(case))
        .or_else(|| separator::explain(case))
        .or_else(|| within::missing(case))
        .or_else(|| several::explain(case))
}

/// Reports the text at `at`, and collects the names in it.
pub(super) fn report(
    text: &str,
    read: &str,
    at: Span,
    what: What,
    problems: &mut Problems,
    reserved: &mut BTreeSet<String>,
) -> Bad {
    let slice = read.get(at.start..at.end).unwrap_or_default();
    let mut names = names(slice);
    if !slice.trim().is_empty() && !cut_off(text, read, at) {
        let case = Case::new(text, slice, at.start, what);
        let found = if problems.len() < EXPLAINED { explain(&case) } else { None };
        let found = found.unwrap_or_else(|| unexpected(&case));
        // A name that cannot be one is reported where it stands first.
        let word = found.subject().unwrap_or_default();
        let again = found.is("mech::syntax::reserved_name") && !reserved.insert(word.to_owned());
        // `left-arm` declares `left_arm`
        if found.is("mech::syntax::other_word") || found.is("mech::syntax::missing_word") {
            names.extend(self::names(word));
        }
        if !again {
            problems.push(found);
        }
    }
    Bad { names }
}

/// Whether the rest of the line was blanked out, which has been reported.
fn cut_off(text: &str, read: &str, at: Span) -> bool {
    let end = Line::around(text, at.end).end;
    let rest = |text: &str| text.get(at.end..end).unwrap_or_default().trim().to_owned();
    let lost = rest(text);
    let comment = ["//", "#", "/*"].into_iter().any(|sign| lost.starts_with(sign));
    rest(read).is_empty() && !lost.is_empty() && !comment
}

/// A pair of the grammar that has not the shape it promises.
pub(super) fn unreadable(at: Span) -> Diagnosis {
    Diagnosis::error("mech::syntax::unexpected", "cannot read this: it is too long or too deeply nested")
        .label(at, "from here")
}

/// `S 21 N` in a body: a misspelt word, or a point without coordinates.
pub(super) fn point_without_coordinates(text: &str, name: &Name, at: Span) -> Diagnosis {
    match did_you_mean(&name.node, words_of(Place::Member)).first() {
        Some(wanted) => misspelling(&name.node, name.span, wanted, Some(corrected(text, name.span, wanted))),
        None => match letter_of_mass(text, name) {
            Some(wanted) => {
                misspelling(&name.node, name.span, wanted, Some(corrected(text, name.span, wanted)))
            }
            None => without_coordinates(&name.node, at),
        },
    }
}

/// `J 0.04 kg*m^2`: the word for a letter, by the unit after it.
fn letter_of_mass(text: &str, name: &Name) -> Option<&'static str> {
    let line = Line::around(text, name.span.end);
    let rest = text.get(name.span.end..line.end)?.split([';', '}', '/']).next()?.trim();
    let unit = rest.trim_start_matches(|c: char| c.is_ascii_digit() || matches!(c, '.' | ' ' | 'e' | '-'));
    let first = unit.split(' ').next()?;
    match (name.node.as_str(), first) {
        ("J" | "I" | "Theta" | "moment_of_inertia", "kg*m^2" | "kg" | "g*mm^2" | "kg*mm^2" | "kg*cm^2") => {
            Some("inertia")
        }
        ("m" | "M", "kg" | "g" | "t") => Some("mass"),
        ("G" | "W" | "Q", "N" | "kN") => Some("weight"),
        _ => None,
    }
}

fn without_coordinates(name: &str, at: Span) -> Diagnosis {
    let help = format!("give its coordinates, as in: {name} (100 mm, 20 mm)");
    Diagnosis::error("mech::syntax::point_without_coordinates", "a point needs its coordinates")
        .label(at, "`(x, y)` is missing")
        .help(help)
}

/// The message if no repair helps.
fn unexpected(case: &Case<'_>) -> Diagnosis {
    let alone = case.slice.chars().all(is_name_char) && !words::is_member(case.slice);
    if case.what == What::Member && alone && case.reads(&format!("{} (0, 0)", case.slice)) {
        return without_coordinates(case.slice, case.span(0, case.slice.len()));
    }
    let token = case.token(case.fail);
    let found = if token.is_empty() { "the line ends here".to_owned() } else { format!("found `{token}`") };
    let first = case.token(0);
    let what = match case.what {
        What::Statement if words::is_statement(first) => format!("this `{first}`"),
        What::Statement => "this statement".to_owned(),
        What::Member if words::is_member(first) => format!("this `{first}`"),
        What::Member => "this member".to_owned(),
        What::CamMember => "this part of the cam".to_owned(),
        What::Property => "this property".to_owned(),
        What::Header => "this header".to_owned(),
        What::Row => "this row".to_owned(),
    };
    let expected = case.expected.iter().flat_map(|r| words::expected(*r)).collect::<Vec<Expected>>();
    let at = case.span(case.fail, token.len());
    let help = match case.what {
        What::Header | What::Row => Some(
            "write the header and each row on a separate line: names with units, then plain numbers".into(),
        ),
        _ if first == "link" && token.is_empty() && case.slice.contains('-') && !case.slice.contains('{') => {
            Some(format!("give its length, as in: {} 100 mm", case.slice.trim()).into())
        }
        _ if case.slice.trim() == "gravity" => Some(case.help(0, case.slice.len(), "gravity 9.81 m/s^2")),
        _ => help(first).map(Help::from),
    };
    Diagnosis::error("mech::syntax::unexpected", format!("cannot read {what}: {}", words::list(expected)))
        .label(at, found)
        .help_if(help)
}

/// The shape of a statement that could not be read.
fn help(word: &str) -> Option<String> {
    let shape = words::example(word)?;
    Some(format!("for example: {shape}"))
}

/// Every word that may be a name.
pub(super) fn names(slice: &str) -> Vec<String> {
    let mut found = Vec::<String>::new();
    for line in slice.lines() {
        let code = line.split_once("//").map_or(line, |(code, _)| code);
        for word in code.split(|c| !is_name_char(c)) {
            let starts_well = word.chars().next().is_some_and(char::is_alphabetic);
            if starts_well && !is_reserved(word) {
                found.push(word.nfc().collect());
            }
        }
    }
    found.sort();
    found.dedup();
    found
}

pub fn comment_sign(at: Span, found: &str, help: Help) -> Diagnosis {
    Diagnosis::error("mech::syntax::comment_sign", "a comment begins with `//`")
        .label(at, format!("`{found}` does not start a comment; use `//`"))
        .help(help.certain())
}

pub fn instead(found: &str, wanted: &str, at: Span, help: Help) -> Diagnosis {
    Diagnosis::error("mech::syntax::other_word", format!("`{wanted}` is expected instead of `{found}`"))
        .label(at, format!("`{wanted}` instead of this"))
        .help(help)
        .about(wanted)
}

pub fn needless_word(found: &str, at: Span, help: Help) -> Diagnosis {
    Diagnosis::error("mech::syntax::needless_sign", format!("unexpected `{found}`"))
        .label(at, "leave this out")
        .help(help.certain())
}

/// A blank within a unit, and what may be meant.
pub fn broken_unit(at: Span, mut helps: Vec<Help>) -> Diagnosis {
    let help = if helps.len() > 1 { Some(Help::one_of(helps)) } else { helps.pop() };
    Diagnosis::error("mech::syntax::broken_unit", "a unit is written without blanks")
        .label(at, "a blank within it")
        .help_if(help)
}

/// `at` is a value with its tolerance, and `alone` the value without.
pub fn tolerance(text: &str, sign: Span, at: Span, alone: &str) -> Diagnosis {
    let found = text.get(sign.start..sign.end).unwrap_or_default();
    let what = if alone.is_empty() { "the value alone".to_owned() } else { format!("`{alone}`") };
    Diagnosis::error("mech::syntax::tolerance", format!("`{found}` is the sign of a tolerance, not of a sum"))
        .label(sign, "a tolerance")
        .help(corrected(text, at, alone).in_words(format!("tolerances are not supported yet: write {what}")))
}

pub fn lacking(missing: &str, at: Span, help: Help) -> Diagnosis {
    Diagnosis::error("mech::syntax::missing_word", format!("`{missing}` is missing"))
        .label(at, "before this")
        .help(help)
        .about(missing)
}

pub fn misspelling(found: &str, at: Span, wanted: &str, help: Option<Help>) -> Diagnosis {
    Diagnosis::error("mech::syntax::misspelt_word", format!("`{found}` is not known here"))
        .label(at, format!("did you mean `{wanted}`?"))
        // `im` may be `in` or `on`
        .help_if(help.map(|help| if wanted.len() > 3 { help.certain() } else { help }))
}

pub fn misplaced(found: &str, at: Span, place: &'static str, help: Help) -> Diagnosis {
    Diagnosis::error("mech::syntax::misplaced_member", format!("`{found}` is not a statement"))
        .label(at, place)
        .help(help)
}

pub fn word_of_the_language(found: &str, at: Span, help: Help) -> Diagnosis {
    Diagnosis::error("mech::syntax::reserved_name", format!("`{found}` is a keyword and cannot be a name"))
        .label(at, "choose another name")
        .help(help)
        .about(found)
}

pub fn without_operator(at: Span, help: Help) -> Diagnosis {
    Diagnosis::error("mech::syntax::missing_operator", "an operator is missing")
        .label(at, "before this")
        .help(help)
}

pub fn unseparated(at: Span, help: Help) -> Diagnosis {
    Diagnosis::error("mech::syntax::two_statements", "two statements or members are not separated")
        .label(at, "a new line, or `;`, before this")
        .help(help)
}

/// A comma within a number: the lines are those that may be meant.
pub fn comma_in_number(at: Span, lines: Vec<Help>) -> Diagnosis {
    let error =
        |message: &str, said: &str| Diagnosis::error("mech::syntax::decimal_comma", message).label(at, said);
    match <[Help; 1]>::try_from(lines) {
        Ok([help]) => error("use a decimal point, not a comma", "a comma separates the values of a list")
            .help(help.certain()),
        Err(lines) => {
            error("a comma in a number is ambiguous: decimal point or thousands", "three digits follow")
                .help(Help::one_of(lines))
        }
    }
}
