//! Every position of every example against the reference of 30 digits, which is solved from the equations of all bodies at
//! once: what `f64` and its closed forms lose stays below the bound of docs/stability.md.

use assur::check::Overrides;
use assur::math::{Double, Scalar, V2, Vec2};
use assur::plan::Level;
use assur::solve::{Reference, Scene, Solved, precise};
use assur::source::Source;
use assur::structure::{EffortKind, JointKind};
use std::path::{Path, PathBuf};

/// The constant of docs/stability.md.
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

/// Calls `judge` with every position that the examples solve.
fn each_position(mut judge: impl FnMut(&str, &Scene<'_>, &Solved, &Reference)) -> usize {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut paths = Vec::new();
    files(&root.join("examples"), &mut paths);
    paths.sort();
    let mut count = 0;
    for path in paths {
        let name = path.strip_prefix(root).expect("below the root").display().to_string();
        let source = Source::new(&name, std::fs::read_to_string(&path).expect("a file"));
        // files that are variants of others are none by themselves
        let (Some(solved), _) = assur::solve_source(&source, &Overrides::none()) else { continue };
        let scene = solved.compiled.scene();
        for pose in &solved.solution.poses {
            let Ok(at) = &pose.outcome else { continue };
            let reference = solved.solution.reference(&scene, at);
            let name = format!("{name}, {}", pose.name);
            judge(&name, &scene, at, &reference.unwrap_or_else(|| panic!("{name} has no reference")));
            count += 1;
        }
    }
    count
}

fn off(got: Vec2, want: V2<Double>) -> f64 {
    (V2::of(got) - want).norm().high
}

fn off_by(got: f64, want: Double) -> f64 {
    (want - Double::of(got)).high.abs()
}

/// The greatest coordinate of an origin, m; 1 where all are zero.
fn size(exact: &Reference) -> f64 {
    let size = exact.bodies.iter().map(|b| b.p.norm().high).fold(0.0, f64::max);
    if size > 0.0 { size } else { 1.0 }
}

/// Errors of positions, velocities, accelerations, relative to the greatest in play.
fn motion_errors(solved: &Solved, exact: &Reference) -> [f64; 3] {
    let size = size(exact);
    let (mut errors, mut most) = ([0.0_f64; 3], [1.0, f64::MIN_POSITIVE, f64::MIN_POSITIVE]);
    for (got, want) in solved.state.bodies.iter().zip(&exact.bodies) {
        let pairs = [
            (off(got.p, want.p) / size, off(got.u, want.u)),
            (off(got.v, want.v) / size, off_by(got.omega, want.omega)),
            (off(got.a, want.a) / size, off_by(got.alpha, want.alpha)),
        ];
        for (error, (along, turn)) in errors.iter_mut().zip(pairs) {
            *error = error.max(along).max(turn);
        }
        let omega = want.omega.high.abs();
        most[1] = most[1].max(want.v.norm().high / size).max(omega);
        most[2] = most[2].max(want.a.norm().high / size).max(want.alpha.high.abs()).max(omega * omega);
    }
    [0, 1, 2].map(|i| errors[i] / most[i])
}

/// The greatest error of a force, or of a moment over the size, relative to the greatest force in play.
fn force_error(scene: &Scene<'_>, solved: &Solved, exact: &Reference) -> f64 {
    let (size, state) = (size(exact), &solved.state);
    let mut error = 0.0_f64;
    let mut most = exact.applied.iter().map(|w| w.force.norm().high).fold(f64::MIN_POSITIVE, f64::max);
    for (joint, (got, want)) in scene.plan.reactions.iter().zip(state.reactions.iter().zip(&exact.reactions))
    {
        error = error.max(off(got.force, want.force));
        most = most.max(want.force.norm().high);
        // the couples of a chain of guides are shared as one likes
        let kind = &scene.structure.replaced.joint(joint.joint).kind;
        if !matches!(kind, JointKind::Prismatic { in_chain: true, .. }) {
            error = error.max(off_by(got.couple, want.couple) / size);
            most = most.max(want.couple.high.abs() / size);
        }
    }
    for (slot, (got, want)) in state.efforts.iter().zip(&exact.efforts).enumerate() {
        let force = matches!(
            scene.structure.efforts.get(slot).map(|e| e.kind),
            Some(EffortKind::Line(_) | EffortKind::Coordinate(_))
        );
        let scale = if force { 1.0 } else { size };
        error = error.max(off_by(*got, *want) / scale);
        most = most.max(want.high.abs() / scale);
    }
    for (got, law) in exact.multipliers.iter().zip(&state.law_forces) {
        error = error.max(off_by(law.multiplier, *got));
        most = most.max(got.high.abs());
    }
    for (got, want) in state.frictions.iter().zip(&exact.frictions) {
        error = error.max(off_by(*got, *want) / size.max(1.0));
    }
    error / most
}

#[test]
fn answers_lose_no_more_than_the_bound() {
    let mut worst = 0.0_f64;
    let count = each_position(|name, scene, solved, exact| {
        assert!(exact.closure < 1e-29 && exact.equilibrium < 1e-28, "{name}: {exact:?}");
        let sigma = solved.condition;
        let [p, v, a] = motion_errors(solved, exact);
        let f = if exact.reactions.is_empty() { 0.0 } else { force_error(scene, solved, exact) };
        let lost = [(p, 1), (v, 2), (a, 3), (f, 2)];
        for (kind, (error, power)) in ["positions", "velocities", "accelerations", "forces"].iter().zip(lost)
        {
            let c = error * sigma.powi(power) / f64::EPSILON;
            assert!(c <= BOUND, "{name}: {kind} lose {error:e}, condition {sigma:e}");
            worst = worst.max(c);
        }
    });
    println!("{count} positions, c = {worst}");
    assert!(count > 500, "{count} positions");
}

/// Powers of loads, inertia forces and efforts: reactions do none where nothing rubs.
fn powers(scene: &Scene<'_>, exact: &Reference) -> (Double, f64) {
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
    for (effort, value) in scene.structure.efforts.iter().zip(&exact.efforts) {
        add(*value
            * match effort.kind {
                EffortKind::Angle(b) => exact.bodies[b.0].omega,
                EffortKind::RelativeAngle { first, second, .. } => {
                    exact.bodies[second.0].omega - exact.bodies[first.0].omega
                }
                EffortKind::Coordinate(joint) => {
                    let JointKind::Prismatic { slider, point, direction, guide, .. } =
                        scene.structure.replaced.joint(joint).kind
                    else {
                        panic!("a coordinate of a prismatic joint")
                    };
                    let (s, g) = (&exact.bodies[slider.0], &exact.bodies[guide.0]);
                    let under = g.v + (s.position(point) - g.p).perp() * g.omega;
                    let along = V2::of(direction) / V2::<Double>::of(direction).norm();
                    (s.velocity(point) - under).dot(along.turned(s.u))
                }
                EffortKind::Line(_) | EffortKind::Point(_) => panic!("not counted here"),
            });
    }
    (sum, most)
}

#[test]
fn powers_add_up_to_nothing() {
    let mut count = 0;
    each_position(|name, scene, _, exact| {
        let plan = scene.plan;
        let counted = plan.effects.level >= Level::Velocities && !exact.reactions.is_empty();
        if counted
            && plan.friction.is_empty()
            && !plan.effects.losses
            && plan.lines.is_empty()
            && plan.outer.is_empty()
        {
            let (sum, most) = powers(scene, exact);
            assert!(sum.high.abs() <= 1e-27 * most, "{name}: {sum:?} of {most:e}");
            count += 1;
        }
    });
    assert!(count > 200, "{count} positions");
}

#[test]
fn closed_forms_with_as_many_digits_agree() {
    let mut count = 0;
    each_position(|name, scene, solved, exact| {
        let Some(closed) = precise(scene.plan, &solved.state) else { return };
        let size = size(exact);
        let sigma = solved.condition;
        let mut near = |what: &str, got: Double, want: Double, most: f64, power: i32| {
            let error = (got - want).high.abs() / most;
            let bound = 1e-29 / sigma.powi(power);
            assert!(error <= bound, "{name}: {what} {got:?} for {want:?}, off by {error:e} of {bound:e}");
        };
        let turning = exact.bodies.iter().map(|b| b.omega.high.abs()).fold(f64::MIN_POSITIVE, f64::max);
        for (got, want) in closed.bodies.iter().zip(&exact.bodies) {
            near("place", got.p.x, want.p.x, size, 1);
            near("place", got.p.y, want.p.y, size, 1);
            near("direction", got.u.x, want.u.x, 1.0, 1);
            near("direction", got.u.y, want.u.y, 1.0, 1);
            near("angular velocity", got.omega, want.omega, turning, 2);
            near(
                "angular acceleration",
                got.alpha,
                want.alpha,
                (turning * turning).max(f64::MIN_POSITIVE),
                3,
            );
        }
        let forces = exact.reactions.iter().map(|r| r.force.norm().high);
        let most = forces.fold(f64::MIN_POSITIVE, f64::max);
        for (got, want) in closed.reactions.iter().zip(&exact.reactions) {
            near("reaction", got.force.x, want.force.x, most, 3);
            near("reaction", got.force.y, want.force.y, most, 3);
        }
        count += 1;
    });
    println!("{count} positions");
    assert!(count > 200, "{count} positions");
}
