//! Motions in which something rubs: every pair, transmission and load against the motion has a sense of its own.
//!
//! A pair slides in a sense, or it is held: its two links do not move against each other, and an effort φ holds them that no law
//! of sliding gives. The accelerations q̈ and the efforts φ are found together,
//!
//! effort(q̈, φ) = 0 of all free coordinates, relative acceleration(q̈) = 0 of all pairs that are held,
//!
//! by secants from M q̈ − Jᵀφ = Q, J q̈ = −J̇ q̇ without other friction. What closed stops bear is found with them, as if it
//! were held. Which pairs are held and which stops are closed changes at events alone (`contact_modes`).

use super::dissipative::DissipativeElement;
use super::equations::Equations;
use super::sliding_sense::Slipping;
use crate::math::{Lu, Vec2};
use crate::model::{LoadId, Value};
use crate::plan::{Opposing, Path};
use crate::position::{Against, ContactMode};
use crate::solve::failure::Halt;
use crate::structure::EffortKind;

impl Equations<'_, '_> {
    /// The rates of the unknowns at the position that is set.
    pub fn slipping_rates(&mut self, y: &[f64], dy: &mut [f64]) -> Result<(), Halt> {
        let n = self.order();
        let Some(mut slipping) = self.slipping.take() else { return Err(Halt::NotANumber) };
        let found = self.slipping_accelerations(&mut slipping);
        if found.is_ok() {
            let rests = slipping.rests;
            if slipping.held.is_empty() && self.model.plan.effects.loses() {
                let left = slipping.secants.x[..n].iter().fold(0.0_f64, |most, x| most.max(x.abs()));
                self.terms = (self.terms.0.max(slipping.greatest), self.terms.1.max(left));
            }
            for (i, a) in dy[n..2 * n].iter_mut().enumerate() {
                *a = if rests { 0.0 } else { slipping.secants.x[i] * slipping.units[i] };
            }
        }
        self.slipping = Some(slipping);
        found?;
        dy[..n].copy_from_slice(&y[n..2 * n]);
        let elements = self.model.plan.friction.iter().zip(&self.trial.forces.frictions);
        // stages beyond a rest go on smoothly
        let friction: f64 = elements.map(|(e, effort)| effort * self.trial.sliding_speed(e)).sum();
        let losses = self.trial.power_of_losses(self.model.plan);
        dy[2 * n] = self.trial.power_of_loads(self.model, &self.evaluated) + friction + losses;
        self.powers(&mut dy[2 * n + 1..], 1.0);
        Ok(())
    }

    /// Accelerations and efforts of the elements that are held, at the position that is set. Leaves the motion and the forces
    /// that go with them.
    pub fn slipping_accelerations(&mut self, slipping: &mut Slipping) -> Result<(), Halt> {
        self.take_grips(slipping);
        let n = self.order();
        let closed = self.closed.len();
        slipping.secants.resize(n + slipping.held.len() + closed);
        self.trial.motion.stops.fill(0.0);
        self.accelerations_without_friction(&mut slipping.secants.x[..n])?;
        self.find_slopes(slipping);
        let Slipping { held, units, slopes, matrix, secants, efforts_of, greatest, .. } = slipping;
        for (x, unit) in secants.x.iter_mut().zip(&*units) {
            *x /= unit;
        }
        if slipping.undetermined {
            secants.x.fill(0.0);
            return self.put((&[], units), &secants.x);
        }
        fill(matrix, (n, held.len() + closed), (self.reduced.mass(), slopes), units);
        if !matrix.factor() {
            return Err(Halt::Jam);
        }
        if self.model.plan.effects.loses() {
            secants.solve(matrix, |x, left| {
                *greatest = self.unbalanced((held, units, efforts_of), x, left)?;
                Ok(*greatest)
            })?;
        } else {
            // loads do not depend on what presses: one step solves the equations
            if held.len() + closed > 0 {
                let mut left = vec![0.0; secants.x.len()];
                self.put((held, units), &secants.x)?;
                self.speeds_change((held, units), &mut left);
                matrix.solve(&mut left);
                *greatest = greatest_of(&secants.x);
                secants.x.iter_mut().zip(&left).for_each(|(x, left)| *x -= left);
            }
            *greatest = greatest.max(greatest_of(&secants.x));
            self.put((held, units), &secants.x)?;
        }
        slipping.efforts.fill(0.0);
        for (k, &element) in slipping.held.iter().enumerate() {
            slipping.efforts[element] = slipping.secants.x[n + k] * slipping.units[n + k];
        }
        Ok(())
    }

