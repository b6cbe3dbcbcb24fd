//! Motions in which something rubs or stands at a stop: accelerations and efforts where it is known how everything goes on.
//!
//! A pair, a transmission with losses or a load against the motion slides in a sense, or it is held: its speed w q̇ stays as it
//! is, by an effort φ that no law of sliding gives. A closed stop bears Λ, which keeps its coordinate u q from accelerating. With the
//! efforts of friction f of what slides
//!
//! ```text
//! M q̈ = Q + Wᵀ(f, φ) + UᵀΛ,   w q̈ + ẇ q̇ = 0 of what is held,   u q̈ + u̇ q̇ = 0 of closed stops.
//! ```
//!
//! For given f these are linear, and so are all reactions; what is left is f = −s c(reactions) of what slides, by secants. Its
//! determinant without friction is 1. How everything goes on changes at events alone (`contact_modes`).

use super::dissipative::DissipativeElement;
use super::equations::Equations;
use super::plane::rows;
use super::secants::Left;
use super::sliding_sense::Slipping;
use crate::math::{Lu, Vec2};
use crate::model::{LoadId, Value};
use crate::plan::{Opposing, Path};
use crate::position::{Against, ContactMode};
use crate::solve::failure::Halt;

/// What is left of a law of friction, relative to its terms.
const ENOUGH: f64 = 1e-13;

