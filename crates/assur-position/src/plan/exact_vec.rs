//! Vectors that a plan forms of several points, with what rounding took of them.

use super::step::unit;
use crate::math::{Double, Scalar, V2, Vec2};

/// A vector in the frame of a body or the axes of a guide, m.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ExactVec {
    rounded: Vec2,
    rest: Vec2,
}

impl ExactVec {
    /// A vector formed twice, in `f64` and with twice the digits.
    fn new(rounded: Vec2, exact: V2<Double>) -> Self {
        let rest = exact - V2::of(rounded);
        Self { rounded, rest: Vec2::new(rest.x.high, rest.y.high) }
    }

    /// From one point to another.
    pub(super) fn between(from: Vec2, to: Vec2) -> Self {
        let rounded = to - from;
        let rest = |x: f64, from: f64, to: f64| {
            // Knuth's sum of `to` and −`from`
            let part = x - to;
            (to - (x - part)) + (-from - part)
        };
        Self { rounded, rest: Vec2::new(rest(rounded.x, from.x, to.x), rest(rounded.y, from.y, to.y)) }
    }

    /// In the axes of a direction.
    pub(super) fn in_axes(self, axis: Vec2) -> Self {
        if axis == Vec2::new(1.0, 0.0) {
            return Self { rounded: self.rounded.turned_back(axis), ..self };
        }
        Self::new(self.rounded.turned_back(axis), self.of().turned_back(unit(axis)))
    }

    /// Out of the axes of `from` into those of `to`.
    pub(super) fn carried(self, from: Vec2, to: Vec2) -> Self {
        let exact = unit(to).turned_back(unit(from));
        Self::new(self.rounded.turned(to.turned_back(from)), self.of().turned(exact))
    }

    pub(super) fn plus(self, o: Self) -> Self {
        Self::new(self.rounded + o.rounded, self.of::<Double>() + o.of())
    }

    /// The vector, with as many digits as the number has.
    #[inline(always)]
    #[must_use]
    pub fn of<S: Scalar>(&self) -> V2<S> {
        let rounded = V2::of(self.rounded);
        if S::EXTENDED { rounded + V2::of(self.rest) } else { rounded }
    }
}
