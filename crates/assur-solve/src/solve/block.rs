//! Positions of a sweep side by side, where none depends on the one before.
//!
//! A closed form finds a position from the drives and from the assembly alone. Where every group stays far from its change points
//! the motion keeps the assembly, which is what following would find: a block of such positions is solved at once, here, and then
//! taken over by the one that follows ([`Taking::take`](super::Taking::take)), as far as that holds. Nothing else may come of
//! it than from following: not a bit, not a note.

use super::inputs::Rates;
use super::lost::{is_moderate, out_of_scale};
use super::positions::Sweep;
use super::solution::{Pose, Solved};
use super::steps::steps;
use super::track::{CAREFUL, turn_on};
use crate::answer::{PoseAnswers, WholeCycle};
use crate::model::PairKind;
use crate::plan::Numbers;
use crate::position::{Branch, Model, PoseOrigin, Residuals, State, Together};
use std::f64::consts::TAU;

/// The most positions of a block.
pub const BLOCK: usize = 64;
/// Conditions above this are not worth a note, whatever they are of, and make no group behind them worse.
const NO_NOTE: f64 = 0.05;

/// Whether positions of a mechanism can depend on the drives and the assembly alone, with nothing to be said about them.
pub(super) fn is_free(model: &Model<'_>) -> bool {
    let plan = model.plan;
    let contact = |pair: &crate::model::Pair| matches!(pair.kind, PairKind::Contact { .. });
    plan.is_batchable()
        && plan.settings.scalar == Numbers::Double
        && !plan.effects.loses()
        && !model.mechanism.has_curves
        && !model.mechanism.pairs.iter().any(contact)
}

/// What the next positions of a sweep are solved from while the one that follows it looks at others.
#[derive(Clone, Copy, Debug)]
pub struct Ahead<'f> {
    pub(super) model: &'f Model<'f>,
    pub(super) rates: &'f Rates,
    pub(super) statics: &'f WholeCycle,
    pub(super) sweep: &'f Sweep,
    pub(super) branches: &'f [Branch],
    pub(super) first: usize,
    pub(super) count: usize,
    pub(super) extent: f64,
    /// How many angles there are, of bodies and pairs.
    pub(super) angles: usize,
    /// The balance of forces is checked and its residuals are kept.
    pub(super) residuals: bool,
}

/// Positions side by side, with the memory for them.
#[derive(Debug, Default)]
pub struct Block {
    poses: Vec<Pose>,
    states: Vec<State>,
    residuals: Vec<Residuals>,
    together: Together,
    /// Whole turns of the bodies since the first position.
    turns: Vec<f64>,
    pub(super) begin: Begin,
    /// How many positions from the first on are what following would find, as far as it was looked at.
    free: usize,
}

/// What the positions of a block have from those before them.
#[derive(Debug, Default)]
pub(super) struct Begin {
    /// Whole turns of the bodies at the first position.
    pub turns: Vec<f64>,
    /// Whole turns of the pairs, rad.
    pub pairs: Vec<f64>,
}

