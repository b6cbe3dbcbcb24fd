//! The way to a value of the one coordinate. Angles that are followed, and steps of motion that start from where bodies stand, depend
//! on what was before: the method of energy looks far ahead of where it stands, and goes there in parts in which no body turns far.

use super::equations::Equations;
use crate::math::Vec2;
use crate::position::State;
use crate::solve::failure::Halt;
use std::f64::consts::TAU;

/// No body turns by more in a part of the way, rad.
const PART: f64 = 0.5;
/// A part is so much of the way at least.
const SHORTEST: f64 = 1e-4;
/// A run goes no further by it: some 400,000 turns of a body, those that steps look at again among them.
const MOST_PARTS: usize = 5_000_000;

/// Where the way has come to.
#[derive(Clone, Debug)]
pub(super) struct Walk {
    /// The coordinate where the present step begins.
    begin: f64,
    /// That of the place, which moves at a unit rate.
    q: f64,
    state: State,
    angles: Vec<f64>,
    /// Memory for the next place.
    next: State,
    /// How many parts it has gone.
    parts: usize,
}

impl Walk {
    /// The greatest angular velocity of a body for a unit rate.
    fn fastest(state: &State) -> f64 {
        state.motion.bodies.iter().map(|body| body.omega.abs()).fold(0.0, f64::max)
    }
}

impl Equations<'_, '_> {
    /// From here on the coordinate is looked at far ahead.
    pub fn begin_walk(&mut self, q: f64) {
        let needed = self.loads_need_angles || self.conditions_need_angles || self.model.plan.goes_on();
        let (_, state, angles) = self.here();
        let angles = angles[..state.motion.bodies.len()].to_vec();
        let (mut state, next) = (state.clone(), self.trial.clone());
        state.motion.inputs.clone_from(&next.motion.inputs);
        self.walk = needed.then(|| Box::new(Walk { begin: q, q: f64::NAN, state, angles, next, parts: 0 }));
    }

    /// The present step begins here.
    pub fn walk_begins(&mut self, q: f64) {
        if let Some(walk) = &mut self.walk {
            walk.begin = q;
        }
    }

    /// Goes to a value of the coordinate.
    ///
    /// # Errors
    /// The group that does not close on the way, or a way that is too long.
    pub fn walk_to(&mut self, q: f64) -> Result<(), Halt> {
        let Some(mut walk) = self.walk.take() else { return Ok(()) };
        let found = self.walked(&mut walk, q);
        self.walk = Some(walk);
        found
    }

    fn walked(&mut self, walk: &mut Walk, q: f64) -> Result<(), Halt> {
        if walk.q.to_bits() == q.to_bits() {
            return Ok(());
        }
        if walk.q.is_nan() || (q - walk.begin).abs() < (q - walk.q).abs() {
            let (_, accepted, angles) = self.here();
            walk.state.start_from(accepted);
            walk.angles.iter_mut().zip(angles).for_each(|(angle, accepted)| *angle = *accepted);
            walk.next.start_from(accepted);
            walk.q = walk.begin;
            self.stand(&mut walk.next, walk.begin)?;
            std::mem::swap(&mut walk.state, &mut walk.next);
        }
        let whole = q - walk.q;
        let mut part = PART / Walk::fastest(&walk.state);
        while walk.q.to_bits() != q.to_bits() {
            walk.parts += 1;
            if walk.parts > MOST_PARTS {
                return Err(Halt::TooManySteps { steps: walk.parts, rate: 0.0 });
            }
            let left = q - walk.q;
            let to = if left.abs() <= part { q } else { walk.q + part.copysign(left) };
            walk.next.start_from(&walk.state);
            let closes = self.stand(&mut walk.next, to);
            let fastest = Walk::fastest(&walk.next);
            let far = (to - walk.q).abs() * fastest > 2.0 * PART;
            let shorter = 0.5 * (to - walk.q).abs();
            let is_last = shorter < SHORTEST * whole.abs();
            if closes.is_err() && is_last {
                walk.q = f64::NAN;
                return closes;
            }
            if closes.is_err() || (far && !is_last) {
                part = shorter;
                continue;
            }
            for (angle, body) in walk.angles.iter_mut().zip(&walk.next.motion.bodies) {
                *angle = continued(*angle, body.u);
            }
            std::mem::swap(&mut walk.state, &mut walk.next);
            (walk.q, part) = (to, PART / fastest);
        }
        Ok(())
    }

    /// Moves the bodies of a state at a unit rate of the coordinate.
    fn stand(&mut self, state: &mut State, q: f64) -> Result<(), Halt> {
        let input = &mut state.motion.inputs[self.reduced.free()[0]];
        (input.value, input.place) = (q, Vec2::direction(q));
        (input.rate, input.acceleration) = (1.0, 0.0);
        state.motion.laws.clone_from(&self.trial.motion.laws);
        if let Some(bridge) = &mut self.bridge {
            if bridge.covers(q) {
                bridge.put(q, &mut state.motion);
                return Ok(());
            }
            state.branches.copy_from_slice(bridge.branches(q));
        }
        state.run_motion::<1>(self.model.plan);
        state.motion.open.map_or(Ok(()), |group| Err(Halt::Open { group }))
    }

    /// Starts the trial from where the way has come to, or from where the present step begins.
    pub fn start_trial(&mut self) {
        if self.goes_on {
            self.trial.start_from(self.walk.as_ref().map_or(&self.accepted.1, |walk| &walk.state));
        }
    }

    /// The angles of the bodies of the trial, where they were followed along the way.
    pub fn angles_of_walk(&mut self) -> bool {
        let Some(walk) = &self.walk else { return false };
        for ((angle, walked), body) in self.angles.iter_mut().zip(&walk.angles).zip(&self.trial.motion.bodies)
        {
            *angle = continued(*walked, body.u);
        }
        true
    }
}

/// The angle of a direction that is nearest to another angle.
fn continued(before: f64, u: Vec2) -> f64 {
    let principal = u.angle();
    principal + TAU * ((before - principal) / TAU).round()
}
