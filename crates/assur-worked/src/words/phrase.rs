//! Sentences that are made in English elsewhere, in the language of a solution.

use super::Language;
use super::phrases::PHRASES;

/// A sentence of a table or a picture in a language; as it is where it is of the author.
#[must_use]
pub fn phrase(language: Language, english: &str) -> String {
    let column = match language {
        Language::English => return english.to_owned(),
        Language::Chinese => 1,
        Language::Russian => 2,
    };
    let spaced = english.trim_end();
    let tail = &english[spaced.len()..];
    // the unit of a header, and what a heading says besides
    let (words, unit) = match spaced.rsplit_once(" [") {
        Some((words, _)) if spaced.ends_with(']') => (words, &spaced[words.len()..]),
        _ => (spaced, ""),
    };
    let found = PHRASES.iter().find_map(|row| Some((row, parts(row[0], words)?)));
    let Some((row, parts)) = found else {
        // a list of names, of which some are made here
        let items = english
            .split(", ")
            .map(|item| if item == english { item.to_owned() } else { phrase(language, item) });
        return items.collect::<Vec<_>>().join(", ");
    };
    let mut parts = parts.into_iter();
    let mut said = String::new();
    for (i, literal) in row[column].split("{}").enumerate() {
        if i > 0 {
            said += &parts.next().map(|part| phrase(language, part)).unwrap_or_default();
        }
        said += literal;
    }
    said + unit + tail
}

/// What stands for the `{}` of a pattern; none where it is another sentence.
fn parts<'a>(pattern: &str, words: &'a str) -> Option<Vec<&'a str>> {
    let mut literals = pattern.split("{}");
    let mut rest = words.strip_prefix(literals.next()?)?;
    let mut found = Vec::new();
    let mut literals = literals.peekable();
    while let Some(literal) = literals.next() {
        // the last reaches to the end; what a title says goes as far as it can
        let at = match (literals.peek(), literal) {
            (None, "") => rest.len(),
            (None, literal) => rest.len().checked_sub(literal.len()).filter(|_| rest.ends_with(literal))?,
            (Some(_), literal) => rest.find(literal)?,
        };
        if at == 0 {
            return None;
        }
        found.push(&rest[..at]);
        rest = &rest[at + literal.len()..];
    }
    rest.is_empty().then_some(found)
}
