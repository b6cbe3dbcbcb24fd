//! Positions of a sweep side by side, where none depends on the one before.
//!
//! A closed form finds a position from the drives and from the assembly alone. Where every group stays far from its change points
//! the motion keeps the assembly, which is what following would find: a block of such positions is solved at once, here, and then
//! taken over by the one that follows ([`Following::take`](super::Following::take)), as far as that holds. Nothing else may come of
//! it than from following: not a bit, not a note.

use super::inputs::Rates;
use super::positions::Sweep;
use super::regular::{NO_NOTE, conditions, is_sound};
use super::solution::{Pose, Solved};
use super::track::CAREFUL;
use crate::answer::{PoseAnswers, WholeCycle};
use crate::model::PairKind;
use crate::plan::Numbers;
use crate::position::{Branch, Model, PoseOrigin, Residuals, State, Together};

/// The most positions of a block.
pub const BLOCK: usize = 64;

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
    /// Whole turns of the bodies at every position, rad.
    turns: Vec<f64>,
    /// The same at the position that is looked at.
    pub(super) running: Vec<f64>,
    /// How many positions from the first on are what following would find, as far as it was looked at.
    free: usize,
}

impl Ahead<'_> {
    /// How many positions can be tried.
    #[must_use]
    pub const fn count(&self) -> usize {
        self.count
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
        for (i, pose) in block.poses.iter_mut().enumerate() {
            let (state, residuals) = (&mut block.states[i], block.residuals[i]);
            if !is_regular(self.model, state, &residuals) {
                break;
            }
            let Ok(solved) = &mut pose.outcome else { break };
            solved.condition = conditions(self.model, state).fold(1.0, f64::min);
            solved.residuals = residuals;
            std::mem::swap(&mut solved.state, state);
            block.free += 1;
        }
    }

    /// Adds to the positions that were taken over what depends on those before: the quantities, and the angles if they are asked
    /// for.
    pub fn answer(&self, block: &mut Block, angles: bool) {
        let bodies = self.model.plan.bodies;
        let turns = block.turns.chunks_exact(bodies);
        for (pose, turns) in block.poses.iter_mut().take(block.free).zip(turns) {
            let Ok(solved) = &mut pose.outcome else { continue };
            if angles {
                let bodies = solved.state.motion.bodies.iter().zip(turns);
                for (angle, (body, turns)) in solved.angles.iter_mut().zip(bodies) {
                    *angle = body.u.angle() + turns;
                }
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

    /// The state at a position.
    pub(super) fn state(&self, position: usize) -> Option<&State> {
        self.poses.get(position)?.outcome.as_ref().ok().map(|solved| &solved.state)
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

    /// Keeps the whole turns of the bodies at a position, rad, and of its pairs what does not change.
    pub(super) fn keep_turns(&mut self, position: usize, bodies: &[f64], pairs: &[f64]) {
        let count = bodies.len();
        self.turns.resize(self.poses.len() * count, 0.0);
        self.turns[position * count..(position + 1) * count].copy_from_slice(bodies);
        if let Ok(solved) = &mut self.poses[position].outcome {
            solved.angles.resize(count, f64::NAN);
            solved.angles.extend_from_slice(pairs);
        }
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
        && conditions(model, state).all(|c| c > NO_NOTE)
        && is_sound(state, residuals)
}

/// Whether no group is so near to a change point that following tries both its assemblies.
pub(super) fn keeps_its_assembly(model: &Model<'_>, state: &State) -> bool {
    let groups = model.plan.motion.iter().zip(&state.motion.conditions);
    groups.into_iter().all(|(step, c)| c.abs() >= CAREFUL || !state.has_two_roots(step))
}
