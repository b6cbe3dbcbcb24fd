//! Mistakes that are found when the machine is put together or solved, and notes: `tests/cases/use3/messages`.

use crate::case::Paste::{Line, Whole};
use crate::case::{Case, judge, near, said, text};
use assur::internals::check::Overrides;
use assur::internals::diagnostic::DiagnosticView;
use assur::internals::source::Source;
use proptest::prelude::*;
use std::fmt::Write;

const REPEATED: &[&str] = &["mech::determinacy::repeated"];
const OVER: &[&str] = &["mech::determinacy::overconstrained"];
const DEAD: &[&str] = &["mech::solve::dead_position"; 4];

const CASES: &[Case] = &[
    near(
        "use3/messages/ring-two-pairs-of-one-ratio",
        REPEATED,
        "`mesh n` repeats what `mesh m` does already",
        &[Whole("mesh n: b - d\n", "")],
    ),
    near(
        "use3/messages/ring-of-six",
        REPEATED,
        "leave out `mesh m6`, the motion stays the same",
        &[Whole("mesh m6: f - a\n", "")],
    ),
    near(
        "use3/messages/ring-of-five",
        OVER,
        "`I` would have to turn at −1 times its own speed, so nothing can turn",
        &[Whole("mesh m5: e - a\n", "")],
    ),
    near(
        "use3/messages/clutch-with-two-speeds",
        OVER,
        "add `slipping` to the clutch, as in `clutch k: I - II { capacity 40 N*m; slipping }`",
        &[Whole("{ capacity 40 N*m }", "{ capacity 40 N*m; slipping }")],
    ),
    near("use3/messages/change-point-at-182", DEAD, "dead position at pose 6 (a = 180 deg)", &[]),
    near(
        "use3/messages/drive-missing",
        &["mech::determinacy::underconstrained"],
        "add one of\n  drive ring at 0 rpm\n",
        &[Line("drive ring at 0 rpm")],
    ),
    near(
        "use3/messages/drive-missing",
        &["mech::determinacy::underconstrained"],
        "",
        &[Line("drive carrier at 60 rpm")],
    ),
    near(
        "use3/messages/drive-missing",
        &["mech::determinacy::underconstrained"],
        "",
        &[Line("drive planet at 60 rpm")],
    ),
    near(
        "use3/messages/does-not-turn-fully",
        &["mech::solve::no_extreme"],
        "closes from 13.29 deg to 137.8 deg only",
        &[
            Whole(
                "drive crank = 0 deg .. 360 deg in 12 steps at 60 rpm",
                "drive crank = 14 deg .. 137 deg in 12 steps at 60 rpm",
            ),
            Whole("stroke(D)", "max(displacement(D)) - min(displacement(D))"),
        ],
    ),
];

#[test]
fn machines_that_do_not_fit() {
    judge(CASES, said);
}

/// Everything that is said of a text, notes too.
fn all(text: &str) -> Vec<DiagnosticView> {
    let source = Source::new("text.mech", text);
    assur::internals::solve_source(&source, &Overrides::none()).1.views(&source)
}

