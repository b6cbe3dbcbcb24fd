//! Corners of the loads: conditions that change, points of curves, places where `max`, `min` and `abs` change over.
//!
//! A step takes every load on the side of its corners where it begins, so that what is integrated is smooth; where such a side
//! ends the step ends, and the next one begins on the other side.

use super::equations::Equations;
use super::lookout::Lookout;
use super::records::within_step;
use crate::answer::{OF_MOTION, PoseAnswers, Switch};
use crate::math::Vec2;
use crate::math::ode::event::first_crossing;
use crate::math::ode::{Integrator, Undefined};
use crate::plan::FrictionLaw;

/// Where all are looked at first, parts of the step.
const PLACES: [f64; 5] = [0.2, 0.4, 0.6, 0.8, 1.0];
/// A number that stays above this part of its variation in the step is smooth enough not to pass zero between the places.
const CLEAR: f64 = 0.5;
/// What turns so often at one instant is left as it is: it would hold its load at the corner.
const MOST: u32 = 3;
/// Numbers of a switch: a piece of a curve has two ends.
const ENDS: usize = 2;
/// Shortly after an instant: this part of the run.
const SHORTLY: f64 = 1e-6;
/// The slope of a number is taken over this part of the step.
const SLOPE: f64 = 1e-3;
/// Rounding of an instant.
const ROUNDING: f64 = 1e-15;
/// What presses by less than this part of the greatest force is at its corner.
const NOTHING: f64 = 1e-9;

/// The corners of a run.
pub(super) struct Corners {
    y: Vec<f64>,
    /// The least and the greatest value of each number in a step.
    ranges: Vec<(f64, f64)>,
    /// Which of them are far from the ends of their sides.
    lookouts: Vec<Lookout>,
    /// Where each ends in the last step, s; infinite where it does not.
    crossings: Vec<f64>,
    /// Where the present step ends by one, s; infinite where none does.
    ends: f64,
    /// How often each has turned at the last instant of its turning, s.
    turned: Vec<(f64, u32)>,
    /// What happens at one instant, s.
    at_once: f64,
}

impl Corners {
    pub fn new(equations: &Equations<'_, '_>, at_once: f64) -> Self {
        let count = ENDS * (equations.switches.len() + equations.pressing()) + equations.seams();
        Self {
            y: equations.start(),
            ranges: vec![(0.0, 0.0); count],
            lookouts: vec![Lookout::NEW; count],
            crossings: vec![f64::INFINITY; count],
            ends: f64::INFINITY,
            turned: vec![(f64::NAN, 0); count],
            at_once,
        }
    }

