//! What holds a free coordinate: friction in its own pair, or a stop on which it rests. No effort acts on the coordinate, so that the
//! balance of its link gives the force that holds it.

use crate::course::Derivation;
use crate::document::{Line, text};
use crate::motion::of;
use crate::words::FrictionMessage;
use assur_formula::{Expr, Name, Quantity, Unit};
use assur_model::model::{Load, LoadId, LoadKind, PairId, PairKind, Query, Value};
use assur_position::plan::{ForceStep, FrictionElement};
use assur_position::position::{Action, Origin};
use std::sync::Arc;

/// A force or couple that holds a pair, and that the balance of a link gives.
#[derive(Clone, Debug)]
pub struct Hold {
    pair: PairId,
    /// What it is in the list of what acts.
    from: Origin,
    /// Its letters, value and unit.
    name: Name,
    value: f64,
    unit: Unit,
    /// The body on which it acts as counted; the other has the opposite.
    on: usize,
}

/// The pair and the effort of a link that has a hinge or a guide and an effort alone.
fn balanced(course: &Derivation<'_>, step: &ForceStep) -> Option<(PairId, usize)> {
    let (slot, effort) = match step {
        ForceStep::Turn { hinge, value, .. } => (hinge.slot, value.0),
        ForceStep::Shift { guide, value, .. } => (guide.slot, value.0),
        ForceStep::Friction { plain, .. } => return balanced(course, plain),
        _ => return None,
    };
    Some((course.pair_of_reaction(slot), effort))
}

impl Derivation<'_> {
    /// The pair of a reaction.
    pub(super) fn pair_of_reaction(&self, slot: usize) -> PairId {
        let joint = self.scene.model.plan.reactions[slot].joint;
        self.structure().replaced.joint(joint).pair
    }

    /// Whether the balance of a link gives what holds this pair: no effort acts on its coordinate, and nothing else holds it.
    fn gives_hold(&self, pair: PairId) -> bool {
        let plan = self.scene.model.plan;
        let senses = &self.state().forces.senses;
        let held = plan.friction.iter().enumerate().filter(|(slot, element)| {
            element.pair == pair && senses[*slot] == 0.0 && self.friction_in(*slot) != 0.0
        });
        let stops = (self.scene.mechanism().loads.iter().enumerate())
            .filter(|(i, load)| stop_of(load) == Some(pair) && self.load_value(*i) != 0.0);
        let steps = plan.forces.iter().flat_map(|step| match step {
            ForceStep::Sequence(steps) => steps.as_slice(),
            one => std::slice::from_ref(one),
        });
        let own = steps
            .filter_map(|step| balanced(self, step))
            .any(|(p, slot)| p == pair && self.has_no_effort(slot));
        own && held.count() + stops.count() == 1
    }

    fn load_value(&self, load: usize) -> f64 {
        match self.scene.view().query(&Query::Load(LoadId::at(load))) {
            Value::Scalar(x) => x,
            _ => 0.0,
        }
    }

    /// The friction of an element that is held, as what is still to be found; none where no balance gives it.
    pub(super) fn friction_to_find(
        &mut self,
        slot: usize,
        element: &FrictionElement,
        unit: Unit,
    ) -> Option<Expr> {
        self.is_to_find(slot, element).then(|| {
            let (name, value) = (self.friction_name(element), self.state().forces.frictions[slot]);
            let from = Origin::Friction(slot);
            self.sought(Hold { pair: element.pair, from, name, value, unit, on: element.through })
        })
    }

    /// Whether an element is held by friction that the balance of its link gives.
    pub(super) fn is_to_find(&self, slot: usize, element: &FrictionElement) -> bool {
        self.state().forces.senses[slot] == 0.0 && self.gives_hold(element.pair)
    }

    /// The force of a stop on which a pair rests: its magnitude, which the balance of a link gives or the solver states.
    pub(super) fn stop_effort(&mut self, pair: PairId, action: &Action, effort: f64, unit: Unit) -> Expr {
        let declared = self.scene.mechanism().pair(pair);
        let parts = matches!(declared.kind, PairKind::Contact { .. });
        let message = if parts { FrictionMessage::ContactCloses } else { FrictionMessage::RestsOnStop };
        let words = declared.name.clone();
        let name = Name::new(if unit == Unit::Force { "N" } else { "M" }, &words);
        let letters: [Line; 2] = [vec![text(words)], of(&name)];
        self.say(message, &letters);
        if self.gives_hold(pair) {
            let (from, on) = (action.from, action.on);
            return self.sought(Hold { pair, from, name, value: effort, unit, on });
        }
        self.solutions.insert(name.clone());
        self.stated(name, effort, unit)
    }

    fn sought(&mut self, hold: Hold) -> Expr {
        let (name, value, unit) = (hold.name.clone(), hold.value, hold.unit);
        self.holds.push(hold);
        Expr::Leaf(Arc::new(Quantity { name, value, unit, scale: value.abs(), given: false, rounding: 0.0 }))
    }

    /// What holds a pair and is still to be found, with its letters.
    pub(super) fn hold_in(&self, pair: PairId) -> Option<Hold> {
        self.holds.iter().find(|hold| hold.pair == pair).cloned()
    }

    /// The known forces and couples of a body without what holds it, while something is done.
    pub(super) fn without_hold<T>(
        &mut self,
        body: usize,
        hold: Option<&Hold>,
        work: impl FnOnce(&mut Self) -> T,
    ) -> T {
        let Some(hold) = hold else { return work(self) };
        let (forces, couples) = (self.free.forces[body].clone(), self.free.couples[body].clone());
        self.free.forces[body].retain(|force| force.from != Some(hold.from));
        self.free.couples[body].retain(|couple| couple.from != Some(hold.from));
        let found = work(self);
        self.free.forces[body] = forces;
        self.free.couples[body] = couples;
        found
    }

    /// What holds a body, from all else that acts on it along its guide or about its hinge.
    pub(super) fn found_hold(&mut self, body: usize, hold: &Hold, others: Expr) {
        let right = if hold.on == body { -others } else { others };
        self.equate_or_nothing(&hold.name, hold.value, hold.unit, right);
    }
}

impl Hold {
    pub(super) const fn name(&self) -> &Name {
        &self.name
    }
}

/// The pair of a stop.
pub(super) const fn stop_of(load: &Load) -> Option<PairId> {
    match load.kind {
        LoadKind::InPair { pair, value: assur_model::model::Expr::Query(Query::StopEffort(_)), .. } => {
            Some(pair)
        }
        _ => None,
    }
}