#[test]
fn notes_that_lead_to_what_is_missing() {
    let cases = [
        (
            "teeth-mismatch",
            "mech::train::planet_distance",
            "write `wheel r teeth 80`",
            "wheel r teeth 79",
            "wheel r teeth 80",
        ),
        (
            "inertia-before-mass-missing-S",
            "mech::geometry::point_mass",
            "add `mass 1 kg at B`",
            "inertia 0.0425",
            "mass 1 kg at B; inertia 0.0425",
        ),
    ];
    for (case, code, words, old, new) in cases {
        let text = text(&format!("use3/messages/{case}"));
        let found = all(&text);
        assert_eq!(found.len(), 1, "{case}: {found:#?}");
        assert!(found[0].code.as_deref() == Some(code) && said(&found).contains(words), "{found:#?}");
        let fixed = all(&text.replace(old, new));
        assert!(fixed.is_empty(), "{case}: {fixed:#?}");
    }
    let found = all(&text("use3/messages/bevel-differential"));
    assert!(said(&found).contains("`left` and `right` turn in the same direction"), "{found:#?}");
    // its axial force is that of the load too: see "Reactions" of the language
    assert!(all(&text("use3/messages/truss-load-on-a-pin")).is_empty());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(crate::share::part(60)))]

    /// A Geneva wheel is back after as many turns as it has slots: the range that is offered is a whole cycle.
    #[test]
    fn the_range_that_is_offered_is_a_whole_cycle(slots in 3i32..12, turns in 1i32..4, from in -90i32..90) {
        let with = |range: &str| format!(
            "ground {{ A (0, 0); C (100 mm, 0) }}\nlink crank A-B 100 mm*sin(180 deg/{slots})\n\
             link wheel {{ C (0, 0); line slot through C along 0 deg }}\nrevolute A: ground - crank\n\
             revolute C: ground - wheel\nslot K: crank.B - wheel.slot {{ slots {slots} }}\n\
             drive crank = {range} at 60 rpm\nfind mean(omega(wheel))"
        );
        let found = all(&with(&format!("{from} deg .. {} deg in 24 steps", from + 360 * turns)));
        let help = found.first().and_then(|d| d.help.clone()).unwrap_or_default();
        let offered = help.rsplit_once("write `").map(|(_, range)| range.trim_end_matches('`'));
        if turns % slots == 0 {
            prop_assert!(found.is_empty(), "{:#?}", found);
        } else {
            let left = offered.map(|range| all(&with(range)));
            prop_assert!(left.as_ref().is_some_and(Vec::is_empty), "{}\n{:#?}", help, left);
        }
    }

    /// Shafts in a ring, each with two wheels: by the product of the ratios the ring turns or is locked.
    #[test]
    fn rings_turn_where_their_ratios_agree(
        radii in prop::collection::vec((1u32..9, 1u32..9), 2..7),
        agrees in any::<bool>(),
    ) {
        let n = radii.len();
        // the speed of the last shaft for one of the first, and what the last mesh has to make of it
        let ratio: f64 = radii[1..].iter().zip(&radii).map(|((a, _), (_, b))| -f64::from(*b) / f64::from(*a)).product();
        let closing = if agrees { -ratio } else { -ratio * 1.25 };
        prop_assume!(closing > 0.0);
        let mut text = String::from("mech 1\n");
        for (i, (a, b)) in radii.iter().enumerate() {
            // the first shaft meshes with the last by a wheel that fits
            let _ = writeln!(text, "shaft s{i} {{ wheel a{i} radius {a} mm; wheel b{i} radius {b} mm; wheel c{i} radius {} mm }}",
                if i == 0 { 1.0 } else { 1.0 / closing });
        }
        for i in 1..n {
            let _ = writeln!(text, "mesh m{i}: b{} - a{i}", i - 1);
        }
        let last = n - 1;
        let _ = writeln!(text, "mesh m0: c{last} - c0\ndrive s0 at 10 rad/s\nfind omega(s{last})");
        let found = all(&text);
        let code = found.iter().find(|d| d.severity == "error").and_then(|d| d.code.clone());
        // c_last turns c_0 by −r_last/r_0 = −1/closing: around the ring −ratio/closing
        let around = -ratio / closing;
        let wanted = if (around - 1.0).abs() < 1e-9 { REPEATED[0] } else { OVER[0] };
        prop_assert_eq!(code.as_deref(), Some(wanted), "{}\n{:#?}", text, found);
        if wanted == REPEATED[0] {
            let without = text.replace(&format!("mesh m0: c{last} - c0\n"), "");
            prop_assert!(all(&without).iter().all(|d| d.severity != "error"), "{}", without);
        }
    }
}
