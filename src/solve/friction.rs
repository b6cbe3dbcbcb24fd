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
//! where the determinant of ∂g/∂φ is 1. It falls to zero where the mechanism locks: beyond, what solves the equations
//! is no motion. The absolute values of normal forces have one kink each: their signs are tried in turn where Newton
//! does not settle.

use super::state::{Reaction, State, Wrench};
use crate::math::{Dense, Vec2};
use crate::plan::{ForceStep, FrictionElement, Plan, Rub, RubbingGroup};

/// Newton's method has settled when the laws hold to this, relative to the forces.
const SETTLED: f64 = 1e-14;
/// Newton's steps are at most this many; with a solution four suffice.
const STEPS: usize = 25;
/// Velocities below this part of the greatest are none.
pub(super) const STILL: f64 = 1e-11;

/// Memory of a group with friction.
#[derive(Clone, Debug)]
pub struct RubbingWork {
    /// Wrenches of the group's bodies and bases as the group finds them.
    saved: Vec<Wrench>,
    /// Reactions of the group's slots: from the loads, then from each unit effort.
    responses: Vec<Vec<Reaction>>,
    senses: Vec<f64>,
    jacobian: Dense,
    values: Vec<f64>,
    right: Vec<f64>,
}

impl RubbingWork {
    /// Memory for a group.
    #[must_use]
    pub fn new(group: &RubbingGroup) -> Self {
        let count = group.elements.len();
        Self {
            saved: vec![Wrench::default(); group.bodies.len() + group.bases.len()],
            responses: vec![vec![Reaction::default(); group.slots.len()]; count + 1],
            senses: vec![0.0; count],
            jacobian: Dense::new(count),
            values: vec![0.0; count],
            right: vec![0.0; count],
        }
    }
}

impl State {
    /// Line along which an element's force acts, and a point of it; `None` for a torque.
    pub(super) fn rubbing_line(&self, element: &FrictionElement) -> Option<(Vec2, Vec2)> {
        match &element.kind {
            Rub::Circle { .. } => None,
            Rub::Guide { way, .. } | Rub::BothEnds { way, .. } => {
                Some((self.bodies[way.slider].position(way.point), self.direction(way)))
            }
            Rub::Contact { first, second, internal, .. } => {
                let (p, n) = self.touch((element.body, *first), (element.base, *second), *internal)?;
                Some((p, n.perp()))
            }
        }
    }

    /// Velocity of the element's body against its base, rad/s or m/s, in the sense in which its effort counts.
    pub(super) fn rubbing_speed(&self, element: &FrictionElement) -> f64 {
        let (body, base) = (&self.bodies[element.body], &self.bodies[element.base]);
        match self.rubbing_line(element) {
            None => body.omega - base.omega,
            Some((p, d)) => {
                let at = |b: &super::state::BodyState| b.v + (p - b.p).perp() * b.omega;
                (at(body) - at(base)).dot(d)
            }
        }
    }

    /// Senses of all elements: the sign of the relative velocity, zero where it is nothing but rounding.
    pub fn set_senses(&mut self, plan: &Plan) {
        let turn = self.bodies.iter().map(|b| b.omega.abs()).fold(0.0, f64::max);
        let mut speed = self.bodies.iter().map(|b| b.v.norm()).fold(0.0, f64::max);
        for element in &plan.friction {
            if let Some((p, _)) = self.rubbing_line(element) {
                let body = &self.bodies[element.body];
                speed = speed.max((body.v + (p - body.p).perp() * body.omega).norm());
            }
        }
        for (i, element) in plan.friction.iter().enumerate() {
            let relative = self.rubbing_speed(element);
            let scale = if matches!(element.kind, Rub::Circle { .. }) { turn } else { speed };
            self.senses[i] = if relative.abs() <= STILL * scale { 0.0 } else { relative.signum() };
        }
    }

