//! Motion of one body.

use crate::math::{Scalar, V2, Vec2};
use crate::plan::Arm;

/// Motion of a body: its origin and direction with their derivatives, in ground axes.
#[derive(Clone, Copy, Debug)]
pub struct BodyState<S = f64> {
    /// Origin of its frame, m.
    pub p: V2<S>,
    /// Direction (cos, sin) of its x axis.
    pub u: V2<S>,
    /// Velocity of the origin, m/s.
    pub v: V2<S>,
    /// Angular velocity, rad/s.
    pub omega: S,
    /// Acceleration of the origin, m/s².
    pub a: V2<S>,
    /// Angular acceleration, rad/s².
    pub alpha: S,
    /// Angle of a body that a drive or a train turns, whole turns included, rad.
    pub turned: S,
}

impl<S: Scalar> BodyState<S> {
    /// At rest in the ground's frame.
    #[must_use]
    pub fn rest() -> Self {
        let (zero, none) = (S::zero(), V2::zero());
        Self { p: none, u: V2::new(S::one(), zero), v: none, omega: zero, a: none, alpha: zero, turned: zero }
    }

    /// Position of a point of the body, m.
    #[inline(always)]
    #[must_use]
    pub fn position(&self, at: Vec2) -> V2<S> {
        self.p + V2::of(at).turned(self.u)
    }

    /// Position of a pin, m, and its arm from the origin in ground axes where it has one.
    #[inline(always)]
    pub(super) fn pin(&self, pin: &Arm) -> (V2<S>, Option<V2<S>>) {
        match pin {
            None => (self.p, None),
            Some(at) => {
                let r = V2::of(*at).turned(self.u);
                (self.p + r, Some(r))
            }
        }
    }

    /// Velocity of a point of the body, m/s.
    #[inline(always)]
    #[must_use]
    pub fn velocity(&self, at: Vec2) -> V2<S> {
        self.v + V2::of(at).turned(self.u).perp() * self.omega
    }

    /// Acceleration of a point of the body, m/s².
    #[inline(always)]
    #[must_use]
    pub fn acceleration(&self, at: Vec2) -> V2<S> {
        let r = V2::of(at).turned(self.u);
        self.a + r.perp() * self.alpha - r * (self.omega * self.omega)
    }
}
