//! What an expression is expected to be.

use assur_text::units::Dimension;

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
    /// An acceleration.
    pub const ACCELERATION: Self = Self(Dimension::ACCELERATION);
}
