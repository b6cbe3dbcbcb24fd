//! The equations of [`Checks`] at one position or at several side by side: every joint closes, every body is in equilibrium, the
//! powers add up to nothing. What laws of transmissions and friction add is in `residual`.

use super::free_body::Action;
use super::state::State;
use super::wrench::Wrench;
use crate::math::{Scalar, V2};
use crate::plan::{Checks, EffortCheck, JointCheck, Plan};

impl<S: Scalar> State<S> {
    /// Greatest distance between what a joint joins, m, and the extent of the mechanism, m.
    #[cfg_attr(in_one, inline(always))]
    pub(super) fn gaps(&self, checks: &Checks) -> (S, S) {
        let bodies = &self.motion.bodies;
        // the root of the greatest square is the greatest root
        let (mut worst, mut size) = (S::zero(), S::zero());
        let (mut apart, mut far) = (S::zero(), S::zero());
        for joint in &checks.joints {
            match joint {
                JointCheck::Hinge(members) => {
                    let Some(&(first, at)) = members.first() else { continue };
                    let p = bodies[first].position(at);
                    for &(body, at) in members {
                        let q = bodies[body].position(at);
                        apart = apart.max(square(q - p));
                        far = far.max(square(q)).max(square(bodies[body].p));
                    }
                }
                JointCheck::Guide { slider, direction, guide, along, offset } => {
                    let (s, g) = (&bodies[slider.0], &bodies[guide.0]);
                    let d = V2::of(*along).turned(g.u);
                    let from_line = s.position(slider.1) - g.position(guide.1);
                    let extent = from_line.norm();
                    worst = worst.max((from_line.dot(d.perp()).abs() - S::of(*offset)).abs());
                    worst = worst.max((V2::of(*direction).turned(s.u) - d).norm() * extent);
                    size = size.max(extent).max(s.p.norm());
                }
            }
        }
        (worst.max(apart.sqrt()), size.max(far.sqrt()).max(S::of(f64::MIN_POSITIVE)))
    }

    /// The greatest of these distances over the extent.
    #[cfg_attr(in_one, inline(always))]
    pub(super) fn closure(&self, checks: &Checks) -> S {
        let (worst, size) = self.gaps(checks);
        worst / size
    }

    /// Virtual power of the loads and efforts on all moving bodies, and of what bodies of given motion put in through their
    /// joints, W.
    #[cfg_attr(in_one, inline(always))]
    pub(super) fn power(&self, checks: &Checks) -> S {
        let (bodies, forces) = (&self.motion.bodies, &self.forces);
        let mut sum = S::zero();
        for &slot in &checks.free {
            let (body, w) = (&bodies[slot], &forces.applied[slot]);
            sum = sum + w.force.dot(body.v);
            sum = sum + w.moment * body.omega;
        }
        for (slot, effort) in &checks.efforts {
            let value = forces.efforts[*slot];
            sum = sum
                + match effort {
                    EffortCheck::Torque(body) => value * bodies[*body].omega,
                    EffortCheck::Between(first, second) => {
                        value * (bodies[*second].omega - bodies[*first].omega)
                    }
                    EffortCheck::Line(body) => {
                        let (p, n) = forces.lines[*slot];
                        let body = &bodies[*body];
                        value * (body.v + (p - body.p).perp() * body.omega).dot(n)
                    }
                    EffortCheck::Along { slider, guide, along, .. } => {
                        let (s, g) = (&bodies[slider.0], &bodies[*guide]);
                        let p = s.position(slider.1);
                        let v = s.velocity(slider.1) - g.v - (p - g.p).perp() * g.omega;
                        value * v.dot(V2::of(*along).turned(g.u))
                    }
                };
        }
        for (slot, reaction) in checks.reactions.iter().enumerate() {
            if let Some(at) = reaction.and_then(|r| r.driven.map(|at| (r.base, at))) {
                sum = sum + forces.reactions[slot].force.dot(bodies[at.0].velocity(at.1));
            }
        }
        sum
    }

    /// A sum of powers, W, over the greatest there may be: nothing, where its terms are products of two roundings.
    #[cfg_attr(in_one, inline(always))]
    pub(super) fn over_most_power(&self, sum: S, checks: &Checks) -> S {
        let part = sum.abs() / self.most_power(checks);
        S::select(part.lt(S::of(f64::EPSILON * f64::EPSILON)), S::zero(), part)
    }