    /// Ends the last step where the first side ends.
    ///
    /// # Errors
    /// A stage has no value.
    pub fn shorten<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
    ) -> Result<(), Undefined> {
        self.ends = f64::INFINITY;
        if !equations.held {
            return Ok(());
        }
        let step = (method.previous_t(), method.t());
        // those of cams are far in most steps
        if self.ranges.len() == equations.seams() && !equations.may_pass_seams() {
            return Ok(());
        }
        let far = |(index, lookout): (usize, &mut Lookout)| {
            lookout.is_far(equations, method, |equations, t, y| {
                if equations.observe_again(t, y, false) { equations.room(index) } else { f64::NAN }
            })
        };
        if self.lookouts.iter_mut().enumerate().all(far) {
            return Ok(());
        }
        self.take_ranges(equations, method, step);
        self.crossings.fill(f64::INFINITY);
        let mut first = None;
        for index in 0..self.ranges.len() {
            let (least, greatest) = self.ranges[index];
            if least > CLEAR * (greatest - least)
                || greatest.max(-least) <= self.nothing(equations, method, index)
            {
                continue;
            }
            let crossing = first_crossing(step, Some(true), |t| self.room(equations, method, index, t));
            // where a value has none nothing is known
            if let Some(crossing) = crossing.filter(|crossing| crossing.t.is_finite()) {
                self.crossings[index] = crossing.t;
                if first.is_none_or(|(earliest, _)| crossing.t < earliest) {
                    first = Some((crossing.t, index));
                }
            }
        }
        let Some((t, index)) = first else { return Ok(()) };
        self.ends = t;
        if t >= step.1 {
            return Ok(());
        }
        let before = t - SLOPE * (t - step.0);
        let slope = (self.room(equations, method, index, t) - self.room(equations, method, index, before))
            / (t - before);
        method.shorten(equations, t)?;
        // the output between the ends is less accurate than the ends
        let late = self.room(equations, method, index, t) / slope;
        let exact = t - late;
        if late.abs() > ROUNDING * t.abs() && late.abs() < t - before && exact < step.1 {
            method.shorten(equations, exact)?;
            (self.ends, self.crossings[index]) = (exact, exact);
        }
        Ok(())
    }

    /// The state where a side has ended.
    pub fn state(&self) -> &[f64] {
        &self.y
    }

    /// The ranges of all numbers within the last step.
    fn take_ranges<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        (from, to): (f64, f64),
    ) {
        self.ranges.fill((f64::INFINITY, f64::NEG_INFINITY));
        for part in PLACES {
            let t = if part < 1.0 { from + part * (to - from) } else { to };
            let known =
                within_step(equations, method, t, &mut self.y) && equations.observe(t, &self.y, false);
            for (index, range) in self.ranges.iter_mut().enumerate() {
                let room = if known { equations.room(index) } else { f64::NEG_INFINITY };
                self.lookouts[index].note(part, room);
                *range = (range.0.min(room), range.1.max(room));
            }
        }
    }

    fn room<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        index: usize,
        t: f64,
    ) -> f64 {
        let known = within_step(equations, method, t, &mut self.y) && equations.observe(t, &self.y, false);
        if known { equations.room(index) } else { f64::NAN }
    }

    /// What is zero but for rounding of a number of a switch, or of what presses.
    fn nothing<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        index: usize,
    ) -> f64 {
        let switches = ENDS * equations.switches.len();
        if (switches..switches + equations.seams()).contains(&index) {
            return f64::NEG_INFINITY;
        }
        self.room(equations, method, index, method.t());
        if index >= switches {
            return NOTHING * equations.greatest_force();
        }
        equations.look_at_sizes();
        let size = equations.seen().room_size(&equations.switches[index / ENDS]);
        equations.rounding_of(size, OF_MOTION)
    }

    /// The step has ended, where sides end or before it: goes over to the other sides, and whether it does.
    ///
    /// All that end at one instant turn together: between them the loads would be those of no side.
    pub fn turn<M: Integrator<f64>>(&mut self, equations: &mut Equations<'_, '_>, method: &M) -> bool {
        let t = method.t();
        if t + self.at_once < self.ends {
            return false;
        }
        self.y.copy_from_slice(method.y());
        if !equations.observe(t, &self.y, false) {
            return false;
        }
        let mut of_last = None;
        for index in 0..self.crossings.len() {
            // of the two ends of a piece one turns
            let switch = (index < ENDS * equations.switches.len()).then_some(index / ENDS);
            if self.crossings[index] > self.ends + self.at_once || switch.is_some() && switch == of_last {
                continue;
            }
            of_last = switch;
            let (last, count) = &mut self.turned[index];
            *count = if (t - *last).abs() <= self.at_once { *count + 1 } else { 1 };
            *last = t;
            equations.turn(index, *count > MOST);
        }
        self.ends = f64::INFINITY;
        true
    }
}

