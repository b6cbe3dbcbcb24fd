//! Losses of transmissions in a motion under loads, where the run and not the velocity says how their sides move: as friction in
//! pairs does, they hold a transmission at rest by an effort that no direction of the power gives.

use super::grip::ContactMode;
use super::state::State;
use super::train_losses::sides;
use super::wrench::LawForce;
use crate::math::Vec2;
use crate::plan::{LawSite, Plan, PlannedLaw};

impl State {
    /// How the sides of a law with losses move, where the run says it.
    pub(super) fn law_grip(&self, law: &PlannedLaw) -> Option<ContactMode> {
        self.motion.grips.get(law.grip?).copied()
    }

    /// The rate of the first side from the carrier.
    #[must_use]
    pub fn law_speed(&self, law: &PlannedLaw) -> f64 {
        self.seen_from_carrier(law, 0, &|site| self.site_rate(site))
    }

    #[must_use]
    pub fn law_acceleration(&self, law: &PlannedLaw) -> f64 {
        self.seen_from_carrier(law, 0, &|site| self.site_acceleration(site))
    }

    /// A rate of a side, as the carrier sees it.
    pub(super) fn seen_from_carrier(
        &self,
        law: &PlannedLaw,
        side: usize,
        rate: &dyn Fn(&LawSite) -> f64,
    ) -> f64 {
        let own = law.terms.get(side).map_or(0.0, |term| rate(&term.0));
        match law.terms.get(2) {
            Some(carrier) if law.counts_from_carrier(side) => own - rate(&carrier.0),
            _ => own,
        }
    }

    /// Calls `act` with what holds a law at rest.
    pub(super) fn grip_of_law(&self, law: &PlannedLaw, act: &mut dyn FnMut(usize, Vec2, Vec2, f64)) {
        if let Some(ContactMode { sense: 0.0, effort, .. }) = self.law_grip(law) {
            self.friction_at_law(law, effort, act);
        }
    }

    /// Calls `act` with the friction of a law: on its first side, and back on the carrier.
    fn friction_at_law(&self, law: &PlannedLaw, effort: f64, act: &mut dyn FnMut(usize, Vec2, Vec2, f64)) {
        for (term, value) in [(0, effort), (2, -effort)] {
            match law.terms.get(term) {
                Some((LawSite::Turn(body), _)) => {
                    act(*body, self.motion.bodies[*body].p, Vec2::zero(), value)
                }
                Some((LawSite::Slide(guide), _)) => {
                    let p = self.motion.bodies[guide.slider].position(guide.point);
                    let force = self.direction(guide) * value;
                    let other = if guide.slider == guide.body { guide.base } else { guide.body };
                    act(guide.slider, p, force, 0.0);
                    act(other, p, -force, 0.0);
                }
                None => {}
            }
        }
    }

    /// Adds the friction of laws to the loads: beside it they pass on all of their power.
    pub(super) fn apply_law_grips(&mut self, plan: &Plan) {
        for law in &plan.laws {
            let Some(ContactMode { effort, .. }) = self.law_grip(law).filter(|grip| grip.effort != 0.0)
            else {
                continue;
            };
            let mut wrenches = std::mem::take(&mut self.forces.wrenches);
            self.friction_at_law(law, effort, &mut |body, p, force, couple| {
                wrenches[body].force += force;
                wrenches[body].moment += (p - self.motion.bodies[body].p).cross(force) + couple;
            });
            self.forces.wrenches = wrenches;
        }
    }

    /// Takes the forces on the sides of laws that move as parts of one multiplier, by the direction of the power.
    pub(super) fn take_sides(&mut self, plan: &Plan) {
        for (slot, law) in plan.laws.iter().enumerate() {
            let Some(ContactMode { sense, effort, .. }) = self.law_grip(law) else { continue };
            let LawForce { multiplier, sides, .. } = &mut self.forces.law_forces[slot];
            let first = *multiplier + effort / law.terms[0].1;
            let backwards = -law.terms[0].1 * sense * *multiplier < 0.0;
            if sense != 0.0 && !backwards && *multiplier != 0.0 && first != 0.0 {
                (*sides, *multiplier) = ([1.0, *multiplier / first], first);
            } else if sense != 0.0 && backwards {
                *sides = [first / *multiplier, 1.0];
            }
        }
    }

    /// What the friction of a law is that moves, in the sense in which its speed counts, from what presses: power from the first side
    /// to the second or back loses its part on the first side.
    #[must_use]
    pub fn friction_of_law(&self, law: &PlannedLaw, slot: usize, sense: f64) -> f64 {
        let [there, back] = law.efficiency.unwrap_or([1.0; 2]);
        let LawForce { multiplier, sides, .. } = &self.forces.law_forces[slot];
        let power = -law.terms[0].1 * sense * multiplier * sides[1];
        -sense * if power >= 0.0 { power * (1.0 / there - 1.0) } else { power * (back - 1.0) }
    }

    /// What holds a law over what its losses can hold: the forces on its two sides lie between those with which either drives.
    #[must_use]
    pub fn part_of_losses(&self, law: &PlannedLaw, slot: usize, effort: f64) -> f64 {
        let multiplier = self.forces.law_forces[slot].multiplier;
        let held = [multiplier + effort / law.terms[0].1, multiplier];
        let [there, back] = [false, true].map(|backwards| sides(law, backwards, 1.0));
        let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
        let whole = cross(there, back);
        let (of_there, of_back) = (cross(held, back) / whole, cross(there, held) / whole);
        let sum = of_there.abs() + of_back.abs();
        let sign = (of_there + of_back).signum();
        if sum == 0.0 { 0.0 } else { 1.0 - 2.0 * (sign * of_there).min(sign * of_back) / sum }
    }

    /// The forces on both sides of a law with losses, per unit of their coefficients, with what holds it.
    #[must_use]
    pub fn on_sides(&self, law: &PlannedLaw, slot: usize) -> [f64; 2] {
        let force = &self.forces.law_forces[slot];
        let [one, other] = force.sides.map(|side| force.multiplier * side);
        match self.law_grip(law) {
            Some(ContactMode { sense: 0.0, effort, .. }) => [one + effort / law.terms[0].1, other],
            _ => [one, other],
        }
    }

    /// The power that transmissions take from what they act on, W.
    #[must_use]
    pub fn power_of_losses(&self, plan: &Plan) -> f64 {
        let losing = plan.laws.iter().enumerate().filter(|(_, law)| law.efficiency.is_some());
        losing.map(|(slot, law)| self.law_power(law, slot)).sum()
    }
}
