//! What accuracy costs: errors are true, fall with the tolerances, and keep what is wanted. Times are never held to anything.

#![allow(clippy::unwrap_used)] // a test that cannot read its files has failed

use crate::share::{least, spread};
use assur::internals::accuracy::{AccuracyStudy, Kind, Setting, Source as Reference, candidates, study};
use assur::internals::check::Overrides;
use assur::internals::plan::{Precision, Settings};
use assur::internals::solve::{PoseOrigin, Solution, State, extent};
use assur::internals::source::Source;
use assur::internals::{Solved, solve_source, solve_within};
use std::path::Path;
use std::sync::LazyLock;
use std::time::Instant;

fn example(name: &str) -> Source {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples").join(name);
    Source::new(name, std::fs::read_to_string(path).unwrap())
}

fn solved(source: &Source) -> Solved {
    solve_source(source, &Overrides::none()).0.unwrap_or_else(|| panic!("{} is solved", source.name))
}

fn studied(source: &Source) -> AccuracyStudy {
    let solved = solved(source);
    study(&solved.compiled.model(), &solved.solution, 1e-9, seconds)
}

/// The clock of this machine.
fn seconds() -> f64 {
    static BEGIN: LazyLock<Instant> = LazyLock::new(Instant::now);
    BEGIN.elapsed().as_secs_f64()
}

fn knob(study: &AccuracyStudy, kind: Kind) -> &Setting {
    study.knobs.iter().find(|k| k.kind == kind).unwrap_or_else(|| panic!("{kind:?} in {study:?}"))
}

/// The torque of the chain is known in closed form: M = g r cos φ (41 m/2 + 40 m_0). Twice the digits give all 16 of it,
/// f64 as many as its error says.
#[test]
fn a_chain_keeps_what_it_says() {
    let source = example("accuracy/chain-of-40-dyads.mech");
    let (compiled, _) = assur::internals::compile(&source, &Overrides::none());
    let mut compiled = compiled.unwrap();
    for (within, numbers) in [(1e-9, Precision::F64), (1e-15, Precision::DoubleDouble)] {
        let (found, problems) = solve_within(compiled, Some(within));
        assert!(!problems.has_errors());
        let found = found.unwrap();
        let reached = found.reached.unwrap();
        assert_eq!(reached.settings.scalar, numbers);
        assert!(reached.is_kept() && reached.source == Reference::DoubleDouble, "{reached:?}");
        // moments go over the extent times the greatest force
        let scale = extent(&found.compiled.model()) * greatest_force(&found.solution);
        for pose in &found.solution.poses {
            let state = &pose.outcome.as_ref().unwrap().state;
            let exact = 9.81 * 0.3 * state.motion.inputs[0].place.x * (41.0 / 2.0 + 40.0 * 0.5);
            let off = (state.forces.efforts[0] - exact).abs() / scale;
            assert!(off <= reached.error + 4.0 * f64::EPSILON, "{within}: {off:e} {reached:?}");
        }
        compiled = found.compiled;
    }
}

fn greatest_force(solution: &Solution) -> f64 {
    let states = solution.poses.iter().filter_map(|p| p.outcome.as_ref().ok());
    states
        .flat_map(|s| &s.state.forces.reactions)
        .map(|r| r.force.norm())
        .filter(|f| f.is_finite())
        .fold(0.0, f64::max)
}

