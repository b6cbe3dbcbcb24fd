//! Names in two pieces: with a hyphen, or with a blank.

use super::case::Case;
use crate::error::SyntaxError;
use crate::words::{is_name_char, is_reserved};

/// `left-arm`, `right arm`: the pieces joined by `_`.
pub(super) fn explain(case: &Case<'_>) -> Option<SyntaxError> {
    let words = case.words();
    let near = words.windows(2).filter(|pair| pair[0].0 <= case.fail);
    near.rev().take(4).find_map(|pair| joined(case, pair[0], pair[1]))
}

fn joined(case: &Case<'_>, first: (usize, &str), second: (usize, &str)) -> Option<SyntaxError> {
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
    case.reads(&case.with(start, end, &wanted)).then(|| SyntaxError::OtherWord {
        found: case.slice.get(start..end).unwrap_or_default().to_owned(),
        wanted: wanted.clone(),
        at: case.span(start, end - start),
        help: case.help(start, end, &wanted),
    })
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
