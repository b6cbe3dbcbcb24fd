//! What is printed is what was computed: cells of tables for people against the same with all digits.

#![allow(clippy::unwrap_used)] // a test that cannot read its files has failed

use assur::internals::Solved;
use assur::internals::check::Overrides;
use assur::internals::report::document::{Block, Table};
use assur::internals::report::{AccuracyShown, PrintedDigits, of_answers, table_of_poses};
use assur::internals::source::Source;
use proptest::prelude::*;
use std::path::Path;

/// What a table for people shows as 0, as a part of the greatest in its column.
const NOISE: f64 = 1.01e-9;

fn solved(name: &str, text: &str) -> Solved {
    let source = Source::new(name, text);
    let (solved, problems) = assur::internals::solve_source(&source, &Overrides::none());
    solved.unwrap_or_else(|| panic!("{name}: {problems:?}\n{text}"))
}

/// The tables with the answers of a report.
fn answers(solved: &Solved) -> Vec<Table> {
    let report = of_answers("case.mech", &solved.answers(PrintedDigits::READABLE), AccuracyShown::Worst);
    let sections = report.sections.into_iter().filter(|section| section.heading == "Answers");
    let tables = sections.flat_map(|section| section.blocks);
    tables.filter_map(|block| if let Block::Table(table) = block { Some(table) } else { None }).collect()
}

/// The cell of a value over the whole motion, by its name.
fn whole(solved: &Solved, name: &str) -> String {
    let tables = answers(solved);
    let row = tables.iter().flat_map(|table| &table.rows).find(|row| row[0] == name);
    row.unwrap_or_else(|| panic!("{name} in {tables:?}"))[1].clone()
}

/// What is wrong with the cells of a column, beside the same with all digits.
fn wrong(header: &str, shown: &[&str], full: &[&str]) -> Vec<String> {
    let number = |cell: &&str| cell.parse::<f64>().unwrap_or(0.0).abs();
    let greatest = full.iter().map(number).fold(0.0, f64::max);
    let mut wrong = Vec::new();
    for (shown, full) in shown.iter().zip(full) {
        let right = match (shown.parse::<f64>(), full.parse::<f64>()) {
            (Ok(0.0), Ok(full)) => full.abs() <= NOISE * greatest.max(1.0),
            (Ok(shown), Ok(full)) => (shown / full - 1.0).abs() <= 5.1e-6,
            (Err(_), Err(_)) => full.is_empty() || shown == full,
            _ => false,
        };
        if !right {
            wrong.push(format!("{header}: {shown} for {full}"));
        }
    }
    wrong
}

/// What is wrong in the tables of a solved file.
fn wrong_cells(solved: &Solved) -> Vec<String> {
    let full = table_of_poses(&solved.answers(PrintedDigits::READABLE));
    let tables = answers(solved);
    let Some(sweep) = tables.first().filter(|table| table.rows.len() == full.rows.len()) else {
        return Vec::new();
    };
    let column = |table: &Table, i: usize| table.rows.iter().map(|row| row[i].clone()).collect::<Vec<_>>();
    let mut found = Vec::new();
    for i in 1..sweep.columns.len() {
        let own = full.columns.iter().position(|column| column.header == sweep.columns[i].header).unwrap();
        let (shown, full) = (column(sweep, i), column(&full, own));
        let [shown, full] = [&shown, &full].map(|cells| cells.iter().map(String::as_str).collect::<Vec<_>>());
        found.extend(wrong(&sweep.columns[i].header, &shown, &full));
    }
    for row in tables.iter().skip(1).flat_map(|table| &table.rows) {
        let is_own = |header: &str| header == row[0] || header.starts_with(&format!("{} [", row[0]));
        let own = full.columns.iter().position(|column| is_own(&column.header));
        if let Some(own) = own.filter(|_| !row[1].starts_with('(')) {
            found.extend(wrong(&row[0], &[&row[1]], &[&full.rows[0][own]]));
        }
    }
    found
}

