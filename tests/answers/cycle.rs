//! Quantities over the sweep and flywheels, against `tests/reference/cycle.py`, closed formulas and brute force.

use assur::internals::Solved;
use assur::internals::check::Overrides;
use assur::internals::diagnostic::{Style, render};
use assur::internals::model::Value;
use assur::internals::source::Source;
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

const ENGINE: &str = "
ground { A (0, 0); line guide through A along 0 deg }
link crank A-B 100 mm
link rod B-C 350 mm { S (120 mm, 0); mass 2.5 kg at S; inertia 0.03 kg*m^2 }
link piston { C (0, 0); mass 3 kg }
revolute A: ground - crank
revolute B: crank - rod
revolute C: rod - piston
prismatic D: piston.C - ground.guide
gravity 9.81 m/s^2
drive crank = 0 deg .. 360 deg in 12 steps at 1500 rpm
assemble C ahead of B
balance torque Mb on crank
";

const LOADED: &str = "
force P on piston at C = (-4 kN, 0) when 0.2 < travel(D)/stroke(D) < 0.7 and velocity(C).x > 0
";

fn solved(text: &str) -> Solved {
    let source = Source::new("test.mech", text.to_owned());
    let (solved, problems) = assur::internals::test_source(&source, &Overrides::none());
    assert!(problems.is_empty(), "{}", render(&problems, &source, Style::PLAIN));
    solved.expect("it is solved")
}

/// Expectations within relative tolerances; the positions solved for each function over the sweep.
fn holds(text: &str, expected: &[(&str, f64, f64)]) -> Vec<usize> {
    let key: String = expected
        .iter()
        .map(|(what, value, within)| format!("expect {what} = {value:?} within {within:e}\n"))
        .collect();
    let solved = solved(&format!("{text}{key}"));
    assert_eq!(solved.outcomes.len(), expected.len());
    for outcome in &solved.outcomes {
        let (Value::Scalar(got), Value::Scalar(expected)) = (outcome.got, outcome.expected) else { continue };
        println!("{:32} {:.1e}", outcome.text, (got - expected).abs() / expected.abs());
    }
    solved.solution.statics.cycles.iter().map(|c| c.samples).collect()
}

#[test]
fn a_smooth_mechanism_reaches_thirteen_digits_with_thirty_two_samples() {
    let samples = holds(
        ENGINE,
        &[
            ("mean(velocity(C).x^2)/(1 m^2/s^2)", 125.996_139_151_084_76, 1e-13),
            ("mean(Mb^2)/(1 N*m*N*m)", 157_525.479_411_633_96, 1e-13),
        ],
    );
    assert!(samples.iter().all(|n| *n <= 32), "{samples:?}");
}

#[test]
fn a_stroke_between_steps_of_the_search_is_found() {
    // its ends are exactly at 0 and 180 deg, or at other places where the search looks
    for ahead in [0, 2, 30, 90, 178] {
        for drive in ["0 deg .. 360 deg in 10 steps", "7 deg .. 367 deg in 9 steps"] {
            let text = format!(
                "ground {{ A (0, 0); line way through A along {ahead} deg }}\nlink crank A-B 50 mm\n\
                 link yoke {{ C (0, 0); line slot through C along 90 deg }}\nrevolute A: ground - crank\n\
                 slot K: crank.B - yoke.slot\nprismatic D: yoke.C - ground.way\ndrive crank = {drive}\n\
                 find stroke(D), dead(D, 1), dead(D, 2)\n"
            );
            holds(
                &text,
                &[
                    ("stroke(D)/(1 m)", 0.1, 1e-14),
                    ("dead(D, 1)/(1 deg)", f64::from(180 + ahead), 1e-11),
                    ("1 + dead(D, 2)/(1 deg)", f64::from(1 + ahead), 1e-11),
                ],
            );
        }
    }
}

