//! Friction that cannot be solved.

use super::open_places::unplaced_reactions;
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

/// Friction in pairs whose reactions depend on forces of transmissions without a place.
pub(super) fn without_place(model: &Model<'_>) -> Option<Refusal> {
    if !model.plan.effects.friction || model.plan.laws.is_empty() {
        return None;
    }
    let unknown = unplaced_reactions(model);
    let pairs = model.mechanism.pairs.iter().enumerate();
    let rubbing = pairs.filter(|(i, p)| unknown[*i] && p.friction.is_some_and(|f| f.is_some()));
    let pairs: Vec<PairId> = rubbing.map(|(i, _)| PairId::at(i)).collect();
    (!pairs.is_empty()).then_some(Refusal::FrictionWithoutPlace(pairs))
}
