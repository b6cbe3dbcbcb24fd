//! The block that stands for the pin of a Geneva wheel. Whether the pin is in a slot, and in which, is taken over from the state.

use super::unit;
use crate::math::{Double, V2};
use crate::plan::GenevaStep;
use crate::position::{BodyState, State};

type D = Double;

/// Places the block that stands for the pin.
pub(super) fn place_block(step: &GenevaStep, state: &State, bodies: &mut [BodyState<D>]) {
    let pair = &step.pair;
    let (crank, wheel) = (bodies[pair.crank.index()], bodies[pair.wheel.index()]);
    let slot: Option<V2<D>> = step.slot(&state.motion);
    let (p, u) = match slot {
        Some(slot) => (crank.position(pair.pin), slot.turned(wheel.u)),
        None => {
            let frame = bodies[pair.frame.index()];
            (crank.position(pair.crank_centre), -unit(pair.towards).turned(frame.u))
        }
    };
    let r = p - crank.p;
    bodies[step.block] = BodyState {
        p,
        u,
        v: crank.v + r.perp() * crank.omega,
        omega: wheel.omega,
        a: crank.a + r.perp() * crank.alpha - r * (crank.omega * crank.omega),
        alpha: wheel.alpha,
        ..BodyState::rest()
    };
}
