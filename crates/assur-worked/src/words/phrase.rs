//! Sentences that are made in English elsewhere, in the language of a solution.

use super::Language;
use super::message::rows;

/// A sentence of a table or a picture in a language; as it is where it is of the author.
#[must_use]
pub fn phrase(language: Language, english: &str) -> String {
    if language == Language::English {
        return english.to_owned();
    }
    known(language, english).unwrap_or_else(|| {
        // a list of names, of which some are made here
        let items = english
            .split(", ")
            .map(|item| if item == english { item.to_owned() } else { phrase(language, item) });
        items.collect::<Vec<_>>().join(", ")
    })
}

/// A sentence that the list has; none where it is of the author.
#[must_use]
pub fn known(language: Language, english: &str) -> Option<String> {
    if language == Language::English {
        return Some(english.to_owned());
    }
    let spaced = english.trim_end();
    let tail = &english[spaced.len()..];
    // the unit of a header, and what a heading says besides
    let (words, unit) = match spaced.rsplit_once(" [") {
        Some((words, _)) if spaced.ends_with(']') => (words, &spaced[words.len()..]),
        _ => (spaced, ""),
    };
    // an item is not the first of several
    let items = rows(language, "items").iter().filter(|_| !words.contains(", "));
    // nor the first of several sentences
    let several = words.contains("; ");
    let pictures = rows(language, "pictures").iter().filter(|row| !(several && row.0.starts_with("{}")));
    let mut all = rows(language, "phrases").iter().chain(pictures).chain(items);
    let (text, parts) = all.find_map(|row| Some((row.1, parts(row.0, words)?)))?;
    Some(filled(text, &parts, |_, part| phrase(language, part)) + unit + tail)
}

/// The title of a picture: what the author called the problem stays as it is.
#[must_use]
pub fn title(language: Language, english: &str) -> String {
    let found = rows(language, "titles").iter().find_map(|row| Some((row.1, parts(row.0, english)?)));
    found.map_or_else(
        || english.to_owned(),
        |(text, parts)| {
            filled(text, &parts, |i, part| if i == 0 { part.to_owned() } else { phrase(language, part) })
        },
    )
}

/// A pattern with its parts in their places.
fn filled(pattern: &str, parts: &[&str], said: impl Fn(usize, &str) -> String) -> String {
    let mut out = String::new();
    for (i, literal) in pattern.split("{}").enumerate() {
        if let Some(before) = i.checked_sub(1) {
            out += &parts.get(before).map(|part| said(before, part)).unwrap_or_default();
        }
        out += literal;
    }
    out
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
