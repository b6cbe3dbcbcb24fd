//! Pieces that begin with a wrong word.

use super::What;
use super::case::Case;
use crate::diagnostic::did_you_mean;
use crate::syntax::error::SyntaxError;
use crate::syntax::grammar::{Grammar, Rule};
use crate::syntax::words::{self, is_name_char};
use pest::Parser;

pub(super) fn explain(case: &Case<'_>) -> Option<SyntaxError> {
    let word = case.token(0);
    if let Some(sign) = ["#", "%", "--", "/*", "'"].into_iter().find(|s| case.slice.starts_with(s)) {
        let at = case.span(0, sign.len());
        return Some(SyntaxError::CommentSign {
            at,
            found: sign.to_owned(),
            help: case.help(0, sign.len(), "//"),
        });
    }
    let known = match case.what {
        What::Statement => words::STATEMENTS,
        What::Member => words::MEMBERS,
        What::CamMember => words::CAM_MEMBERS,
        What::Property | What::Header | What::Row => return None,
    };
    if known.contains(&word) || !word.starts_with(is_name_char) {
        return None;
    }
    if case.what != What::Statement {
        return misspelt(case, word, known);
    }
    let member = words::MEMBERS.contains(&word) || words::CAM_MEMBERS.contains(&word);
    let exactly = if member { displaced(case, word) } else { None };
    exactly
        .or_else(|| misspelt(case, word, known))
        .or_else(|| displaced(case, word))
        .or_else(|| Some(unknown(case, word)))
}

/// A word that is near one that could stand there.
fn misspelt(case: &Case<'_>, word: &str, known: &[&str]) -> Option<SyntaxError> {
    let near = did_you_mean(word, known.iter().copied());
    let fits = near.iter().find(|w| case.reads(&case.with(0, word.len(), w)));
    let defines = case.slice[word.len()..].trim_start().starts_with('=');
    let wanted = match (fits, near.first()) {
        (Some(fits), _) => fits,
        (None, Some(first)) if case.what == What::Statement && !defines => first,
        _ => return None,
    };
    Some(SyntaxError::MisspeltWord {
        found: word.to_owned(),
        at: case.span(0, word.len()),
        wanted: (*wanted).to_owned(),
        help: fits.map(|w| case.help(0, word.len(), w)),
    })
}

/// A member outside its braces.
fn displaced(case: &Case<'_>, word: &str) -> Option<SyntaxError> {
    if case.slice[word.len()..].trim_start().starts_with('=') {
        return None;
    }
    let member = Grammar::parse(Rule::one_member, case.slice).is_ok();
    let point = member && case.slice.contains('(');
    let (place, owner) = match word {
        "wheel" => ("this belongs into the braces of a shaft or a link", "shaft"),
        _ if words::CAM_MEMBERS.contains(&word) => ("this belongs into the braces of a cam", "cam"),
        _ if point || words::MEMBERS.contains(&word) => ("this belongs into the braces of a link", "link"),
        _ => return None,
    };
    let help = format!("write: {owner} NAME {{ {} }}", case.slice.trim());
    let found = word.to_owned();
    Some(SyntaxError::MisplacedMember { found, at: case.span(0, word.len()), place, help })
}

fn unknown(case: &Case<'_>, word: &str) -> SyntaxError {
    let behind = case.slice[word.len()..].trim_start();
    let line = case.slice.lines().next().unwrap_or_default().trim();
    let help = if behind.starts_with('=') {
        format!("a value is defined by: given {line}")
    } else if behind.starts_with(':') {
        format!("a pair begins with its kind: revolute {line}")
    } else {
        format!("a statement begins with one of: {}", words::STATEMENTS.join(", "))
    };
    SyntaxError::UnknownStatement { found: word.to_owned(), at: case.span(0, word.len()), help }
}
