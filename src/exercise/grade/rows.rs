//! Which row of the key a row of answers is for.

use super::row_names::as_written;
use super::sheet::{NAMES, Sheet, SheetRow};
use crate::exercise::table::TableError;
use assur_text::source::Span;
use std::path::Path;

/// A row of answers whose row of the key is wanted.
pub(super) struct Wanted<'a> {
    /// Its line in the file.
    pub line: usize,
    pub text: &'a str,
    /// What names it, in the order of [`NAMES`].
    pub names: &'a [Option<String>; 4],
    pub person: Option<&'a str>,
}

/// The row of the key that a row of the answers is for. Names that are alike to the letter go before others.
pub(super) fn find(key: &Sheet, answers: &Sheet, row: &Wanted<'_>) -> Result<usize, TableError> {
    if answers.persons && row.person.is_none() {
        let help = "write who answered into every row".to_owned();
        return Err(unknown(row, "nothing says who answered".to_owned(), help));
    }
    let own = |k: &SheetRow| row.person.is_none() || !key.persons || k.person.as_deref() == row.person;
    let found = |same: fn(usize, &str, &str) -> bool| -> Vec<usize> {
        let fits = |k: &SheetRow| {
            let mut names = row.names.iter().zip(&k.names.each).enumerate();
            names.all(|(i, names)| match names {
                (Some(a), Some(k)) => same(i, a, k),
                _ => true,
            })
        };
        let all = key.rows.iter().enumerate();
        all.filter(|(_, k)| own(k) && fits(k)).map(|(i, _)| i).collect()
    };
    let exact = found(|_, a, k| a == k);
    let found = if exact.is_empty() { found(alike) } else { exact };
    match found[..] {
        [one] => Ok(one),
        _ => Err(none_or_several(key, answers, row, found.len())),
    }
}

/// Whether two names of a row mean the same: numbers by value, words in small and capital letters, files by name without
/// folder and ending, or by the number that the name begins with.
fn alike(which: usize, a: &str, k: &str) -> bool {
    let number = |text: &str| text.parse::<u64>().ok();
    let stem = |text: &str| Path::new(text).file_stem().map(|s| s.to_string_lossy().to_lowercase());
    let leading = |text: &str| {
        let stem = stem(text)?;
        let end = stem.find(|c: char| !c.is_ascii_digit()).unwrap_or(stem.len());
        let apart = !stem[end..].starts_with(|c: char| c.is_alphanumeric() || c == '.');
        number(&stem[..end]).filter(|_| apart)
    };
    number(a).is_some_and(|a| number(k) == Some(a))
        || a.to_lowercase() == k.to_lowercase()
        || which == 0 && (stem(a) == stem(k) || number(a).is_some_and(|a| leading(k) == Some(a)))
}

fn unknown(row: &Wanted<'_>, why: String, help: String) -> TableError {
    TableError::UnknownRow { line: row.line, why, help, span: Span::new(0, row.text.len()) }
}

fn none_or_several(key: &Sheet, answers: &Sheet, row: &Wanted<'_>, found: usize) -> TableError {
    let words = as_written(row.names).join(", ");
    let person = row.person.map(|name| format!(" ({name})")).unwrap_or_default();
    let (why, help) = match (found, words.is_empty()) {
        (0, empty) => {
            let words = if empty { "row" } else { &words };
            (format!("the key has no {words}{person}"), named_in_key(key, row))
        }
        (n, true) => {
            let help = "add a column `row`, or `variant`, that names the row of the key".to_owned();
            (format!("nothing says which of the {n} rows of the key this is{person}"), help)
        }
        (n, false) => {
            let lacks = |i: &usize| key.named[*i] && !answers.named[*i];
            let help = match (0..4).find(lacks) {
                Some(i) => format!("add a column `{}`", NAMES[i]),
                None => match (0..4).find(|i| key.named[*i] && row.names[*i].is_none()) {
                    Some(i) => format!("write the {} into this row", NAMES[i]),
                    None => "give the rows of the key different names".to_owned(),
                },
            };
            (format!("the key has {n} rows for {words}{person}"), help)
        }
    };
    unknown(row, why, help)
}

/// How the key names its rows, where a row of the answers is none of them.
fn named_in_key(key: &Sheet, row: &Wanted<'_>) -> String {
    /// The most names that are listed.
    const MOST: usize = 8;
    let as_the_key = "number the rows as the key does".to_owned();
    let names_of = |i: usize| key.rows.iter().filter_map(move |k| k.names.each[i].as_deref());
    let missing =
        |i: &usize| row.names[*i].as_deref().is_some_and(|name| names_of(*i).all(|k| !alike(*i, name, k)));
    let Some(i) = (0..4).find(missing) else { return as_the_key };
    let mut names = names_of(i).collect::<Vec<_>>();
    names.dedup();
    let what = NAMES[i];
    let numbered = names.iter().enumerate().all(|(at, name)| name.parse() == Ok(at + 1));
    match names.as_slice() {
        [] => as_the_key,
        [only] => format!("{as_the_key}: it has {what} {only} alone"),
        [first, .., last] if numbered => format!("{as_the_key}: it has {what}s {first} to {last}"),
        all if all.len() <= MOST => format!("{as_the_key}: it has {what}s {}", all.join(", ")),
        _ => as_the_key,
    }
}
