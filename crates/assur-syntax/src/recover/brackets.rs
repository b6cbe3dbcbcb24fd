//! Brackets that do not match.

use super::case::Case;
use super::lacking;
use crate::words::is_name_char;
use assur_text::diagnostic::Diagnosis;

pub(super) fn explain(case: &Case<'_>) -> Option<Diagnosis> {
    third_coordinate(case).or_else(|| unopened(case)).or_else(|| unmatched(case)).or_else(|| unclosed(case))
}

/// `(1 m, 2 m, 3 m)`
fn third_coordinate(case: &Case<'_>) -> Option<Diagnosis> {
    let before = case.slice.get(..case.fail)?;
    let open = open_brackets(before).pop()?;
    let called = before.get(..open)?.ends_with(is_name_char);
    let comma = case.token(case.fail) == "," && before.get(open..)?.starts_with('(') && !called;
    comma.then(|| {
        Diagnosis::error("mech::syntax::third_coordinate", "a vector has exactly two coordinates")
            .label(case.span(case.fail, 1), "a third coordinate")
            .help(
                "write `(x, y)`, mechanisms are planar; in numbers use a decimal point, \
                 not a comma",
            )
    })
}

/// A brace that closes and was not opened, where it can be: `link rod A (0, 0) }`.
fn unopened(case: &Case<'_>) -> Option<Diagnosis> {
    let count = |sign: char| case.slice.matches(sign).count();
    if count('}') != count('{') + 1 {
        return None;
    }
    let opens = |at: &usize| case.reads(&case.with(*at, *at, "{ "));
    let words = case.words().into_iter().map(|(at, _)| at);
    let at = words.filter(|at| *at <= case.fail && *at > 0).rev().find(opens)?;
    let mut problem = lacking("{", case.span(at, case.token(at).len()), case.help(at, at, "{ "));
    problem = problem.about("");
    Some(problem)
}

/// A closing bracket too many.
fn unmatched(case: &Case<'_>) -> Option<Diagnosis> {
    let token = case.token(case.fail);
    let found = token.chars().next().filter(|c| matches!(c, ')' | '}' | ']'))?;
    if !open_brackets(case.slice.get(..case.fail)?).is_empty() {
        return None;
    }
    let without = case.with(case.fail, case.fail + 1, "");
    let mends = case.reads(without.trim());
    let help = mends.then(|| case.help(case.fail, case.fail + 1, ""));
    Some(
        Diagnosis::error("mech::syntax::unmatched_bracket", format!("unmatched `{found}`"))
            .label(case.span(case.fail, 1), "no bracket is open here")
            .help_if(help),
    )
}

/// An opening bracket that nothing closes.
fn unclosed(case: &Case<'_>) -> Option<Diagnosis> {
    let open = open_brackets(case.slice).pop()?;
    if !case.slice.get(open..)?.starts_with('(') {
        return None;
    }
    let before = case.slice.get(..case.fail)?.trim_end().len();
    let places = [case.slice.len(), before];
    let place = places.into_iter().find(|at| case.reads(&case.with(*at, *at, ")")));
    Some(
        Diagnosis::error("mech::syntax::unclosed_bracket", "a bracket is not closed")
            .label(case.span(open, 1), "opened here")
            .help_if(place.map(|at| case.help(at, at, ")"))),
    )
}

/// The brackets still open at the end of a text, outermost first.
fn open_brackets(text: &str) -> Vec<usize> {
    let mut open = Vec::new();
    let mut quoted = false;
    let mut comment = false;
    let mut before = ' ';
    for (at, c) in text.char_indices() {
        match c {
            '\n' => (quoted, comment) = (false, false),
            _ if comment => {}
            '"' => quoted = !quoted,
            '/' if before == '/' && !quoted => comment = true,
            '(' | '[' | '{' if !quoted => open.push(at),
            ')' | ']' | '}' if !quoted => {
                open.pop();
            }
            _ => {}
        }
        before = c;
    }
    open
}
