//! What answers in `f64`, and the closed forms with twice the digits, are off from the reference of 30 digits.

use assur::internals::math::{Double, Scalar, V2, Vec2};
use assur::internals::solve::{Model, Reference, Solved, State};
use assur::internals::structure::{EffortKind, JointKind};

fn off(got: Vec2, want: V2<Double>) -> f64 {
    (V2::of(got) - want).norm().high
}

fn off_by(got: f64, want: Double) -> f64 {
    (want - Double::of(got)).high.abs()
}

/// The greatest coordinate of an origin, m; 1 where all are zero.
pub fn size(exact: &Reference) -> f64 {
    let size = exact.bodies.iter().map(|b| b.p.norm().high).fold(0.0, f64::max);
    if size > 0.0 { size } else { 1.0 }
}

/// Errors of positions, velocities, accelerations, relative to the greatest in play.
pub fn motion_errors(solved: &Solved, exact: &Reference) -> [f64; 3] {
    let size = size(exact);
    let (mut errors, mut most) = ([0.0_f64; 3], [1.0, f64::MIN_POSITIVE, f64::MIN_POSITIVE]);
    for (got, want) in solved.state.motion.bodies.iter().zip(&exact.bodies) {
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
    // what is nothing is not judged relative to itself
    most[2] = most[2].max(most[1] * most[1]);
    [0, 1, 2].map(|i| errors[i] / most[i])
}

/// The greatest error of a force, or of a moment over the size, relative to the greatest force in play.
pub fn force_error(model: &Model<'_>, solved: &Solved, exact: &Reference) -> f64 {
    let (error, most) = force_errors(model, solved, exact);
    error / most
}

/// That error and that force, N.
pub fn force_errors(model: &Model<'_>, solved: &Solved, exact: &Reference) -> (f64, f64) {
    let (size, state) = (size(exact), &solved.state);
    let mut error = 0.0_f64;
    let mut most = exact.applied.iter().map(|w| w.force.norm().high).fold(f64::MIN_POSITIVE, f64::max);
    for (joint, (got, want)) in
        model.plan.reactions.iter().zip(state.forces.reactions.iter().zip(&exact.reactions))
    {
        error = error.max(off(got.force, want.force));
        most = most.max(want.force.norm().high);
        // the couples of a chain of guides are shared as one likes
        let kind = &model.structure.replaced.joint(joint.joint).kind;
        if !matches!(kind, JointKind::Prismatic { in_chain: true, .. }) {
            error = error.max(off_by(got.couple, want.couple) / size);
            most = most.max(want.couple.high.abs() / size);
        }
    }
    for (slot, (got, want)) in state.forces.efforts.iter().zip(&exact.efforts).enumerate() {
        let force = matches!(
            model.structure.efforts.get(slot).map(|e| e.kind),
            Some(EffortKind::Line(_) | EffortKind::Coordinate(_))
        );
        let scale = if force { 1.0 } else { size };
        error = error.max(off_by(*got, *want) / scale);
        most = most.max(want.high.abs() / scale);
    }
    for (got, law) in exact.multipliers.iter().zip(&state.forces.law_forces) {
        error = error.max(off_by(law.multiplier, *got));
        most = most.max(got.high.abs());
    }
    for (got, want) in state.forces.frictions.iter().zip(&exact.frictions) {
        error = error.max(off_by(*got, *want) / size.max(1.0));
    }
    (error, most)
}

/// What the closed forms with twice the digits are off: positions, velocities, accelerations, forces, each relative to the
/// greatest in play.
pub fn closed_form_errors(closed: &State<Double>, exact: &Reference) -> [f64; 4] {
    let size = size(exact);
    let apart = |a: V2<Double>, b: V2<Double>| (a - b).norm().high;
    let (mut errors, mut most) = ([0.0_f64; 4], [1.0, 0.0_f64, 0.0_f64, 0.0_f64]);
    for (got, want) in closed.motion.bodies.iter().zip(&exact.bodies) {
        let omega = want.omega.high.abs();
        errors[0] = errors[0].max(apart(got.p, want.p) / size).max(apart(got.u, want.u));
        errors[1] = errors[1].max(apart(got.v, want.v) / size).max((got.omega - want.omega).high.abs());
        errors[2] = errors[2].max(apart(got.a, want.a) / size).max((got.alpha - want.alpha).high.abs());
        most[1] = most[1].max(want.v.norm().high / size).max(omega);
        most[2] = most[2].max(want.a.norm().high / size).max(want.alpha.high.abs()).max(omega * omega);
    }
    for (got, want) in closed.forces.reactions.iter().zip(&exact.reactions) {
        errors[3] = errors[3].max(apart(got.force, want.force));
        most[3] = most[3].max(want.force.norm().high);
    }
    most[2] = most[2].max(most[1] * most[1]);
    most[3] = exact.applied.iter().map(|w| w.force.norm().high).fold(most[3], f64::max);
    [0, 1, 2, 3].map(|i| errors[i] / most[i].max(f64::MIN_POSITIVE))
}