#[test]
fn errors_fall_as_tolerances_fall() {
    for (name, kind) in [
        ("accuracy/crank-slider-with-friction.mech", Kind::Friction),
        ("general/class-iii-triad.mech", Kind::Triad),
        ("general/class-iv-group.mech", Kind::Newton),
        ("cycle/crank-slider.mech", Kind::Samples),
        ("cycle/crank-slider.mech", Kind::Root),
        ("shaper/shaper-a.mech", Kind::Samples),
    ] {
        let study = studied(&example(name));
        let errors: Vec<f64> = knob(&study, kind).rows.iter().map(|r| r.error.unwrap()).collect();
        let (first, last) = (errors[0], errors[errors.len() - 1]);
        assert!(first > 1e3 * last, "{name} {kind:?}: {errors:?}");
        assert!(errors.windows(2).all(|e| e[1] <= 1.01 * e[0].max(1e-12)), "{name} {kind:?}: {errors:?}");
        // the error that a tolerance leaves is no more than it says
        let bounds = kind != Kind::Newton && kind != Kind::Root;
        let tolerances = knob(&study, kind).rows.iter().map(|r| r.setting.parse::<f64>().unwrap());
        for (tolerance, error) in tolerances.zip(&errors).filter(|_| bounds) {
            assert!(*error <= tolerance.max(1e-12), "{name} {kind:?}: {error:e} at {tolerance:e}");
        }
    }
}

#[test]
fn what_cannot_be_set_says_why() {
    let study = studied(&example("cams/lever.mech"));
    for (what, why) in [
        ("friction", "none in this problem"),
        ("general groups", "none in this problem"),
        ("samples", "no functions over the cycle"),
    ] {
        assert!(study.absent.iter().any(|a| a.what == what && a.why == why), "{what}: {:?}", study.absent);
    }
}

/// Without a word about accuracy the solver has the settings it always had.
#[test]
fn the_default_is_what_it_was() {
    let full = Settings::default();
    assert_eq!(full.scalar, Precision::F64);
    let tolerances = [full.friction, full.friction_step, full.newton, full.triad, full.samples, full.root];
    let unit = f64::EPSILON;
    assert_eq!(tolerances, [1e-15, 1e-9, 1e-12, 4.0 * unit, 2e-15, 4.0 * unit]);
    let solved = solved(&example("accuracy/four-bar.mech"));
    assert_eq!(solved.compiled.plan.settings, full);
    assert!(solved.reached.is_none());
}

#[test]
fn candidates_go_from_cheap_to_dear() {
    let solved = solved(&example("accuracy/four-bar.mech"));
    let model = solved.compiled.model();
    let all = candidates(&model, 1e-6);
    assert_eq!(all.len(), 3);
    assert!(all[0].newton > all[1].newton && all[1] == Settings::FULL);
    assert_eq!(all[2].scalar, Precision::DoubleDouble);
}

/// What is offered has the error that a solution with it has, and the solver takes those settings for it.
#[test]
fn what_is_offered_is_what_the_solver_takes() {
    for name in
        ["accuracy/crank-slider-with-friction", "general/class-iii-triad", "shaper/shaper-a", "cams/lever"]
    {
        let source = example(&format!("{name}.mech"));
        let found = studied(&source);
        assert_eq!(
            (found.choices[0].within, found.recommendation),
            (None, Some(0)),
            "{name}: {:?}",
            found.choices
        );
        for choice in found.choices[1..].iter().filter(|choice| choice.can_be_had()) {
            let (compiled, _) = assur::internals::compile(&source, &Overrides::none());
            let reached = solve_within(compiled.unwrap(), choice.within).0.unwrap().reached.unwrap();
            assert_eq!(reached.settings, choice.settings, "{name}: {choice:?}");
            assert!(
                reached.error <= choice.within.unwrap() && choice.error <= choice.within.unwrap(),
                "{name}"
            );
        }
    }
    // what f64 does not have is recommended with twice the digits
    let solved = solved(&example("accuracy/chain-of-40-dyads.mech"));
    let beyond = study(&solved.compiled.model(), &solved.solution, 1e-15, seconds);
    let taken = &beyond.choices[beyond.recommendation.unwrap()];
    assert_eq!((taken.settings.scalar, taken.within), (Precision::DoubleDouble, Some(1e-15)));
    assert!(taken.error > 1e-16 && taken.error < 1e-15, "{taken:?}");
}

