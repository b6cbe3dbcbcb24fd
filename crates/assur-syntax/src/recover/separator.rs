//! Statements or members that nothing separates.

use super::case::Case;
use super::phrase::What;
use crate::recover::{instead, unseparated};
use crate::words::{self, is_name_char};
use assur_text::diagnostic::Diagnosis;
use assur_text::units::is_unit;

/// A statement's word in the middle, with a statement on both sides of it.
pub(super) fn statements(case: &Case<'_>) -> Option<Diagnosis> {
    if case.what != What::Statement {
        return None;
    }
    let begins = |(at, word): &(usize, &str)| *at > 0 && *at <= case.fail && words::is_statement(word);
    let candidates = case.words().into_iter().rev().filter(begins).take(4);
    for (at, word) in candidates {
        let (first, second) = (&case.slice[..at], &case.slice[at..]);
        let more = case.words().iter().any(|(i, w)| *i > at && words::is_statement(w));
        if case.reads(first.trim_end()) && (more || case.reads(second)) {
            let trimmed = first.trim_end();
            let help = case.help(trimmed.len(), at, "; ");
            return Some(unseparated(case.span(at, word.len()), help));
        }
    }
    None
}

/// `S (60 mm, 15 mm) mass 1.2 kg at S`: members one after the other, each of which reads.
pub(super) fn members(case: &Case<'_>) -> Option<Diagnosis> {
    if matches!(case.what, What::Statement | What::Header | What::Row) {
        return None;
    }
    /// The most members on a line that are looked at.
    const MOST: usize = 20;
    let mut parts = Vec::new();
    let mut rest = case.slice;
    let mut first = None;
    while !case.reads(rest) {
        let at = case.fail_of(rest);
        let (member, next) = (rest.get(..at)?.trim_end(), rest.get(at..)?);
        if parts.len() == MOST || !is_member(case, member) {
            return None;
        }
        first = first.or(Some(at));
        parts.push(member);
        rest = next;
    }
    let first = first.filter(|_| is_member(case, rest))?;
    parts.push(rest);
    let help = case.help(0, case.slice.len(), &parts.join("; "));
    Some(unseparated(case.span(first, case.token(first).len()), help))
}

/// Whether a part reads as a member, and as no point whose coordinates are a name: `teeht zp`.
fn is_member(case: &Case<'_>, part: &str) -> bool {
    let word = part.split(|c| !is_name_char(c)).next().unwrap_or_default();
    let known = match case.what {
        What::Member => words::is_member(word) || part.contains('('),
        _ => words::is_cam_member(word) || part.contains(' '),
    };
    known && !part.is_empty() && case.reads(part)
}

// Parts of a statement or member in another order.

/// Longer pieces are not tried: every place between two words is.
const LONGEST: usize = 200;

/// `link crank 40 mm A-B`, `drive crank at 1500 rpm = 45 deg`: two neighbours exchanged, one of which begins or ends where
/// reading stopped.
pub(super) fn explain(case: &Case<'_>) -> Option<Diagnosis> {
    if case.slice.len() > LONGEST || matches!(case.what, What::Header | What::Row) {
        return None;
    }
    let fail = case.fail;
    let rest = case.slice.get(fail..)?;
    let end = fail + rest.find('{').map_or(rest, |brace| &rest[..brace]).trim_end().len();
    let cuts = starts(case.slice, end);
    let behind = cuts.iter().filter(|at| **at > fail).map(|at| (fail, *at, end));
    let first = cuts.first().copied()?;
    let before = cuts.iter().rev().filter(|at| **at < fail && **at > first).map(|at| (*at, fail, end));
    behind.chain(before).find_map(|(start, middle, end)| exchanged(case, start, middle, end))
}

/// The piece with the parts on both sides of a place exchanged.
fn exchanged(case: &Case<'_>, start: usize, middle: usize, end: usize) -> Option<Diagnosis> {
    let (first, second) = (case.slice.get(start..middle)?.trim(), case.slice.get(middle..end)?.trim());
    let wanted = format!("{second} {first}");
    // what begins with an operator belongs to what stands before it
    let whole = |part: &str| part.starts_with(|c| is_name_char(c) || matches!(c, '=' | '(' | '@' | '"'));
    (whole(first) && whole(second) && case.reads(&case.with(start, end, &wanted))).then(|| {
        instead(
            case.slice.get(start..end).unwrap_or_default(),
            &wanted,
            case.span(start, end - start),
            case.help(start, end, &wanted),
        )
    })
}

/// Where words begin that follow a blank, except units after their numbers.
fn starts(slice: &str, end: usize) -> Vec<usize> {
    let mut blank = true;
    let mut starts = Vec::new();
    for (at, c) in slice.char_indices().take_while(|(at, _)| *at < end) {
        if blank && !c.is_whitespace() && !is_unit_behind(slice, at) {
            starts.push(at);
        }
        blank = c.is_whitespace();
    }
    starts
}

/// Whether a unit stands there, with its number before it.
fn is_unit_behind(slice: &str, at: usize) -> bool {
    let (before, rest) = slice.split_at(at);
    let number = before.trim_end().rsplit(char::is_whitespace).next().unwrap_or_default();
    let word = rest.split(|c| !is_name_char(c)).next().unwrap_or_default();
    number.parse::<f64>().is_ok() && is_unit(word)
}
