//! Whole turns: they make no difference to a direction, and count where something turns many times.

use assur_model::model::{BinaryOp, CycleFunction, Expr, Function, Mechanism, Positions, Query, Value};
use std::f64::consts::{PI, TAU};

/// A turn, and what rounding adds to it.
const ONE: f64 = TAU * (1.0 + 1e-6);

/// Whether whole turns make no difference to an angle: by its right value, SI, and by how many SI units its unit is.
#[must_use]
pub fn are_free(right: f64, unit: f64) -> bool {
    // who writes `rev` counts them
    right.abs() <= ONE && unit != TAU
}

/// A difference, without whole turns where they are free.
#[must_use]
pub fn difference(are_free: bool, x: f64, from: f64) -> f64 {
    let plain = x - from;
    if are_free { plain - TAU * (plain / TAU).round() } else { plain }
}

/// What a tolerance is a part of: no direction is further off than half a turn.
#[must_use]
pub const fn scale(are_free: bool, size: f64) -> f64 {
    if are_free { size.min(PI) } else { size }
}

/// Whether an angle is a direction, and that of something which turns once at most.
#[must_use]
pub fn is_direction(mechanism: &Mechanism, angle: &Expr) -> bool {
    let swept = mechanism.drives.iter().map(|drive| match &drive.positions {
        Positions::Range { from: Expr::Constant(from), to: Expr::Constant(to), .. } => match (from, to) {
            (Value::Scalar(from), Value::Scalar(to)) => (to - from).abs(),
            _ => 0.0,
        },
        _ => 0.0,
    });
    let turns_once = mechanism.simulation.is_none()
        // they are wound
        && mechanism.torsion_springs.is_empty()
        && swept.fold(0.0, f64::max) <= ONE;
    let is = |angle: &Expr| is_direction(mechanism, angle);
    match angle {
        Expr::Query(Query::Angle(_) | Query::Displacement(_) | Query::EventDrive(..)) => turns_once,
        Expr::Query(Query::Cycle(i)) => turns_once && mechanism.cycles[*i].how == CycleFunction::Argmax,
        Expr::Query(Query::Dead(..)) | Expr::Call(Function::Direction | Function::Atan2, _) => true,
        Expr::Negate(angle) => is(angle),
        Expr::Binary(BinaryOp::Add | BinaryOp::Sub, a, b) => match (&**a, &**b) {
            (Expr::Constant(_), angle) | (angle, Expr::Constant(_)) => is(angle),
            _ => false,
        },
        Expr::Quantity(id) => is(&mechanism.quantities[id.index()].expr),
        _ => false,
    }
}
