//! A long file is checked at once.
//!
//! `cargo test --release --test answers large -- --nocapture` prints how long each stage takes.

use crate::busy::Busy;
use assur::internals::check::{Overrides, check};
use assur::internals::plan::plan;
use assur::internals::source::Source;
use assur::internals::structure::structure;
use assur::internals::syntax::parse;
use std::fmt::Write;
use std::time::Duration;

const DYADS: usize = 1_000;

/// A row of parallel rockers, each joined to the next by a coupler: a crank and `DYADS` dyads, ten lines to each.
fn rockers() -> String {
    let mut text = "mech 1\nmechanism \"Rockers in a row\"\nground {\n  O0 (0, 0)\n".to_owned();
    let mut add = |line: std::fmt::Arguments<'_>| writeln!(text, "{line}").expect("a text");
    for i in 1..=DYADS {
        add(format_args!("  O{i} ({} mm, 0)", 100 * i));
    }
    add(format_args!("}}\nlink r0 O0-T0 50 mm\nrevolute O0: ground - r0\ndrive r0 = 60 deg at 60 rpm"));
    for i in 1..=DYADS {
        let before = i - 1;
        add(format_args!("// dyad {i}"));
        add(format_args!("given l{i} = 100 mm"));
        add(format_args!("let   h{i} = l{i} / 2      // its rocker"));
        add(format_args!("link k{i} T{before}-T{i} l{i}"));
        add(format_args!("link r{i} O{i}-T{i} h{i} {{ S (h{i}/2, 0); mass 1 kg at S; inertia 0.1 kg*m^2 }}"));
        add(format_args!("revolute O{i}: ground - r{i}"));
        add(format_args!("revolute T{before}: r{before} - k{i}"));
        add(format_args!("revolute U{i}: k{i}.T{i} - r{i}.T{i}"));
        add(format_args!("assemble U{i} right of T{before}-O{i}"));
    }
    add(format_args!("find angle(r{DYADS})"));
    text
}

#[test]
fn a_thousand_dyads() {
    let source = Source::new("rockers.mech", rockers());
    assert!(source.text.lines().count() >= 10_000, "{}", source.text.lines().count());
    let start = Busy::start();
    let (document, problems) = parse(&source);
    let parsed = start.elapsed();
    assert!(problems.is_empty(), "{:#?}", problems.views(&source).first());
    let (mechanism, problems) = check(&document, &Overrides::none());
    let checked = start.elapsed();
    assert!(problems.is_empty(), "{:#?}", problems.views(&source).first());
    let mechanism = mechanism.expect("nothing is wrong");
    let (structure, _) = structure(&mechanism).expect("a chain of dyads");
    let split = start.elapsed();
    assert_eq!(structure.motion.len(), DYADS + 1);
    let plan = plan(&mechanism, &structure);
    let planned = start.elapsed();
    let model = assur::internals::solve::Model { mechanism: &mechanism, structure: &structure, plan: &plan };
    let solution = assur::internals::solve::solve(&model).expect("it closes");
    let solved = start.elapsed();
    assert!(solution.poses[0].outcome.is_ok());
    println!(
        "{} lines: parse {parsed:?}, check {:?}, structure {:?}, plan {:?}, assemble and solve {:?}",
        source.text.lines().count(),
        checked - parsed,
        split - checked,
        planned - split,
        solved - planned
    );
    // far more than a quiet machine needs, far less than a quadratic loop would take
    assert!(split < Duration::from_secs(3), "{split:?}");
    assert!(solved < Duration::from_secs(10), "{solved:?}");
}
