//! Statements or members that nothing separates.

use super::case::Case;
use super::what::What;
use crate::error::SyntaxError;
use crate::words::{self, is_name_char};

/// A statement's word in the middle, with a statement on both sides of it.
pub(super) fn statements(case: &Case<'_>) -> Option<SyntaxError> {
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
            return Some(SyntaxError::TwoStatements { at: case.span(at, word.len()), help });
        }
    }
    None
}

/// `S (60 mm, 15 mm) mass 1.2 kg at S`: members one after the other, each of which reads.
pub(super) fn members(case: &Case<'_>) -> Option<SyntaxError> {
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
    Some(SyntaxError::TwoStatements { at: case.span(first, case.token(first).len()), help })
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
