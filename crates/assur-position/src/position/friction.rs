//! Friction in a group: Newton's method on the efforts of friction alone.
//!
//! Let φ_j be the friction torque or force in joint j of the group. For given φ the reactions follow from the plain step,
//! which is linear in the loads: λ(φ) = λ_0 + Σ φ_j λ_j, with λ_0 from the loads as they are and λ_j from a unit of φ_j
//! alone. The laws then read
//!
//! ```text
//! g_i(φ) = φ_i + s_i ρ_i |λ_i(φ)| = 0,
//! ```
//!
//! s_i the sense of the relative motion, ρ_i the radius of the friction circle or the coefficient, |λ_i| the force in
//! the hinge, the normal force of the guide, or |N_1| + |N_2| of its two ends. Newton starts without friction, φ = 0,
//! where the determinant of ∂g/∂φ is 1, and accepts a solution where it is positive. Magnitudes have kinks where a force
//! changes its sense: where Newton does not settle, all laws of the mechanism are searched (`friction_search`).

use super::friction_steps::FrictionLog;
use super::friction_work::FrictionWork;
use super::state::State;
use super::wrench::{Reaction, Wrench};
use crate::math::Vec2;
use crate::plan::{ForceStep, FrictionElement, FrictionGroup, FrictionLaw, Plan};

/// Newton's steps are at most this many; with a solution four suffice.
pub(super) const STEPS: u32 = 25;
/// A step below this part of the efforts may be rounding.
const RESTLESS: f64 = 1e-2;
/// Velocities below this part of the greatest are none.
pub const STILL: f64 = 1e-11;

impl State {
    /// Line along which an element's force acts, and a point of it; `None` for a torque.
    pub fn friction_line(&self, element: &FrictionElement) -> Option<(Vec2, Vec2)> {
        match &element.kind {
            FrictionLaw::Circle { .. } | FrictionLaw::Rolling { .. } => None,
            FrictionLaw::Guide { guide, .. } | FrictionLaw::BothEnds { guide, .. } => {
                Some((self.motion.bodies[guide.slider].position(guide.point), self.direction(guide)))
            }
            FrictionLaw::Contact { first, second, internal, .. } => {
                let (first, second) = ((element.body, *first), (element.base, *second));
                let (p, n) = match element.stop {
                    Some(stop) => {
                        let side = self.motion.sides.get(stop).copied().unwrap_or(0.0);
                        self.touch_on(side, first, second, *internal)?
                    }
                    None => self.touch(first, second, *internal)?,
                };
                Some((p, n.perp()))
            }
        }
    }

    /// Velocity of the element's body against its base, rad/s or m/s, in the sense in which its effort counts.
    pub fn sliding_speed(&self, element: &FrictionElement) -> f64 {
        let (body, base) = (&self.motion.bodies[element.body], &self.motion.bodies[element.base]);
        match self.friction_line(element) {
            None => body.omega - base.omega,
            Some((p, d)) => {
                let at = |b: &super::body::BodyState| b.v + (p - b.p).perp() * b.omega;
                (at(body) - at(base)).dot(d)
            }
        }
    }

    /// Senses of all elements: the sign of the relative velocity, zero where it is nothing but rounding.
    pub fn set_senses(&mut self, plan: &Plan) {
        let (mut turn, mut square, mut extent) = (0.0, 0.0, 0.0);
        for b in &self.motion.bodies {
            turn = f64::max(turn, b.omega * b.omega);
            square = f64::max(square, b.v.dot(b.v));
            extent = f64::max(extent, (b.p - self.motion.bodies[0].p).dot(b.p - self.motion.bodies[0].p));
        }
        for (i, element) in plan.friction.iter().enumerate() {
            self.forces.senses[i] = match self.friction_line(element) {
                None => self.motion.bodies[element.body].omega - self.motion.bodies[element.base].omega,
                Some((p, d)) => {
                    let at = |b: &super::body::BodyState| b.v + (p - b.p).perp() * b.omega;
                    let v = at(&self.motion.bodies[element.body]);
                    square = f64::max(square, v.dot(v));
                    (v - at(&self.motion.bodies[element.base])).dot(d)
                }
            };
        }
        // where nothing turns, what is left of an angular velocity is a rounded velocity over a length
        let (unit, turn) = if extent > 0.0 { (extent, f64::max(turn * extent, square)) } else { (1.0, turn) };
        for (sense, element) in self.forces.senses.iter_mut().zip(&plan.friction) {
            let turns = element.kind.turns();
            let (unit, most) = if turns { (unit, turn) } else { (1.0, square) };
            let still = *sense * *sense * unit <= STILL * STILL * most;
            *sense = if still { 0.0 } else { sense.signum() };
        }
    }

