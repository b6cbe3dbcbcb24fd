//! One free coordinate with friction, losses or brakes: its acceleration from the effort that vanishes, and rest.
//!
//! Reactions depend on the acceleration and friction on reactions, so that the equation is effort(q̈) = 0, solved by the
//! method of secants from the acceleration without friction. The effort is a broken line in q̈; where it does not rise with q̈
//! no acceleration is the answer, or several are (Painlevé), and the run ends.

use super::dissipative::DissipativeElement;
use super::drives::moves;
use super::equations::Equations;
use super::loads::all_parts;
use super::sliding_sense::Mode;
use crate::answer::PoseAnswers;
use crate::math::Vec2;
use crate::model::{Expr, Query};
use crate::plan::FrictionLaw;
use crate::position::{Against, ContactMode, STILL, State};
use crate::solve::failure::Halt;
use crate::structure::EffortSource;

/// Steps of the method of secants at most; where nothing breaks two suffice.
const MOST: usize = 40;
/// What is left of the effort, relative to the loads.
const ENOUGH: f64 = 1e-13;
/// A rate that is nothing where nothing else moves, but has a sense.
const LEAST_RATE: f64 = 1e-100;
/// The same relative to the rates of drives: more than the part that counts as rest.
const LEAST_PART: f64 = 1e3 * STILL;

/// A sliding acceleration below this part of the greatest is rounding.
const NEVER: f64 = 1e-9;

/// Whether what acts on a mechanism depends on the sense of its motion.
pub(super) fn rubs(equations: &Equations<'_, '_>) -> bool {
    equations.model.plan.effects.loses() || equations.acting().any(|(_, load, _)| load.is_against_motion())
}

/// Whether something changes while the coordinate rests: a drive moves, or a load depends on the instant.
pub(super) fn wakes(equations: &Equations<'_, '_>) -> bool {
    let mechanism = equations.model.mechanism;
    let mut timed = false;
    all_parts(mechanism, equations.acting().flat_map(|(_, _, exprs)| exprs), |part| {
        timed |= matches!(part, Expr::Query(Query::Time));
    });
    timed || mechanism.drives.iter().any(|d| !d.free && (d.speed.is_some() || d.acceleration.is_some()))
}

impl Equations<'_, '_> {
    /// Chooses how the coordinate goes on from here: as it moves, or, at rest, in the sense in which it accelerates.
    ///
    /// # Errors
    /// There is no acceleration, or one in either sense.
    pub fn choose_mode(&mut self, t: f64, y: &[f64]) -> Result<(), Halt> {
        if self.mode.is_none() {
            return Ok(());
        }
        if y[1] != 0.0 {
            self.mode = Some(Mode::Moving(y[1].signum()));
            return Ok(());
        }
        let forward = self.acceleration_from_rest(t, y, 1.0)?;
        let back = self.acceleration_from_rest(t, y, -1.0)?;
        self.mode = Some(match (forward > 0.0, back < 0.0) {
            (true, false) => Mode::Moving(1.0),
            (false, true) => Mode::Moving(-1.0),
            (false, false) => Mode::Resting,
            (true, true) => return Err(Halt::Jam),
        });
        Ok(())
    }

    /// The rates of the unknowns at the position that is set.
    pub fn rubbing_rates(&mut self, mode: Mode, y: &[f64], dy: &mut [f64]) -> Result<(), Halt> {
        let Mode::Moving(sense) = mode else {
            dy.fill(0.0);
            self.accelerate(0.0);
            self.act_against(|_, _| Vec2::zero());
            return self.trial.motion.open.map_or(Ok(()), |group| Err(Halt::Open { group }));
        };
        let held = if self.held { &self.senses[..] } else { &[] };
        self.trial.motion.grips.clear();
        self.trial
            .motion
            .grips
            .extend(held.iter().map(|&sense| ContactMode { sense, ..ContactMode::default() }));
        let acceleration = self.rubbing_acceleration(sense)?;
        if self.model.plan.effects.loses() {
            let term = self.reduced.greatest_power(0, self.model.plan, &self.trial) / self.reduced.mass()[0];
            self.terms = (self.terms.0.max(term), self.terms.1.max(acceleration.abs()));
        }
        // stages beyond a rest go on smoothly
        let rate = self.trial.motion.inputs[self.reduced.free()[0]].rate;
        let power = self.trial.power_of_loads(self.model, &self.evaluated)
            + self.power_of_friction()
            + self.trial.power_of_losses(self.model.plan);
        let work = power / rate * y[1];
        dy[..3].copy_from_slice(&[y[1], acceleration, work]);
        self.powers(&mut dy[3..], y[1] / rate);
        Ok(())
    }