#[test]
fn instants_of_events_are_printed() {
    let solved = solved("time-of-event", include_str!("../cases/use3/numbers/time-of-event.mech"));
    // falls from h, rebounds with 0.8 of the speed: t₁ = √(2h/g), the tops lie t₁·(1 + 2·Σ0.8ⁿ) − 0.8ᵏ·t₁ later
    let fall = (2.0 * 2.0 / 9.81_f64).sqrt();
    let top = |k: i32| fall * (1.0 + 2.0 * (1..k).map(|n| 0.8_f64.powi(n)).sum::<f64>() + 0.8_f64.powi(k));
    let right = [("time(rest)", 9.0 * fall), ("time(top)", top(1)), ("time(top, 3)", top(3))];
    for (name, right) in right.into_iter().chain([("time(top, 40)", top(40))]) {
        let shown: f64 = whole(&solved, name).parse().unwrap();
        assert!((shown / right - 1.0).abs() < 5e-6, "{name} {shown}, not {right}");
    }
    assert!(wrong_cells(&solved).is_empty(), "{:?}", wrong_cells(&solved));
}

#[test]
fn the_begin_of_a_run_that_fails_is_printed() {
    let text = include_str!("../cases/use3/numbers/failed-run-prints-zero.mech");
    // whatever ends the run
    let solved = solved("failed-run-prints-zero", &text.replace("50 N*s/m", "5e7 N*s/m"));
    let table = &answers(&solved)[0];
    assert_eq!(table.rows[0][1..], ["-30", "0"], "{table:?}");
    let unknown = |row: &Vec<String>| row[1] == "—" || row[1].parse::<f64>().unwrap().abs() > 1.0;
    assert!(table.rows.iter().all(unknown), "{table:?}");
}

#[test]
fn tables_of_all_motions_show_what_was_computed() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/simulation");
    let paths = std::fs::read_dir(folder).unwrap().flatten().map(|entry| entry.path());
    let mut files = 0;
    for path in paths.filter(|path| path.extension().is_some_and(|e| e == "mech")) {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let wrong = wrong_cells(&solved(&name, &std::fs::read_to_string(&path).unwrap()));
        assert!(wrong.is_empty(), "{name}: {wrong:?}");
        files += 1;
    }
    assert!(files > 20, "{files} files");
}

/// Balls, pendulums and oscillators that reach rest, turn back and are wanted to any number of digits.
fn motion() -> impl Strategy<Value = String> {
    let number = 0.1..3.0_f64;
    (0..3, number.clone(), number.clone(), number, -9..-1_i32).prop_map(|(kind, a, b, c, digits)| {
        let (body, events) = match kind {
            0 => (
                format!("start P = {a} m\nstop P > 0 m {{ restitution {} }}", 0.1 + 0.2 * b),
                "event turn: velocity(bar.B).y = 0 m/s falling\nfind time(turn), max(mag(velocity(bar.B))), velocity(bar.B).y",
            ),
            1 => (
                format!("start P = {a} m at {b} m/s\nforce R on bar at B = {c} N against motion"),
                "event turn: velocity(bar.B).y = 0 m/s\nlet t = 2*time(turn)\nfind t, work(R), velocity(bar.B)",
            ),
            _ => (
                format!("spring k: ground.O - bar.B {{ stiffness {} N/m; free_length 5 m }}\nstart P = {a} m", 10.0 * b),
                "event turn: velocity(bar.B).y = 0 m/s falling\nfind time(turn), work(k), velocity(bar.B), max(mag(velocity(bar.B)))",
            ),
        };
        // instants of events alone, or others too
        let steps = if digits % 2 == 0 { " in 8 steps" } else { "" };
        format!(
            "gravity 9.81 m/s^2\nground {{ O (0, 0); line up through O along 90 deg }}\n\
             link bar {{ B (0, 0); mass {c} kg at B }}\nprismatic P: bar.B - ground.up\n\
             {body}\nsimulate 6 s{steps} within 1e{digits}\n{events}\n"
        )
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(crate::share::part(60)))]

    #[test]
    fn tables_of_random_motions_show_what_was_computed(text in motion()) {
        let wrong = wrong_cells(&solved("random.mech", &text));
        prop_assert!(wrong.is_empty(), "{wrong:?}\n{text}");
    }
}
