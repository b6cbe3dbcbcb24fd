//! What a document gives, by what it asks.

use assur_syntax::given::{Given, names_of};
use assur_syntax::parse;
use assur_text::source::Source;
use std::collections::BTreeSet;

const TWO_PARTS: &str = "mech 1
given f = 0.1
given r = 80 mm
given m = 2 kg
let l = 3*r
gravity 9.81 m/s^2
ground { A (0, 0); line guide through A along 0 deg }
link crank A-B r
link rod B-C l
link piston { C (0, 0); mass m at C }
revolute A: ground - crank
revolute B: crank - rod
revolute C: rod - piston
prismatic D: piston.C - ground.guide { friction f }
drive crank = 60 deg at 900 rpm
shaft I { wheel z1 teeth 20 }
shaft II { wheel z2 teeth 50 }
mesh k: z1 - z2
drive I at 600 rpm
balance torque M on crank
";

/// The kinds of the data, and the values in use.
fn given(find: &str) -> (BTreeSet<String>, BTreeSet<String>) {
    let source = Source::new("", format!("{TWO_PARTS}find {find}\n"));
    let document = parse(&source).0;
    let given = Given::of(&document);
    let kinds = given.lines.iter().flat_map(|line| &line.data).map(|datum| datum.kind.key.to_owned());
    (kinds.collect(), given.used.iter().map(|name| (*name).to_owned()).collect())
}

fn names(all: &[&str]) -> BTreeSet<String> {
    all.iter().map(|name| (*name).to_owned()).collect()
}

#[test]
fn a_question_of_motion_needs_no_mass() {
    let (kinds, used) = given("velocity(piston.C)");
    assert!(
        !kinds.contains("mass") && !kinds.contains("friction") && !kinds.contains("gravity"),
        "{kinds:?}"
    );
    assert!(kinds.contains("bar") && kinds.contains("drive.at"), "{kinds:?}");
    assert_eq!(used, names(&["l", "r"]));
    let (kinds, _) = given("angle(rod)");
    assert!(!kinds.contains("drive.at"), "{kinds:?}");
    let (kinds, used) = given("M");
    assert!(kinds.contains("mass") && kinds.contains("friction"), "{kinds:?}");
    assert_eq!(used, names(&["f", "l", "m", "r"]));
}

#[test]
fn a_part_that_nothing_joins_is_left_out() {
    assert!(!given("M").0.contains("wheel.teeth"));
    let (kinds, used) = given("omega(II)");
    assert!(kinds.contains("wheel.teeth") && !kinds.contains("bar"), "{kinds:?}");
    assert_eq!(used, names(&[]));
    // what is of the whole mechanism needs all
    for whole in ["efficiency()", "reactions", "critical(f)"] {
        let (kinds, _) = given(whole);
        assert!(kinds.contains("wheel.teeth") && kinds.contains("mass"), "{whole}: {kinds:?}");
    }
}

#[test]
fn names_are_those_of_values_and_curves() {
    let source = Source::new("", "mech 1\nlet x = 2*p(angle(crank)) - sin(q)^2\n");
    let document = parse(&source).0;
    let lines = assur_syntax::given::lines(&document);
    let value = lines[1].data[0].expressions()[0];
    assert_eq!(names_of(value), ["p", "crank", "q"]);
}