    /// Lets the loads against the motion act with these parts of their values.
    pub fn act_against(&mut self, part: impl Fn(&PoseAnswers<'_>, usize) -> Vec2) {
        let mut against = std::mem::take(&mut self.trial.motion.against);
        against.clear();
        if self.is_braked() {
            let (view, count) = (self.view(), self.model.mechanism.loads.len());
            against.extend((0..count).map(|load| Against { part: part(&view, load), ..Against::default() }));
        }
        self.trial.motion.against = against;
    }

    /// Puts the rates as they are in place of those that only have the sense of the motion, and leaves the forces.
    pub fn take_rates(&mut self, y: &[f64]) {
        if self.mode.is_some() {
            if self.mode != Some(Mode::Resting) {
                self.act_against(|view, load| view.against_velocity(load));
            }
            let drive = self.reduced.free()[0];
            self.trial.motion.inputs[drive].rate = y[1];
            self.trial.run_motion::<2>(self.model.plan);
        }
    }

    /// How far the coordinate is from leaving its rest: positive where it does.
    pub fn leaving(&mut self, t: f64, y: &[f64]) -> f64 {
        let ways = [1.0, -1.0].map(|sense| self.acceleration_from_rest(t, y, sense).map(|a| a * sense));
        match ways {
            [Ok(forward), Ok(back)] => forward.max(back),
            _ => f64::NAN,
        }
    }

    /// A rest ends: the coordinate moves in the sense in which it is pulled most.
    pub fn leave(&mut self, t: f64, y: &[f64]) -> Result<(), Halt> {
        let forward = self.acceleration_from_rest(t, y, 1.0)?;
        let back = -self.acceleration_from_rest(t, y, -1.0)?;
        self.mode = Some(Mode::Moving(if forward >= back { 1.0 } else { -1.0 }));
        Ok(())
    }

    /// The acceleration with which it would begin to move in a sense; nothing where friction holds it.
    pub fn acceleration_from_rest(&mut self, t: f64, y: &[f64], sense: f64) -> Result<f64, Halt> {
        let kept = self.mode.replace(Mode::Moving(sense));
        let moving = self.model;
        self.model = self.still.unwrap_or(moving);
        let rest = [y[0], 0.0];
        self.trial.motion.grips.clear();
        self.set_position(t, &rest);
        let found = self.rubbing_acceleration(sense);
        self.mode = kept;
        self.model = moving;
        if self.is_blocked(sense) {
            return Ok(0.0);
        }
        match found {
            // friction that locks holds it
            Err(Halt::Jam) => Ok(0.0),
            other => other,
        }
    }

    /// The acceleration at the position and rate that are set, moving in a sense. Leaves the motion and the forces that go
    /// with it.
    pub fn rubbing_acceleration(&mut self, sense: f64) -> Result<f64, Halt> {
        let drive = self.reduced.free()[0];
        let rate = self.trial.motion.inputs[drive].rate;
        let others = self.trial.motion.inputs.iter().enumerate().filter(|(i, _)| *i != drive);
        let fastest =
            others.map(|(_, input)| input.rate.abs().max(input.velocity.norm())).fold(0.0, f64::max);
        let least = LEAST_RATE.max(LEAST_PART * fastest);
        self.trial.motion.inputs[drive].rate = sense * (sense * rate).max(least);
        let mut start = [0.0];
        self.accelerations_without_friction(&mut start)?;
        if !self.model.plan.effects.loses() {
            self.accelerate(start[0]);
            return Ok(start[0]);
        }
        self.vanishing_effort(start[0])
    }

    /// The acceleration at which the effort vanishes, from the one without friction.
    fn vanishing_effort(&mut self, start: f64) -> Result<f64, Halt> {
        let mass = self.reduced.mass()[0];
        let (mut a, mut effort) = (start, self.effort(start)?);
        let mut slope = mass;
        for _ in 0..MOST {
            // what the friction adds is of the order of the loads
            let greatest = self.reduced.greatest_power(0, self.model.plan, &self.trial) + mass * a.abs();
            if effort.abs() <= ENOUGH * greatest {
                return Ok(a);
            }
            let next = a - effort / slope;
            if !next.is_finite() {
                return Err(Halt::NotANumber);
            }
            if next == a {
                return Ok(a);
            }
            let then = self.effort(next)?;
            slope = (then - effort) / (next - a);
            (a, effort) = (next, then);
            if slope.is_nan() || slope <= STILL * mass {
                return Err(Halt::Jam);
            }
        }
        Err(Halt::Jam)
    }

    fn accelerate(&mut self, acceleration: f64) {
        let drive = self.reduced.free()[0];
        self.trial.motion.inputs[drive].acceleration = acceleration;
        self.trial.run_motion::<2>(self.model.plan);
    }

    /// The effort that the coordinate would need for an acceleration.
    pub fn effort(&mut self, acceleration: f64) -> Result<f64, Halt> {
        self.accelerate(acceleration);
        self.trial.run_loads_and_forces(self.model, &self.evaluated);
        if self.trial.forces.locked {
            return Err(Halt::Jam);
        }
        let drive = self.reduced.free()[0];
        let mut efforts = self.model.structure.efforts.iter();
        let own = efforts.position(|e| matches!(e.source, EffortSource::Drive(id) if id.index() == drive));
        let effort = own.map(|slot| self.trial.forces.efforts[slot] * self.along_line(slot, 0));
        effort.filter(|e| e.is_finite()).ok_or(Halt::NotANumber)
    }

    /// What friction in the pairs takes, W: not positive but beyond the end of a step.
    pub fn power_of_friction(&self) -> f64 {
        let state: &State = &self.trial;
        let elements = self.model.plan.friction.iter().zip(&state.forces.frictions);
        elements.map(|(element, effort)| effort * state.sliding_speed(element)).sum::<f64>()
    }

    /// The sense in which each pair that rubs slides, where everything was evaluated; that in which it begins to where it does
    /// not.
    pub fn take_senses(&mut self) {
        self.senses.clear();
        self.sides.clear();
        if !matches!(self.mode, Some(Mode::Moving(_))) {
            return;
        }
        let extent = self.extent();
        let bodies = self.trial.motion.bodies.iter();
        let turns = bodies.map(|b| b.a.norm() / extent + b.alpha.abs() + b.omega * b.omega);
        let most = turns.fold(0.0, f64::max);
        for (element, sense) in self.model.plan.friction.iter().zip(&self.trial.forces.senses) {
            let begins = self.trial.sliding_acceleration(element);
            let unit = if matches!(element.kind, FrictionLaw::Circle { .. }) { 1.0 } else { extent };
            // what neither slides nor begins to does not rub
            let none = begins.abs() <= NEVER * unit * most;
            self.senses.push(if *sense != 0.0 || none { *sense } else { begins.signum() });
            let Vec2 { x, y } = self.trial.measured(self.model.plan, element);
            self.sides.push([x.signum(), y.signum()]);
        }
    }

    /// What presses in a guide, on the side where the present step begins: magnitudes of forces have corners.
    pub fn pressing_room(&self, element: usize, end: usize) -> f64 {
        let own = &self.model.plan.friction[element];
        let of = |side: &[f64; 2]| {
            let Vec2 { x, y } = self.trial.measured(self.model.plan, own);
            [side[0] * x, side[1] * y][end]
        };
        let guides = matches!(own.kind, FrictionLaw::BothEnds { .. })
            || (end == 0 && matches!(own.kind, FrictionLaw::Guide { .. }));
        self.sides.get(element).filter(|_| guides).map_or(1.0, of)
    }

    /// The sliding speed of a pair for a unit rate of the coordinate, in its sense where the present step begins.
    pub fn sliding_room(&mut self, element: usize) -> f64 {
        let Some(Mode::Moving(sense)) = self.mode else { return 1.0 };
        let own = &self.model.plan.friction[element];
        sense * self.senses[element] * self.reduced.at_unit_rate(0, &mut self.trial, |s| s.sliding_speed(own))
    }

    /// Whether a load acts against the motion.
    pub fn is_braked(&self) -> bool {
        self.acting().any(|(_, load, _)| load.is_against_motion())
    }

    /// Whether drives alone can move nothing against each other that rubs: then all of it rests with the free coordinate.
    pub fn rests_together(&mut self, t: f64, y: &[f64]) -> bool {
        let speeds = |equations: &mut Self| {
            equations.trial.run_motion::<1>(equations.model.plan);
            let all = DissipativeElement::all(equations.model.plan);
            all.map(|rubs| rubs.speed(&equations.trial).abs()).fold(0.0, f64::max)
        };
        self.set_position(t, &[y[0], 1.0]);
        let moving = speeds(self);
        self.set_position(t, &[y[0], 0.0]);
        for (input, drive) in self.trial.motion.inputs.iter_mut().zip(&self.model.mechanism.drives) {
            if !drive.free && (drive.of_time || moves(input)) {
                (input.rate, input.velocity) = (1.0, Vec2::new(1.0, 1.0));
            }
        }
        speeds(self) <= STILL * moving
    }
}
