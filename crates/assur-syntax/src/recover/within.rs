//! Pieces that begin well and go wrong further on.

use super::case::Case;
use super::harmonic;
use crate::recover::{lacking, misspelling, without_operator, word_of_the_language};
use crate::words::{self, Expected, Rule, is_name_char, is_reserved};
use assur_text::diagnostic::{Diagnosis, did_you_mean};
use assur_text::units::is_unit;

pub(super) fn explain(case: &Case<'_>) -> Option<Diagnosis> {
    harmonic::explain(case)
        .or_else(|| reserved_name(case))
        .or_else(|| misspelt_here(case))
        .or_else(|| misspelt_before(case))
}

/// The last attempts at a correction.
pub(super) fn missing(case: &Case<'_>) -> Option<Diagnosis> {
    missing_operator(case).or_else(|| missing_word(case))
}

/// A reserved word where a name is due.
fn reserved_name(case: &Case<'_>) -> Option<Diagnosis> {
    let word = case.token(case.fail);
    // `find at = …`: what is looked for may have a name
    let asked = case.token(0) == "find";
    let may_be = |e: &Expected| *e == Expected::Name || (asked && *e == Expected::Kind("a value"));
    let named = case.expected.iter().any(|r| words::expected(*r).iter().any(may_be));
    if !is_reserved(word) || !named || matches!(word, "cw" | "ccw") {
        return None;
    }
    let end = case.fail + word.len();
    let other = format!("{word}_1");
    case.reads(&case.with(case.fail, end, &other)).then(|| {
        word_of_the_language(word, case.span(case.fail, word.len()), case.help(case.fail, end, &other))
    })
}

/// A misspelt word where reading stopped.
fn misspelt_here(case: &Case<'_>) -> Option<Diagnosis> {
    let word = case.token(case.fail);
    let fitting = case.literals();
    respelt(case, case.fail, word, fitting.iter().map(String::as_str).collect())
}

/// A misspelt word read as a name or a unit, just before the place where reading stopped.
fn misspelt_before(case: &Case<'_>) -> Option<Diagnosis> {
    let (at, word) = case.words().into_iter().rev().find(|(at, _)| *at < case.fail)?;
    let known = words::within().collect();
    respelt(case, at, word, known)
}

fn respelt(case: &Case<'_>, at: usize, word: &str, known: Vec<&str>) -> Option<Diagnosis> {
    if !word.starts_with(is_name_char) || is_unit(word) {
        return None;
    }
    let end = at + word.len();
    let near = did_you_mean(word, known);
    let wanted = near.into_iter().find(|w| case.reads(&case.with(at, end, w)))?;
    Some(misspelling(word, case.span(at, word.len()), wanted, Some(case.help(at, end, wanted))))
}

/// `2(a + b)`
fn missing_operator(case: &Case<'_>) -> Option<Diagnosis> {
    if let Some(call) = number_before_call(case) {
        return Some(call);
    }
    let before = case.slice.get(..case.fail)?.trim_end();
    let here = case.token(case.fail);
    let closes = before.ends_with(')') || before.ends_with(is_name_char);
    let opens = here == "(" || (before.ends_with(')') && here.starts_with(is_name_char));
    let corrected = case.with(before.len(), case.fail, " * ");
    (closes && opens && !is_reserved(here) && case.reads(&corrected))
        .then(|| without_operator(case.span(case.fail, here.len()), case.help(before.len(), case.fail, "*")))
}

/// `2 sin(x)`: the name of the function has been read as a unit.
fn number_before_call(case: &Case<'_>) -> Option<Diagnosis> {
    let (at, word) = case.words().into_iter().rev().find(|(at, w)| at + w.len() == case.fail)?;
    let before = case.slice.get(..at)?.trim_end();
    let after_number = before.ends_with(|c: char| c.is_ascii_digit()) && before.len() < at;
    let call = case.token(case.fail) == "(" && after_number && case.reads(&case.with(before.len(), at, "*"));
    call.then(|| without_operator(case.span(at, word.len()), case.help(before.len(), at, "*")))
}

/// `expect M 12 N*m within 1 %`: the sign of equality between what is expected and its value.
pub(super) fn equals_of_expect(case: &Case<'_>) -> Option<Diagnosis> {
    if case.token(0) != "expect" || case.slice.contains(['=', '<', '>']) {
        return None;
    }
    let mut depth = 0_usize;
    let blanks = case.slice.char_indices().filter(|(_, c)| {
        match c {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            _ => {}
        }
        *c == ' ' && depth == 0
    });
    let at = blanks.map(|(at, _)| at).find(|at| case.reads(&case.with(*at, at + 1, " = ")))?;
    Some(lacking("=", case.span(at + 1, case.token(at + 1).len()), case.help(at, at + 1, " = ")))
}

/// A word or sign that makes the piece read; only if there is just one.
fn missing_word(case: &Case<'_>) -> Option<Diagnosis> {
    let here = case.token(case.fail);
    if here.is_empty() || case.expected.contains(&Rule::p_close) {
        return None;
    }
    let mut fitting = case.literals();
    fitting
        .retain(|w| w != "{" && w != "}" && case.reads(&case.with(case.fail, case.fail, &format!(" {w} "))));
    fitting.retain(|w| w != "accelerating");
    // a mass lacks its point more often than its inertia or plane
    let has_point = fitting.iter().any(|w| w == "at");
    fitting.retain(|w| !matches!(w.as_str(), "inertia" | "plane") || !has_point);
    // behind `when` stands a comparison
    let compared = case.slice.get(case.fail..)?.contains(['<', '>']);
    fitting.retain(|w| w != "when" || compared);
    let missing = match fitting.as_slice() {
        [missing] => missing,
        // loads and balances act on links more often than in pairs
        [first, on] if first == "in" && on == "on" => on,
        _ => return None,
    };
    let before = case.slice.get(..case.fail)?.trim_end();
    let spaced = match missing.as_str() {
        sign @ (":" | ",") => format!("{sign} "),
        word => format!(" {word} "),
    };
    Some(lacking(missing, case.span(case.fail, here.len()), case.help(before.len(), case.fail, &spaced)))
}