#[test]
fn extremes_are_the_true_ones() {
    holds(
        ENGINE,
        &[
            ("max(velocity(C).x)/(1 m/s)", 16.340_115_863_194_318, 1e-14),
            ("min(velocity(C).x)/(1 m/s)", -16.340_115_863_194_318, 1e-14),
            ("argmax(velocity(C).x)/(1 rad)", 4.971_821_929_416_299, 1e-12),
            ("argmax(-velocity(C).x)/(1 rad)", TAU - 4.971_821_929_416_299, 1e-12),
            ("max(position(C).x)/(1 m)", 0.45, 1e-15),
            ("max(angle(rod))/(1 rad)", libm::asin(0.1 / 0.35), 1e-14),
        ],
    );
}

#[test]
fn a_load_that_switches_costs_no_digits() {
    holds(
        &format!("{ENGINE}{LOADED}"),
        &[
            ("mean(Mb)/(1 N*m)", 200.0 / PI, 1e-12),
            ("integral(Mb)/(1 N*m)", 400.0, 1e-12),
            ("mean(Mb^2)/(1 N*m*N*m)", 204_281.192_380_956_8, 1e-12),
            ("argmax(abs(P.x))/(1 rad)", 4.200_694_753_886_601, 1e-14),
        ],
    );
}

#[test]
fn a_flywheel_is_found_at_the_roots_of_the_difference() {
    let text = format!(
        "{ENGINE}{LOADED}
flywheel J on crank for Mb {{ fluctuation 1/50; rim {{ diameter 0.4 m; density 7200 kg/m^3; height_to_width 2 }} }}
flywheel L on crank for Mb {{ fluctuation 1/50; with_links }}
"
    );
    let inertia = 1.549_830_006_572_904_5;
    holds(
        &text,
        &[
            ("fluctuation(J)/(1 J)", 764.810_452_690_614_4, 1e-12),
            ("J/(1 kg*m^2)", inertia, 1e-12),
            ("L/(1 kg*m^2)", inertia - 0.034_499_085_037_360_5, 1e-12),
            ("argmax(work(J))/(1 rad)", 5.207_996_156_133_107, 1e-11),
            ("argmax(-work(J))/(1 rad)", 3.258_624_273_320_768_4, 1e-11),
            ("(max(work(J)) - min(work(J)))/(1 J)", 764.810_452_690_614_4, 1e-12),
            ("mean(reduced_inertia(J))/(1 kg*m^2)", 0.034_499_085_037_360_5, 1e-12),
            ("rim(J).width^2/(1 m^2)", 4.0 * inertia / (2.0 * PI * 0.064 * 7200.0), 1e-12),
            ("rim(J).height/rim(J).width", 2.0, 1e-14),
            ("rim(J).mass/(1 kg)", 4.0 * inertia / 0.16, 1e-12),
        ],
    );
}

#[test]
fn a_flywheel_does_not_hang_on_where_the_sweep_begins_nor_on_its_sense() {
    let of = |drive: &str| {
        let text = format!("{ENGINE}{LOADED}flywheel J on crank for Mb {{ fluctuation 1/50 }}\nfind J\n");
        let solved = solved(&text.replace("0 deg .. 360 deg in 12 steps at 1500 rpm", drive));
        solved.solution.statics.flywheels[0].inertia
    };
    let first = of("0 deg .. 360 deg in 12 steps at 1500 rpm");
    for drive in [
        "77 deg .. 437 deg in 5 steps at 1500 rpm",
        "0 deg .. 720 deg in 5 steps at 1500 rpm",
        "360 deg .. 0 deg in 9 steps at 1500 rpm",
    ] {
        let again = of(drive);
        assert!((again - first).abs() < 1e-12 * first, "{drive}: {again} {first}");
    }
}

