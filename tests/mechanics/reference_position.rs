//! Every position of every example against the reference of 30 digits, which is solved from the equations of all bodies at
//! once: what `f64` and its closed forms lose stays below the bound of docs/measured/stability.md.

use crate::support::digits::{closed_form_errors, force_error, motion_errors};
use assur::internals::check::Overrides;
use assur::internals::math::{Double, Scalar, V2};
use assur::internals::plan::Level;
use assur::internals::solve::{Model, Reference, Solved, precise};
use assur::internals::source::Source;
use assur::internals::structure::{EffortKind, JointKind};
use std::path::{Path, PathBuf};

/// The constant of docs/measured/stability.md.
const BOUND: f64 = 64.0;

fn files(folder: &Path, out: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).expect("a folder").flatten() {
        let path = entry.path();
        if path.is_dir() {
            files(&path, out);
        } else if path.extension().is_some_and(|e| e == "mech") {
            out.push(path);
        }
    }
}

/// Rounding adds up along a chain of groups: how many times that of four. Forces count twice: on n groups in a row they are
/// sums of n loads, whose places are off by up to n times as much as that of the first.
fn chain(model: &Model<'_>) -> f64 {
    (model.plan.motion.len() as f64 / 4.0).max(1.0)
}

/// Calls `judge` with every position that the examples solve.
fn each_position(mut judge: impl FnMut(&str, &Model<'_>, &Solved, &Reference)) -> usize {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut paths = Vec::new();
    files(&root.join("examples"), &mut paths);
    paths.sort();
    let mut count = 0;
    for path in paths {
        let name = path.strip_prefix(root).expect("below the root").display().to_string();
        let source = Source::new(&name, std::fs::read_to_string(&path).expect("a file"));
        // files that are variants of others are none by themselves
        let (Some(solved), _) = assur::internals::solve_source(&source, &Overrides::none()) else { continue };
        // of a motion under loads the drives' values are results, of many turns: `answers/simulation` judges them
        if solved.compiled.mechanism.simulation.is_some() {
            continue;
        }
        let model = solved.compiled.model();
        for pose in &solved.solution.poses {
            let Ok(at) = &pose.outcome else { continue };
            let reference = solved.solution.reference(&model, at);
            let name = format!("{name}, {}", pose.name);
            judge(&name, &model, at, &reference.unwrap_or_else(|| panic!("{name} has no reference")));
            count += 1;
        }
    }
    count
}

/// One pass over all examples, since to solve them with 30 digits takes longer than to judge them.
#[test]
fn every_position_of_every_example_agrees_with_thirty_digits() {
    let (mut worst, mut with_powers, mut closed) = (0.0_f64, 0, 0);
    let count = each_position(|name, model, solved, exact| {
        worst = worst.max(loses_no_more_than_the_bound(name, model, solved, exact));
        with_powers += usize::from(powers_add_up_to_nothing(name, model, exact));
        closed += usize::from(closed_forms_with_as_many_digits_agree(name, model, solved, exact));
    });
    println!("{count} positions, c = {worst}, {with_powers} with powers, {closed} in closed form");
    assert!(count > 500 && with_powers > 200 && closed > 200);
}

fn loses_no_more_than_the_bound(name: &str, model: &Model<'_>, solved: &Solved, exact: &Reference) -> f64 {
    assert!(exact.closure < 1e-29 && exact.equilibrium < 1e-28, "{name}: {exact:?}");
    let sigma = solved.condition;
    let [p, v, a] = motion_errors(solved, exact);
    let f = if exact.reactions.is_empty() { 0.0 } else { force_error(model, solved, exact) };
    let lost = [(p, 1), (v, 2), (a, 3), (f / chain(model), 2)];
    let mut worst = 0.0_f64;
    for (kind, (error, power)) in ["positions", "velocities", "accelerations", "forces"].iter().zip(lost) {
        let c = error * sigma.powi(power) / (chain(model) * f64::EPSILON);
        assert!(c <= BOUND, "{name}: {kind} lose {error:e}, condition {sigma:e}");
        worst = worst.max(c);
    }
    worst
}

/// Powers of loads, inertia forces and efforts: reactions do none where nothing rubs.
fn powers(model: &Model<'_>, exact: &Reference) -> (Double, f64) {
    let mut sum = Double::zero();
    let mut add = |power: Double| sum = sum + power;
    // in a dwell nothing moves but by rounding: the greatest force times the greatest velocity
    let (mut force, mut moment) = (0.0_f64, 0.0_f64);
    let (mut speed, mut turning) = (0.0_f64, 0.0_f64);
    for (body, load) in exact.bodies.iter().zip(&exact.applied) {
        add(load.force.dot(body.v));
        add(load.moment * body.omega);
        force = force.max(load.force.norm().high);
        moment = moment.max(load.moment.high.abs());
        speed = speed.max(body.v.norm().high);
        turning = turning.max(body.omega.high.abs());
    }
    let most = (force * speed + moment * turning).max(f64::MIN_POSITIVE);
    for (effort, value) in model.structure.efforts.iter().zip(&exact.efforts) {
        let rate = |kind| match kind {
            EffortKind::Angle(b) => exact.bodies[b.0].omega,
            EffortKind::RelativeAngle { first, second, .. } => {
                exact.bodies[second.0].omega - exact.bodies[first.0].omega
            }
            EffortKind::Coordinate(joint) => {
                let JointKind::Prismatic { slider, point, direction, guide, .. } =
                    model.structure.replaced.joint(joint).kind
                else {
                    panic!("a coordinate of a prismatic joint")
                };
                let (s, g) = (&exact.bodies[slider.0], &exact.bodies[guide.0]);
                let under = g.v + (s.position(point) - g.p).perp() * g.omega;
                let along = V2::of(direction) / V2::<Double>::of(direction).norm();
                (s.velocity(point) - under).dot(along.turned(s.u))
            }
            EffortKind::Line(_) | EffortKind::Point(_) | EffortKind::Place(..) => panic!("not counted here"),
        };
        effort.places().for_each(|kind| add(*value * rate(kind)));
    }
    (sum, most)
}

/// Whether powers are counted at this position.
fn powers_add_up_to_nothing(name: &str, model: &Model<'_>, exact: &Reference) -> bool {
    let plan = model.plan;
    let counted = plan.effects.level >= Level::Velocities
        && !exact.reactions.is_empty()
        && plan.friction.is_empty()
        && !plan.effects.losses
        && plan.lines.is_empty()
        && plan.outer.is_empty();
    if counted {
        let (sum, most) = powers(model, exact);
        assert!(sum.high.abs() <= 1e-27 * most, "{name}: {sum:?} of {most:e}");
    }
    counted
}

/// Whether the position has a closed form.
fn closed_forms_with_as_many_digits_agree(
    name: &str,
    model: &Model<'_>,
    solved: &Solved,
    exact: &Reference,
) -> bool {
    let Some(closed) = precise(model.plan, &solved.state) else { return false };
    let mut errors = closed_form_errors(&closed, exact);
    errors[3] /= chain(model);
    for (error, power) in errors.into_iter().zip([1, 2, 3, 3]) {
        let bound = 1e-29 * chain(model) / solved.condition.powi(power);
        assert!(error <= bound, "{name}: {errors:?}, condition {:e}", solved.condition);
    }
    true
}
