//! Losses in trains: the direction in which power flows through each transmission.
//!
//! Each multiplier acts with the efficiency of its direction, hence with a column of the system for each of its signs. Where
//! the departures of all columns from their middles are so small that the system has one solution whatever the loads (found
//! once, in the plan), turning the directions that contradict their powers leads to it. Everything else is searched: all
//! directions that are consistent, and the one reached continuously when the losses grow from zero.

use super::consistent::Consistent;
use super::state::State;
use super::train_work::TrainWork;
use crate::math::AbsLinearSystem;
use crate::plan::{Plan, PlannedLaw, TrainForces, loss_system};

/// Rounds in which directions are turned before all are searched.
const ROUNDS: usize = 12;
/// Powers below this part of the greatest are rounding.
pub(super) const NOTHING: f64 = 1e-11;
/// Most multiplications, roughly, of a search for other solutions than the one followed: some hundredths of a second.
const WORK_FOR_OTHERS: f64 = 1e8;
/// With a middle that is singular, at most this number of transmissions is tried in all directions.
const MOST_TRIED: usize = 12;

/// What is left of the forces on the two sides of a law, by the direction of the power and the part of the losses.
pub(super) fn sides(law: &PlannedLaw, backwards: bool, part: f64) -> [f64; 2] {
    let [there, back] = law.efficiency.unwrap_or([1.0, 1.0]).map(|e| 1.0 + part * (e - 1.0));
    if backwards { [back, 1.0] } else { [1.0, there] }
}

impl State {
    /// Finds the directions in which power flows; the unknowns are then in `work.found`.
    pub(super) fn with_losses(
        &mut self,
        plan: &Plan,
        train: &TrainForces,
        work: &mut TrainWork,
    ) -> Consistent {
        if !train.laws.iter().any(|l| self.loses(&plan.laws[*l])) {
            return Consistent::One;
        }
        work.trial.copy_from_slice(&work.found);
        for _ in 0..ROUNDS {
            self.set_directions(plan, train, &work.trial);
            if !self.unknowns(plan, train, work) {
                break;
            }
            if self.flows(plan, train, &work.trial) {
                if !train.unique {
                    break;
                }
                work.found.copy_from_slice(&work.trial);
                return Consistent::One;
            }
        }
        self.search_losses(plan, train, work)
    }

    /// The unknowns with the sides as they are set.
    pub(super) fn in_senses(&self, plan: &Plan, train: &TrainForces, work: &mut TrainWork) -> Consistent {
        if train.laws.iter().all(|l| plan.laws[*l].efficiency.is_none()) {
            return Consistent::One;
        }
        if !self.unknowns(plan, train, work) {
            return Consistent::Undecided;
        }
        work.found.copy_from_slice(&work.trial);
        Consistent::One
    }

    #[cold]
    #[inline(never)]
    fn search_losses(&mut self, plan: &Plan, train: &TrainForces, work: &mut TrainWork) -> Consistent {
        let Some(laws) = self.loss_laws(plan, train, &work.loads, 1.0) else {
            return self.try_directions(plan, train, work);
        };
        let followed = AbsLinearSystem::follow(|part| self.loss_laws(plan, train, &work.loads, part));
        let left = self.scratch.searched.left();
        let all = laws.solutions(if followed.is_some() { left.min(WORK_FOR_OTHERS) } else { left });
        self.scratch.searched.add(all.work);
        let consistent = match (all.found.len(), &followed) {
            (0 | 1, Some(_)) => Consistent::One,
            (1, None) if all.complete => Consistent::One,
            (0, None) if all.complete => return Consistent::None,
            (_, None) if !all.complete => return Consistent::Undecided,
            (count, _) => Consistent::Several { count, followed: followed.is_some() },
        };
        let size = |x: &Vec<f64>| x.iter().map(|x| x.abs()).sum::<f64>();
        let least = all.found.into_iter().min_by(|a, b| size(a).total_cmp(&size(b)));
        let Some(x) = followed.or(least) else { return Consistent::None };
        // the signs of the multipliers decide; the numbers come from the system itself
        work.trial.fill(0.0);
        let lossy = train.laws.iter().enumerate().filter(|(_, slot)| self.loses(&plan.laws[**slot]));
        for ((column, _), part) in lossy.zip(&laws.parts) {
            work.trial[column] = part.at(&x).x;
        }
        self.set_directions(plan, train, &work.trial);
        if !self.unknowns(plan, train, work) {
            return Consistent::Undecided;
        }
        work.found.copy_from_slice(&work.trial);
        consistent
    }

