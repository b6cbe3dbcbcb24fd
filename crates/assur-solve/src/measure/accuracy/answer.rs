//! What one position gave, with twice the digits: in this form answers are compared.

use crate::math::{Double, V2};
use crate::solve::{BodyState, Edge, Exact, Reaction, Reference, State, Wrench};

/// What answers are held against.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// The same position with twice the digits.
    DoubleDouble,
    /// `f64` with the settings that leave all its digits.
    Full,
}

/// Motion, reactions and efforts at one position.
#[derive(Clone, Debug, Default)]
pub struct Answer {
    pub bodies: Vec<BodyState<Double>>,
    pub reactions: Vec<Reaction<Double>>,
    pub efforts: Vec<Double>,
    /// The greatest force of a load on a body, N.
    pub load: f64,
}

fn wide<S: Edge>(v: V2<S>) -> V2<Double> {
    V2::new(v.x.widened(), v.y.widened())
}

pub(super) fn wide_body<S: Edge>(b: &BodyState<S>) -> BodyState<Double> {
    b.map(S::widened)
}

pub(super) fn wide_reaction<S: Edge>(r: &Reaction<S>) -> Reaction<Double> {
    Reaction { force: wide(r.force), couple: r.couple.widened() }
}

fn greatest<S: Edge>(loads: &[Wrench<S>]) -> f64 {
    loads.iter().map(|w| w.force.norm().widened().rounded()).fold(0.0, f64::max)
}

impl Answer {
    /// Of a state; nothing of one that does not close.
    #[must_use]
    pub fn of<S: Edge>(state: &State<S>) -> Self {
        if state.motion.open.is_some() {
            return Self::default();
        }
        Self {
            bodies: state.motion.bodies.iter().map(wide_body).collect(),
            reactions: state.forces.reactions.iter().map(wide_reaction).collect(),
            efforts: state.forces.efforts.iter().map(|e| e.widened()).collect(),
            load: greatest(&state.forces.applied),
        }
    }

    /// Of a position with twice the digits, of which the loads are known in `f64`.
    #[must_use]
    pub fn exact(exact: Exact, state: &State) -> Self {
        let load = greatest(&state.forces.applied);
        Self { bodies: exact.bodies, reactions: exact.reactions, efforts: exact.efforts, load }
    }

    #[must_use]
    pub fn reference(exact: Reference) -> Self {
        let load = greatest(&exact.applied);
        Self { bodies: exact.bodies, reactions: exact.reactions, efforts: exact.efforts, load }
    }
}
