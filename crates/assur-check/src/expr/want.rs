//! What an expression is expected to be.

use crate::units::Dimension;

/// An expected dimension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Want(pub Dimension);

impl Want {
    /// A plain number.
    pub const NUMBER: Self = Self(Dimension::NUMBER);
    /// An angle.
    pub const ANGLE: Self = Self(Dimension::ANGLE);
    /// A length.
    pub const LENGTH: Self = Self(Dimension::LENGTH);
    /// A mass.
    pub const MASS: Self = Self(Dimension::MASS);
    /// A time.
    pub const TIME: Self = Self(Dimension::TIME);
    /// A velocity.
    pub const VELOCITY: Self = Self(Dimension::VELOCITY);
    /// An acceleration.
    pub const ACCELERATION: Self = Self(Dimension::ACCELERATION);
    /// An angular velocity.
    pub const ANGULAR_VELOCITY: Self = Self(Dimension::ANGULAR_VELOCITY);
    /// An angular acceleration.
    pub const ANGULAR_ACCELERATION: Self = Self(Dimension::ANGULAR_ACCELERATION);
    /// A force.
    pub const FORCE: Self = Self(Dimension::FORCE);
    /// A torque.
    pub const TORQUE: Self = Self(Dimension::TORQUE);
    /// A moment of inertia.
    pub const INERTIA: Self = Self(Dimension::INERTIA);
    /// A stiffness.
    pub const STIFFNESS: Self = Self(Dimension::STIFFNESS);
    /// A damping.
    pub const DAMPING: Self = Self(Dimension::DAMPING);
}