    /// Every direction of few transmissions.
    fn try_directions(&mut self, plan: &Plan, train: &TrainForces, work: &mut TrainWork) -> Consistent {
        let lossy: Vec<usize> = train.laws.iter().copied().filter(|l| self.loses(&plan.laws[*l])).collect();
        if lossy.len() > MOST_TRIED {
            return Consistent::Undecided;
        }
        let mut all: Vec<Vec<f64>> = Vec::new();
        for directions in 0..1_usize << lossy.len() {
            for (bit, &slot) in lossy.iter().enumerate() {
                self.forces.law_forces[slot].sides = sides(&plan.laws[slot], directions >> bit & 1 == 1, 1.0);
            }
            if self.unknowns(plan, train, work) && self.flows(plan, train, &work.trial) {
                let near = |x: &Vec<f64>| {
                    x.iter().zip(&work.trial).all(|(a, b)| (a - b).abs() <= 1e-9 * a.abs().max(b.abs()))
                };
                if !all.iter().any(near) {
                    all.push(work.trial.clone());
                }
            }
        }
        let size = |x: &Vec<f64>| x.iter().map(|x| x.abs()).sum::<f64>();
        let count = all.len();
        let Some(least) = all.into_iter().min_by(|a, b| size(a).total_cmp(&size(b))) else {
            return Consistent::None;
        };
        self.set_directions(plan, train, &least);
        work.found.copy_from_slice(&least);
        if count == 1 { Consistent::One } else { Consistent::Several { count, followed: false } }
    }

    /// The system in the magnitudes of the multipliers of the laws that lose: those are linear in the magnitudes. `None`
    /// where it is singular with the middles of the columns.
    fn loss_laws(
        &self,
        plan: &Plan,
        train: &TrainForces,
        loads: &[f64],
        part: f64,
    ) -> Option<AbsLinearSystem> {
        let n = train.members.len();
        let lossy: Vec<(usize, usize)> = train
            .laws
            .iter()
            .copied()
            .enumerate()
            .filter(|(_, slot)| self.loses(&plan.laws[*slot]))
            .collect();
        let (mut middle, mut departures) = (train.matrix.clone(), Vec::new());
        for &(column, slot) in &lossy {
            let law = &plan.laws[slot];
            let [there, back] = [false, true].map(|backwards| train.column(law, sides(law, backwards, part)));
            let sense = if self.power_sense(law) < 0.0 { -0.5 } else { 0.5 };
            for i in 0..n {
                middle[i * n + column] = 0.5 * (there[i] + back[i]);
            }
            departures.push((0..n).map(|i| sense * (there[i] - back[i])).collect::<Vec<f64>>());
        }
        let columns: Vec<usize> = lossy.iter().map(|l| l.0).collect();
        loss_system(n, &middle, loads, &departures, &columns)
    }

    /// Whether a law has losses, and its sides move.
    pub(super) fn loses(&self, law: &PlannedLaw) -> bool {
        law.efficiency.is_some() && self.side_rates(law).iter().any(|r| *r != 0.0)
    }

    /// Power that enters on the first side, per unit of the multiplier.
    pub(super) fn power_sense(&self, law: &PlannedLaw) -> f64 {
        -law.terms[0].1 * self.side_rates(law)[0]
    }

    /// Whether power in a law has no direction, since its sides stand.
    #[must_use]
    pub fn is_at_rest(&self, law: &PlannedLaw) -> bool {
        self.side_rates(law) == [0.0, 0.0]
    }

    /// Rates of the two sides from the carrier.
    fn side_rates(&self, law: &PlannedLaw) -> [f64; 2] {
        [0, 1].map(|side| self.seen_from_carrier(law, side, &|site| self.site_rate(site)))
    }

    /// Takes every direction as these multipliers have it.
    fn set_directions(&mut self, plan: &Plan, train: &TrainForces, multipliers: &[f64]) {
        for (&slot, multiplier) in train.laws.iter().zip(multipliers) {
            let law = &plan.laws[slot];
            if self.loses(law) {
                let backwards = multiplier * self.power_sense(law) < 0.0;
                self.forces.law_forces[slot].sides = sides(law, backwards, 1.0);
            }
        }
    }

    /// Whether power flows through every transmission in the direction that is taken.
    fn flows(&self, plan: &Plan, train: &TrainForces, multipliers: &[f64]) -> bool {
        let powers = || {
            train
                .laws
                .iter()
                .zip(multipliers)
                .filter(|(slot, _)| self.loses(&plan.laws[**slot]))
                .map(|(slot, multiplier)| (slot, multiplier * self.power_sense(&plan.laws[*slot])))
        };
        let greatest = powers().map(|p| p.1.abs()).fold(0.0, f64::max);
        powers().all(|(slot, power)| {
            let there = self.forces.law_forces[*slot].sides == sides(&plan.laws[*slot], false, 1.0);
            power.abs() <= NOTHING * greatest || (power > 0.0) == there
        })
    }
}
