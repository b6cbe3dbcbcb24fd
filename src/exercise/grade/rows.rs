//! Which row of the key a row of answers is for.

use super::rules::Points;
use super::sheet::{NAMES, Sheet, SheetRow, as_written};
use crate::exercise::table::TableError;
use assur_text::source::Span;
use std::collections::BTreeSet;
use std::path::Path;
use std::sync::Arc;

/// A row of answers whose row of the key is wanted.
pub(super) struct RowRequest<'a> {
    /// Its line in the file.
    pub line: usize,
    pub text: &'a str,
    /// What names it, in the order of [`NAMES`].
    pub names: &'a [Option<String>; 4],
    pub person: Option<&'a str>,
}

/// The line of the key that a line of answers is for.
#[derive(Clone, Copy)]
pub(super) struct FoundRow {
    pub index: usize,
    /// Nothing says which of the positions of its row it is, and there are several.
    pub any_position: bool,
}

/// The row of the key that a row of the answers is for. Names that are alike to the letter go before others.
pub(super) fn find(key: &Sheet, answers: &Sheet, row: &RowRequest<'_>) -> Result<FoundRow, TableError> {
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
    let mut found = if exact.is_empty() { found(alike) } else { exact };
    let has_pose = row.names[3].is_some();
    if has_pose && found.iter().any(|i| key.rows[*i].names.each[3].is_some()) {
        // the line of what has no position
        found.retain(|i| key.rows[*i].names.each[3].is_some());
    }
    match found[..] {
        [index] => Ok(FoundRow { index, any_position: false }),
        [index, ..] if !has_pose && key.positions.are_one_row(&found) => {
            Ok(FoundRow { index, any_position: true })
        }
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

fn unknown(row: &RowRequest<'_>, why: String, help: String) -> TableError {
    TableError::UnknownRow { line: row.line, why, help, span: Span::new(0, row.text.len()) }
}

fn none_or_several(key: &Sheet, answers: &Sheet, row: &RowRequest<'_>, found: usize) -> TableError {
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
fn named_in_key(key: &Sheet, row: &RowRequest<'_>) -> String {
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

// What a student was to hand in: which rows of the key.

/// Rows of the key that a student was to answer and did not.
pub(super) struct MissingAnswer {
    pub rows: Vec<usize>,
    /// Whether these are the student's own rows; else nothing tells which variant is, and these stand for it.
    pub known: bool,
}

/// The key, and whether the answers are those of several students.
pub(super) struct Assignment<'a> {
    pub key: &'a Sheet,
    pub points: &'a Points,
    /// A column of the answers says who answered.
    pub persons: bool,
}

impl Assignment<'_> {
    /// What a student did not hand in. Where the key names students, a student's rows are those with the name; where the
    /// answers name no students, all of the key; else all positions of the variants that were answered, and one variant
    /// of every problem that was not.
    pub fn missing(&self, person: Option<&Arc<str>>, answered: &BTreeSet<usize>) -> Vec<MissingAnswer> {
        let all = 0..self.key.rows.len();
        let rows: Vec<usize> = match (self.key.persons, self.persons) {
            (true, true) => all.filter(|i| self.key.rows[*i].person.as_ref() == person).collect(),
            (_, false) => all.collect(),
            (false, true) => return self.of_variants(answered),
        };
        let rows = rows.into_iter().filter(|i| !answered.contains(i)).collect();
        vec![MissingAnswer { rows, known: true }]
    }

    fn of_variants(&self, answered: &BTreeSet<usize>) -> Vec<MissingAnswer> {
        let variant = |i: usize| &self.key.rows[i].names.each[..3];
        let is_own = |i: &usize| answered.iter().any(|a| variant(*a) == variant(*i));
        let of_own = (0..self.key.rows.len()).filter(|i| is_own(i) && !answered.contains(i)).collect();
        let mut owed = vec![MissingAnswer { rows: of_own, known: true }];
        let is_answered =
            |file: &Option<String>| answered.iter().any(|a| self.key.rows[*a].names.each[0] == *file);
        let mut left: Vec<&Option<String>> = Vec::new();
        for row in &self.key.rows {
            let file = &row.names.each[0];
            if !is_answered(file) && !left.contains(&file) {
                left.push(file);
                owed.push(self.variant_of(file, answered));
            }
        }
        owed
    }

    /// The variant of a problem that a student left out: the one that all answers to other problems are of, or the only
    /// one; else the one of the fewest points stands for it.
    fn variant_of(&self, file: &Option<String>, answered: &BTreeSet<usize>) -> MissingAnswer {
        let variant = |row: &SheetRow| row.names.each[1..3].to_vec();
        let mut variants: Vec<(Vec<Option<String>>, Vec<usize>)> = Vec::new();
        for (i, row) in self.key.rows.iter().enumerate().filter(|(_, row)| row.names.each[0] == *file) {
            let names = variant(row);
            match variants.iter_mut().find(|(known, _)| *known == names) {
                Some((_, rows)) => rows.push(i),
                None => variants.push((names, vec![i])),
            }
        }
        if let [(_, rows)] = variants.as_slice() {
            return MissingAnswer { rows: rows.clone(), known: true };
        }
        let mut own: Vec<_> = answered.iter().map(|a| variant(&self.key.rows[*a])).collect();
        own.sort();
        own.dedup();
        if let [own] = own.as_slice()
            && let Some((_, rows)) = variants.iter().find(|(names, _)| names == own)
        {
            return MissingAnswer { rows: rows.clone(), known: true };
        }
        let points = |rows: &[usize]| rows.iter().map(|i| self.points_of(*i)).sum::<f64>();
        let least = variants.into_iter().map(|(_, rows)| rows).min_by(|a, b| points(a).total_cmp(&points(b)));
        MissingAnswer { rows: least.unwrap_or_default(), known: false }
    }

    fn points_of(&self, index: usize) -> f64 {
        let row = &self.key.rows[index];
        let asked = (0..row.entries.len()).filter(|place| {
            row.entries[*place] != super::sheet::Entry::Empty && self.key.positions.is_asked(index, *place)
        });
        asked.map(|place| self.points.of(self.key, row, place)).sum()
    }
}
