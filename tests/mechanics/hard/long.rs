//! Long chains and long sweeps.

use super::catalogue::{BOUND, rows};
use assur::internals::check::Overrides;
use assur::internals::model::{FindKind, Value};
use assur::internals::source::Source;
use assur::internals::{Solved, solve_source};
use std::fmt::Write;

fn solved(text: String) -> Solved {
    let source = Source::new("long.mech", text);
    let (solved, problems) = solve_source(&source, &Overrides::none());
    assert!(!problems.has_errors(), "{:?}", problems.views(&source).first());
    solved.expect("an answer")
}

fn value(solved: &Solved, pose: usize, name: &str) -> f64 {
    let find = solved.compiled.mechanism.finds.iter().find(|f| f.name == name).expect("asked for");
    let FindKind::Value { expr, .. } = &find.kind else { panic!("{name}") };
    let at = solved.solution.poses[pose].outcome.as_ref().expect("a position");
    match solved.solution.view(&solved.compiled.model(), at).value(expr) {
        Value::Scalar(x) => x,
        other => panic!("{other:?}"),
    }
}

/// A row of rockers of nearly 50 mm, each joined to the next by a coupler of nearly 100 mm, as in the reference.
fn chain(dyads: i32) -> String {
    let mut text = "mech 1\nmechanism \"Rockers in a row\"\nground {\n  O0 (0, 0)\n".to_owned();
    let mut add = |line: std::fmt::Arguments<'_>| writeln!(text, "{line}").expect("a text");
    for i in 1..=dyads {
        add(format_args!("  O{i} ({} mm, 0)", 100 * i));
    }
    add(format_args!("}}\nlink r0 O0-T0 50 mm\nrevolute O0: ground - r0\ndrive r0 = 60 deg at 2 rad/s"));
    for i in 1..=dyads {
        let before = i - 1;
        let (k, h) = (1000 + (7 * i) % 11 - 5, 500 + (5 * i) % 7 - 3);
        add(format_args!("link k{i} T{before}-T{i} {}.{} mm", k / 10, k % 10));
        add(format_args!("link r{i} O{i}-T{i} {}.{} mm", h / 10, h % 10));
        add(format_args!("revolute O{i}: ground - r{i}"));
        add(format_args!("revolute T{before}: r{before} - k{i}"));
        add(format_args!("revolute U{i}: k{i}.T{i} - r{i}.T{i}"));
        add(format_args!("assemble U{i} left of T{before}-O{i}"));
        if [1, 10, 100, 1000].contains(&i) {
            add(format_args!("find angle{i} = angle(r{i}), omega{i} = omega(r{i})"));
        }
    }
    text
}

#[test]
fn a_chain_of_a_thousand_dyads() {
    let solved = solved(chain(1000));
    let condition = solved.solution.poses[0].outcome.as_ref().expect("it closes").condition;
    for row in rows().into_iter().filter(|r| r.file == "chain") {
        let dyads: f64 = row.settings.parse().expect("a number");
        let got = value(&solved, 0, &format!("{}{}", row.quantity, row.settings));
        let error = ((got - row.value[0]) - row.value[1]).abs() / row.scale;
        // what a dyad loses is carried on by the next
        let bound = BOUND * dyads * f64::EPSILON / condition.powi(row.power);
        println!("{row:?}: {error:.1e} of {bound:.1e}");
        assert!(error <= bound, "{row:?}: error {error:e}, bound {bound:e}");
    }
}

/// A machine over many turns, at the beginning and at the end of each of ten ways.
fn turns(links: [&str; 3], frame: &str, turns: u32) -> Solved {
    let [crank, coupler, rocker] = links;
    let each = turns / 10;
    let positions: Vec<String> = (0..=10).map(|i| format!("{} rev + 40 deg", each * i)).collect();
    solved(format!(
        "mech 1\nmechanism \"Many turns\"\nground {{ A (0, 0); D ({frame}, 0) }}\nlink crank A-B {crank}\n\
         link coupler B-C {coupler}\nlink rocker D-C {rocker}\nrevolute A: ground - crank\n\
         revolute B: crank - coupler\nrevolute C: coupler - rocker\nrevolute D: ground - rocker\n\
         drive crank = {} at 1 rad/s\nassemble C left of B-D\n\
         find phi = angle(crank), chi = angle(coupler), psi = angle(rocker), w = omega(rocker)\n",
        positions.join(", ")
    ))
}

/// 360° in radians times a number of turns, with what f64 can hold of it.
fn after(angle: f64, turns: f64, got: f64) {
    let expected = angle + turns * std::f64::consts::TAU;
    // the drive's own value is rounded to the last place of so many turns
    let bound = 4.0 * f64::EPSILON * (1.0 + expected.abs());
    assert!((got - expected).abs() <= bound, "{got} for {expected}: {:e}", got - expected);
}

#[test]
fn ten_thousand_turns_of_a_four_bar() {
    let solved = turns(["100 mm", "250 mm", "200 mm"], "300 mm", 10_000);
    for pose in 0..=10 {
        let done = 1000.0 * pose as f64;
        after(40_f64.to_radians(), done, value(&solved, pose, "phi"));
        for name in ["chi", "psi"] {
            let (first, last) = (value(&solved, 0, name), value(&solved, pose, name));
            // coupler and rocker swing: they are where they were, but for the rounding of the crank's angle
            assert!((last - first).abs() <= 4.0 * f64::EPSILON * 6.3e4, "{name}: {first} {last}");
        }
    }
}

#[test]
fn ten_thousand_turns_of_a_parallelogram() {
    let solved = turns(["100 mm", "300 mm", "100 mm"], "300 mm", 10_000);
    for pose in 0..=10 {
        let done = 1000.0 * pose as f64;
        after(40_f64.to_radians(), done, value(&solved, pose, "psi"));
        assert!(value(&solved, pose, "chi").abs() <= 4.0 * f64::EPSILON, "the coupler stays parallel");
        assert!((value(&solved, pose, "w") - 1.0).abs() <= 1e-13);
    }
    assert!(solved.solution.notes.len() <= 1);
}
