//! A position with twice the digits, put into one of `f64`.

use super::precise::precise;
use super::solution::Scene;
use super::state::{BodyState, Reaction, State};
use crate::math::{Double, V2};
use crate::model::{LoadId, Value};

/// One position with twice the digits.
#[derive(Clone, Debug)]
pub struct Exact {
    /// Bodies by slot.
    pub bodies: Vec<BodyState<Double>>,
    /// Reactions by slot.
    pub reactions: Vec<Reaction<Double>>,
    /// Efforts by slot.
    pub efforts: Vec<Double>,
}

/// The position in which a solved state stands, with twice the digits; `None` where there is no such way to solve its plan.
/// # Given
/// `evaluated` values of the loads that are expressions.
#[must_use]
pub fn exact(scene: &Scene<'_>, state: &State, evaluated: &[(LoadId, Value)]) -> Option<Exact> {
    if !evaluated.is_empty() {
        return None;
    }
    let exact = precise(scene.plan, state).filter(|exact| exact.open.is_none())?;
    Some(Exact { bodies: exact.bodies, reactions: exact.reactions, efforts: exact.efforts })
}

/// Whether there is a way to solve a plan with twice the digits.
#[must_use]
pub fn has_exact(scene: &Scene<'_>) -> bool {
    scene.plan.laned()
}

impl Exact {
    /// Puts the motion, rounded, into a state.
    pub(super) fn round_motion(&self, state: &mut State) {
        for (out, b) in state.bodies.iter_mut().zip(&self.bodies) {
            *out = BodyState {
                p: rounded(b.p),
                u: rounded(b.u),
                v: rounded(b.v),
                omega: b.omega.rounded(),
                a: rounded(b.a),
                alpha: b.alpha.rounded(),
                way: out.way,
            };
        }
    }

    /// The same of reactions and efforts.
    pub(super) fn round_forces(&self, state: &mut State) {
        for (out, r) in state.reactions.iter_mut().zip(&self.reactions) {
            *out = Reaction { force: rounded(r.force), couple: r.couple.rounded() };
        }
        for (out, e) in state.efforts.iter_mut().zip(&self.efforts) {
            *out = e.rounded();
        }
    }
}

fn rounded(v: V2<Double>) -> V2<f64> {
    V2::new(v.x.rounded(), v.y.rounded())
}
