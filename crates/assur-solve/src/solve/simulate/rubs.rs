//! What rubs in a motion of several free coordinates, by number: the elements of friction in the pairs, then the transmissions that
//! lose power.

use crate::model::{PairId, ProfileShape};
use crate::plan::{FrictionElement, FrictionLaw, LawSite, Plan, PlannedLaw};
use crate::position::State;

#[derive(Clone, Copy)]
pub(super) enum Rubs<'p> {
    Pair(&'p FrictionElement),
    Law(&'p PlannedLaw, usize),
}

impl<'p> Rubs<'p> {
    pub fn of(plan: &'p Plan, index: usize) -> Self {
        match plan.friction.get(index) {
            Some(element) => Self::Pair(element),
            None => {
                let slot = plan.losing[index - plan.friction.len()];
                Self::Law(&plan.laws[slot], slot)
            }
        }
    }

    /// All of them, in order.
    pub fn all(plan: &'p Plan) -> impl Iterator<Item = Self> {
        (0..Self::count(plan)).map(|index| Self::of(plan, index))
    }

    /// How many there are.
    pub const fn count(plan: &Plan) -> usize {
        plan.friction.len() + plan.losing.len()
    }

    /// Its speed: of a transmission that of its first side from the carrier.
    pub fn speed(self, state: &State) -> f64 {
        match self {
            Self::Pair(element) => state.sliding_speed(element),
            Self::Law(law, _) => state.law_speed(law),
        }
    }

    /// Its acceleration where it does not move.
    pub fn acceleration(self, state: &State) -> f64 {
        match self {
            Self::Pair(element) => state.sliding_acceleration(element),
            Self::Law(law, _) => state.law_acceleration(law),
        }
    }

    /// Whether its speed is an angular one.
    pub fn turns(self) -> bool {
        match self {
            Self::Pair(element) => matches!(element.kind, FrictionLaw::Circle { .. }),
            Self::Law(law, _) => matches!(law.terms[0].0, LawSite::Turn(_)),
        }
    }

    /// Whether it may be held: how the contact of a cam that rolls accelerates is not followed.
    pub fn can_hold(self) -> bool {
        let is_cam = |shape| matches!(shape, ProfileShape::Rim(_));
        match self {
            Self::Pair(FrictionElement { kind: FrictionLaw::Contact { first, second, .. }, .. }) => {
                !is_cam(*first) && !is_cam(*second)
            }
            _ => true,
        }
    }

    /// The pair, or the transmission.
    pub const fn pair(self) -> PairId {
        match self {
            Self::Pair(element) => element.pair,
            Self::Law(law, _) => law.pair,
        }
    }
}