    /// What is left of the equations in their units, and the greatest of their terms.
    fn unbalanced(
        &mut self,
        (held, units, efforts_of): (&[usize], &[f64], &[usize]),
        x: &[f64],
        left: &mut [f64],
    ) -> Result<f64, Halt> {
        self.put((held, units), x)?;
        self.speeds_change((held, units), left);
        let mut greatest = greatest_of(x);
        for i in 0..self.order() {
            let effort = efforts_of[i];
            left[i] = self.trial.forces.efforts[effort] * self.along_line(effort, i) * units[i];
            greatest = greatest.max(units[i] * self.reduced.greatest_power(i, self.model.plan, &self.trial));
        }
        let known = left.iter().all(|left| left.is_finite()) && greatest.is_finite();
        if known { Ok(greatest) } else { Err(Halt::NotANumber) }
    }

    /// How fast the point of an effort moves along its line for a unit rate of a free coordinate; 1 of others, which act along their own.
    pub fn along_line(&self, effort: usize, coordinate: usize) -> f64 {
        let EffortKind::Line(body) = self.model.structure.efforts[effort].kind else { return 1.0 };
        let (at, along) = self.trial.forces.lines[effort];
        let (v, omega) = self.reduced.unit_motion(coordinate, body.0);
        (v + (at - self.trial.motion.bodies[body.0].p).perp() * omega).dot(along)
    }

    /// Puts accelerations and what holds, in their units, with the motion and the forces that go with them.
    fn put(&mut self, (held, units): (&[usize], &[f64]), x: &[f64]) -> Result<(), Halt> {
        let n = self.order();
        for ((&drive, x), unit) in self.reduced.free().iter().zip(x).zip(units) {
            self.trial.motion.inputs[drive].acceleration = x * unit;
        }
        for (k, &element) in held.iter().enumerate() {
            let effort = x[n + k] * units[n + k];
            self.trial.motion.grips[element].effort = effort;
            if let DissipativeElement::Load(load) = DissipativeElement::of(self.model.plan, element) {
                let held = self.acts(load, effort);
                self.trial.motion.against[load.load.index()].held = held;
                let value = if load.point.is_some() { Value::Vector(held) } else { Value::Scalar(held.x) };
                self.put_load(load.load, value);
            }
        }
        let stopped = n + held.len();
        for (k, x) in x.iter().enumerate().skip(stopped) {
            self.press(self.closed[k - stopped], x * units[k]);
        }
        self.trial.run_motion::<2>(self.model.plan);
        if self.model.plan.effects.forces {
            self.trial.run_loads_and_forces(self.model, &self.evaluated);
        }
        if self.trial.forces.locked { Err(Halt::Jam) } else { Ok(()) }
    }

    /// What the speeds that are held change by, in their units.
    fn speeds_change(&self, (held, units): (&[usize], &[f64]), left: &mut [f64]) {
        let n = self.order();
        for (k, &element) in held.iter().enumerate() {
            left[n + k] =
                DissipativeElement::of(self.model.plan, element).acceleration(&self.trial) * units[n + k];
        }
        for (k, left) in left.iter_mut().enumerate().skip(n + held.len()) {
            *left = self.stop_acceleration(self.closed[k - n - held.len()]) * units[k];
        }
    }

