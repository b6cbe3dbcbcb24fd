//! Whether a value stays so far from zero in a step that nothing within needs to be looked at.
//!
//! The first steps, every so many and all that follow a jump are looked at in many places. They show how far the value goes beyond
//! those at both ends and in the middle of a step. Elsewhere these bound it: the end is known, the middle is that of the cubic.

use super::equations::Equations;
use crate::math::ode::Integrator;

/// Steps that are looked at first, and how many others come between two that are.
const FIRST: usize = 32;
const EVERY: usize = 64;
/// So many times what it ever changed by in a step a value is far from zero whatever the middle says.
const FAR: f64 = 4.0;
/// It goes beyond the three values by no more than so many times what was seen.
const BEYOND: f64 = 2.0;
/// The middle part of a step.
const MIDDLE: std::ops::Range<f64> = 0.4..0.6;

/// What was seen of a value.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lookout {
    /// Where the last step ended, s, and the value there.
    end: (f64, f64),
    steps: usize,
    /// Steps that something had ended.
    shortened: usize,
    /// The most that it changed by in a step, and went beyond the values at the ends and in the middle.
    widest: f64,
    beyond: f64,
    /// Its range in the present step, and that of the three values.
    range: (f64, f64),
    three: (f64, f64),
}

const NONE: (f64, f64) = (f64::INFINITY, f64::NEG_INFINITY);

fn with(range: (f64, f64), x: f64) -> (f64, f64) {
    (range.0.min(x), range.1.max(x))
}

impl Lookout {
    pub const NEW: Self = Self {
        end: (f64::NAN, 0.0),
        steps: 0,
        shortened: 0,
        widest: 0.0,
        beyond: 0.0,
        range: NONE,
        three: NONE,
    };

    /// Whether the value, at an instant, s, in a state, stays far from zero in the last step.
    pub fn is_far<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &M,
        mut value: impl FnMut(&mut Equations<'_, '_>, f64, &[f64]) -> f64,
    ) -> bool {
        if self.range.0 <= self.range.1 {
            self.widest = self.widest.max(self.range.1 - self.range.0);
            self.beyond = self.beyond.max(self.three.0 - self.range.0).max(self.range.1 - self.three.1);
        }
        (self.range, self.three) = (NONE, NONE);
        let (from, to) = (method.previous_t(), method.t());
        let end = (to, value(equations, to, method.y()));
        let begin = std::mem::replace(&mut self.end, end);
        self.steps += 1;
        let shortened = method.counts().shortened;
        let jumps = shortened != std::mem::replace(&mut self.shortened, shortened) || begin.0 != from;
        let known = begin.1.is_finite() && end.1.is_finite();
        if !known || jumps || self.steps <= FIRST || self.steps.is_multiple_of(EVERY) {
            return false;
        }
        let ends = with(with(NONE, begin.1), end.1);
        let is_clear = |(least, greatest): (f64, f64), by: f64| least.max(-greatest) > by;
        self.widest = self.widest.max(ends.1 - ends.0);
        if is_clear(ends, FAR * self.widest) {
            return true;
        }
        let beyond = BEYOND * self.beyond;
        if !is_clear(ends, ends.1 - ends.0 + beyond) {
            return false;
        }
        let middle = 0.5 * (from + to);
        let mut y = std::mem::take(&mut equations.within);
        y.resize(method.y().len(), 0.0);
        method.dense(middle, &mut y);
        let value = value(equations, middle, &y);
        equations.within = y;
        let three = with(ends, value);
        self.widest = self.widest.max(three.1 - three.0);
        value.is_finite() && is_clear(three, three.1 - three.0 + beyond)
    }

    /// The value at a part of a step that is looked at.
    pub fn note(&mut self, part: f64, value: f64) {
        self.range = with(self.range, value);
        if part <= 0.0 || part >= 1.0 || MIDDLE.contains(&part) {
            self.three = with(self.three, value);
        }
    }
}

impl Equations<'_, '_> {
    /// The same as [`Self::observe`] of a state that may have been evaluated last.
    pub fn observe_again(&mut self, t: f64, y: &[f64], deep: bool) -> bool {
        if deep || !self.is_at(t, y) {
            return self.observe(t, y, deep);
        }
        self.follow_angles(t);
        true
    }
}
