//! Where friction would let go: the part of it at which a locked position begins to move.

use super::pose_answers::PoseAnswers;
use crate::model::PairId;
use crate::plan::Plan;
use crate::position::{Model, State};

/// Parts of friction at which is looked whether it moves: it may stop, and move again with more.
const PARTS: u32 = 32;
/// Halvings between two of them.
const HALVINGS: usize = 45;

pub(crate) struct Locked<'a> {
    pub model: &'a Model<'a>,
    /// The position with its loads and senses.
    pub state: &'a State,
    /// Power of the efforts without friction, W.
    pub ideal: f64,
}

impl Locked<'_> {
    /// The part of the friction, in one pair or in all, below which it always moves; `None` where it is locked without.
    pub fn limit(&self, of: Option<PairId>) -> Option<f64> {
        let mut plan = self.model.plan.clone();
        let mut state = self.state.clone().ready(self.model.plan);
        state.scratch.searched = state.scratch.searched.nearly_spent();
        if !self.moves(&mut state, &mut plan, of, 0.0) {
            return None;
        }
        let parts = (1..PARTS).map(|i| f64::from(i) / f64::from(PARTS));
        let first = parts.into_iter().find(|part| !self.moves(&mut state, &mut plan, of, *part));
        let (mut least, mut most) =
            first.map_or((1.0 - 1.0 / f64::from(PARTS), 1.0), |part| (part - 1.0 / f64::from(PARTS), part));
        for _ in 0..HALVINGS {
            let middle = 0.5 * (least + most);
            if self.moves(&mut state, &mut plan, of, middle) {
                least = middle;
            } else {
                most = middle;
            }
        }
        Some(least)
    }

    /// The pairs and the power that each loses where it just moves, the greatest first.
    pub fn losses(&self, part: f64) -> Vec<(PairId, f64)> {
        let mut plan = self.model.plan.clone();
        let mut state = self.state.clone().ready(self.model.plan);
        self.moves(&mut state, &mut plan, None, part * (1.0 - 1e-6));
        let mut losses: Vec<(PairId, f64)> = Vec::new();
        for (element, effort) in plan.friction.iter().zip(&state.forces.frictions) {
            let power = -effort * state.sliding_speed(element);
            match losses.iter_mut().find(|(pair, _)| *pair == element.pair) {
                Some((_, sum)) => *sum += power,
                None => losses.push((element.pair, power)),
            }
        }
        losses.sort_by(|a, b| b.1.total_cmp(&a.1));
        losses
    }

    fn moves(&self, state: &mut State, plan: &mut Plan, of: Option<PairId>, part: f64) -> bool {
        for (element, full) in plan.friction.iter_mut().zip(&self.model.plan.friction) {
            let by = if of.is_none_or(|pair| pair == full.pair) { part } else { 1.0 };
            element.kind = full.kind.scaled(by);
        }
        state.forces.wrenches.clone_from(&state.forces.applied);
        state.bear_loads(plan);
        state.forces.frictions.fill(0.0);
        state.forces.locked = false;
        state.run_forces(plan);
        let actual = PoseAnswers::new(self.model, state, &[], &super::whole_cycle::WholeCycle::EMPTY)
            .power_of_efforts();
        !state.forces.locked && actual * self.ideal > 0.0
    }
}