    /// Marks all reactions and efforts as not existing: the mechanism is locked.
    pub(super) fn forget_forces(&mut self) {
        let none = Reaction { force: Vec2::new(f64::NAN, f64::NAN), couple: f64::NAN };
        self.reactions.fill(none);
        self.efforts.fill(f64::NAN);
        self.frictions.fill(f64::NAN);
    }

    /// Adds an element's effort to the loads of its bodies.
    fn apply_rub(&mut self, element: &FrictionElement, effort: f64) {
        match self.rubbing_line(element) {
            None => {
                self.wrenches[element.body].moment += effort;
                self.wrenches[element.base].moment -= effort;
            }
            Some((p, d)) => {
                self.carry(element.body, p, d * -effort, 0.0);
                self.carry(element.base, p, d * effort, 0.0);
            }
        }
    }

    fn save(&self, group: &RubbingGroup, saved: &mut [Wrench]) {
        for (slot, keep) in group.bodies.iter().chain(&group.bases).zip(saved) {
            *keep = self.wrenches[*slot];
        }
    }

    fn restore(&mut self, group: &RubbingGroup, saved: &[Wrench]) {
        for (slot, keep) in group.bodies.iter().chain(&group.bases).zip(saved) {
            self.wrenches[*slot] = *keep;
        }
    }

    /// The measure of an element's reaction that the law multiplies, and its derivatives with respect to the efforts.
    fn measure(
        &self,
        element: &FrictionElement,
        place: usize,
        work: &RubbingWork,
        signs: Option<f64>,
        slopes: &mut [f64],
    ) -> f64 {
        let at = |response: &[Reaction]| response[place];
        let (zero, units) = work.responses.split_at(1);
        let sum = units.iter().zip(&work.values).fold(at(&zero[0]), |sum, (unit, x)| {
            let unit = at(unit);
            Reaction { force: sum.force + unit.force * *x, couple: sum.couple + unit.couple * *x }
        });
        let mut add = |weight: f64, of: &dyn Fn(&Reaction) -> f64| {
            for (slope, unit) in slopes.iter_mut().zip(units) {
                *slope += weight * of(&at(unit));
            }
        };
        match &element.kind {
            Rub::Circle { .. } | Rub::Contact { .. } => {
                let size = sum.force.norm();
                let n = if size > 0.0 { sum.force / size } else { Vec2::zero() };
                add(1.0, &|r| n.dot(r.force));
                size
            }
            Rub::Guide { way, .. } => {
                let n = self.direction(way).perp();
                let normal = n.dot(sum.force);
                let sign = signs.unwrap_or(normal.signum());
                add(sign, &|r| n.dot(r.force));
                sign * normal
            }
            Rub::BothEnds { way, contacts: [a, b], .. } => {
                // the couple is kept on the joint's body, as the force is: both change sign together
                let n = self.direction(way).perp();
                let first = |r: &Reaction| (r.couple - n.dot(r.force) * b) / (a - b);
                let second = |r: &Reaction| (n.dot(r.force) * a - r.couple) / (a - b);
                let (one, two) = (first(&sum), second(&sum));
                add(one.signum(), &first);
                add(two.signum(), &second);
                one.abs() + two.abs()
            }
        }
    }

    /// A group with friction. Returns the condition figure of its plain step times that of the friction.
    pub(super) fn force_rubbing(
        &mut self,
        plan: &Plan,
        index: usize,
        plain: &ForceStep,
        group: &RubbingGroup,
    ) -> f64 {
        let Some(mut work) = self.rubbing_work.get_mut(index).and_then(Option::take) else { return 0.0 };
        self.save(group, &mut work.saved);
        let sine = self.respond(plan, plain, group, &mut work, None);
        for unit in 0..group.elements.len() {
            let sense = self.senses[group.elements[unit]];
            work.senses[unit] = sense;
            if sense == 0.0 {
                work.responses[unit + 1].fill(Reaction::default());
            } else {
                self.respond(plan, plain, group, &mut work, Some(unit));
            }
        }
        let settled = self.settle(plan, group, &mut work);
        self.restore(group, &work.saved);
        if settled {
            for (&element, &x) in group.elements.iter().zip(&work.values) {
                self.frictions[element] = x;
                self.apply_rub(&plan.friction[element], x);
            }
        } else {
            self.locked = true;
        }
        self.force_step(plan, plain);
        self.rubbing_work[index] = Some(work);
        sine
    }