    /// What a load against the motion does where it acts with this effort in the sense in which its speed counts: of a torque the first
    /// number.
    fn acts(&self, load: &Opposing, effort: f64) -> Vec2 {
        let body = &self.trial.motion.bodies[load.body];
        let along = match load.point {
            None => Vec2::new(1.0, 0.0),
            Some((_, Path::Line(along))) => along.turned(body.u),
            Some((at, Path::Curve(_))) => {
                let (v, omega) = self.reduced.unit_motion(0, load.body);
                (v + (body.position(at) - body.p).perp() * omega).unit().unwrap_or_default()
            }
        };
        along * effort
    }

    /// Puts the value of a load that is evaluated at every position.
    pub fn put_load(&mut self, load: LoadId, value: Value) {
        let own = self.evaluated.iter_mut().filter(|(id, _)| *id == load);
        own.for_each(|(_, known)| *known = value);
    }

    /// Speeds of the elements that are held and of closed stops for unit rates, in the state that was moved last, and the units of all
    /// unknowns.
    pub fn find_slopes(&mut self, slipping: &mut Slipping) {
        let n = self.order();
        slipping.units.clear();
        slipping.units.extend((0..n).map(|i| self.reduced.scale(i)));
        slipping.slopes.clear();
        for k in 0..slipping.held.len() {
            let element = slipping.held[k];
            self.slopes_of_element(element, &mut slipping.slopes);
        }
        for k in 0..self.closed.len() {
            slipping.slopes.extend(self.slopes(self.closed[k]));
        }
        for k in 0..slipping.held.len() + self.closed.len() {
            let slopes = slipping.slopes_of(k, n).iter().zip(&slipping.units);
            let square: f64 = slopes.map(|(slope, unit)| (slope * unit).powi(2)).sum();
            slipping.units.push(1.0 / square.sqrt());
        }
    }

    /// The speeds of an element for a unit rate of each free coordinate.
    pub fn slopes_of_element(&mut self, element: usize, out: &mut Vec<f64>) {
        let rubs = DissipativeElement::of(self.model.plan, element);
        for i in 0..self.order() {
            out.push(self.reduced.at_unit_rate(i, &mut self.trial, |state| rubs.unit_speed(state)));
        }
    }

    /// Puts how all elements move where forces are found.
    fn take_grips(&mut self, slipping: &Slipping) {
        let grips = &mut self.trial.motion.grips;
        grips.clear();
        grips.extend(slipping.senses.iter().map(|&sense| ContactMode { sense, ..ContactMode::default() }));
    }

    /// Lets the loads against the motion act in the senses of their elements, others by the velocity, in the state that was moved last.
    pub fn take_against(&mut self) {
        let plan = self.model.plan;
        if plan.opposing.is_empty() || self.trial.motion.grips.is_empty() {
            return;
        }
        let mut against = std::mem::take(&mut self.trial.motion.against);
        against.clear();
        let parts = (0..self.model.mechanism.loads.len()).map(|load| self.view().against_velocity(load));
        against.extend(parts.map(|part| Against { part, held: Vec2::zero() }));
        let grips = &self.trial.motion.grips[DissipativeElement::inner(plan)..];
        for (load, grip) in plan.opposing.iter().zip(grips) {
            against[load.load.index()].part = self.acts(load, -grip.sense);
        }
        self.trial.motion.against = against;
    }
}

fn greatest_of(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |most, x| most.max(x.abs()))
}

/// The matrix of the equations without friction of what slides.
fn fill(matrix: &mut Lu, (n, held): (usize, usize), (mass, slopes): (&[f64], &[f64]), units: &[f64]) {
    if matrix.order() != n + held {
        *matrix = Lu::new(n + held);
    }
    matrix.clear();
    for i in 0..n {
        for j in 0..n {
            *matrix.at_mut(i, j) = mass[i * n + j] * units[i] * units[j];
        }
        for k in 0..held {
            let slope = slopes[k * n + i] * units[i] * units[n + k];
            *matrix.at_mut(i, n + k) = -slope;
            *matrix.at_mut(n + k, i) = slope;
        }
    }
}
