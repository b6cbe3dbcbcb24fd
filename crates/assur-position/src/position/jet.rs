//! Numbers and vectors with their first derivatives by time. Another derivative is one more place in the arrays, one more row of
//! binomials and one more line of [`Moving::turning`] and [`Jet::through`].

use super::body::BodyState;
use crate::math::{Scalar, V2, Vec2};
use std::array::from_fn;

/// A value and its derivatives.
pub const PLACES: usize = 4;
/// Coefficients of the derivatives of a product.
const BINOMIALS: [[f64; PLACES]; PLACES] =
    [[1.0, 0.0, 0.0, 0.0], [1.0, 1.0, 0.0, 0.0], [1.0, 2.0, 1.0, 0.0], [1.0, 3.0, 3.0, 1.0]];

/// A number and its derivatives.
#[derive(Clone, Copy, Debug)]
pub struct Jet<S>(pub [S; PLACES]);

impl<S: Scalar> Jet<S> {
    /// A number that does not change.
    pub(super) fn constant(value: S) -> Self {
        Self([value, S::zero(), S::zero(), S::zero()])
    }

    /// A number with its derivatives.
    pub(super) fn of(value: S, rates: [S; PLACES - 1]) -> Self {
        Self(from_fn(|i| if i == 0 { value } else { rates[i - 1] }))
    }

    pub(super) fn less(self, o: Self) -> Self {
        Self(from_fn(|i| self.0[i] - o.0[i]))
    }

    pub(super) fn plus(self, o: Self) -> Self {
        Self(from_fn(|i| self.0[i] + o.0[i]))
    }

    pub(super) fn times(self, k: S) -> Self {
        Self(self.0.map(|x| x * k))
    }

    /// A function of a number that has the derivatives `by`, from the function's own by that number.
    pub(super) fn through([f, f_1, f_2, f_3]: [S; PLACES], by: [S; PLACES - 1]) -> Self {
        let [v, a, j] = by;
        let three = S::of(3.0);
        Self([f, f_1 * v, f_2 * v * v + f_1 * a, f_3 * v * v * v + three * f_2 * v * a + f_1 * j])
    }

    /// The derivatives alone.
    pub(super) fn rates(&self) -> [S; PLACES - 1] {
        from_fn(|i| self.0[i + 1])
    }
}

/// A vector and its derivatives.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moving<S>(pub [V2<S>; PLACES]);

impl<S: Scalar> Moving<S> {
    /// A point of a body.
    pub fn point(body: &BodyState<S>, at: Vec2) -> Self {
        let arm = Self::axis(body, V2::of(at));
        let origin = [body.p, body.v, body.a, body.j];
        Self(from_fn(|i| origin[i] + arm.0[i]))
    }

    /// A direction of a body.
    pub fn axis(body: &BodyState<S>, direction: V2<S>) -> Self {
        Self::turning(direction.turned(body.u), body.turning())
    }

    /// A vector of constant length.
    pub fn turning(value: V2<S>, [omega, alpha, zeta]: [S; PLACES - 1]) -> Self {
        let across = value.perp();
        Self([
            value,
            across * omega,
            across * alpha - value * (omega * omega),
            across * (zeta - omega * omega * omega) - value * (S::of(3.0) * omega * alpha),
        ])
    }

    pub fn less(self, o: Self) -> Self {
        Self(from_fn(|i| self.0[i] - o.0[i]))
    }

    pub fn dot(self, o: Self) -> Jet<S> {
        Jet(from_fn(|n| {
            (0..=n).fold(S::zero(), |sum, k| sum + S::of(BINOMIALS[n][k]) * self.0[k].dot(o.0[n - k]))
        }))
    }

    pub fn cross(self, o: Self) -> Jet<S> {
        Self(self.0.map(V2::perp)).dot(o)
    }
}
