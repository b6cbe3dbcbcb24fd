//! Numbers and vectors with their first two derivatives by time.

use crate::math::{Double, Scalar, V2, Vec2};
use crate::position::BodyState;

/// A number and its derivatives.
#[derive(Clone, Copy, Debug)]
pub(super) struct Jet {
    pub value: Double,
    pub rate: Double,
    pub second: Double,
}

impl Jet {
    /// A number that does not change.
    pub(super) fn constant(value: Double) -> Self {
        Self { value, rate: Double::zero(), second: Double::zero() }
    }

    pub(super) fn less(self, o: Self) -> Self {
        Self { value: self.value - o.value, rate: self.rate - o.rate, second: self.second - o.second }
    }

    pub(super) fn plus(self, o: Self) -> Self {
        Self { value: self.value + o.value, rate: self.rate + o.rate, second: self.second + o.second }
    }

    pub(super) fn times(self, k: Double) -> Self {
        Self { value: self.value * k, rate: self.rate * k, second: self.second * k }
    }
}

/// A vector and its derivatives.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moving {
    pub value: V2<Double>,
    pub rate: V2<Double>,
    pub second: V2<Double>,
}

impl Moving {
    /// A point of a body.
    pub(super) fn point(body: &BodyState<Double>, at: Vec2) -> Self {
        Self { value: body.position(at), rate: body.velocity(at), second: body.acceleration(at) }
    }

    /// A direction of a body.
    pub(super) fn axis(body: &BodyState<Double>, direction: V2<Double>) -> Self {
        Self::turning(direction.turned(body.u), body.omega, body.alpha)
    }

    /// A vector of constant length.
    pub(super) fn turning(value: V2<Double>, omega: Double, alpha: Double) -> Self {
        let rate = value.perp() * omega;
        Self { value, rate, second: value.perp() * alpha - value * (omega * omega) }
    }

    pub(super) fn less(self, o: Self) -> Self {
        Self { value: self.value - o.value, rate: self.rate - o.rate, second: self.second - o.second }
    }

    pub(super) fn dot(self, o: Self) -> Jet {
        let two = Double::of(2.0);
        Jet {
            value: self.value.dot(o.value),
            rate: self.rate.dot(o.value) + self.value.dot(o.rate),
            second: self.second.dot(o.value) + two * self.rate.dot(o.rate) + self.value.dot(o.second),
        }
    }

    pub(super) fn cross(self, o: Self) -> Jet {
        let left = Self { value: self.value.perp(), rate: self.rate.perp(), second: self.second.perp() };
        left.dot(o)
    }
}

/// A direction of the model, of unit length to all digits.
pub(super) fn unit(direction: Vec2) -> V2<Double> {
    let direction = V2::of(direction);
    direction / direction.norm()
}
