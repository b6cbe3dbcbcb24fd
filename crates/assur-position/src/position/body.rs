//! Motion of one body.

use super::jet::Moving;
use crate::math::{Scalar, V2, Vec2};
use crate::plan::step::unit;
use crate::plan::{Arm, PlannedPart};

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
    /// Jerk of the origin, m/s³, where it is asked for.
    pub j: V2<S>,
    /// Angular jerk, rad/s³, where it is asked for.
    pub zeta: S,
    /// Angle of a body that a drive or a train turns, whole turns included, rad.
    pub turned: S,
}

impl<S: Copy> BodyState<S> {
    /// The same motion in other numbers.
    #[inline(always)]
    pub fn map<T>(&self, f: impl Fn(S) -> T) -> BodyState<T> {
        let of = |v: V2<S>| V2 { x: f(v.x), y: f(v.y) };
        BodyState {
            p: of(self.p),
            u: of(self.u),
            v: of(self.v),
            omega: f(self.omega),
            a: of(self.a),
            alpha: f(self.alpha),
            j: of(self.j),
            zeta: f(self.zeta),
            turned: f(self.turned),
        }
    }
}

impl<S: Scalar> BodyState<S> {
    /// At rest in the ground's frame.
    #[must_use]
    pub fn rest() -> Self {
        let (zero, none) = (S::zero(), V2::zero());
        let u = V2::new(S::one(), zero);
        Self { p: none, u, v: none, omega: zero, a: none, alpha: zero, j: none, zeta: zero, turned: zero }
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

    /// Jerk of a point of the body, m/s³.
    #[must_use]
    pub fn jerk(&self, at: Vec2) -> V2<S> {
        Moving::point(self, at).0[3]
    }

    /// How a part of the body moves.
    #[must_use]
    pub fn carried(&self, part: &PlannedPart) -> Self {
        Self {
            p: self.position(part.at),
            u: unit(part.along).turned(self.u),
            v: self.velocity(part.at),
            a: self.acceleration(part.at),
            j: self.jerk(part.at),
            turned: self.turned + S::of(part.angle),
            ..*self
        }
    }

    /// A derivative, from the first on, of the place of the origin and of the angle.
    pub const fn rate_mut(&mut self, order: usize) -> (&mut V2<S>, &mut S) {
        match order {
            1 => (&mut self.v, &mut self.omega),
            2 => (&mut self.a, &mut self.alpha),
            _ => (&mut self.j, &mut self.zeta),
        }
    }

    /// The same, to be read.
    pub fn rate(mut self, order: usize) -> (V2<S>, S) {
        let (origin, turn) = self.rate_mut(order);
        (*origin, *turn)
    }

    /// The derivatives of its angle.
    #[must_use]
    pub const fn turning(&self) -> [S; 3] {
        [self.omega, self.alpha, self.zeta]
    }
}
