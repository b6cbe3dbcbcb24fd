//! The units of equations.

use assur_formula::Unit;

/// The unit of equations of a dimension.
#[must_use]
pub const fn unit_of(dimension: [i8; 4]) -> Option<Unit> {
    Some(match dimension {
        [0, 0, 0, 0] => Unit::One,
        [0, 0, 0, _] => Unit::Angle,
        [1, 0, 0, _] => Unit::Length,
        [2, 0, 0, _] => Unit::Area,
        [1, 0, -1, _] => Unit::Velocity,
        [1, 0, -2, _] => Unit::Acceleration,
        [0, 0, -1, 1] => Unit::AngularVelocity,
        [0, 0, -2, 1] => Unit::AngularAcceleration,
        [0, 1, 0, _] => Unit::Mass,
        [2, 1, 0, _] => Unit::Inertia,
        [1, 1, -2, _] => Unit::Force,
        [2, 1, -2, _] => Unit::Torque,
        [2, 1, -3, _] => Unit::Power,
        [0, 1, -2, _] => Unit::Stiffness,
        _ => return None,
    })
}
