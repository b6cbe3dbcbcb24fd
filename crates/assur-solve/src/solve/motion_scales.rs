//! How large the quantities of a solution are: what a rounding error is small against.

use super::{Model, Solved};
use crate::math::Vec2;
use crate::model::{Display, LinkId};

/// The greatest length, angular velocity and force of all poses, in SI; every other dimension follows from them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MotionScales {
    length: f64,
    per_time: f64,
    force: f64,
}

impl MotionScales {
    /// Of the positions of a solution.
    #[must_use]
    pub fn of<'s>(model: &Model<'_>, positions: impl IntoIterator<Item = &'s Solved>) -> Self {
        let mut greatest = Self::default();
        let mut fastest = 0.0_f64;
        for solved in positions {
            fastest = fastest.max(greatest.include(model, solved));
        }
        if greatest.per_time == 0.0 && greatest.length > 0.0 {
            greatest.per_time = fastest / greatest.length;
        }
        if greatest.force == 0.0 {
            greatest.force = 1.0;
        }
        greatest
    }

    /// Takes a position in; the greatest velocity there.
    fn include(&mut self, model: &Model<'_>, solved: &Solved) -> f64 {
        let state = &solved.state;
        let mut fastest = 0.0_f64;
        for (i, link) in model.mechanism.links.iter().enumerate() {
            let body = &state.motion.bodies[LinkId::at(i).index()];
            for at in link.points.iter().map(|p| p.at).chain([Vec2::zero()]) {
                self.length = self.length.max(body.position(at).norm());
                fastest = fastest.max(body.velocity(at).norm());
            }
            self.per_time = self.per_time.max(body.omega.abs());
        }
        let reactions = state.forces.reactions.iter().map(|r| r.force);
        let forces = reactions.chain(state.forces.applied.iter().map(|w| w.force));
        self.force = forces.fold(self.force, |most, f| most.max(f.norm()));
        fastest
    }

    /// What a quantity of a dimension is large against, SI: F^m L^(l−m) T^(t+2m). Zero where one of them is divided by: the greatest
    /// divisor says how small a quotient is, not how large, and one that is itself rounding would make all of them rounding.
    #[must_use]
    pub fn in_si(&self, [l, m, t, _]: [i8; 4]) -> f64 {
        let time = t.saturating_add(m.saturating_mul(2));
        let powers =
            [(self.force, m), (self.length, l.saturating_sub(m)), (self.per_time, time.saturating_neg())];
        let known = powers.iter().all(|(_, power)| *power >= 0);
        let product: f64 = powers.iter().map(|(base, power)| libm::pow(*base, f64::from(*power))).product();
        if known && product.is_finite() { product } else { 0.0 }
    }

    /// The same in the unit of a display.
    #[must_use]
    pub fn in_unit(&self, display: &Display) -> f64 {
        display.of_si(self.in_si(display.dimension))
    }
}
