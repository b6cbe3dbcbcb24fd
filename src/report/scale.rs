//! How large the quantities of a solved file are: what a rounding error is small against.

use super::answers::Answers;
use assur_math::math::Vec2;
use assur_model::model::{Display, LinkId};
use assur_solve::solve::Solved;

/// The greatest length, angular velocity and force of all poses, in SI; every other dimension follows from them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Scale {
    length: f64,
    per_time: f64,
    force: f64,
}

impl Scale {
    /// The scale of a solution.
    pub fn of(answers: &Answers<'_>) -> Self {
        let mut scale = Self::default();
        for solved in answers.poses().filter_map(|p| p.outcome.as_ref().ok()) {
            scale.include(answers, solved);
        }
        if scale.force == 0.0 {
            scale.force = 1.0;
        }
        scale
    }

    fn include(&mut self, answers: &Answers<'_>, solved: &Solved) {
        let state = &solved.state;
        let mut fastest = 0.0_f64;
        for (i, link) in answers.model.mechanism.links.iter().enumerate() {
            let body = &state.motion.bodies[LinkId::at(i).index()];
            for at in link.points.iter().map(|p| p.at).chain([Vec2::zero()]) {
                self.length = self.length.max(body.position(at).norm());
                fastest = fastest.max(body.velocity(at).norm());
            }
            self.per_time = self.per_time.max(body.omega.abs());
        }
        if self.per_time == 0.0 && self.length > 0.0 {
            self.per_time = fastest / self.length;
        }
        let forces = state
            .forces
            .reactions
            .iter()
            .map(|r| r.force)
            .chain(state.forces.applied.iter().map(|w| w.force));
        self.force = forces.fold(self.force, |most, f| most.max(f.norm()));
    }

    /// The scale of a dimension, in the unit of a display: F^m L^(l−m) T^(t+2m).
    pub fn in_unit(&self, display: &Display) -> f64 {
        let [l, m, t, _] = display.dimension;
        let power = |base: f64, n: i8| if n == 0 { 1.0 } else { libm::pow(base, f64::from(n)) };
        let time = t.saturating_add(m.saturating_mul(2));
        let si = power(self.force, m)
            * power(self.length, l.saturating_sub(m))
            * power(self.per_time, time.saturating_neg());
        if si.is_finite() { display.of_si(si) } else { 0.0 }
    }
}