impl Equations<'_, '_> {
    /// The rates of the unknowns at the position that is set.
    pub fn slipping_rates(&mut self, y: &[f64], dy: &mut [f64]) -> Result<(), Halt> {
        let n = self.order();
        let Some(mut slipping) = self.slipping.take() else { return Err(Halt::NotANumber) };
        let found = self.slipping_accelerations(&mut slipping);
        if found.is_ok() {
            if slipping.held.is_empty() && self.model.plan.effects.loses() {
                let left = (0..n).fold(0.0_f64, |most, i| most.max(slipping.share_of(i)));
                self.terms = (self.terms.0.max(slipping.greatest), self.terms.1.max(left));
            }
            dy[n..2 * n].copy_from_slice(&slipping.accelerations);
            if slipping.rests {
                dy[n..2 * n].fill(0.0);
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

    /// Accelerations and efforts of all elements at the position that is set. Leaves the motion and the forces that go with them.
    pub fn slipping_accelerations(&mut self, slipping: &mut Slipping) -> Result<(), Halt> {
        self.take_grips(slipping);
        let n = self.order();
        self.trial.motion.stops.fill(0.0);
        slipping.loaded.resize(n, 0.0);
        self.accelerations_without_friction(&mut slipping.loaded)?;
        slipping.bias.clear();
        slipping.bias.extend(self.trial.motion.bodies.iter().map(|body| (body.a, body.alpha)));
        slipping.take_sliding(self.model.plan);
        self.find_slopes(slipping);
        slipping.efforts.fill(0.0);
        self.take_given(slipping);
        slipping.pressed.clear();
        slipping.pressed.resize(self.closed.len(), 0.0);
        if slipping.undetermined {
            slipping.accelerations.clear();
            slipping.accelerations.resize(n, 0.0);
            return self.put(slipping);
        }
        self.find_held(slipping)?;
        let mut secants = std::mem::take(&mut slipping.secants);
        let found = if secants.x.is_empty() {
            self.bear(slipping, &[]);
            self.put(slipping)
        } else {
            secants.solve(|x, left| self.unbalanced(slipping, x, left))
        };
        slipping.secants = secants;
        found?;
        self.find_greatest(slipping);
        Ok(())
    }

    /// Whether what slides, where everything was evaluated, goes on so if it rubs a little more or less.
    ///
    /// # Errors
    /// There is no solution next to it.
    pub fn is_stable(&mut self, slipping: &mut Slipping) -> Result<bool, Halt> {
        let least = self.greatest_load();
        let mut secants = std::mem::take(&mut slipping.secants);
        let stable = secants.is_stable(least, |x, left| self.unbalanced(slipping, x, left));
        let x = std::mem::take(&mut secants.x);
        self.bear(slipping, &x);
        secants.x = x;
        slipping.secants = secants;
        self.put(slipping)?;
        stable
    }

    /// The greatest load or inertia force, N, as it acts on the free coordinates, whatever cancels.
    fn greatest_load(&self) -> f64 {
        let (extent, bodies) = (self.extent(), self.model.plan.bodies);
        let of = |i: usize| {
            let speeds = (0..bodies).map(|body| {
                let (v, omega) = self.reduced.unit_motion(i, body);
                v.norm() + extent * omega.abs()
            });
            let power = self.reduced.greatest_power(i, self.model.plan, &self.trial);
            power / speeds.fold(f64::MIN_POSITIVE, f64::max)
        };
        (0..self.order()).map(of).fold(0.0, f64::max)
    }

    /// What the speeds of the held elements and of closed stops change by where nothing holds, and what each effort changes it by.
    pub fn find_held(&mut self, slipping: &mut Slipping) -> Result<(), Halt> {
        let (n, held) = (self.order(), slipping.held.len());
        let count = held + self.closed.len();
        slipping.left.clear();
        for &element in &slipping.held {
            let acceleration = DissipativeElement::of(self.model.plan, element).acceleration(&self.trial);
            slipping.left.push(acceleration);
        }
        for &stop in &self.closed {
            slipping.left.push(self.stop_acceleration(stop));
        }
        slipping.columns.clear();
        slipping.columns.extend_from_slice(&slipping.slopes);
        slipping.columns.chunks_exact_mut(n.max(1)).for_each(|column| self.reduced.solve(column));
        if slipping.matrix.order() != count {
            slipping.matrix = Lu::new(count);
        }
        let Slipping { slopes, columns, matrix, units, .. } = slipping;
        for i in 0..count {
            for j in 0..count {
                let (row, column) = (&slopes[i * n..][..n], &columns[j * n..][..n]);
                *matrix.at_mut(i, j) = dot(row, column) * units[n + i] * units[n + j];
            }
        }
        if count > 0 && !matrix.factor() {
            return Err(Halt::Jam);
        }
        Ok(())
    }

    /// Accelerations and what holds, with these efforts of what slides.
    fn bear(&self, slipping: &mut Slipping, x: &[f64]) {
        let n = self.order();
        let Slipping {
            held,
            sliding,
            loaded,
            accelerations,
            columns,
            slopes,
            units,
            left,
            bears,
            matrix,
            ..
        } = slipping;
        let count = left.len();
        accelerations.clone_from(loaded);
        let mut add = |column: &[f64], effort: f64| {
            accelerations.iter_mut().zip(column).for_each(|(a, c)| *a += c * effort);
        };
        for (k, (&element, x)) in sliding.iter().zip(x).enumerate() {
            let effort = x * slipping.scales[element];
            slipping.efforts[element] = effort;
            add(&columns[(count + k) * n..][..n], effort);
        }
        bears.clear();
        for (k, left) in left.iter().enumerate() {
            bears.push(-(left + dot(&slopes[k * n..][..n], accelerations)) * units[n + k]);
        }
        if count > 0 {
            matrix.solve(bears);
        }
        for (k, bears) in bears.iter().enumerate() {
            let effort = bears * units[n + k];
            match held.get(k) {
                Some(&element) => slipping.efforts[element] = effort,
                None => slipping.pressed[k - held.len()] = effort,
            }
            accelerations.iter_mut().zip(&columns[k * n..][..n]).for_each(|(a, c)| *a += c * effort);
        }
        // what is held in every direction does not creep by rounding
        if count == n && left.iter().all(|left| *left == 0.0) {
            accelerations.fill(0.0);
        }
    }

    /// What is left of the laws of what slides, with these efforts.
    fn unbalanced(&mut self, slipping: &mut Slipping, x: &[f64], left: &mut [f64]) -> Left {
        self.bear(slipping, x);
        self.put(slipping)?;
        let plan = self.model.plan;
        let forces = self.trial.forces.reactions.iter().map(|reaction| reaction.force);
        let forces = forces.chain(self.trial.forces.applied.iter().map(|applied| applied.force));
        let force = forces.map(|force| force.dot(force)).fold(0.0, f64::max).sqrt();
        // where nothing presses loads and inertia cancel
        let force = force.max(self.greatest_load());
        let moment = force * slipping.extent;
        let (mut settled, mut greatest) = (true, f64::MIN_POSITIVE);
        for ((&element, x), left) in slipping.sliding.iter().zip(x).zip(left) {
            let (sense, scale) = (slipping.senses[element], slipping.scales[element]);
            let rubs = DissipativeElement::of(plan, element);
            let (friction, size) = match rubs {
                DissipativeElement::Pair(own) => {
                    (self.trial.sliding_friction(plan, own, sense), own.kind.factor() * force)
                }
                DissipativeElement::Law(law, slot) => {
                    let multiplier = self.trial.forces.law_forces[slot].multiplier;
                    // of losses a part of what is passed on is rounding, and of what it is the sum of
                    let [there, back] = law.efficiency.unwrap_or([1.0; 2]);
                    let lost = (1.0 / there - 1.0).abs().max((back - 1.0).abs());
                    let own = (multiplier * law.terms[0].1).abs();
                    let all = if rubs.turns() { moment } else { force };
                    (self.trial.friction_of_law(law, slot, sense), lost * own.max(all))
                }
                DissipativeElement::Load(_) => (0.0, 0.0),
            };
            let friction = friction / scale;
            *left = x - friction;
            if !left.is_finite() {
                return Err(Halt::NotANumber);
            }
            let size = x.abs() + friction.abs() + size.abs() / scale;
            settled &= left.abs() <= ENOUGH * size;
            greatest = greatest.max(size);
        }
        Ok((settled, greatest))
    }

    /// Adds efforts that are given to the loads.
    fn take_given(&mut self, slipping: &mut Slipping) {
        for &(element, effort) in &slipping.given {
            slipping.efforts[element] = effort;
            let mut column = Vec::with_capacity(self.order());
            self.slopes_of_element(element, &mut column);
            self.reduced.solve(&mut column);
            slipping.loaded.iter_mut().zip(&column).for_each(|(a, c)| *a += c * effort);
        }
    }

    /// Puts accelerations and efforts, with the motion and the forces that go with them.
    pub fn put(&mut self, slipping: &Slipping) -> Result<(), Halt> {
        for (body, (a, alpha)) in self.trial.motion.bodies.iter_mut().zip(&slipping.bias) {
            (body.a, body.alpha) = (*a, *alpha);
        }
        self.reduced.accelerate(&mut self.trial, &slipping.accelerations);
        for (grip, effort) in self.trial.motion.grips.iter_mut().zip(&slipping.efforts) {
            grip.effort = *effort;
        }
        let given = slipping.given.iter().map(|(element, _)| element);
        for &element in slipping.held.iter().chain(given) {
            if let DissipativeElement::Load(load) = DissipativeElement::of(self.model.plan, element) {
                let held = self.holds_by(load, (slipping, element));
                self.trial.motion.against[load.load.index()].held = held;
                let value = if load.point.is_some() { Value::Vector(held) } else { Value::Scalar(held.x) };
                self.put_load(load.load, value);
            }
        }
        for (k, &pressed) in slipping.pressed.iter().enumerate() {
            self.press(self.closed[k], pressed);
        }
        if self.model.plan.effects.forces {
            self.trial.run_loads_and_forces(self.model, &self.evaluated);
        }
        if self.trial.forces.locked { Err(Halt::Jam) } else { Ok(()) }
    }

    /// The greatest term of the equations, in the units of the unknowns.
    fn find_greatest(&self, slipping: &mut Slipping) {
        let n = self.order();
        let mut greatest = slipping.bears.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        for i in 0..n {
            let unit = slipping.units[i];
            greatest = greatest.max((slipping.loaded[i] / unit).abs()).max(slipping.share_of(i));
            if self.model.plan.effects.loses() {
                greatest = greatest.max(unit * self.reduced.greatest_power(i, self.model.plan, &self.trial));
            }
        }
        slipping.greatest = greatest;
    }

    /// What a load against the motion does that holds.
    fn holds_by(&self, load: &Opposing, (slipping, element): (&Slipping, usize)) -> Vec2 {
        match rows(self.model.plan, element) {
            Some([x, y]) => Vec2::new(slipping.efforts[x], slipping.efforts[y]),
            None => self.acts(load, slipping.efforts[element]),
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
            Some((_, Path::Plane(_))) => return Vec2::zero(),
        };
        along * effort
    }

    /// Puts the value of a load that is evaluated at every position.
    pub fn put_load(&mut self, load: LoadId, value: Value) {
        let own = self.evaluated.iter_mut().filter(|(id, _)| *id == load);
        own.for_each(|(_, known)| *known = value);
    }

    /// Speeds of the held elements, of closed stops and of what slides for unit rates, in the state that was moved last, and the units
    /// of the free coordinates and of all efforts that hold.
    pub fn find_slopes(&mut self, slipping: &mut Slipping) {
        let n = self.order();
        slipping.units.clear();
        slipping.units.extend((0..n).map(|i| self.reduced.scale(i)));
        slipping.slopes.clear();
        for k in 0..slipping.held.len() {
            self.slopes_of_element(slipping.held[k], &mut slipping.slopes);
        }
        for k in 0..self.closed.len() {
            slipping.slopes.extend(self.slopes(self.closed[k]));
        }
        for k in 0..slipping.held.len() + self.closed.len() {
            let slopes = slipping.slopes_of(k, n).iter().zip(&slipping.units);
            let square: f64 = slopes.map(|(slope, unit)| (slope * unit).powi(2)).sum();
            slipping.units.push(1.0 / square.sqrt());
        }
        for k in 0..slipping.sliding.len() {
            self.slopes_of_element(slipping.sliding[k], &mut slipping.slopes);
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
        let each = slipping.senses.iter().zip(&slipping.along);
        grips.extend(each.map(|(&sense, &along)| ContactMode { sense, effort: 0.0, along }));
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
            if let (Some((at, Path::Plane(_))), 1.0) = (load.point, grip.sense) {
                let v = self.trial.motion.bodies[load.body].velocity(at);
                let v = if v.norm() > grip.along.norm() { v } else { grip.along };
                against[load.load.index()].part = -v.unit().unwrap_or_default();
                continue;
            }
            let sense = if load.free * grip.sense > 0.0 { 0.0 } else { grip.sense };
            against[load.load.index()].part = self.acts(load, -sense);
        }
        self.trial.motion.against = against;
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
