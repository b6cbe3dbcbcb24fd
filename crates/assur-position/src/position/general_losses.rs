//! Losses of wheels in general groups: every direction of the power is tried, and all that are consistent are counted.

use super::consistent::Consistent;
use super::general_work::Workspace;
use super::state::State;
use super::train_losses::{NOTHING, sides};
use crate::plan::{BalanceSystem, Plan};
use assur_math::math::SAME;

/// With more transmissions with losses in one group the forces are not searched for.
const MOST: usize = 8;

impl State {
    /// Puts the coefficients of the laws as the sides have them; without losses as they are.
    pub(super) fn set_columns(
        &self,
        plan: &Plan,
        system: &BalanceSystem,
        work: &mut Workspace,
        losses: bool,
    ) {
        for (&slot, gearing) in system.laws.iter().zip(&mut work.equations.laws[system.shared.len()..]) {
            let law = &plan.laws[slot];
            if law.efficiency.is_none() {
                continue;
            }
            let sides = if losses { self.forces.law_forces[slot].sides } else { [1.0, 1.0] };
            for (i, term) in gearing.terms.iter_mut().enumerate() {
                term.coefficient = law.with_losses(i, sides);
            }
        }
    }

    /// Finds the directions in which power flows: the unknowns are then in `work.lambda`, the sides in the state.
    pub(super) fn general_losses(
        &mut self,
        plan: &Plan,
        system: &BalanceSystem,
        work: &mut Workspace,
    ) -> Consistent {
        let lossy = |state: &Self| system.laws.iter().filter(|s| state.loses(&plan.laws[**s])).count();
        let count = lossy(self);
        if count == 0 {
            return Consistent::One;
        }
        if count > MOST {
            return Consistent::Undecided;
        }
        let first = work.lambda.len() - system.laws.len();
        let (mut found, mut best, mut least) = (0, 0, f64::INFINITY);
        for directions in 0..1_u32 << count {
            if !self.solve_directions(plan, system, work, directions) {
                continue;
            }
            let own = &work.lambda[first..];
            let size = own.iter().map(|x| x.abs()).sum::<f64>();
            // where no power flows both directions say the same
            let again = found > 0 && own.iter().zip(&work.kept).all(|(a, b)| (a - b).abs() <= SAME * size);
            if !again {
                found += 1;
            }
            if size < least && !again {
                work.kept[..own.len()].copy_from_slice(own);
                (best, least) = (directions, size);
            }
        }
        if found == 0 {
            return Consistent::None;
        }
        self.solve_directions(plan, system, work, best);
        if found == 1 { Consistent::One } else { Consistent::Several { count: found, followed: false } }
    }

    /// Solves with directions as the bits say; whether power flows so.
    fn solve_directions(
        &mut self,
        plan: &Plan,
        system: &BalanceSystem,
        work: &mut Workspace,
        directions: u32,
    ) -> bool {
        let mut bit = 0;
        for &slot in &system.laws {
            let law = &plan.laws[slot];
            if self.loses(law) {
                self.forces.law_forces[slot].sides = sides(law, directions >> bit & 1 == 1, 1.0);
                bit += 1;
            }
        }
        self.set_columns(plan, system, work, true);
        if work.equations.factor(&work.poses).is_err() {
            return false;
        }
        work.equations.reactions(&work.loads, &mut work.lambda);
        let first = work.lambda.len() - system.laws.len();
        let powers = system.laws.iter().zip(&work.lambda[first..]);
        let lossy = powers.filter(|(slot, _)| self.loses(&plan.laws[**slot]));
        let power = |(slot, multiplier): (&usize, &f64)| multiplier * self.power_sense(&plan.laws[*slot]);
        let greatest = lossy.clone().map(|x| power(x).abs()).fold(0.0, f64::max);
        let mut flows = lossy.map(power).enumerate();
        flows.all(|(bit, power)| {
            power.abs() <= NOTHING * greatest || (power < 0.0) == (directions >> bit & 1 == 1)
        })
    }
}
