//! What rubs in a motion, by number: the elements of friction in the pairs, then the transmissions that
//! lose power, then the loads against the motion.

use crate::math::Vec2;
use crate::model::{PairId, ProfileShape};
use crate::plan::{FrictionElement, FrictionLaw, LawSite, Opposing, Path, Plan, PlannedLaw};
use crate::position::State;
use crate::solve::simulate::report::Holder;

const fn component(v: Vec2, axis: usize) -> f64 {
    if axis == 0 { v.x } else { v.y }
}

#[derive(Clone, Copy)]
pub(super) enum DissipativeElement<'p> {
    Pair(&'p FrictionElement),
    Law(&'p PlannedLaw, usize),
    Load(&'p Opposing),
}

impl<'p> DissipativeElement<'p> {
    pub fn of(plan: &'p Plan, index: usize) -> Self {
        let inner = Self::inner(plan);
        match plan.friction.get(index) {
            Some(element) => Self::Pair(element),
            None if index >= inner => Self::Load(&plan.opposing[index - inner]),
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
        Self::inner(plan) + plan.opposing.len()
    }

    /// How many of them rub within the mechanism: the loads follow.
    pub const fn inner(plan: &Plan) -> usize {
        plan.friction.len() + plan.losing.len()
    }

    /// Its speed: of a transmission that of its first side from the carrier.
    pub fn speed(self, state: &State) -> f64 {
        match self {
            Self::Pair(element) => state.sliding_speed(element),
            Self::Law(law, _) => state.law_speed(law),
            Self::Load(Opposing { body, against, point, .. }) => {
                let bodies = &state.motion.bodies;
                let (body, other) = (&bodies[*body], against.map_or(0.0, |(other, _)| bodies[other].omega));
                match *point {
                    None => body.omega - other,
                    Some((at, Path::Line(along))) => body.velocity(at).dot(along.turned(body.u)),
                    Some((at, Path::Curve(drive))) => {
                        body.velocity(at).norm().copysign(state.motion.inputs[drive].rate)
                    }
                    Some((at, Path::Plane(_))) => body.velocity(at).norm(),
                }
            }
        }
    }

    /// Its speed along the row by which an effort holds it: that of a point in the plane has a sign.
    pub fn row_speed(self, state: &State) -> f64 {
        match self {
            Self::Load(Opposing { point: Some((_, Path::Plane(_))), .. }) => self.unit_speed(state),
            other => other.speed(state),
        }
    }

    /// Its speed where one free coordinate has the rate 1.
    pub fn unit_speed(self, state: &State) -> f64 {
        match self {
            Self::Load(Opposing { body, point: Some((at, Path::Curve(_))), .. }) => {
                state.motion.bodies[*body].velocity(*at).norm()
            }
            Self::Load(Opposing { body, point: Some((at, Path::Plane(axis))), .. }) => {
                component(state.motion.bodies[*body].velocity(*at), *axis)
            }
            other => other.speed(state),
        }
    }

    /// Its acceleration where it does not move.
    pub fn acceleration(self, state: &State) -> f64 {
        match self {
            Self::Pair(element) => state.sliding_acceleration(element),
            Self::Law(law, _) => state.law_acceleration(law),
            Self::Load(Opposing { body, against, point, .. }) => {
                let bodies = &state.motion.bodies;
                let (body, other) = (&bodies[*body], against.map_or(0.0, |(other, _)| bodies[other].alpha));
                match *point {
                    None => body.alpha - other,
                    Some((at, Path::Line(along))) => body.acceleration(at).dot(along.turned(body.u)),
                    Some((at, Path::Curve(drive))) => {
                        body.acceleration(at).norm().copysign(state.motion.inputs[drive].acceleration)
                    }
                    Some((at, Path::Plane(axis))) => component(body.acceleration(at), axis),
                }
            }
        }
    }

    /// Whether its speed is an angular one.
    pub fn turns(self) -> bool {
        match self {
            Self::Pair(element) => element.kind.turns(),
            Self::Law(law, _) => matches!(law.terms[0].0, LawSite::Turn(_)),
            Self::Load(load) => load.point.is_none(),
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

    /// What may hold: the pair or the transmission, or the load. A contact whose rolling alone is held may slide.
    pub fn holder(self) -> Option<Holder> {
        match self {
            Self::Pair(FrictionElement { kind: FrictionLaw::Rolling { .. }, .. }) => None,
            Self::Load(load) => Some(self.pair().map_or(Holder::Load(load.load), Holder::Pair)),
            Self::Pair(FrictionElement { pair, .. }) | Self::Law(PlannedLaw { pair, .. }, _) => {
                Some(Holder::Pair(*pair))
            }
        }
    }

    /// The pair, or the transmission.
    pub fn pair(self) -> Option<PairId> {
        match self {
            Self::Pair(element) => Some(element.pair),
            Self::Law(law, _) => Some(law.pair),
            Self::Load(load) => load.against.map(|(_, clutch)| clutch),
        }
    }
}
