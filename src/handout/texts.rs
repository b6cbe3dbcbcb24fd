//! Texts of problems as sheets have them: for all rows of variants, and what they use.

use assur_check as check;
use assur_syntax::document::{Document, Expr, ExprKind, Statement, Variants};
use assur_text::units::lookup;
use assur_worked::in_letters;

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

/// The numbers of a document without its expectations and its table of variants, SI.
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
    let curves = document.statements.iter().filter_map(|s| match &s.node {
        Statement::Curve(curve) => Some(&curve.table),
        _ => None,
    });
    for table in curves {
        for (i, column) in table.columns.iter().enumerate() {
            let unit = column.unit.as_ref().and_then(|unit| lookup(&unit.node).ok());
            let cells = table.rows.iter().filter_map(|row| row.cells.get(i)?.node.text().parse::<f64>().ok());
            numbers.extend(cells.map(|x| unit.as_ref().map_or(x, |unit| unit.to_si(x))));
        }
    }
    numbers
}

/// Whether a text has the value of a name.
pub fn names(text: &str, name: &str) -> bool {
    let mut found = false;
    check::with_names(text, |named| {
        found |= named == name;
        None
    });
    found
}

fn each_part<'d>(statement: &'d Statement, visit: &mut dyn FnMut(&'d Expr)) {
    check::expressions(statement, &mut |expr| check::parts_of(expr, visit));
}

fn asking(document: &Document) -> impl Iterator<Item = &Statement> {
    document.statements.iter().map(|s| &s.node).filter(|s| !matches!(s, Statement::Expect(_)))
}