#[test]
fn a_given_ratio_puts_the_flywheel_on_a_faster_shaft() {
    let text = format!(
        "{ENGINE}{LOADED}
flywheel J on crank for Mb {{ fluctuation 1/50 }}
flywheel K on crank for Mb {{ fluctuation 1/50; ratio 3 }}
expect K = J/9 within 1e-13
expect fluctuation(K) = fluctuation(J) within 1e-13
"
    );
    solved(&text);
}

/// A torque by a law of its own: the work of M (1 + cos φ) less its mean goes from −M to M.
#[test]
fn a_flywheel_evens_out_a_given_torque() {
    solved(
        "ground { A (0, 0) }
        link crank A-B 100 mm
        revolute A: ground - crank
        drive crank = 0 deg .. 360 deg in 8 steps at 20 rad/s
        torque Md on crank = 10 N*m*(1 + cos(angle(crank)))
        flywheel J on crank for Md { fluctuation 1/50 }
        flywheel K on crank { fluctuation 1/50 }
        find J, K
        expect fluctuation(J) = 20 J within 1e-13
        expect J = 2.5 kg*m^2 within 1e-13
        expect K = J within 1e-13
        expect argmax(work(J)) = 90 deg within 1e-12
        expect mean(reduced_torque(J)) = 10 N*m within 1e-13
        ",
    );
}

/// Friction changes its sense at the dead positions.
#[test]
fn a_flywheel_without_friction_is_that_of_the_file_without_friction() {
    let file = |friction: &str| {
        format!(
            "{}{LOADED}flywheel J on crank for Mb {{ fluctuation 1/40; rim {{ diameter 0.5 m; density 7200 kg/m^3; height_to_width 1.5 }} }}
flywheel L on crank for Mb {{ fluctuation 1/40; with_links }}
let twice = 2*J
find {{asked}}
",
            ENGINE.replace("ground.guide\n", &format!("ground.guide{friction}\n"))
        )
    };
    let asked =
        ["J", "fluctuation(J)", "rim(J).width", "L", "twice", "work(J)", "reduced_torque(J)", "max(work(J))"];
    let answers = |friction: &str, wrapped: bool| {
        let items = asked.map(|what| if wrapped { format!("frictionless({what})") } else { what.to_owned() });
        let solution =
            assur::solve(file(friction).replace("{asked}", &items.join(", "))).expect("it is solved");
        let pose = &solution.poses()[4];
        let answer = |item: &String| pose.get(item).and_then(assur::Answer::number);
        items.each_ref().map(|item| answer(item).unwrap_or_else(|| panic!("{item}")))
    };
    let rubbing = " { friction 0.15 }";
    let (plain, ideal, with) = (answers("", false), answers(rubbing, true), answers(rubbing, false));
    for (i, what) in asked.into_iter().enumerate() {
        assert!(
            (plain[i] - ideal[i]).abs() <= 1e-11 * plain[i].abs(),
            "{what}: {} and {}",
            plain[i],
            ideal[i]
        );
        assert!((plain[i] - with[i]).abs() > 1e-4 * plain[i].abs(), "{what} does not depend on friction");
    }
}

#[test]
fn friction_is_split_where_it_changes_its_sense() {
    let text = ENGINE
        .replace("ground.guide\n", "ground.guide { friction 0.1 }\n")
        .replace("mass 2.5 kg at S; inertia 0.03 kg*m^2", "")
        .replace("; mass 3 kg", "")
        .replace("gravity 9.81 m/s^2", "force on piston at C = 1 kN against motion")
        .replace("12 steps", "7200 steps");
    let source = Source::new("test.mech", format!("{text}find Mb, mean(Mb), mean(frictionless(Mb))\n"));
    let (solved, _) = assur::internals::solve_source(&source, &Overrides::none());
    let solution = solved.expect("it is solved").solution;
    let efforts =
        solution.poses.iter().map(|p| p.outcome.as_ref().expect("it moves").state.forces.efforts[0]);
    let brute = efforts.sum::<f64>() / 7200.0;
    let (with, without) = (&solution.statics.cycles[0], &solution.statics.cycles[1]);
    assert_eq!(with.splits.len(), 1, "{with:?}");
    assert!((with.value - brute).abs() < 1e-5 * brute, "{} {brute}", with.value);
    // 1 kN over 0.2 m, there and back
    assert!((without.value - 200.0 / PI).abs() < 1e-10, "{}", without.value);
    assert!(with.value > without.value && with.error < 1e-10 * with.value, "{with:?}");
}

