//! A row of variants is solved on what was found once for all rows; it comes out, bit for bit, as the file with these
//! values set from outside.

use assur::internals::check::{self, Overrides, Row, RowCell, RowColumn};
use assur::internals::pipeline::VariantSolver;
use assur::internals::report::{self, PrintedDigits, csv, rows::AnswerColumns, rows::FULL};
use assur::internals::source::Source;
use assur::internals::syntax::document::Variants;
use assur::internals::{Solved, diagnostic::Problems};
use std::path::Path;
use std::sync::Arc;

/// Files with givens: dyads, slots, friction, locking, general groups, critical values, sweeps, mass substitution.
const FILES: [&str; 17] = [
    "crank-slider.mech",
    "inertia/engine.mech",
    "mass-substitution/connecting-rod.mech",
    "statics/guide-bar.mech",
    "kinetostatics/six-bar.mech",
    "slotted/first-kind.mech",
    "friction/incline-up.mech",
    "friction/incline-locked.mech",
    "friction/toggle-press-working.mech",
    "friction/groove-v.mech",
    "contacts/scotch-yoke.mech",
    "exercise-set/06-statics-of-a-crank-slider.mech",
    "exercise-set/14-scotch-yoke.mech",
    "exercise-set/21-class-iii-group.mech",
    "simulation/elliptic-trammel.mech",
    "simulation/fan.mech",
    "simulation/flap-in-oil.mech",
];
const ROWS: usize = 40;

/// A number in [0, 1), the same at every run.
fn random(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*state >> 11) as f64 / (1_u64 << 53) as f64
}

/// The givens of a file that are numbers with a unit: name, unit, value in it.
fn givens(source: &Source) -> Vec<(String, String, f64)> {
    let lines = source.text.lines().filter_map(|l| l.strip_prefix("given "));
    let parts = lines.filter_map(|line| {
        let (name, rest) = line.split_once('=')?;
        let value = rest.split("//").next()?.trim();
        let (number, unit) = value.split_once(' ').unwrap_or((value, ""));
        Some((name.trim().to_owned(), unit.trim().to_owned(), number.parse().ok()?))
    });
    parts.collect()
}

/// An example without a table of its own.
fn example(file: &str) -> Source {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples").join(file);
    let text = std::fs::read_to_string(path).expect("an example");
    let text =
        if text.contains("variants {") { text.split("\nexpect").next().unwrap_or_default() } else { &text };
    Source::new(file, text)
}

fn codes(problems: &Problems, source: &Source) -> Vec<String> {
    problems.views(source).into_iter().map(|v| format!("{:?} {}", v.code, v.message)).collect()
}

fn shown(solved: Option<&Solved>) -> String {
    let Some(solved) = solved else { return "not solved".to_owned() };
    let answers = solved.answers(PrintedDigits::READABLE);
    let outcomes = solved.outcomes.iter().map(|o| format!("{} {:?} {:?}\n", o.text, o.got, o.expected));
    let states = solved.solution.poses.iter().filter_map(|p| p.outcome.as_ref().ok());
    let states: String =
        states.map(|s| format!("{:?}\n{:?}\n", s.state.motion.bodies, s.state.forces.reactions)).collect();
    csv::render(&report::table_of_poses(&answers)) + &outcomes.collect::<String>() + &states
}

#[test]
fn a_row_is_the_file_with_these_values() {
    let mut state = 42;
    let (mut solved_rows, mut failed_rows) = (0, 0);
    for file in FILES {
        let source = example(file);
        let (document, _) = assur::internals::syntax::parse(&source);
        let document = Arc::new(document);
        let givens = givens(&source);
        assert!(!givens.is_empty(), "{file}");
        let columns: Arc<[RowColumn]> = columns_of(&source, &givens);
        let none = Overrides::none();
        let mut family = VariantSolver::new(&document, &none);
        for _ in 0..ROWS {
            let values: Vec<f64> = givens.iter().map(|g| g.2 * (0.3 + 2.5 * random(&mut state))).collect();
            let cell = |(column, value): (&RowColumn, &f64)| RowCell {
                value: column.unit.to_si(*value),
                digit: 1.0,
            };
            let row = Row::new(columns.clone(), columns.iter().zip(&values).map(cell).collect());
            let (fast, fast_problems) = family.solve(&row);
            let set =
                givens.iter().zip(&values).map(|((name, unit, _), v)| (name.clone(), format!("{v:?}{unit}")));
            let (whole, problems) = assur::internals::solve_source(&source, &Overrides::set(set.collect()));
            assert_eq!(shown(fast.as_ref()), shown(whole.as_ref()), "{file} with {}", row.words());
            assert_eq!(
                codes(&fast_problems, &source),
                codes(&problems, &source),
                "{file} with {}",
                row.words()
            );
            if fast.is_some() { solved_rows += 1 } else { failed_rows += 1 }
        }
    }
    // rows of both kinds are compared
    assert!(solved_rows > 100 && failed_rows > 10, "{solved_rows} solved, {failed_rows} not");
}

