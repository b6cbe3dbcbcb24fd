//! Collects what deserves a note about the friction of all positions: of each kind the first position, and how many more
//! there are.

use super::note::{Locking, Note};
use crate::answer::{Locked, PoseAnswers};
use crate::model::{At, Expr, FindKind, Mechanism, PairId, Query, Relation};
use crate::position::{Model, PoseOrigin, PoseRequest};

/// A pair that loses less than this part of the greatest loss is not what locks.
const SLIGHT: f64 = 0.05;

/// What was found so far.
#[derive(Debug, Default)]
pub(super) struct FrictionNotes {
    locked: Option<Locking>,
    /// The ideal power of the last position of a sweep that does not lock, W, and what locks since then.
    passing: (Option<f64>, Option<Locking>),
    /// Results without a value at the first position that has such results, and how many more there are.
    without_effort: Option<(Vec<usize>, PoseRequest, usize)>,
    still: Vec<(PairId, PoseRequest, usize)>,
}

impl FrictionNotes {
    /// Looks at the friction of a position.
    pub(super) fn update(&mut self, model: &Model<'_>, view: &PoseAnswers<'_>, pose: &PoseRequest) {
        if matches!(pose.origin, PoseOrigin::Expected(_)) {
            return;
        }
        let simulated = model.mechanism.simulation.is_some();
        if model.plan.effects.losses && !simulated && !view.state.forces.locked {
            for (law, force) in model.plan.laws.iter().zip(&view.state.forces.law_forces) {
                if law.efficiency.is_some() && force.multiplier != 0.0 && view.state.is_at_rest(law) {
                    self.note_at_rest(law.pair, pose);
                }
            }
        }
        // no effort moves a motion that follows from the loads
        if !model.plan.effects.friction || simulated {
            return;
        }
        for (i, pair) in model.mechanism.pairs.iter().enumerate() {
            let id = PairId::at(i);
            let rubs = pair.friction.is_some_and(|f| f.is_some());
            let senses =
                || model.plan.friction_of.places(id).iter().filter_map(|&e| view.state.forces.senses.get(e));
            if rubs && senses().all(|sense| *sense == 0.0) {
                self.note_at_rest(id, pose);
            }
        }
        if view.efficiency() > 0.0 || view.efficiency().is_nan() || view.overcomes_friction_alone() {
            self.moves(view, pose);
            return;
        }
        let passes = matches!(pose.origin, PoseOrigin::Sweep(_)) && !view.state.forces.locked;
        let notes = if passes { &mut self.passing.1 } else { &mut self.locked };
        match notes {
            _ if expects_lock(model.mechanism, pose) => {}
            Some(locking) => locking.more += 1,
            None => *notes = Some(locked(model, view, pose)),
        }
        if !view.state.forces.locked {
            return;
        }
        match &mut self.without_effort {
            Some((_, _, more)) => *more += 1,
            None => {
                let finds = without_effort(view);
                self.without_effort = (!finds.is_empty()).then(|| (finds, pose.clone(), 0));
            }
        }
    }

    /// A position does not lock. If the ideal power changes its sign between this position and the last one that did not lock, the
    /// positions between are next to a dead centre, which the drive passes: that is not reported.
    fn moves(&mut self, view: &PoseAnswers<'_>, pose: &PoseRequest) {
        if !matches!(pose.origin, PoseOrigin::Sweep(_)) {
            return;
        }
        let nothing = view.overcomes_friction_alone();
        let ideal = if nothing { 0.0 } else { view.without_friction().power_of_efforts() };
        let passes = self.passing.0.replace(ideal).is_some_and(|before| before * ideal <= 0.0);
        let passed = self.passing.1.take().filter(|_| !passes);
        self.lock(passed);
    }

    fn lock(&mut self, passed: Option<Locking>) {
        let Some(passed) = passed else { return };
        match &mut self.locked {
            Some(locking) => locking.more += 1 + passed.more,
            None => self.locked = Some(passed),
        }
    }

    /// A pair or a transmission whose losses have no direction.
    fn note_at_rest(&mut self, pair: PairId, pose: &PoseRequest) {
        match self.still.iter_mut().find(|s| s.0 == pair) {
            Some((_, _, more)) => *more += 1,
            None => self.still.push((pair, pose.clone(), 0)),
        }
    }

    /// All that was found.
    pub(super) fn into_notes(mut self) -> impl Iterator<Item = Note> {
        let passed = self.passing.1.take();
        self.lock(passed);
        let still = self.still.into_iter().map(|(pair, pose, more)| Note::NoSliding { pair, pose, more });
        let without = self.without_effort.map(|(finds, pose, more)| Note::NoEffort { finds, pose, more });
        still.chain(self.locked.map(Note::Locked)).chain(without)
    }
}

fn locked(model: &Model<'_>, view: &PoseAnswers<'_>, pose: &PoseRequest) -> Locking {
    let ideal = view.without_friction().power_of_efforts();
    let position = Locked { model, state: view.state, ideal };
    let part = position.limit(None).unwrap_or(0.0);
    let mut losses = position.losses(part);
    let least = losses.first().map_or(0.0, |l| SLIGHT * l.1);
    losses.retain(|l| l.1 >= least && l.1 > 0.0);
    let limit = |pair| model.mechanism.pair(pair).friction.and_then(|_| position.limit(Some(pair)));
    Locking {
        pose: pose.clone(),
        more: 0,
        pairs: losses.into_iter().map(|(pair, _)| (pair, limit(pair))).collect(),
        part,
        efficiency: (!view.state.forces.locked).then(|| view.efficiency()),
        criticals: view.statics.criticals.clone(),
    }
}

/// Whether the file expects `locked()` at this position: then it is no news.
fn expects_lock(mechanism: &Mechanism, pose: &PoseRequest) -> bool {
    mechanism.expects.iter().any(|expect| {
        let here = match &expect.at {
            None => matches!(pose.origin, PoseOrigin::Sweep(_)),
            Some(At::Pose(name, _)) => pose.name == *name,
            Some(At::Drives(_) | At::Time(_) | At::Occasion(_)) => false,
        };
        here && matches!(expect.relation, Relation::Condition) && asserts_lock(mechanism, &expect.expr)
    })
}

/// Whether a condition is true only where friction locks.
fn asserts_lock(mechanism: &Mechanism, condition: &Expr) -> bool {
    match condition {
        Expr::Query(Query::Locked) => true,
        Expr::And(a, b) => asserts_lock(mechanism, a) || asserts_lock(mechanism, b),
        Expr::Quantity(id) => asserts_lock(mechanism, &mechanism.quantities[id.index()].expr),
        _ => false,
    }
}

/// What the file asks for that does not exist at a locked position.
fn without_effort(view: &PoseAnswers<'_>) -> Vec<usize> {
    let missing = |kind: &FindKind| match kind {
        FindKind::Reactions => true,
        FindKind::Table(_) => false,
        FindKind::Value { expr, poseless, .. } => !poseless && !view.value(expr).is_defined(),
    };
    let finds = view.mechanism.finds.iter().enumerate();
    finds.filter(|(_, f)| missing(&f.kind)).map(|(i, _)| i).collect()
}
