//! What a run leaves at the instants wanted.

use super::bearing::{Bearing, Spread};
use super::chart::Given;
use super::equations::Equations;
use super::report::Energy;
use crate::answer::OF_MOTION;
use crate::math::Vec2;
use crate::math::ode::{Integrator, System};
use crate::position::{BodyState, Branch};

/// What wants an instant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Origin {
    Printed,
    Expected(usize),
}

/// Where a body is, with its whole turns.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BodyPose {
    p: Vec2,
    u: Vec2,
    turned: f64,
}

impl BodyPose {
    fn of(body: &BodyState) -> Self {
        Self { p: body.p, u: body.u, turned: body.turned }
    }

    pub fn put(poses: &[Self], bodies: &mut [BodyState]) {
        for (body, pose) in bodies.iter_mut().zip(poses) {
            (body.p, body.u, body.turned) = (pose.p, pose.u, pose.turned);
        }
    }
}

/// The free coordinates at each instant, one after another.
#[derive(Clone, Debug, Default)]
pub(crate) struct Records {
    pub order: usize,
    /// How many instants were reached.
    pub count: usize,
    /// The instants, s.
    pub times: Vec<f64>,
    pub origins: Vec<Origin>,
    /// Coordinates, rates and accelerations: three times `order` numbers each.
    pub numbers: Vec<f64>,
    /// The work of all loads up to each instant, J.
    pub work: Vec<f64>,
    /// Works, as many numbers each as are asked for.
    pub works: Vec<f64>,
    /// What is zero but for rounding of each of them over the whole run, J.
    pub nothing: Vec<f64>,
    /// What bears the loads beside reactions.
    pub bearings: Vec<Bearing>,
    /// A second way to share it, where there is one.
    pub spreads: Vec<Spread>,
    /// What stops gave in impacts, as many numbers each as there are stops.
    pub impulses: Vec<f64>,
    /// Angles of the bodies, rad, continuous over the run.
    pub angles: Vec<f64>,
    /// Where the bodies stand, for steps of motion that start from there.
    pub poses: Vec<BodyPose>,
    pub bodies: usize,
    /// The whole position, of instants that were found in other coordinates than those written.
    pub given: Vec<Option<Box<Given>>>,
    /// How the groups stand, where change points have been passed.
    pub assemblies: Vec<Option<Box<[Branch]>>>,
}

impl Records {
    /// Coordinates and rates at an instant.
    pub fn state(&self, index: usize) -> &[f64] {
        &self.numbers[3 * self.order * index..][..2 * self.order]
    }

    /// Accelerations at an instant.
    pub fn accelerations(&self, index: usize) -> &[f64] {
        &self.numbers[3 * self.order * index + 2 * self.order..][..self.order]
    }

    /// Works at an instant.
    pub fn works(&self, index: usize) -> &[f64] {
        let each = self.works.len() / self.count.max(1);
        &self.works[each * index..][..each]
    }

    /// What stops gave in an impact at an instant.
    pub fn impulses(&self, index: usize) -> &[f64] {
        let each = self.impulses.len() / self.count.max(1);
        &self.impulses[each * index..][..each]
    }

    /// Angles of the bodies at an instant.
    pub fn angles(&self, index: usize) -> &[f64] {
        let each = self.angles.len() / self.count.max(1);
        &self.angles[each * index..][..each]
    }

    /// Whether all of it was found in the coordinates written, with the assemblies of the first instant.
    pub fn is_as_written(&self) -> bool {
        self.given.iter().all(Option::is_none) && self.assemblies.iter().all(Option::is_none)
    }

    /// Where the bodies stand, if that is kept.
    pub fn bodies_at(&self, index: usize) -> Option<&[BodyPose]> {
        self.poses.get(self.bodies * index..)?.get(..self.bodies).filter(|s| !s.is_empty())
    }
}

/// Keeps what is wanted at an instant.
pub(super) struct Recorder {
    records: Records,
    /// What rounding of all powers came to by the begin of the last step, J.
    sizes: Vec<f64>,
    /// It in that step, W, and at its end.
    powers: Vec<[f64; 2]>,
    y: Vec<f64>,
    dy: Vec<f64>,
    /// The length of the last step, s.
    length: f64,
    goes_on: bool,
    /// The first instant, s, and the unknowns there before an impact.
    pub struck: Option<(f64, Vec<f64>)>,
    /// When the last impact was, s, and the impulses by stop.
    last_impact: (f64, Vec<f64>),
    begin: Option<f64>,
    end: f64,
    work: f64,
    missing: f64,
    exchanged: f64,
}

impl Recorder {
    pub fn new(equations: &Equations<'_, '_>) -> Self {
        let order = equations.order();
        Self {
            records: Records { order, bodies: equations.model.plan.bodies, ..Records::default() },
            sizes: vec![0.0; equations.model.mechanism.works.len()],
            powers: vec![[0.0; 2]; equations.model.mechanism.works.len()],
            y: equations.start(),
            dy: equations.start(),
            length: 0.0,
            goes_on: equations.model.plan.goes_on(),
            struck: None,
            last_impact: (f64::NAN, vec![0.0; equations.model.mechanism.stops.len()]),
            begin: None,
            end: 0.0,
            work: 0.0,
            missing: 0.0,
            exchanged: 0.0,
        }
    }

