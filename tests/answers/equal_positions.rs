//! Positions that are equal to the ones before them, which no step leads to.

#![allow(clippy::disallowed_methods, reason = "an independent computation")]

use assur::internals::check::Overrides;
use assur::internals::diagnostic::{Style, render};
use assur::internals::solve::{Block, Following, Pose, PoseOutputs};
use assur::internals::source::Source;
use proptest::prelude::*;

const MACHINE: &str = "ground { A (0, 0); line guide through A along 0 deg }
link crank A-B 100 mm
link rod B-C 350 mm
link piston { C (0, 0) }
revolute A: ground - crank
revolute B: crank - rod
revolute C: rod - piston
prismatic D: piston.C - ground.guide
assemble C ahead of B
find x = displacement(D) as mm, v = velocity(C).x
";

fn driven(positions: &[f64]) -> String {
    let list = positions.iter().map(|deg| format!("{deg} deg")).collect::<Vec<_>>().join(", ");
    format!("{MACHINE}drive crank = {list} at 1500 rpm\n")
}

/// The displacements, m, solved one by one or in lanes.
fn displacements(text: &str, in_lanes: bool) -> Vec<f64> {
    let source = Source::new("equal.mech", text);
    let (compiled, problems) = assur::internals::compile(&source, &Overrides::none());
    let compiled = compiled.unwrap_or_else(|| panic!("{problems:?}"));
    let model = compiled.model();
    let mut following = Following::new(&model, Vec::new()).ok().flatten().expect("it moves");
    let x = |pose: &Pose| pose.outcome.as_ref().expect("it closes").state.motion.bodies[3].p.x;
    let mut found = Vec::new();
    while let Some(pose) = following.next() {
        found.push(x(&pose.expect("it begins")));
        let each = |_: &Vec<f64>, count: usize, work: &(dyn Fn(usize) + Sync)| (0..count).for_each(work);
        if in_lanes {
            following.side_by_side(PoseOutputs::ALL, &mut found, each, |found, sweep| {
                let mut block = Block::default();
                for number in 0..sweep.blocks() {
                    sweep.solve(number, &mut block);
                    found.extend(block.poses().iter().map(x));
                }
                true
            });
        }
    }
    found
}

/// x = r cos φ + √(l² − r² sin² φ)
fn right(deg: f64) -> f64 {
    let (sin, cos) = deg.to_radians().sin_cos();
    0.1 * cos + (0.35_f64.powi(2) - (0.1 * sin).powi(2)).sqrt()
}

fn holds(positions: &[f64]) {
    let text = driven(positions);
    for found in [displacements(&text, false), displacements(&text, true)] {
        assert_eq!(found.len(), positions.len(), "{positions:?}");
        for (x, deg) in found.iter().zip(positions) {
            assert!((x - right(*deg)).abs() < 1e-15, "{x} at {deg} deg");
        }
    }
}

#[test]
fn any_number_of_equal_positions_is_solved() {
    for count in [2, 9, 10, 11, 63, 64, 65, 66, 200] {
        holds(&vec![30.0; count]);
    }
    let case = include_str!("../cases/use3/limits/equal-list.mech");
    assert!(displacements(case, false).iter().all(|x| (x - right(30.0)).abs() < 1e-15));
}

#[test]
fn a_range_of_no_length_is_an_error_before_and_while_it_is_solved() {
    let range = |range: &str| format!("{MACHINE}drive crank = {range} at 1500 rpm\n");
    for empty in [
        "0 deg .. 0 deg in 12 steps",
        "30 deg .. 0.5235987755982988 rad in 1 steps",
        "2 deg .. 2 deg step 1 deg",
        "dead(D, 2) .. 0 deg in 12 steps",
        "dead(D, 1) .. 180 deg in 1 steps",
        "dead(D, 1) .. dead(D, 1) in 3 steps",
    ] {
        let source = Source::new("empty.mech", range(empty));
        let (solved, problems) = assur::internals::solve_source(&source, &Overrides::none());
        let words = format!("{problems:?}");
        assert!(solved.is_none() && words.contains("empty_range"), "{empty}: {words}");
        // what is offered solves
        let from = empty.split(" .. ").next().expect("a range");
        let line = format!("drive crank = {from} at 1500 rpm");
        assert!(render(&problems, &source, Style::PLAIN).contains(&format!("write `{line}`")), "{words}");
        assert_eq!(displacements(&range(from), false).len(), 1, "{line}");
    }
    for some in
        ["0 deg .. 1e-9 deg in 12 steps", "dead(D, 2) .. 1e-9 deg in 12 steps", "0 deg .. 360 deg in 1 steps"]
    {
        assert!(!displacements(&range(some), false).is_empty(), "{some}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(crate::share::part(60)))]

    #[test]
    fn runs_of_equal_positions_are_solved(runs in prop::collection::vec((1..70_usize, -3_i32..4), 1..6)) {
        let mut at = 40.0;
        let mut positions = Vec::new();
        for (count, step) in runs {
            at += 0.5 * f64::from(step);
            positions.extend(std::iter::repeat_n(at, count));
        }
        holds(&positions);
    }
}
