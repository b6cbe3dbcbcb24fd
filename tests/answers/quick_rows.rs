//! A row that is put into the mechanism of the rows before comes out, to the last bit and the last word, as if it were checked as
//! a whole: mechanism, structure, plan, positions, outcomes, messages.

use assur::internals::check::{self, ColumnUse, Overrides, Row, RowCell, RowColumn};
use assur::internals::exercise::table::Table;
use assur::internals::pipeline::VariantSolver;
use assur::internals::source::Source;
use assur::internals::syntax::document::{Definition, Document, ExprKind, Statement, UnaryOp, Variants};
use assur::internals::{Solved, diagnostic::Problems};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Rows that are compared.
const ROWS: usize = 40;
/// More characters are a long sweep, which another row does not make more telling.
const LONG: usize = 400_000;

/// A number in [0, 1), the same at every run.
pub fn random(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*state >> 11) as f64 / (1_u64 << 53) as f64
}

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    let mut all: Vec<_> =
        std::fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()).collect();
    all.sort();
    for path in all {
        if path.is_dir() {
            files(&path, found);
        } else if path.extension().is_some_and(|e| e == "mech") {
            found.push(path);
        }
    }
}

/// The header of a table that replaces the givens of a file that are numbers.
fn header(document: &Document) -> String {
    let givens = document.statements.iter().filter_map(|s| match &s.node {
        Statement::Given(Definition { name, value }) => {
            let value = match &value.kind {
                ExprKind::Unary(op, inner) if op.node == UnaryOp::Minus => inner,
                _ => value,
            };
            let ExprKind::Number(number) = &value.kind else { return None };
            let unit = number.unit.as_ref().map_or_else(String::new, |unit| format!(" [{}]", unit.node));
            Some(format!("{}{unit}", name.node))
        }
        _ => None,
    });
    givens.collect::<Vec<_>>().join(",") + "\n"
}

fn columns(document: &Document) -> Option<Arc<[RowColumn]>> {
    let none = Overrides::none();
    let own = check::table(document).cloned();
    let table: Variants = match own {
        Some(table) => table,
        None => Table::open("t.csv", header(document).as_bytes()).expect("read").ok()?.columns,
    };
    check::columns(document, &none, &table).0.map(Arc::from)
}

/// The values of the file, and those of its first rows.
fn starts(document: &Document, columns: &Arc<[RowColumn]>) -> Vec<Vec<f64>> {
    if let Some(table) = check::table(document) {
        let rows = check::file_rows(table, columns);
        return rows.iter().map(|row| row.row.entries().map(|(_, cell)| cell.value).collect()).collect();
    }
    let Some(mechanism) = check::check(document, &Overrides::none()).0 else { return Vec::new() };
    let value = |column: &RowColumn| {
        let named = mechanism.values.iter().find(|v| v.name == column.name)?;
        match named.value {
            assur::internals::model::Value::Scalar(x) => Some(x),
            _ => None,
        }
    };
    columns.iter().map(value).collect::<Option<Vec<f64>>>().into_iter().collect()
}

fn shown(solved: Option<&Solved>, problems: &Problems, source: &Source) -> String {
    let views = problems.views(source);
    let Some(solved) = solved else { return format!("{views:?}") };
    let Solved { compiled, solution, outcomes, .. } = solved;
    format!(
        "{views:?}\n{outcomes:?}\n{:?}\n{:?}\n{:?}\n{:?}",
        solution, compiled.mechanism, compiled.structure, compiled.plan
    )
}

/// How far a row goes from the values of the file: most keep close, some do not.
fn factor(i: usize, state: &mut u64) -> f64 {
    match (i % 8, random(state)) {
        (6, x) => 3.0 * x - 1.0,
        (7, x) if x < 0.3 => 0.0,
        (_, x) => 0.9 + 0.2 * x,
    }
}

#[test]
fn a_quick_row_is_a_row_that_is_checked_as_a_whole() {
    let mut found = Vec::new();
    files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("examples"), &mut found);
    let mut state = 7;
    let (mut quick_files, mut quick_rows, mut failed) = (0, 0, 0);
    for path in found {
        let text = std::fs::read_to_string(&path).expect("an example");
        let source = Source::new("example.mech", text);
        let document = Arc::new(assur::internals::syntax::parse(&source).0);
        let Some(columns) = columns(&document).filter(|c| !c.is_empty()) else { continue };
        let starts = starts(&document, &columns);
        if starts.is_empty() {
            continue;
        }
        let none = Overrides::none();
        let (mut quick, mut whole) =
            (VariantSolver::new(&document, &none), VariantSolver::new(&document, &none));
        let row_of = |cells: Vec<f64>| {
            let digit = |x: f64| (x.abs() * 1e-3).max(1e-9);
            let cells = cells.into_iter().map(|value| RowCell { value, digit: digit(value) });
            Row::new(columns.clone(), cells.collect())
        };
        if !quick.prepare(&row_of(starts[0].clone())) {
            eprintln!("NOT {}", path.display());
            continue;
        }
        quick_files += 1;
        for i in 0..ROWS {
            let cells = columns.iter().zip(&starts[i % starts.len()]).map(|(column, x)| {
                let changed = column.what == ColumnUse::Given || i % 5 == 4;
                if changed { x * factor(i, &mut state) } else { *x }
            });
            let row = row_of(cells.collect());
            let (solved, problems) = quick.solve_in_place(&row);
            let in_place = shown(solved, &problems, &source);
            let (solved, problems) = whole.solve(&row);
            assert!(
                in_place == shown(solved.as_ref(), &problems, &source),
                "{} with {}:\n{in_place}\n\nbut\n\n{}",
                path.display(),
                row.words(),
                shown(solved.as_ref(), &problems, &source)
            );
            quick_rows += 1;
            failed += usize::from(solved.is_none() || problems.has_errors());
            if in_place.len() > LONG {
                break;
            }
        }
    }
    // rows of both kinds
    assert!(
        quick_files > 40 && quick_rows > 1500 && failed > 100,
        "{quick_files} files, {quick_rows} rows, {failed} without answers"
    );
}