fn columns_of(source: &Source, givens: &[(String, String, f64)]) -> Arc<[RowColumn]> {
    let header = givens.iter().map(|(name, unit, _)| match unit.as_str() {
        "" => name.clone(),
        unit => format!("{name} [{unit}]"),
    });
    let text = header.collect::<Vec<_>>().join(",") + "\n";
    let table = assur::internals::exercise::table::Table::open("t.csv", text.as_bytes()).expect("read");
    let table: Variants = table.map_err(|_| "a header").expect("a header").columns;
    let (document, _) = assur::internals::syntax::parse(source);
    let document = Arc::new(document);
    let (columns, problems) = check::columns(&document, &Overrides::none(), &table);
    assert!(problems.is_empty());
    columns.expect("columns that fit").into()
}

#[test]
fn a_batch_writes_what_solve_writes() {
    let mut written = 0;
    for file in FILES {
        let source = example(file);
        let (solved, _) = assur::internals::solve_source(&source, &Overrides::none());
        let Some(solved) = solved else { continue };
        // what names events has a column more
        if solved.compiled.mechanism.events.iter().any(|event| event.name.is_some()) {
            continue;
        }
        let answers = solved.answers(PrintedDigits::READABLE);
        let columns = AnswerColumns::of(&answers.model);
        let mut text = std::iter::once(columns.pose_header().to_owned()).chain(columns.headers(false));
        let head: Vec<String> = text.by_ref().map(|h| csv::field(&h).into_owned()).collect();
        let mut lines = (head.join(",") + csv::LINE_END).into_bytes();
        let whole = columns.whole(&answers);
        for pose in answers.poses() {
            lines.extend(pose.name.as_bytes());
            columns.write(&answers, (Some(pose), &whole), (FULL, false, None), &mut lines);
            lines.extend(csv::LINE_END.as_bytes());
        }
        let lines = String::from_utf8(lines).expect("text");
        assert_eq!(lines, csv::render(&report::table_of_poses(&answers)), "{file}");
        written += 1;
    }
    assert!(written >= FILES.len() - 3, "{written}");
}

/// A crank-slider that rubs in its guide.
const RUBS: &str = "
given f = 0.1
ground { A (0, 0); line guide through A along 0 deg }
link crank A-B 100 mm
link rod B-C 350 mm
link piston { C (0, 0); mass 2 kg }
revolute A: ground - crank
revolute B: crank - rod
revolute C: rod - piston
prismatic D: piston.C - ground.guide { friction f }
drive crank = 60 deg at 1500 rpm
assemble C ahead of B
force on piston at C = 1000 N @ 180 deg
find reactions
";

#[test]
fn the_columns_of_one_row_are_those_of_another_structure() {
    let source = Source::new("rubs.mech", RUBS);
    let solved = |f: &str| {
        let set = Overrides::set(vec![("f".to_owned(), f.to_owned())]);
        assur::internals::solve_source(&source, &set).0.expect("it closes")
    };
    let (smooth, rough) = (solved("0"), solved("0.2"));
    for (first, other) in [(&smooth, &rough), (&rough, &smooth)] {
        let answers = other.answers(PrintedDigits::READABLE);
        let written = |columns: &AnswerColumns| {
            let mut line = Vec::new();
            let write = |pose| columns.write(&answers, (Some(pose), &[]), (FULL, false, None), &mut line);
            answers.poses().for_each(write);
            line
        };
        let model = first.answers(PrintedDigits::READABLE).model;
        assert_eq!(written(&AnswerColumns::of(&model)), written(&AnswerColumns::of_file(&answers.model)));
    }
}