/// Greatest difference of two solutions: of positions over the extent, of forces over the greatest.
fn difference(a: &Solved, b: &Solved) -> f64 {
    let (length, force) = (extent(&a.compiled.model()), greatest_force(&a.solution));
    let states = |s: &'_ Solved| -> Vec<State> {
        let poses = s.solution.poses.iter().filter(|p| !matches!(p.origin, PoseOrigin::Expected(_)));
        poses.filter_map(|p| p.outcome.as_ref().ok()).map(|s| s.state.clone()).collect()
    };
    let (one, two) = (states(a), states(b));
    assert_eq!(one.len(), two.len());
    let mut most = 0.0_f64;
    for (x, y) in one.iter().zip(&two).filter(|(x, _)| !x.forces.locked) {
        for (p, q) in x.motion.bodies.iter().zip(&y.motion.bodies) {
            most = most.max((p.p - q.p).norm() / length).max((p.u - q.u).norm());
        }
        for (p, q) in
            x.forces.reactions.iter().zip(&y.forces.reactions).filter(|(p, _)| p.force.norm().is_finite())
        {
            most = most.max((p.force - q.force).norm() / force.max(f64::MIN_POSITIVE));
        }
    }
    for (p, q) in a.solution.statics.cycles.iter().zip(&b.solution.statics.cycles) {
        if p.value.is_finite() {
            most = most.max((p.value - q.value).abs() / p.scale.max(f64::MIN_POSITIVE));
        }
    }
    for (p, q) in a.solution.statics.flywheels.iter().zip(&b.solution.statics.flywheels) {
        most = most.max((p.fluctuation - q.fluctuation).abs() / p.fluctuation);
    }
    most
}

/// Every example with every wanted accuracy: what is said to be kept is kept, what is not is said.
#[test]
fn what_is_wanted_is_kept() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let (mut kept, mut measured, mut wrong) = (0, 0, Vec::new());
    for path in spread(crate::folder::files(&root, "mech")) {
        let source = Source::new(path.display().to_string(), std::fs::read_to_string(&path).unwrap());
        let (full, _) = solve_source(&source, &Overrides::none());
        let Some(full) = full else { continue };
        for wanted in [1e-2, 1e-4, 1e-6, 1e-9, 1e-12] {
            let (compiled, _) = assur::internals::compile(&source, &Overrides::none());
            let (found, problems) = solve_within(compiled.unwrap(), Some(wanted));
            let Ok(found) = found else {
                wrong.push(format!("{} has no answer within {wanted:e}", source.name));
                continue;
            };
            if let Some(run) = &found.solution.simulation {
                // a run says itself what it keeps, and ends with an error where it does not
                let told = problems.has_errors();
                assert!(run.error <= wanted || told, "{} within {wanted:e}: {}", source.name, run.error);
                continue;
            }
            let reached = found.reached.unwrap();
            if !reached.is_kept() {
                let told = problems.views(&source);
                assert!(told.iter().any(|v| v.code.as_deref() == Some("mech::accuracy::out_of_reach")));
                continue;
            }
            kept += 1;
            measured += usize::from(reached.source == Reference::DoubleDouble);
            // what f64 itself loses stands in the solution it is held against
            let condition = found.solution.poses.iter().filter_map(|p| p.outcome.as_ref().ok());
            let condition = condition.map(|s| s.condition).fold(1.0, f64::min);
            let slack = 64.0 * f64::EPSILON / condition.powi(3);
            let off = difference(&full, &found);
            if off > wanted + slack {
                wrong.push(format!("{} within {wanted:e}: off by {off:e}, {reached:?}", source.name));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(kept > least(500) && measured > least(100), "{kept} {measured}");
}

/// The same answer on every machine: nothing is measured by the clock.
#[test]
fn what_is_chosen_hangs_on_no_clock() {
    let source = example("shaper/shaper-a.mech");
    let run = || {
        let (compiled, _) = assur::internals::compile(&source, &Overrides::none());
        let found = solve_within(compiled.unwrap(), Some(1e-6)).0.unwrap();
        (found.reached.unwrap(), found.solution.statics.flywheels[0].fluctuation.to_bits())
    };
    assert_eq!(run(), run());
}