    /// Reactions of the group from the loads as they are, or from a unit of one element.
    fn respond(
        &mut self,
        plan: &Plan,
        plain: &ForceStep,
        group: &RubbingGroup,
        work: &mut RubbingWork,
        unit: Option<usize>,
    ) -> f64 {
        if let Some(unit) = unit {
            for &body in group.bodies.iter().chain(&group.bases) {
                self.wrenches[body] = Wrench::default();
            }
            self.apply_rub(&plan.friction[group.elements[unit]], 1.0);
        }
        let sine = self.force_step(plan, plain);
        let response = &mut work.responses[unit.map_or(0, |u| u + 1)];
        for (keep, &slot) in response.iter_mut().zip(&group.slots) {
            *keep = self.reactions[slot];
        }
        self.restore(group, &work.saved);
        sine
    }

    /// Solves the laws of friction; on success the efforts are in `work.values` and the motion is possible.
    fn settle(&self, plan: &Plan, group: &RubbingGroup, work: &mut RubbingWork) -> bool {
        if self.newton(plan, group, work, None) {
            return true;
        }
        // the kinks of at most a few guides: every pattern of signs, and the one that its answer confirms
        let guides: Vec<usize> = (0..group.elements.len())
            .filter(|&i| matches!(plan.friction[group.elements[i]].kind, Rub::Guide { .. }))
            .collect();
        (0..1_u32 << guides.len().min(8)).any(|pattern| {
            let signs: Vec<Option<f64>> = (0..group.elements.len())
                .map(|i| {
                    let bit = guides.iter().position(|&g| g == i)?;
                    Some(if pattern >> bit & 1 == 0 { 1.0 } else { -1.0 })
                })
                .collect();
            self.newton(plan, group, work, Some(&signs))
        })
    }

    fn newton(
        &self,
        plan: &Plan,
        group: &RubbingGroup,
        work: &mut RubbingWork,
        signs: Option<&[Option<f64>]>,
    ) -> bool {
        let count = group.elements.len();
        work.values.fill(0.0);
        let mut slopes = vec![0.0; count];
        for _ in 0..STEPS {
            let (mut worst, mut scale, mut confirmed) = (0.0_f64, f64::MIN_POSITIVE, true);
            for i in 0..count {
                let element = &plan.friction[group.elements[i]];
                let Some(place) = group.slots.iter().position(|s| *s == element.slot) else { return false };
                slopes.fill(0.0);
                let sign = signs.and_then(|s| s[i]);
                let measure = self.measure(element, place, work, sign, &mut slopes);
                confirmed &= measure >= 0.0;
                let weight = work.senses[i] * element.kind.factor();
                work.right[i] = -(work.values[i] + weight * measure);
                worst = worst.max(work.right[i].abs());
                scale = scale.max((weight * measure).abs());
                for (j, slope) in slopes.iter().enumerate() {
                    work.jacobian.row_mut(i)[j] = f64::from(u8::from(i == j)) + weight * slope;
                }
            }
            let regular = work.jacobian.factor();
            if worst <= SETTLED * scale || worst == 0.0 {
                return regular && confirmed && work.jacobian.sign() > 0.0;
            }
            if !regular || !worst.is_finite() {
                return false;
            }
            work.jacobian.solve(&mut work.right);
            for (x, step) in work.values.iter_mut().zip(&work.right) {
                *x += step;
            }
        }
        false
    }
}

impl Rub {
    /// Radius of the friction circle, m, or coefficient.
    #[must_use]
    pub const fn factor(&self) -> f64 {
        match self {
            Self::Circle { radius } => *radius,
            Self::Guide { coefficient, .. }
            | Self::BothEnds { coefficient, .. }
            | Self::Contact { coefficient, .. } => *coefficient,
        }
    }
}
