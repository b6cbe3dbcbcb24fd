//! What an expression is expected to be.

use assur_text::units::Dimension;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Want(pub Dimension);

impl Want {
    pub const NUMBER: Self = Self(Dimension::NUMBER);
    pub const ANGLE: Self = Self(Dimension::ANGLE);
    pub const LENGTH: Self = Self(Dimension::LENGTH);
    pub const ACCELERATION: Self = Self(Dimension::ACCELERATION);
}