#[test]
fn a_mechanism_that_does_not_close_has_no_mean() {
    let text = "ground { A (0, 0); D (300 mm, 0) }
        link crank A-B 200 mm
        link coupler B-C 120 mm
        link rocker C-D 150 mm
        revolute A: ground - crank
        revolute B: crank - coupler
        revolute C: coupler - rocker
        revolute D: ground - rocker
        drive crank = 0 deg .. 90 deg in 3 steps
        assemble C right of B-D
        expect mean(angle(rocker)) = 1 rad within 1 rad
        ";
    let source = Source::new("test.mech", text.to_owned());
    let (_, problems) = assur::internals::test_source(&source, &Overrides::none());
    let said = render(&problems, &source, Style::PLAIN);
    assert!(said.contains("does not close at crank"), "{said}");
}

#[test]
fn a_part_of_a_turn_is_integrated_too() {
    let text = ENGINE.replace("0 deg .. 360 deg in 12 steps", "20 deg .. 110 deg in 3 steps");
    // ∫ v/ω dφ is the way
    holds(&text, &[("integral(velocity(C).x/omega(crank))/(1 m)", x(110.0) - x(20.0), 1e-13)]);
}

fn x(deg: f64) -> f64 {
    let phi = deg.to_radians();
    0.1 * libm::cos(phi) + (0.35_f64 * 0.35 - libm::pow(0.1 * libm::sin(phi), 2.0)).sqrt()
}

