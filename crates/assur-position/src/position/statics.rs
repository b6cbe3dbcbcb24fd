//! Forces at one position: loads, reactions, efforts, friction.

use super::consistent::Consistent;
use super::wrench::{LawForce, Reaction, Wrench};
use crate::math::{Scalar, V2};
use crate::plan::Plan;

/// The forces at one position, or at several side by side.
#[derive(Clone, Debug, Default)]
pub struct Forces<S = f64> {
    /// Loads on the bodies before reactions are added, kept for the residuals.
    pub applied: Vec<Wrench<S>>,
    /// Loads, to which the steps of forces add the reactions found so far.
    pub wrenches: Vec<Wrench<S>>,
    pub reactions: Vec<Reaction<S>>,
    pub efforts: Vec<S>,
    /// Lines of unknown forces: point and unit direction in ground axes.
    pub lines: Vec<(V2<S>, V2<S>)>,
    /// Condition figures of the groups.
    pub conditions: Vec<S>,
    /// Efforts of friction, by element: torque or force on the element's body.
    pub frictions: Vec<f64>,
    /// Senses of the relative motions, by element: ±1, or 0 where there is none.
    pub senses: Vec<f64>,
    /// What the laws of transmissions do.
    pub law_forces: Vec<LawForce>,
    /// Friction admits no motion: reactions and efforts do not exist.
    pub locked: bool,
    /// How many states of the forces satisfy the laws of friction and of losses.
    pub consistent: Consistent,
}

impl<S: Scalar + Default> Forces<S> {
    pub(super) fn none(plan: &Plan) -> Self {
        Self {
            applied: vec![Wrench::default(); plan.bodies],
            wrenches: vec![Wrench::default(); plan.bodies],
            reactions: vec![Reaction::default(); plan.reactions.len()],
            efforts: vec![S::zero(); plan.efforts],
            lines: vec![(V2::zero(), V2::new(S::one(), S::zero())); plan.efforts],
            conditions: vec![S::one(); plan.forces.len()],
            frictions: vec![0.0; plan.friction.len()],
            senses: vec![0.0; plan.friction.len()],
            law_forces: vec![LawForce::default(); plan.laws.len()],
            locked: false,
            consistent: Consistent::One,
        }
    }
}

impl Forces {
    /// Takes over all of another one, in the memory that is there.
    pub(super) fn copy(&mut self, other: &Self) {
        let Self { applied, wrenches, reactions, efforts, lines, conditions, .. } = other;
        self.applied.clone_from(applied);
        self.wrenches.clone_from(wrenches);
        self.reactions.clone_from(reactions);
        self.efforts.clone_from(efforts);
        self.lines.clone_from(lines);
        self.conditions.clone_from(conditions);
        let Self { frictions, senses, law_forces, locked, consistent, .. } = other;
        self.frictions.clone_from(frictions);
        self.senses.clone_from(senses);
        self.law_forces.clone_from(law_forces);
        (self.locked, self.consistent) = (*locked, *consistent);
    }

    /// Puts all of them to nothing.
    pub fn clear(&mut self) {
        self.applied.fill(Wrench::default());
        self.wrenches.fill(Wrench::default());
        self.reactions.fill(Reaction::default());
        self.efforts.fill(0.0);
        self.conditions.fill(1.0);
        self.frictions.fill(0.0);
        self.senses.fill(0.0);
        self.law_forces.fill(LawForce::default());
        self.locked = false;
        self.consistent = Consistent::One;
    }
}
