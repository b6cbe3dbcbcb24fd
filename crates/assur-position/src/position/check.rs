//! The equations of [`Checks`] at one position or at several side by side: every joint closes, every body is in equilibrium, the
//! powers add up to nothing. What laws of transmissions and friction add is in `residual`.

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

    /// The greatest force times the greatest velocity of a joint, W.
    #[cfg_attr(in_one, inline(always))]
    pub(super) fn most_power(&self, checks: &Checks) -> S {
        let (mut force, mut moment, mut speed, mut turn) = (S::zero(), S::zero(), S::zero(), S::zero());
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
        }
        (force.sqrt() * speed.sqrt() + moment * turn).max(S::of(f64::MIN_POSITIVE))
    }
}

#[inline(always)]
fn square<S: Scalar>(v: V2<S>) -> S {
    v.dot(v)
}

/// Sums of all forces on every body, with the greatest force, N, and moment, N m, among them.
#[derive(Debug, Default)]
pub(super) struct Sums<S> {
    total: Vec<Wrench<S>>,
    most_force: S,
    most_moment: S,
}

impl<S: Scalar + Default> Sums<S> {
    /// Of the loads alone, in the memory of a list.
    pub fn of(applied: &[Wrench<S>], total: Vec<Wrench<S>>) -> Self {
        let mut sums = Self { total, most_force: S::zero(), most_moment: S::zero() };
        sums.restart(applied);
        sums
    }

    /// The list.
    pub fn into_memory(self) -> Vec<Wrench<S>> {
        self.total
    }

    /// The same in the memory of other sums.
    #[cfg_attr(in_one, inline(always))]
    fn restart(&mut self, applied: &[Wrench<S>]) {
        let tiny = S::of(f64::MIN_POSITIVE);
        self.total.clear();
        self.total.extend_from_slice(applied);
        (self.most_force, self.most_moment) = (tiny, tiny);
    }

    /// The residuals of a state whose plan has neither laws nor friction: closure, equilibrium, power. The last two have a
    /// meaning where forces are solved.
    #[cfg_attr(in_one, inline(always))]
    pub fn residuals(&mut self, plan: &Plan, state: &State<S>) -> [S; 3] {
        let checks = &plan.checks;
        let closure = state.closure(checks);
        if !plan.has_forces() {
            return [closure, S::zero(), S::zero()];
        }
        self.restart(&state.forces.applied);
        self.reactions(checks, state);
        self.efforts(checks, state);
        [closure, self.worst(checks, state), state.power(checks).abs() / state.most_power(checks)]
    }

    /// Adds a force at a place in ground axes, and a couple.
    #[inline(always)]
    pub fn add(&mut self, state: &State<S>, body: usize, p: V2<S>, force: V2<S>, couple: S) {
        self.add_known(state, body, p, (force, force.norm()), couple);
    }

    #[inline(always)]
    fn add_known(&mut self, state: &State<S>, body: usize, p: V2<S>, (force, norm): (V2<S>, S), couple: S) {
        let r = p - state.motion.bodies[body].p;
        let moment = r.cross(force) + couple;
        let total = &mut self.total[body];
        total.force += force;
        total.moment = total.moment + moment;
        self.most_force = self.most_force.max(norm);
        self.most_moment = self.most_moment.max(r.norm() * norm).max(couple.abs());
    }

    /// Adds all reactions.
    #[cfg_attr(in_one, inline(always))]
    pub fn reactions(&mut self, checks: &Checks, state: &State<S>) {
        for (slot, reaction) in checks.reactions.iter().enumerate() {
            let Some(at) = reaction else { continue };
            let p = state.motion.bodies[at.at.0].position(at.at.1);
            let reaction = state.forces.reactions[slot];
            let norm = reaction.force.norm();
            self.add_known(state, at.body, p, (reaction.force, norm), reaction.couple);
            self.add_known(state, at.base, p, (-reaction.force, norm), -reaction.couple);
        }
    }

    /// Adds all unknown efforts.
    #[cfg_attr(in_one, inline(always))]
    pub fn efforts(&mut self, checks: &Checks, state: &State<S>) {
        let (bodies, none) = (&state.motion.bodies, V2::zero());
        for (slot, effort) in &checks.efforts {
            let value = state.forces.efforts[*slot];
            match effort {
                EffortCheck::Torque(body) => self.add(state, *body, bodies[*body].p, none, value),
                EffortCheck::Between(first, second) => {
                    self.add(state, *second, bodies[*second].p, none, value);
                    self.add(state, *first, bodies[*first].p, none, -value);
                }
                EffortCheck::Line(body) => {
                    let (p, n) = state.forces.lines[*slot];
                    self.add(state, *body, p, n * value, S::zero());
                }
                EffortCheck::Along { slider, direction, guide, .. } => {
                    let s = &bodies[slider.0];
                    let (p, force) = (s.position(slider.1), V2::of(*direction).turned(s.u) * value);
                    self.add(state, slider.0, p, force, S::zero());
                    self.add(state, *guide, p, -force, S::zero());
                }
            }
        }
    }

    /// The worst equilibrium of a body, over the greatest force or moment.
    #[cfg_attr(in_one, inline(always))]
    pub fn worst(&mut self, checks: &Checks, state: &State<S>) -> S {
        for w in &state.forces.applied {
            self.most_force = self.most_force.max(w.force.norm());
            self.most_moment = self.most_moment.max(w.moment.abs());
        }
        let mut worst = S::zero();
        for &slot in &checks.free {
            let w = &self.total[slot];
            worst = worst.max(w.force.norm() / self.most_force).max(w.moment.abs() / self.most_moment);
        }
        worst
    }
}
