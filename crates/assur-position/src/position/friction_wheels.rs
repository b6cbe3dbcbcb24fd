//! Friction together with wheels: forces between teeth, and what gets through with losses, depend on the sense in which the
//! teeth press. With the senses set the forces are linear in the loads, and the laws of friction are solved as elsewhere; then
//! the multipliers must have these senses.

use super::consistent::Consistent;
use super::friction_work::FrictionWork;
use super::state::State;
use super::train_losses::sides;
use super::wrench::Wrench;
use crate::plan::{ForceStep, FrictionGroup, Plan, PlannedLaw};
use assur_math::math::SAME;

/// Rounds in which senses are turned before all are searched.
const ROUNDS: usize = 8;
/// A multiplier below this part of the greatest is rounding.
const NOTHING: f64 = 1e-11;
/// All senses of at most this number of laws are searched.
const MOST: usize = 6;

impl State {
    /// As [`State::rub`], for a group whose step finds multipliers.
    pub(super) fn rub_with_wheels(
        &mut self,
        plan: &Plan,
        plain: &ForceStep,
        group: &FrictionGroup,
        work: &mut FrictionWork,
    ) -> Option<f64> {
        self.respond(plan, plain, group, work, None);
        self.scratch.in_senses = true;
        let mut found = None;
        for _ in 0..ROUNDS {
            self.take_senses(plan, &group.laws);
            found = self.rub(plan, plain, group, work, &mut ());
            if found.is_none() || self.has_senses(&group.laws) {
                break;
            }
            found = None;
            self.restore(group, &work.saved);
        }
        self.scratch.in_senses = false;
        found
    }

    /// Takes the senses of the multipliers as they are.
    fn take_senses(&mut self, plan: &Plan, laws: &[usize]) {
        for &slot in laws {
            let backwards = self.forces.law_forces[slot].multiplier < 0.0;
            self.set_sense(&plan.laws[slot], slot, backwards);
        }
    }

    fn set_sense(&mut self, law: &PlannedLaw, slot: usize, backwards: bool) {
        let sense = if backwards { -1.0 } else { 1.0 };
        let of_power = self.loses(law).then(|| sense * self.power_sense(law) < 0.0);
        let force = &mut self.forces.law_forces[slot];
        force.sense = sense;
        force.sides = of_power.map_or([1.0, 1.0], |backwards| sides(law, backwards, 1.0));
    }

    /// Whether the multipliers have the senses that are set.
    fn has_senses(&self, laws: &[usize]) -> bool {
        let forces = || laws.iter().map(|slot| &self.forces.law_forces[*slot]);
        let greatest = forces().map(|f| f.multiplier.abs()).fold(0.0, f64::max);
        forces().all(|f| f.multiplier * f.sense >= -NOTHING * greatest)
    }

    /// Laws whose forces depend on their senses.
    pub(super) fn sensed(&self, plan: &Plan) -> Vec<usize> {
        let presses = |law: &PlannedLaw| law.meeting.is_some_and(|m| m.tangent != 0.0);
        let laws = plan.laws.iter().enumerate().filter(|(_, law)| presses(law) || self.loses(law));
        laws.map(|(slot, _)| slot).collect()
    }

    /// All states of the forces in which friction and the senses of these laws agree: that which loses the least power.
    pub(super) fn search_beside_wheels(
        &mut self,
        plan: &Plan,
        sensed: &[usize],
        moving: &[usize],
        loads: &[Wrench],
    ) -> (Option<Vec<f64>>, Consistent) {
        if sensed.len() > MOST {
            return (None, Consistent::Undecided);
        }
        let mut all: Vec<(u32, Vec<f64>)> = Vec::new();
        let mut complete = true;
        self.scratch.in_senses = true;
        for senses in 0..1_u32 << sensed.len() {
            self.set_all_senses(plan, sensed, senses);
            let laws = self.friction_laws(plan, moving, loads);
            let found = laws.solutions(self.scratch.searched.left());
            self.scratch.searched.add(found.work);
            complete &= found.complete;
            for efforts in found.found {
                self.rub_all(plan, moving, &efforts, loads);
                let size = efforts.iter().fold(f64::MIN_POSITIVE, |most: f64, x| most.max(x.abs()));
                let near = |x: &[f64]| x.iter().zip(&efforts).all(|(a, b)| (a - b).abs() <= SAME * size);
                if self.has_senses(sensed) && !all.iter().any(|other| near(&other.1)) {
                    all.push((senses, efforts));
                }
            }
        }
        let consistent = match all.len() {
            0 if complete => Consistent::None,
            0 => Consistent::Undecided,
            1 => Consistent::One,
            count => Consistent::Several { count, followed: false },
        };
        let loss = |of: &(u32, Vec<f64>)| -> f64 {
            let powers = moving.iter().zip(&of.1);
            powers.map(|(e, x)| (x * self.sliding_speed(&plan.friction[*e])).abs()).sum()
        };
        let least = all.iter().min_by(|a, b| loss(a).total_cmp(&loss(b))).cloned();
        if let Some((senses, _)) = least {
            self.set_all_senses(plan, sensed, senses);
        }
        (least.map(|x| x.1), consistent)
    }

    fn set_all_senses(&mut self, plan: &Plan, sensed: &[usize], senses: u32) {
        for (bit, &slot) in sensed.iter().enumerate() {
            self.set_sense(&plan.laws[slot], slot, senses >> bit & 1 == 1);
        }
    }
}