impl<'a> Equations<'a, '_> {
    /// Takes all loads on the sides where they are in a state; those that have a side keep it.
    pub fn take_sides(&mut self, t: f64, y: &[f64]) {
        let kept = std::mem::replace(&mut self.held, false);
        self.release_seams();
        let smooth = self.switches.is_empty() && self.pressing() == 0;
        if (smooth && self.seams() == 0) || !self.observe(t, y, false) {
            return;
        }
        self.look_at_sizes();
        self.take_seams();
        let rubs = self.slipping.is_some();
        let mut switches = std::mem::take(&mut self.switches);
        let mut undecided = Vec::new();
        for (index, switch) in switches.iter_mut().enumerate() {
            if !(kept && switch.is_held()) {
                *switch = self.seen().side_here(switch);
                if self.is_at_corner(switch) {
                    undecided.push(index);
                    if rubs && switch.of_speeds {
                        switch.release();
                    }
                }
            }
        }
        self.switches = switches;
        if !undecided.is_empty() && self.observe_shortly(t, y) {
            self.take_switches(&undecided);
        }
        self.held = true;
        // guides press as the loads and drives do on these sides
        if self.pressing() > 0 && self.observe(t, y, false) {
            self.take_pressing_sides(kept);
            if self.sides.iter().flatten().any(|side| *side == 0.0) && self.observe_shortly(t, y) {
                self.take_pressing_sides(true);
            }
        }
    }

    /// Observes the state shortly after an instant.
    fn observe_shortly(&mut self, t: f64, y: &[f64]) -> bool {
        let time = SHORTLY * (self.last - self.from);
        // what is let go at its limit begins without acceleration
        let later = self.carried_on(t, y, time).and_then(|later| self.carried_on(t + time, &later, time));
        later.is_ok_and(|later| self.observe(t + 2.0 * time, &later, false))
    }

    /// Takes switches that are at a corner on the sides where they are in the state that is observed; what stays zero has none.
    fn take_switches(&mut self, undecided: &[usize]) {
        let mut switches = std::mem::take(&mut self.switches);
        for &index in undecided {
            if !self.is_at_corner(&switches[index]) {
                switches[index] = self.seen().side_here(&switches[index]);
            }
        }
        self.switches = switches;
    }

    /// Whether a number of a switch is zero but for rounding in the state that is observed.
    fn is_at_corner(&self, switch: &Switch<'_>) -> bool {
        let seen = self.seen();
        let most = self.rounding_of(seen.room_size(switch), OF_MOTION);
        (0..ENDS).any(|end| seen.room(switch, end).abs() <= most)
    }

    /// Something turns: what depends on speeds is taken as it is.
    pub fn release_speeds(&mut self) {
        self.switches.iter_mut().filter(|switch| switch.of_speeds).for_each(Switch::release);
    }

    /// The state that is observed, with the quantities that loads name.
    fn seen(&self) -> PoseAnswers<'_> {
        PoseAnswers { quantities: self.quantities.as_deref().unwrap_or_default(), ..self.view() }
    }

    fn room(&mut self, index: usize) -> f64 {
        let (switches, seams) = (ENDS * self.switches.len(), self.seams());
        match index.checked_sub(switches + seams) {
            None if index < switches => self.seen().room(&self.switches[index / ENDS], index % ENDS),
            None => self.seam_room(index - switches),
            Some(place) => self.pressing_room(place / ENDS, place % ENDS),
        }
    }

    fn turn(&mut self, index: usize, releases: bool) {
        let other = if releases { 0.0 } else { -1.0 };
        let (switches, seams) = (ENDS * self.switches.len(), self.seams());
        if let Some(place) = index.checked_sub(switches + seams) {
            self.sides[place / ENDS][place % ENDS] *= other;
        } else if index >= switches {
            self.turn_seam(index - switches, releases);
        } else if releases {
            self.switches[index / ENDS].release();
        } else {
            let switch = self.seen().other_side(&self.switches[index / ENDS], index % ENDS);
            self.switches[index / ENDS] = switch;
        }
    }

    /// How many elements of friction and transmissions with losses have sides on which they press.
    const fn pressing(&self) -> usize {
        let plan = self.model.plan;
        if self.slipping.is_some() { plan.friction.len() + plan.losing.len() } else { 0 }
    }

    /// On which sides they press in the state that is observed; what has just turned, and is nothing but rounding, is kept.
    fn take_pressing_sides(&mut self, kept: bool) {
        let nothing = if kept { NOTHING * self.greatest_force() } else { 0.0 };
        self.sides.resize(self.pressing(), [0.0; ENDS]);
        for index in 0..self.sides.len() {
            let pressing = self.pressing_force(index);
            let now = sides_of(pressing);
            for (end, x) in [pressing.x, pressing.y].into_iter().enumerate() {
                if x.abs() > nothing || self.sides[index][end] == 0.0 {
                    self.sides[index][end] = now[end];
                }
            }
        }
    }

    /// What presses in a guide, in a slot or between teeth: its magnitude has corners where it passes zero, the friction and the losses
    /// with it.
    fn pressing_force(&self, index: usize) -> Vec2 {
        let plan = self.model.plan;
        let Some(element) = plan.friction.get(index) else {
            let law = plan.losing[index - plan.friction.len()];
            return Vec2::new(self.trial.forces.law_forces[law].multiplier * plan.laws[law].force, 0.0);
        };
        let force = self.trial.measured(plan, element);
        match element.kind {
            FrictionLaw::Guide { .. } | FrictionLaw::BothEnds { .. } => force,
            FrictionLaw::Contact { first, second, internal, presses: 0.0, .. } => {
                let touch = self.trial.touch((element.body, first), (element.base, second), internal);
                touch.map_or(Vec2::zero(), |(_, normal)| Vec2::new(force.dot(normal), 0.0))
            }
            FrictionLaw::Circle { .. } | FrictionLaw::Contact { .. } | FrictionLaw::Rolling { .. } => {
                Vec2::zero()
            }
        }
    }

    /// The same on the side where the present step begins.
    fn pressing_room(&self, index: usize, end: usize) -> f64 {
        let side = self.sides.get(index).map_or(0.0, |sides| sides[end]);
        if side == 0.0 {
            return 1.0;
        }
        let Vec2 { x, y } = self.pressing_force(index);
        side * [x, y][end]
    }
}

/// The signs of what presses at both ends; 0 where nothing does.
fn sides_of(Vec2 { x, y }: Vec2) -> [f64; 2] {
    [x, y].map(|x| if x == 0.0 { 0.0 } else { x.signum() })
}
