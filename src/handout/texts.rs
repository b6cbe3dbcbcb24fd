//! Texts of problems as sheets have them: for all rows of variants, and what they use.

use assur_check as check;
use assur_syntax::document::{Document, Statement, Variants};
use assur_worked::in_letters;
use std::collections::BTreeSet;

/// A document for all rows of its table: letters are in its title in place of the values that go with the row, and before
/// them in its text.
pub fn for_all(document: &Document, rows: &[String]) -> Document {
    let table = check::table(document);
    let mut document = document.clone();
    let range = match rows {
        [first, .., last] => format!("{first}–{last}"),
        rows => rows.first().cloned().unwrap_or_default(),
    };
    if let Some(table) = table.cloned() {
        let names: Vec<&str> = table.columns.iter().map(|column| column.name.node.as_str()).collect();
        let is_column = |name: &str| names.contains(&name) && name != "variant";
        for statement in &mut document.statements {
            if let Statement::Title(title) = &mut statement.node {
                title.node = check::with_names(&title.node, |name| match name {
                    "variant" => Some(range.clone()),
                    name => is_column(name).then(|| in_letters(name)),
                });
            }
        }
        for note in &mut document.notes {
            note.node = check::with_names(&note.node, |name| {
                is_column(name).then(|| format!("{} = {{{name}}}", in_letters(name)))
            });
        }
    }
    document
}

/// Whether a text has values that go with the row.
pub fn names_a_column(text: &str, table: Option<&Variants>) -> bool {
    let mut found = false;
    check::with_names(text, |name| {
        found |= table.is_some_and(|table| table.columns.iter().any(|column| column.name.node == name));
        None
    });
    found
}

/// The numbers of a text without expectations and remarks; none where it expects nothing.
pub fn numbers(text: &str) -> Vec<f64> {
    let lines = || text.lines().map(str::trim_start);
    if !lines().any(|line| line.starts_with("expect")) {
        return Vec::new();
    }
    let lines = lines().filter(|line| !line.starts_with("expect") && !line.starts_with("//"));
    let words = lines.flat_map(|line| line.split(|c: char| !(c.is_ascii_digit() || c == '.')));
    words.filter_map(|word| word.parse().ok()).collect()
}

/// The names that a text uses before its table and outside of expectations; that which a line gives is not used by it.
pub fn used(text: &str) -> BTreeSet<String> {
    let before = text.split_once("variants").map_or(text, |(before, _)| before);
    let mut used = BTreeSet::new();
    for line in before.lines().filter(|line| !line.trim_start().starts_with("expect")) {
        let mut words = line.split_whitespace();
        let given = words.next().filter(|word| *word == "given").and_then(|_| words.next());
        let in_name = |c: char| c.is_alphanumeric() || c == '_' || c == '\'';
        let names = line.split(|c| !in_name(c)).filter(|name| !name.is_empty() && Some(*name) != given);
        used.extend(names.map(str::to_owned));
    }
    used
}
