//! Texts of problems as sheets have them: for all rows of variants, and what they use.

use assur_check as check;
use assur_syntax::document::{Document, Expr, ExprKind, Statement, Variants};
use assur_text::units::lookup;
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

/// The numbers of a document without its expectations and tables, SI.
pub fn numbers(document: &Document) -> Vec<f64> {
    let mut numbers = Vec::new();
    asking(document).for_each(|statement| {
        each_part(statement, &mut |part| {
            if let ExprKind::Number(number) = &part.kind {
                let unit = number.unit.as_ref().and_then(|unit| lookup(&unit.node).ok());
                numbers.push(unit.map_or(number.value, |unit| unit.to_si(number.value)));
            }
        });
    });
    numbers
}

/// The names that statements and the text use, expectations aside, with those that their values use.
pub fn used(document: &Document) -> BTreeSet<String> {
    let mut used = BTreeSet::new();
    let is_value = |statement: &&Statement| definition(statement).is_some();
    asking(document).filter(|statement| !is_value(statement)).for_each(|s| used.append(&mut names(s)));
    for note in &document.notes {
        check::with_names(&note.node, |name| {
            used.insert(name.to_owned());
            None
        });
    }
    let values = || asking(document).filter_map(|s| Some((definition(s)?, names(s))));
    while let Some((_, more)) = values().find(|(name, more)| used.contains(*name) && !more.is_subset(&used)) {
        used.extend(more);
    }
    used
}

/// These names, and those of values that follow from them.
pub fn following(document: &Document, mut names: BTreeSet<String>) -> BTreeSet<String> {
    let values = || asking(document).filter_map(|s| Some((definition(s)?, self::names(s))));
    while let Some((name, _)) = values().find(|(name, of)| !names.contains(*name) && !of.is_disjoint(&names))
    {
        names.insert(name.to_owned());
    }
    names
}

/// What is written with these names, and nothing else that is no value: with its place.
pub fn written_with<'d>(document: &'d Document, names: &BTreeSet<String>) -> Vec<&'d Expr> {
    let values: BTreeSet<&str> = asking(document).filter_map(definition).collect();
    let mut found: Vec<&Expr> = Vec::new();
    asking(document).filter(|s| !matches!(s, Statement::Find(_))).for_each(|statement| {
        each_part(statement, &mut |part| {
            let own = names_of(part);
            let is_number = !matches!(part.kind, ExprKind::Polar(..) | ExprKind::Vector(..));
            if is_number && !own.is_disjoint(names) && own.iter().all(|name| values.contains(name.as_str())) {
                found.push(part);
            }
        });
    });
    found
}

fn names_of(expr: &Expr) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    check::parts_of(expr, &mut |part| {
        if let ExprKind::Name(name) = &part.kind {
            names.insert(name.clone());
        }
    });
    names
}

fn names(statement: &Statement) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    check::expressions(statement, &mut |expr| names.append(&mut names_of(expr)));
    names
}

fn each_part<'d>(statement: &'d Statement, visit: &mut dyn FnMut(&'d Expr)) {
    check::expressions(statement, &mut |expr| check::parts_of(expr, visit));
}

fn asking(document: &Document) -> impl Iterator<Item = &Statement> {
    document.statements.iter().map(|s| &s.node).filter(|s| !matches!(s, Statement::Expect(_)))
}

fn definition(statement: &Statement) -> Option<&str> {
    match statement {
        Statement::Given(value) | Statement::Let(value) => Some(&value.name.node),
        _ => None,
    }
}