    /// Marks all reactions and efforts as not existing: the mechanism is locked.
    pub fn forget_forces(&mut self) {
        let none = Reaction { force: Vec2::new(f64::NAN, f64::NAN), couple: f64::NAN };
        self.forces.reactions.fill(none);
        self.forces.efforts.fill(f64::NAN);
        self.forces.frictions.fill(f64::NAN);
    }

    /// Adds an element's effort to the loads of its bodies.
    pub(super) fn apply_rub(&mut self, element: &FrictionElement, effort: f64) {
        match self.friction_line(element) {
            None => {
                self.forces.wrenches[element.through].moment += effort;
                self.forces.wrenches[element.base].moment -= effort;
            }
            Some((p, d)) => {
                self.carry(element.through, p, d * -effort);
                self.carry(element.base, p, d * effort);
            }
        }
    }

    pub(super) fn save(&self, group: &FrictionGroup, saved: &mut [Wrench]) {
        for (slot, keep) in group.bodies.iter().chain(&group.bases).zip(saved) {
            *keep = self.forces.wrenches[*slot];
        }
    }

    pub(super) fn restore(&mut self, group: &FrictionGroup, saved: &[Wrench]) {
        for (slot, keep) in group.bodies.iter().chain(&group.bases).zip(saved) {
            self.forces.wrenches[*slot] = *keep;
        }
    }

    /// What an element's law measures of the reaction as it stands: the force in a hinge or contact; the normal force of a
    /// guide; the forces at its two ends.
    #[inline(always)]
    pub fn measured(&self, plan: &Plan, element: &FrictionElement) -> Vec2 {
        if let Some(stop) = element.stop {
            return Vec2::new(self.motion.stops.get(stop).copied().unwrap_or(0.0), 0.0);
        }
        if let Some((from, to)) = element.pin {
            let slots = &plan.pin_slots[from..to];
            return slots
                .iter()
                .fold(Vec2::zero(), |sum, (slot, sign)| sum + self.forces.reactions[*slot].force * *sign);
        }
        let Reaction { force, couple } = self.forces.reactions[element.slot];
        match &element.kind {
            FrictionLaw::Circle { .. } | FrictionLaw::Contact { .. } | FrictionLaw::Rolling { .. } => force,
            FrictionLaw::Guide { guide, .. } => Vec2::new(self.direction(guide).cross(force), 0.0),
            FrictionLaw::BothEnds { guide, contacts: [a, b], .. } => {
                let normal = self.direction(guide).cross(force);
                Vec2::new((couple - normal * b) / (a - b), (normal * a - couple) / (a - b))
            }
        }
    }

    /// A group with friction. Returns the condition figure of its plain step times that of the friction.
    // what it takes from the settings is not computed for plans without friction
    #[inline(never)]
    pub(super) fn force_friction(
        &mut self,
        plan: &Plan,
        index: usize,
        plain: &ForceStep,
        group: &FrictionGroup,
    ) -> f64 {
        if let Some(elements) = &group.reduced {
            let mut steps = 0;
            let conditioning = self.force_reduced(plan, plain, elements, (&mut steps, &mut ()));
            if let Some(Some(work)) = self.scratch.friction_work.get_mut(index) {
                work.steps = steps;
            }
            return conditioning.unwrap_or_else(|| {
                self.forces.locked = true;
                self.force_step(plan, plain)
            });
        }
        let Some(mut work) = self.scratch.friction_work.get_mut(index).and_then(Option::take) else {
            return 0.0;
        };
        work.steps = 0;
        self.save(group, &mut work.saved);
        let conditioning = if group.laws.is_empty() {
            self.rub(plan, plain, group, &mut work, &mut ())
        } else {
            self.rub_with_wheels(plan, plain, group, &mut work)
        };
        if conditioning.is_none() {
            self.forces.locked = true;
            self.restore(group, &work.saved);
            self.force_step(plan, plain);
        }
        self.scratch.friction_work[index] = Some(work);
        conditioning.unwrap_or(0.0)
    }

    /// Finds the friction of a group from its loads as they were saved, and then its forces. `None` where it does not settle.
    pub(super) fn rub(
        &mut self,
        plan: &Plan,
        plain: &ForceStep,
        group: &FrictionGroup,
        work: &mut FrictionWork,
        watch: &mut impl FrictionLog,
    ) -> Option<f64> {
        let conditioning = self.respond(plan, plain, group, work, None);
        for unit in 0..group.elements.len() {
            let sense = self.forces.senses[group.elements[unit]];
            work.senses[unit] = sense;
            if sense != 0.0 {
                self.respond(plan, plain, group, work, Some(unit));
            }
        }
        if !newton(plan, group, work, watch) {
            return None;
        }
        for (&element, &x) in group.elements.iter().zip(&work.values) {
            self.forces.frictions[element] = x;
            self.apply_rub(&plan.friction[element], x);
        }
        self.force_step(plan, plain);
        Some(conditioning)
    }

