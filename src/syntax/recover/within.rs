//! Pieces that begin well and go wrong further on.

use super::What;
use super::case::Case;
use crate::diagnostic::did_you_mean;
use crate::syntax::Rule;
use crate::syntax::error::SyntaxError;
use crate::syntax::words::{self, Expected, is_name_char, is_reserved};

pub(super) fn explain(case: &Case<'_>) -> Option<SyntaxError> {
    decimal_comma(case)
        .or_else(|| two_statements(case))
        .or_else(|| reserved_name(case))
        .or_else(|| misspelt_here(case))
        .or_else(|| misspelt_before(case))
}

/// What remains when nothing else mends it.
pub(super) fn missing(case: &Case<'_>) -> Option<SyntaxError> {
    missing_operator(case).or_else(|| missing_word(case))
}

/// `0,5 m`: first the comma nearest before the failure alone, then all.
fn decimal_comma(case: &Case<'_>) -> Option<SyntaxError> {
    let bytes = case.slice.as_bytes();
    let digit = |i: Option<usize>| i.and_then(|i| bytes.get(i)).is_some_and(u8::is_ascii_digit);
    let is_decimal = |i: &usize| bytes[*i] == b',' && digit(i.checked_sub(1)) && digit(Some(i + 1));
    let commas = (0..bytes.len()).filter(is_decimal).collect::<Vec<_>>();
    let nearest = *commas.iter().rev().find(|i| **i <= case.fail).or(commas.first())?;
    if matches!(case.what, What::Row | What::Header) {
        return None;
    }
    if case.reads(&case.with(nearest, nearest + 1, ".")) {
        let help = case.help(nearest, nearest + 1, ".");
        return Some(SyntaxError::DecimalComma { at: case.span(nearest, 1), help });
    }
    let mut all = case.slice.to_owned();
    for comma in &commas {
        all.replace_range(*comma..comma + 1, ".");
    }
    let first = *commas.first()?;
    case.reads(&all).then(|| SyntaxError::DecimalComma {
        at: case.span(first, 1),
        help: case.help(0, case.slice.len(), &all),
    })
}

/// A statement's word in the middle, with a statement on both sides of it.
fn two_statements(case: &Case<'_>) -> Option<SyntaxError> {
    if case.what != What::Statement {
        return None;
    }
    let begins = |(at, word): &(usize, &str)| *at > 0 && *at <= case.fail && words::STATEMENTS.contains(word);
    let candidates = case.words().into_iter().rev().filter(begins).take(4);
    for (at, word) in candidates {
        let (first, second) = (&case.slice[..at], &case.slice[at..]);
        let more = case.words().iter().any(|(i, w)| *i > at && words::STATEMENTS.contains(w));
        if case.reads(first.trim_end()) && (more || case.reads(second)) {
            let trimmed = first.trim_end();
            let help = case.help(trimmed.len(), at, "; ");
            return Some(SyntaxError::TwoStatements { at: case.span(at, word.len()), help });
        }
    }
    None
}

/// A reserved word where a name is due.
fn reserved_name(case: &Case<'_>) -> Option<SyntaxError> {
    let word = case.token(case.fail);
    let named = case.expected.iter().any(|r| words::expected(*r).contains(&Expected::Name));
    if !is_reserved(word) || !named {
        return None;
    }
    let end = case.fail + word.len();
    let other = format!("{word}_1");
    case.reads(&case.with(case.fail, end, &other)).then(|| SyntaxError::ReservedName {
        found: word.to_owned(),
        at: case.span(case.fail, word.len()),
        help: format!("{}, or any other name", case.help(case.fail, end, &other)),
    })
}

/// A misspelt word where reading stopped.
fn misspelt_here(case: &Case<'_>) -> Option<SyntaxError> {
    let word = case.token(case.fail);
    let fitting = case.literals();
    respelt(case, case.fail, word, fitting.iter().map(String::as_str).collect())
}

/// A misspelt word read as a name or a unit, just before the place where reading stopped.
fn misspelt_before(case: &Case<'_>) -> Option<SyntaxError> {
    let (at, word) = case.words().into_iter().rev().find(|(at, _)| *at < case.fail)?;
    let known = words::CONNECTING.iter().chain(words::CONTEXTUAL).copied().collect();
    respelt(case, at, word, known)
}

fn respelt(case: &Case<'_>, at: usize, word: &str, known: Vec<&str>) -> Option<SyntaxError> {
    if !word.starts_with(is_name_char) {
        return None;
    }
    let end = at + word.len();
    let near = did_you_mean(word, known);
    let wanted = near.into_iter().find(|w| case.reads(&case.with(at, end, w)))?;
    Some(SyntaxError::MisspeltWord {
        found: word.to_owned(),
        at: case.span(at, word.len()),
        wanted: wanted.to_owned(),
        help: Some(case.help(at, end, wanted)),
    })
}

/// `2(a + b)`
fn missing_operator(case: &Case<'_>) -> Option<SyntaxError> {
    let before = case.slice.get(..case.fail)?.trim_end();
    let here = case.token(case.fail);
    let closes = before.ends_with(')') || before.ends_with(is_name_char);
    let opens = here == "(" || (before.ends_with(')') && here.starts_with(is_name_char));
    let mended = case.with(before.len(), case.fail, " * ");
    (closes && opens && !is_reserved(here) && case.reads(&mended)).then(|| SyntaxError::MissingOperator {
        at: case.span(case.fail, here.len()),
        help: case.help(before.len(), case.fail, "*"),
    })
}

/// A word or sign that makes the piece read; only if there is just one.
fn missing_word(case: &Case<'_>) -> Option<SyntaxError> {
    let here = case.token(case.fail);
    if here.is_empty() || case.expected.contains(&Rule::p_close) {
        return None;
    }
    let mut fitting = case.literals();
    fitting
        .retain(|w| w != "{" && w != "}" && case.reads(&case.with(case.fail, case.fail, &format!(" {w} "))));
    let [missing] = fitting.as_slice() else { return None };
    let before = case.slice.get(..case.fail)?.trim_end();
    let spaced = match missing.as_str() {
        sign @ (":" | ",") => format!("{sign} "),
        word => format!(" {word} "),
    };
    Some(SyntaxError::MissingWord {
        missing: missing.clone(),
        at: case.span(case.fail, here.len()),
        help: case.help(before.len(), case.fail, &spaced),
    })
}