    /// The greatest force times the greatest velocity of a joint, W; where that is nothing but rounding, times what would be one.
    #[cfg_attr(in_one, inline(always))]
    fn most_power(&self, checks: &Checks) -> S {
        let (mut force, mut moment) = (S::zero(), S::zero());
        let (mut speed, mut turn, mut reach) = (S::zero(), S::zero(), S::zero());
        for w in &self.forces.applied {
            force = force.max(square(w.force));
            moment = moment.max(w.moment.abs());
        }
        for r in &self.forces.reactions {
            force = force.max(square(r.force));
        }
        for e in &self.forces.efforts {
            moment = moment.max(e.abs());
        }
        for &(slot, at) in &checks.moving {
            let body = &self.motion.bodies[slot];
            speed = speed.max(square(body.velocity(at)));
            turn = turn.max(body.omega.abs());
            reach = reach.max(square(body.p));
        }
        let force = force.sqrt();
        let (most, whole) = (force * speed.sqrt() + moment * turn, force * reach.sqrt() * turn);
        let is_rounding = most.lt(whole * S::of(64.0 * f64::EPSILON));
        S::select(is_rounding, whole, most).max(S::of(f64::MIN_POSITIVE))
    }
}

impl<S: Scalar> State<S> {
    /// The residuals of a state whose plan has neither laws nor friction: closure, equilibrium, power. The last two have a
    /// meaning where forces are solved. `totals` is memory.
    #[cfg_attr(in_one, inline(always))]
    pub(super) fn residuals(&self, plan: &Plan, totals: &mut Vec<Wrench<S>>) -> [S; 3] {
        let checks = &plan.checks;
        let closure = self.closure(checks);
        if !plan.has_forces() {
            return [closure, S::zero(), S::zero()];
        }
        let mut sums = Sums::of(&self.forces.applied, std::mem::take(totals));
        self.reactions_act(checks, |act| sums.add(self, act));
        self.efforts_act(checks, |act| sums.add(self, act));
        let equilibrium = sums.worst(checks);
        *totals = sums.into_memory();
        [closure, equilibrium, self.over_most_power(self.power(checks), checks)]
    }
}

#[inline(always)]
fn square<S: Scalar>(v: V2<S>) -> S {
    v.dot(v)
}

/// Sums of all forces on every body, with the square of the greatest force, N², and the greatest moment, N m, among them.
///
/// A root and a division keep the order of what they are taken of: of many the greatest is looked for first.
#[derive(Debug)]
pub(super) struct Sums<S> {
    total: Vec<Wrench<S>>,
    most_force: S,
    most_moment: S,
}

impl<S: Scalar> Sums<S> {
    /// Of the loads alone, in the memory of a list.
    #[cfg_attr(in_one, inline(always))]
    pub fn of(applied: &[Wrench<S>], mut total: Vec<Wrench<S>>) -> Self {
        total.clear();
        total.extend_from_slice(applied);
        let (mut most_force, mut most_moment) = (S::zero(), S::zero());
        for w in applied {
            most_force = most_force.max(square(w.force));
            most_moment = most_moment.max(w.moment.abs());
        }
        Self { total, most_force, most_moment }
    }

    #[inline(always)]
    pub fn into_memory(self) -> Vec<Wrench<S>> {
        self.total
    }

    /// Adds what acts on a body, and the opposite on the body that does it.
    #[cfg_attr(in_one, inline(always))]
    pub fn add(&mut self, state: &State<S>, action: Action<S>) {
        let Action { on, by, at, force, couple, .. } = action;
        let norm = self.update_max(force, couple);
        let mut arm = self.put(state, on, at, (force, couple));
        if let Some(by) = by {
            arm = arm.max(self.put(state, by, at, (-force, -couple)));
        }
        self.most_moment = self.most_moment.max(arm.sqrt() * norm);
    }

    /// The magnitude of a force: it and the couple may be the greatest.
    #[inline(always)]
    fn update_max(&mut self, force: V2<S>, couple: S) -> S {
        let norm_2 = square(force);
        self.most_force = self.most_force.max(norm_2);
        self.most_moment = self.most_moment.max(couple.abs());
        norm_2.sqrt()
    }

    /// Puts a force and a couple on a body; the square of the arm, m².
    #[inline(always)]
    fn put(&mut self, state: &State<S>, body: usize, p: V2<S>, (force, couple): (V2<S>, S)) -> S {
        let r = p - state.motion.bodies[body].p;
        let total = &mut self.total[body];
        total.force += force;
        total.moment = total.moment + (r.cross(force) + couple);
        square(r)
    }

    /// The worst equilibrium of a body, over the greatest force or moment.
    #[cfg_attr(in_one, inline(always))]
    pub fn worst(&self, checks: &Checks) -> S {
        let (mut force, mut moment) = (S::zero(), S::zero());
        for &slot in &checks.free {
            let w = &self.total[slot];
            force = force.max(square(w.force));
            moment = moment.max(w.moment.abs());
        }
        let least = S::of(f64::MIN_POSITIVE);
        (force.sqrt() / self.most_force.sqrt().max(least)).max(moment / self.most_moment.max(least))
    }
}