    /// Reactions of the group from the loads as they are, or from a unit of one element.
    pub(super) fn respond(
        &mut self,
        plan: &Plan,
        plain: &ForceStep,
        group: &FrictionGroup,
        work: &mut FrictionWork,
        unit: Option<usize>,
    ) -> f64 {
        if let Some(unit) = unit {
            for &body in group.bodies.iter().chain(&group.bases) {
                self.forces.wrenches[body] = Wrench::default();
            }
            self.apply_rub(&plan.friction[group.elements[unit]], 1.0);
        }
        let conditioning = self.force_step(plan, plain);
        let (column, width) = (unit.map_or(0, |u| u + 1), group.elements.len() + 1);
        for (row, &element) in group.elements.iter().enumerate() {
            work.measured[row * width + column] = self.measured(plan, &plan.friction[element]);
        }
        self.restore(group, &work.saved);
        conditioning
    }
}

/// What presses in the pairs of a group with the efforts as they stand.
fn presses(plan: &Plan, group: &FrictionGroup, work: &FrictionWork) -> Vec<f64> {
    let width = group.elements.len() + 1;
    let one = |(i, element): (usize, &usize)| {
        let row = &work.measured[i * width..][..width];
        let units = row[1..].iter().zip(&work.values).zip(&work.senses);
        // nothing is known of the unit of a pair that does not slide
        let moving = units.filter(|(_, sense)| **sense != 0.0);
        let sum = moving.fold(row[0], |sum, ((unit, x), _)| sum + *unit * *x);
        match plan.friction[*element].kind {
            FrictionLaw::BothEnds { .. } => sum.x.abs() + sum.y.abs(),
            FrictionLaw::Guide { .. } => sum.x.abs(),
            FrictionLaw::Circle { .. } | FrictionLaw::Contact { .. } | FrictionLaw::Rolling { .. } => {
                sum.norm()
            }
        }
    };
    group.elements.iter().enumerate().map(one).collect()
}

/// Newton's method; on success the efforts are in `work.values` and the motion is possible.
fn newton(plan: &Plan, group: &FrictionGroup, work: &mut FrictionWork, watch: &mut impl FrictionLog) -> bool {
    let count = group.elements.len();
    let mut last = f64::INFINITY;
    work.values.fill(0.0);
    watch.begin(|| presses(plan, group, work));
    for _ in 0..STEPS {
        work.steps += 1;
        let mut scale = f64::MIN_POSITIVE;
        for i in 0..count {
            let kind = &plan.friction[group.elements[i]].kind;
            let row = &work.measured[i * (count + 1)..][..count + 1];
            let mut sum = row[0];
            for (unit, x) in row[1..].iter().zip(&work.values) {
                sum += *unit * *x;
            }
            // the gradient of the measure: of a length, of a sum of magnitudes
            let (gradient, measure) = match kind {
                FrictionLaw::BothEnds { .. } | FrictionLaw::Guide { .. } => {
                    let signs = Vec2::new(sum.x.signum(), sum.y.signum());
                    (signs, signs.dot(sum))
                }
                FrictionLaw::Circle { .. } | FrictionLaw::Contact { .. } | FrictionLaw::Rolling { .. } => {
                    let size = sum.norm();
                    (if size > 0.0 { sum / size } else { Vec2::zero() }, size)
                }
            };
            let weight = work.senses[i] * kind.factor();
            work.right[i] = -(work.values[i] + weight * measure);
            scale = scale.max((weight * measure).abs());
            for j in 0..count {
                let slope = if work.senses[j] == 0.0 { 0.0 } else { gradient.dot(row[j + 1]) };
                *work.jacobian.at_mut(i, j) = f64::from(u8::from(i == j)) + weight * slope;
            }
        }
        if !work.jacobian.factor() {
            return false;
        }
        work.jacobian.solve(&mut work.right);
        let mut step = 0.0_f64;
        for (x, dx) in work.values.iter_mut().zip(&work.right) {
            *x += dx;
            step = step.max(dx.abs());
        }
        watch.step(|| presses(plan, group, work));
        // the error left is of the order of the square of the step; near locking rounding makes steps that do not fall any more
        let is_rounding = step >= 0.5 * last && step <= RESTLESS * scale;
        if step <= plan.settings.friction_step * scale || is_rounding {
            return work.jacobian.sign() > 0.0;
        }
        last = step;
    }
    false
}

impl FrictionLaw {
    /// Radius of the friction circle or arm of rolling resistance, m, or coefficient.
    #[must_use]
    pub const fn factor(&self) -> f64 {
        match self {
            Self::Circle { radius: length } | Self::Rolling { arm: length } => *length,
            Self::Guide { coefficient, .. }
            | Self::BothEnds { coefficient, .. }
            | Self::Contact { coefficient, .. } => *coefficient,
        }
    }
}
