//! Files on which an answer or a verdict was once wrong, in `tests/cases/numbers`, with what is right.

use assur::internals::check::Overrides;
use assur::internals::model::Value;
use assur::internals::source::Source;

/// The value of a find at the first position, and all messages.
fn solved(text: &str, name: &str) -> (Option<f64>, String) {
    let source = Source::new("case.mech", text);
    let (solved, problems) = assur::internals::test_source(&source, &Overrides::none());
    let words =
        assur::internals::diagnostic::render(&problems, &source, assur::internals::diagnostic::Style::PLAIN);
    let value = solved.and_then(|solved| {
        let model = solved.compiled.model();
        let pose = solved.solution.poses[0].outcome.as_ref().ok()?;
        assert!(pose.residuals.equilibrium? < 1e-12, "{:?}", pose.residuals);
        assert!(pose.residuals.power.is_none_or(|r| r < 1e-12), "{:?}", pose.residuals);
        let view = solved.solution.view(&model, pose);
        let find = model.mechanism.finds.iter().find(|f| f.name == name)?;
        match &find.kind {
            assur::internals::model::FindKind::Value { expr, .. } => match view.value(expr) {
                Value::Scalar(x) => Some(x),
                _ => None,
            },
            _ => None,
        }
    });
    (value, words)
}

fn near(got: Option<f64>, expected: f64, within: f64) {
    let off = got.map(|x| (x / expected - 1.0).abs());
    assert!(off.is_some_and(|off| off <= within), "{got:?}, not {expected}");
}

#[test]
fn all_directions_of_eleven_lossy_meshes_are_tried() {
    let (m, words) = solved(include_str!("../cases/numbers/eleven-lossy-meshes.mech"), "M");
    near(m, 100.015_087_10, 1e-8);
    assert!(words.is_empty(), "{words}");
}

/// The same with a part of its friction: coefficients of J1 and of the slot J5.
fn false_lock(part: f64) -> String {
    let text = include_str!("../cases/numbers/false-lock.mech");
    let text = text.lines().filter(|l| !l.starts_with("expect")).collect::<Vec<_>>().join("\n") + "\n";
    let scaled = |text: &str, coefficient: f64| {
        text.replace(&format!("friction {coefficient}"), &format!("friction {}", coefficient * part))
    };
    scaled(&scaled(&text, 0.346), 0.235)
}

#[test]
fn a_guide_with_two_contacts_and_a_slot_are_not_locked() {
    let steps = [(0.05, 94.96), (0.4, -56.29), (0.6, -234.42), (0.7, -354.48)];
    for (part, expected) in steps {
        near(solved(&false_lock(part), "bal_d1").0, expected, 1e-4);
    }
    let (force, words) = solved(include_str!("../cases/numbers/false-lock.mech"), "bal_d1");
    near(force, -834.983_635_390_114_3, 1e-9);
    assert!(!words.contains("no effort") && words.contains("efficiency is -"), "{words}");
}

#[test]
fn the_coefficient_with_which_it_would_move_is_right() {
    let (_, words) = solved(include_str!("../cases/numbers/false-lock.mech"), "bal_d1");
    let limit = words.split("a coefficient below ").nth(1).and_then(|w| w.split(' ').next());
    let limit: f64 = limit.and_then(|w| w.parse().ok()).unwrap_or_else(|| panic!("{words}"));
    let with = |coefficient: f64| {
        let text = false_lock(1.0).replace("friction 0.346", &format!("friction {coefficient}"));
        solved(&text.replace("find reactions, bal_d1", "find bal_d1, e = efficiency()"), "e")
            .0
            .expect("it is solved")
    };
    for i in 1..20 {
        let coefficient = limit * 0.999 * f64::from(i) / 19.0;
        assert!(with(coefficient) > 0.0, "{coefficient}");
    }
    assert!(with(limit * 1.001) <= 0.0 && with(0.346) <= 0.0);
}

#[test]
fn the_file_with_all_its_pairs_is_not_locked() {
    let (force, words) = solved(include_str!("../cases/numbers/rough-7050.mech"), "bal_d1");
    assert!(force.is_some_and(f64::is_finite) && !words.contains("no effort"), "{force:?} {words}");
}

/// Units that no example has, each in what it measures.
#[test]
fn inches_feet_pounds_and_kilogram_forces_are_read() {
    let text = |length: &str, force: &str, mass: &str| {
        format!(
            "mech 1\nmechanism \"units\"\ngravity 9.80665 m/s^2\nground {{ O (0, 0) }}\n\
             link bar {{ O (0, 0); A ({length}, 0){mass} }}\nrevolute O: ground - bar\n\
             drive bar = 0 deg at 1 rad/s\nforce F on bar at A = {force} @ 90 deg\nbalance torque M on bar\nfind M\n"
        )
    };
    let cases = [
        ("1 inch", "1 lbf", "", -0.0254 * 4.448_221_615_260_5),
        ("1 ft", "1 kgf", "", -0.3048 * 9.806_65),
        ("2 ft", "0 N", "; mass 3 lb at A", 2.0 * 0.3048 * 3.0 * 0.453_592_37 * 9.806_65),
        // a pound of force holds a pound of mass
        ("1 m", "5 lbf", "; mass 6 lb at A", 0.453_592_37 * 9.806_65),
    ];
    for (length, force, mass, expected) in cases {
        near(solved(&text(length, force, mass), "M").0, expected, 1e-14);
    }
}
