//! What a run leaves at the instants wanted.

use super::equations::Equations;
use super::report::Energy;
use crate::math::Vec2;
use crate::math::ode::{Integrator, System};

/// What wants an instant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Origin {
    /// It is printed.
    Printed,
    /// An expectation.
    Expected(usize),
}

/// The free coordinates at each instant, one after another.
#[derive(Clone, Debug, Default)]
pub(crate) struct Records {
    /// Free coordinates.
    pub order: usize,
    /// How many instants were reached.
    pub count: usize,
    /// The instants, s.
    pub times: Vec<f64>,
    /// What wants them.
    pub origins: Vec<Origin>,
    /// Coordinates, rates and accelerations: three times `order` numbers each.
    pub numbers: Vec<f64>,
    /// Angles of the bodies, rad, continuous over the run.
    pub angles: Vec<f64>,
    /// Where the bodies stand, for steps of motion that start from there.
    pub stands: Vec<(Vec2, Vec2)>,
    /// Bodies.
    pub bodies: usize,
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

    /// Angles of the bodies at an instant.
    pub fn angles(&self, index: usize) -> &[f64] {
        let each = self.angles.len() / self.count.max(1);
        &self.angles[each * index..][..each]
    }

    /// Where the bodies stand, if that is kept.
    pub fn stand(&self, index: usize) -> Option<&[(Vec2, Vec2)]> {
        self.stands.get(self.bodies * index..)?.get(..self.bodies).filter(|s| !s.is_empty())
    }
}

/// Keeps what is wanted at an instant.
pub(super) struct Recorder {
    records: Records,
    y: Vec<f64>,
    dy: Vec<f64>,
    goes_on: bool,
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
            y: vec![0.0; 2 * order + 1],
            dy: vec![0.0; 2 * order + 1],
            goes_on: equations.model.plan.goes_on(),
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
        if !within_step(equations, method, time, &mut self.y)
            || equations.rates(time, &self.y, &mut self.dy).is_err()
        {
            return false;
        }
        equations.take_rates(&self.y);
        equations.follow_angles(time);
        let (n, records) = (self.records.order, &mut self.records);
        records.count += 1;
        records.times.push(time);
        records.origins.push(origin);
        records.numbers.extend_from_slice(&self.y[..2 * n]);
        records.numbers.extend_from_slice(&self.dy[n..2 * n]);
        records.angles.extend_from_slice(&equations.angles);
        if self.goes_on {
            records.stands.extend(equations.trial.motion.bodies.iter().map(|b| (b.p, b.u)));
        }
        self.energy(equations);
        true
    }

    fn energy(&mut self, equations: &Equations<'_, '_>) {
        let kinetic = equations.trial.kinetic_energy(equations.model.mechanism);
        let begin = *self.begin.get_or_insert(kinetic);
        self.work = self.y[2 * self.records.order];
        self.end = kinetic;
        self.missing = self.missing.max((kinetic - begin - self.work).abs());
        self.exchanged = self.exchanged.max(kinetic).max(self.work.abs());
    }

    /// The work of the loads up to the end of a step.
    pub fn look(&mut self, work: f64) {
        self.exchanged = self.exchanged.max(work.abs());
    }

    pub fn end(self) -> (Records, Energy) {
        let balance = if self.exchanged > 0.0 { self.missing / self.exchanged } else { 0.0 };
        let energy = Energy { begin: self.begin.unwrap_or(0.0), end: self.end, work: self.work, balance };
        (self.records, energy)
    }
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