    /// Keeps an instant within the last step, or at one of its ends; `false` where the equations have no value there.
    pub fn keep<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        (time, origin): (f64, Origin),
    ) -> bool {
        let end = method.t();
        if !within_step(equations, method, time.min(end), &mut self.y) {
            return false;
        }
        let after = equations.closed.clone();
        if let Some((_, before)) = self.struck.as_ref().filter(|struck| struck.0 == time) {
            self.y.copy_from_slice(before);
            equations.closed.clear();
        }
        // at a corner loads are what the file says there
        let held = std::mem::replace(&mut equations.held, false);
        let known = equations.rates(time, &self.y, &mut self.dy).is_ok();
        let spread = if known { equations.spread((time, &self.y)) } else { None };
        equations.held = held;
        if !known {
            return false;
        }
        equations.follow_angles(time);
        let (n, records) = (self.records.order, &mut self.records);
        let given = equations.given((time, &self.y), &self.dy[n..2 * n]);
        records.count += 1;
        records.times.push(time);
        records.origins.push(origin);
        match &given {
            None => {
                records.numbers.extend_from_slice(&self.y[..2 * n]);
                records.numbers.extend_from_slice(&self.dy[n..2 * n]);
            }
            Some((_, numbers)) => records.numbers.extend_from_slice(numbers),
        }
        records.given.push(given.map(|(given, _)| Box::new(given)));
        records.assemblies.push(equations.assemblies());
        let nothing = nothing(&self.sizes, &self.powers, time - method.previous_t());
        let known = |(work, nothing): (&f64, f64)| if work.abs() <= nothing { 0.0 } else { *work };
        records.work.push(self.y[2 * n]);
        records.works.extend(self.y[2 * n + 1..].iter().zip(nothing).map(known));
        records.bearings.push(equations.bearing());
        records.spreads.push(spread);
        let (at, impulses) = &self.last_impact;
        let now = |impulse: &f64| if time == *at { *impulse } else { 0.0 };
        records.impulses.extend(impulses.iter().map(now));
        records.angles.extend_from_slice(&equations.angles);
        if self.goes_on {
            records.poses.extend(equations.trial.motion.bodies.iter().map(BodyPose::of));
        }
        self.energy(equations);
        equations.closed = after;
        true
    }

    /// An impact at an instant, s, by these stops: what was kept so shortly before it has its impulses.
    pub fn strike(&mut self, (t, at_once): (f64, f64), impulses: &[(usize, f64)]) {
        let (at, all) = &mut self.last_impact;
        *at = t;
        all.fill(0.0);
        impulses.iter().for_each(|(stop, impulse)| all[*stop] = *impulse);
        let kept = self.records.times.iter().rev().take_while(|time| (**time - t).abs() <= at_once).count();
        let from = all.len() * (self.records.count - kept);
        let places = self.records.impulses[from..].iter_mut().zip(all.iter().cycle());
        places.for_each(|(place, impulse)| *place = *impulse);
    }

    fn energy(&mut self, equations: &Equations<'_, '_>) {
        let kinetic = equations.trial.kinetic_energy(equations.model.mechanism);
        let begin = *self.begin.get_or_insert(kinetic);
        self.work = self.y[2 * self.records.order];
        self.end = kinetic;
        self.missing = self.missing.max((kinetic - begin - self.work).abs());
        self.exchanged = self.exchanged.max(kinetic).max(self.work.abs());
    }

    /// Works up to the end of a step.
    pub fn take_works<M: Integrator<f64>>(&mut self, equations: &mut Equations<'_, '_>, method: &M) {
        self.exchanged = self.exchanged.max(method.y()[2 * self.records.order].abs());
        if self.sizes.is_empty() || !equations.observe(method.t(), method.y(), true) {
            return;
        }
        equations.look_at_sizes();
        let length = method.t() - method.previous_t();
        for (id, (size, [power, at_end])) in self.sizes.iter_mut().zip(&mut self.powers).enumerate() {
            *size += self.length * *power;
            let power_there = equations.nothing(&equations.model.mechanism.works[id], OF_MOTION);
            let before = std::mem::replace(at_end, power_there);
            *power = at_end.max(before);
        }
        self.length = length;
    }

    pub fn end(mut self) -> (Records, Energy) {
        self.records.nothing = nothing(&self.sizes, &self.powers, self.length).collect();
        let balance = if self.exchanged > 0.0 { self.missing / self.exchanged } else { 0.0 };
        let energy = Energy { begin: self.begin.unwrap_or(0.0), end: self.end, work: self.work, balance };
        (self.records, energy)
    }
}

/// What is rounding of works some time after the begin of a step, s.
fn nothing<'a>(sizes: &'a [f64], powers: &'a [[f64; 2]], after: f64) -> impl Iterator<Item = f64> + 'a {
    sizes.iter().zip(powers).map(move |(size, [power, _])| size + after * power)
}

/// The unknowns at an instant within the last step, or at one of its ends; `false` where there are none.
pub(super) fn within_step<M: Integrator<f64>>(
    equations: &mut Equations<'_, '_>,
    method: &mut M,
    time: f64,
    y: &mut [f64],
) -> bool {
    if time == method.t() {
        y.copy_from_slice(method.y());
    } else if time == method.previous_t() {
        y.copy_from_slice(method.previous_y());
    } else {
        if method.prepare_dense(equations).is_err() {
            return false;
        }
        method.dense(time, y);
    }
    true
}
