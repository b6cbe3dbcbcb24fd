//! Friction that cannot be solved.

use crate::model::{Friction, PairId};
use crate::position::Model;
use crate::solve::refusal::Refusal;

/// Friction that goes by the forces at two contacts, in pairs whose couple is not determined.
pub(super) fn open_couples(model: &Model<'_>) -> Option<Refusal> {
    let (mechanism, open) = (model.mechanism, &model.structure.undetermined_couples);
    if !model.plan.effects.friction {
        return None;
    }
    let shared = |id: &&PairId| {
        let friction = mechanism.pair(**id).friction;
        friction.is_some_and(|f| f.is_some() && matches!(f, Friction::BothEnds(_)))
    };
    let pairs: Vec<PairId> = open.iter().filter(shared).copied().collect();
    (!pairs.is_empty()).then_some(Refusal::OpenCouple(pairs))
}

/// Friction in pairs of a mechanism with transmissions.
pub(super) fn beside_laws(model: &Model<'_>) -> Option<Refusal> {
    if !model.plan.effects.friction || model.plan.laws.is_empty() {
        return None;
    }
    let pairs = model.mechanism.pairs.iter().enumerate();
    let with_friction = pairs.filter(|(_, p)| p.friction.is_some_and(|f| f.is_some()));
    Some(Refusal::FrictionBesideLaws(with_friction.map(|(i, _)| PairId::at(i)).collect()))
}