/// A crank-rocker or crank-slider with masses under gravity, and nothing else.
fn smooth_machine() -> impl Strategy<Value = String> {
    // the crank turns fully: r + d is at most l + c, r + |l - c| at most d
    let lengths = (0.05..0.15, 0.35..0.5, 0.35..0.5, 0.4..0.5);
    let masses = (0.5..5.0, 0.5..5.0, 0.01..0.2, 0.01..0.2, -0.1..0.1, -200.0..200.0);
    (lengths, masses, any::<bool>()).prop_map(|((r, l, c, d), (m2, m3, j2, j3, s, rate), rocker)| {
        let last = if rocker {
            format!(
                "link last C-D {c} m {{ T ({s} m, 0.1 m); mass {m3} kg at T; inertia {j3} kg*m^2 }}
                revolute C: rod - last
                revolute D: ground - last
                assemble C left of B-D"
            )
        } else {
            format!(
                "link last {{ C (0, 0); mass {m3} kg }}
                revolute C: rod - last
                prismatic D: last.C - ground.guide
                assemble C ahead of B"
            )
        };
        format!(
            "ground {{ A (0, 0); D ({d} m, 0); line guide through A along 0 deg }}
            link crank A-B {r} m
            link rod B-C {l} m {{ S (0.1 m, {s} m); mass {m2} kg at S; inertia {j2} kg*m^2 }}
            revolute A: ground - crank
            revolute B: crank - rod
            {last}
            gravity 9.81 m/s^2 @ 250 deg
            drive crank = 10 deg .. 370 deg in 4 steps at {rate} rad/s
            balance torque Mb on crank
            "
        )
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(crate::share::part(40)))]

    /// Over a cycle inertia and weights do no work.
    #[test]
    fn a_cycle_of_inertia_and_weights_takes_no_work(text in smooth_machine()) {
        let solved = solved(&format!("{text}find mean(power(Mb)), max(abs(power(Mb))), integral(Mb), max(abs(Mb))\n"));
        let values: Vec<f64> = solved.solution.statics.cycles.iter().map(|c| c.value).collect();
        prop_assert!(values[0].abs() <= 1e-12 * values[1], "{values:?}");
        prop_assert!(values[2].abs() <= 1e-11 * values[3], "{values:?}");
    }

    /// The fluctuation of work against sums over many positions; a mean against the sum.
    #[test]
    fn a_fluctuation_agrees_with_brute_force(text in smooth_machine(), from in 0.1..0.4, to in 0.5..0.9, force in 100.0..5000.0) {
        let steps = 7200;
        let text = text.replace("in 4 steps", &format!("in {steps} steps"));
        let coordinate = if text.contains("prismatic") { "displacement(D)" } else { "angle(last)" };
        let load = if text.contains("prismatic") {
            format!("force F on last at C = ({force} N, 0)")
        } else {
            format!("torque F on last = {force} N*m")
        };
        let span = format!("(max({coordinate}) - min({coordinate}))");
        let part = format!("({coordinate} - min({coordinate}))/{span}");
        let rate = if text.contains("prismatic") { "relative_velocity(D)/(1 m/s)" } else { "omega(last)/(1 rad/s)" };
        let solved = solved(&format!(
            "{text}{load} when {from} < {part} < {to} and {rate} > 0
            flywheel J on crank for Mb {{ fluctuation 1/50 }}
            find J, Mb, mean(Mb)\n"
        ));
        let torque: Vec<f64> = solved.solution.poses.iter()
            .map(|p| p.outcome.as_ref().expect("it closes").state.forces.efforts[0]).collect();
        let mean = torque.iter().sum::<f64>() / f64::from(steps);
        let (mut work, mut least, mut most) = (0.0, 0.0_f64, 0.0_f64);
        for i in 0..torque.len() {
            let next = torque[(i + 1) % torque.len()];
            work += (0.5 * (torque[i] + next) - mean) * TAU / f64::from(steps);
            (least, most) = (least.min(work), most.max(work));
        }
        let found = &solved.solution.statics.flywheels[0];
        let peak = torque.iter().fold(0.0_f64, |m, t| m.max(t.abs()));
        prop_assert!((found.fluctuation - (most - least)).abs() < 3e-3 * peak, "{} {}", found.fluctuation, most - least);
        let cycle = solved.solution.statics.cycles.last().expect("mean(Mb)").value;
        prop_assert!((cycle - mean).abs() < 2e-3 * peak, "{cycle} {mean}");
    }
}

#[test]
fn a_change_point_has_its_own_angle() {
    // parallelograms and others on grounds of any direction, in steps that do not meet it
    for (base, lengths, beyond) in
        [(0.0, [100, 300, 100], 180.0), (37.25, [100, 300, 100], 180.0), (-12.5, [120, 320, 140], 180.0)]
    {
        let [crank, coupler, rocker] = lengths;
        // crank and ground in line, as coupler and rocker are
        let ground = f64::from(coupler + rocker - crank);
        let (x, y) = (ground * libm::cos(f64::to_radians(base)), ground * libm::sin(f64::to_radians(base)));
        let text = format!(
            "ground {{ A (0, 0); D ({x} mm, {y} mm) }}\nlink crank A-B {crank} mm\nlink coupler B-C {coupler} mm\n\
             link rocker D-C {rocker} mm\nrevolute A: ground - crank\nrevolute B: crank - coupler\n\
             revolute C: coupler - rocker\nrevolute D: ground - rocker\n\
             drive crank = {} deg .. {} deg in 5 steps\nassemble C right of B-D\nfind angle(rocker)\n",
            base + beyond - 91.7,
            base + beyond + 88.3
        );
        let source = Source::new("change.mech", text);
        let (_, problems) = assur::internals::test_source(&source, &Overrides::none());
        let told = render(&problems, &source, Style::PLAIN).replace("\n  │", "");
        assert!(told.contains(&format!("at crank = {} deg", base + beyond)), "{told}");
    }
}