impl Ahead<'_> {
    /// How many positions can be tried.
    #[must_use]
    pub const fn count(&self) -> usize {
        self.count
    }

    /// Those behind the next `count` of them.
    #[must_use]
    pub const fn behind(self, count: usize) -> Self {
        Self { first: self.first + count, count: self.count.saturating_sub(count), ..self }
    }

    /// The same, with the closure as the only residual: of forces that are neither lost nor out of scale nothing else is reported.
    #[must_use]
    pub const fn without_residuals(self) -> Self {
        Self { residuals: false, ..self }
    }

    /// Solves positions, counted from the first that can be tried.
    pub fn solve(&self, block: &mut Block, from: usize) {
        let count = self.count.saturating_sub(from).min(BLOCK);
        block.resize(self.model, count);
        for (i, (pose, state)) in block.poses.iter_mut().zip(&mut block.states).enumerate() {
            let index = self.first + from + i;
            pose.name.clear();
            pose.name.push_str(itoa::Buffer::new().format(index + 1));
            pose.origin = PoseOrigin::Sweep(index);
            self.sweep.write_values(index, &mut pose.drives);
            self.rates.at(&pose.drives, &mut state.motion.inputs);
            state.branches.copy_from_slice(self.branches);
        }
        block.together.run(self.model.plan, &mut block.states, &mut block.residuals, self.residuals);
        block.free = 0;
        block.turns.clear();
        for i in 0..count {
            if !is_regular(self.model, &block.states[i], &block.residuals[i]) || !self.goes_on(block, i) {
                break;
            }
            let (state, residuals) = (&mut block.states[i], block.residuals[i]);
            let Ok(solved) = &mut block.poses[i].outcome else { break };
            solved.condition = condition(self.model, state);
            solved.residuals = residuals;
            std::mem::swap(&mut solved.state, state);
            block.free += 1;
        }
    }

    /// Whether following goes from the position before to this one in a step; carries the turns of the bodies on.
    fn goes_on(&self, block: &mut Block, i: usize) -> bool {
        let bodies = self.model.plan.bodies;
        let Some(before) = i.checked_sub(1) else {
            block.turns.resize(bodies, 0.0);
            return true;
        };
        let [last, next] = [before, i].map(|i| &block.poses[i].drives);
        if steps(self.model, self.extent, last, next) > 1.0 {
            return false;
        }
        block.turns.extend_from_within(before * bodies..);
        let Ok(last) = &block.poses[before].outcome else { return false };
        turn_on(&mut block.turns[i * bodies..], &last.state, &block.states[i])
    }

    /// Adds to positions what is computed from their states: the quantities; and the angles if they are asked for, of positions that were
    /// taken over.
    pub fn answer(&self, block: &mut Block, angles: bool) {
        let bodies = self.model.plan.bodies;
        let (turns, begin) = (block.turns.chunks_exact(bodies), &block.begin);
        for (pose, turns) in block.poses.iter_mut().take(block.free).zip(turns) {
            let Ok(solved) = &mut pose.outcome else { continue };
            solved.angles.clear();
            if angles {
                let whole = begin.turns.iter().zip(turns);
                let known = solved.state.motion.bodies.iter().zip(whole);
                solved
                    .angles
                    .extend(known.map(|(body, (begin, turns))| body.u.angle() + (begin + turns) * TAU));
                solved.angles.extend_from_slice(&begin.pairs);
            } else {
                solved.angles.resize(self.angles, f64::NAN);
            }
            if !self.model.mechanism.quantities.is_empty() {
                let view = PoseAnswers::new(self.model, &solved.state, &solved.angles, self.statics);
                solved.quantities = view.all_quantities();
            }
        }
    }
}

impl Block {
    /// The positions, as far as they were taken over.
    #[must_use]
    pub fn poses(&self) -> &[Pose] {
        &self.poses[..self.free]
    }

    /// The states at them.
    pub(super) fn states(&self) -> impl Iterator<Item = &State> {
        self.poses().iter().filter_map(|pose| pose.outcome.as_ref().ok()).map(|solved| &solved.state)
    }

    /// Whole turns of the bodies at a position since the first.
    pub(super) fn turns_at(&self, position: usize) -> &[f64] {
        let bodies = self.begin.turns.len();
        &self.turns[position * bodies..][..bodies]
    }

    /// How many were solved.
    pub(super) const fn solved(&self) -> usize {
        self.poses.len()
    }

    /// Hands the positions over.
    pub(super) fn into_poses(mut self) -> impl Iterator<Item = Pose> {
        self.poses.truncate(self.free);
        self.poses.into_iter()
    }

    /// So many positions are left.
    pub(super) fn keep(&mut self, count: usize) {
        self.free = count;
    }

    fn resize(&mut self, model: &Model<'_>, count: usize) {
        self.poses.truncate(count);
        while self.poses.len() < count {
            let (state, angles, quantities) = (State::closed(model.plan), Vec::new(), Vec::new());
            let (frictionless, residuals, condition) = (None, Residuals::default(), 1.0);
            let solved = Solved { state, frictionless, quantities, angles, residuals, condition };
            let (name, origin, drives) = (String::new(), PoseOrigin::Sweep(0), Vec::new());
            self.poses.push(Pose { name, origin, drives, outcome: Ok(solved) });
        }
        self.states.truncate(count);
        self.states.resize_with(count, || State::closed(model.plan));
        self.residuals.resize(count, Residuals::default());
    }
}

/// Whether a position is one that following finds too, if the one before is: far from change points, and with nothing to be said
/// about it.
fn is_regular(model: &Model<'_>, state: &State, residuals: &Residuals) -> bool {
    state.motion.open.is_none()
        && keeps_its_assembly(model, state)
        && state.motion.conditions.iter().all(|c| c.abs() > NO_NOTE)
        && state.forces.conditions.iter().all(|c| c.abs() > NO_NOTE)
        && is_moderate(state)
        && out_of_scale(residuals).is_none()
}

/// Whether no group is so near to a change point that following tries both its assemblies.
pub(super) fn keeps_its_assembly(model: &Model<'_>, state: &State) -> bool {
    let groups = model.plan.motion.iter().zip(&state.motion.conditions);
    groups.into_iter().all(|(step, c)| c.abs() >= CAREFUL || !state.has_two_roots(step))
}

fn condition(model: &Model<'_>, state: &State) -> f64 {
    let forces = if model.plan.effects.forces { state.forces.conditions.as_slice() } else { &[] };
    state.motion.conditions.iter().chain(forces).fold(1.0, |least: f64, c| least.min(c.abs()))
}
