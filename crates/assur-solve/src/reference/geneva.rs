//! A Geneva wheel: its pin on the line of a slot, or its angle at rest. Whether the pin is in a slot, and in which, is taken
//! over from the state.

use super::constraint::{Constraint, GuideRow};
use super::jet::{Jet, Moving, unit};
use crate::math::{Angular, Double, Scalar, V2};
use crate::plan::GenevaStep;
use crate::position::{BodyState, State};

type D = Double;

/// The direction at a number of halves of the angle between two slots.
fn halves(step: &GenevaStep, count: f64) -> V2<D> {
    let angle = D::pi() * D::of(count) / D::of(f64::from(step.pair.law.slots));
    let (sine, cosine) = angle.sine_cosine();
    V2::new(cosine, sine)
}

/// From the named slot to the one the pin is in, in halves of the angle between two slots.
fn to_slot(step: &GenevaStep, state: &State) -> f64 {
    let pair = &step.pair;
    let wheel = &state.motion.bodies[pair.wheel.index()];
    let pin = state.motion.bodies[pair.crank.index()].position(pair.pin) - wheel.position(pair.hub);
    let pitch = pair.law.pitch();
    2.0 * (pin.turned_back(pair.slot.turned(wheel.u)).angle() / pitch).round()
}

/// What the pin, or the arc, demands of the wheel.
pub(super) fn constraint<'a>(step: &GenevaStep, state: &State) -> Constraint<'a> {
    let pair = &step.pair;
    if state.is_in_slot(step) {
        let slot = halves(step, to_slot(step, state)).turned(unit(pair.slot));
        let row = GuideRow {
            slider: pair.crank.index(),
            point: pair.pin,
            guide: pair.wheel.index(),
            through: pair.hub,
            direction: slot.perp(),
        };
        return Constraint::Along(row, Jet::constant(D::zero()));
    }
    let frame = &state.motion.bodies[pair.frame.index()];
    let wheel = &state.motion.bodies[pair.wheel.index()];
    let back = -pair.towards.turned(frame.u);
    let turned = pair.slot.turned(wheel.u).turned_back(back).angle();
    let by = Moving::turning(halves(step, (2.0 * turned / pair.law.pitch()).round()), D::zero(), D::zero());
    Constraint::Turned {
        a: (pair.frame.index(), -unit(pair.towards)),
        b: (pair.wheel.index(), unit(pair.slot)),
        by,
    }
}

/// Places the block that stands for the pin.
pub(super) fn place_block(step: &GenevaStep, state: &State, bodies: &mut [BodyState<D>]) {
    let pair = &step.pair;
    let (crank, wheel) = (bodies[pair.crank.index()], bodies[pair.wheel.index()]);
    let (p, u) = if state.is_in_slot(step) {
        let slot = halves(step, to_slot(step, state)).turned(unit(pair.slot));
        (crank.position(pair.pin), slot.turned(wheel.u))
    } else {
        let frame = bodies[pair.frame.index()];
        (crank.position(pair.crank_centre), -unit(pair.towards).turned(frame.u))
    };
    let r = p - crank.p;
    bodies[step.block] = BodyState {
        p,
        u,
        v: crank.v + r.perp() * crank.omega,
        omega: wheel.omega,
        a: crank.a + r.perp() * crank.alpha - r * (crank.omega * crank.omega),
        alpha: wheel.alpha,
        turned: D::zero(),
    };
}
