//! Runs the steps of forces: reactions group by group, each passed on to the bodies that carry it.

use super::consistent::Consistent;
use super::kinematics::Shared;
use super::losses::Losses;
use super::state::State;
use super::wrench::Reaction;
use crate::group::{pp, prp, rpp, rpr, rrp, rrr};
use crate::math::{Scalar, V2};
use crate::plan::step::unit;
use crate::plan::{Arm, EffortLine, ForceStep, Guide, Hinge, Inner, Plan};

impl State {
    /// Runs all steps of forces from the loads in `wrenches`, to which it adds the reactions. Allocates nothing.
    pub fn run_forces(&mut self, plan: &Plan) {
        (self.forces.locked, self.forces.consistent) = (false, Consistent::One);
        if !plan.friction.is_empty() {
            self.scratch.loads_before.clone_from(&self.forces.wrenches);
        }
        for (index, step) in plan.forces.iter().enumerate() {
            self.forces.conditions[index] = match step {
                ForceStep::Friction { plain, group } => self.force_friction(plan, index, plain, group),
                ForceStep::General { .. }
                | ForceStep::Triad(_)
                | ForceStep::Sequence(_)
                | ForceStep::Train { .. } => self.force_step(plan, step),
                closed => self.closed_force(closed),
            };
        }
        if self.forces.locked {
            self.search_friction(plan);
        }
    }

    /// The same without friction, and without losses unless the senses of all laws are set.
    pub fn run_forces_without_friction(&mut self, plan: &Plan) {
        let losses = if self.scratch.in_senses { Losses::InSenses } else { Losses::None };
        for (index, step) in plan.forces.iter().enumerate() {
            let plain = if let ForceStep::Friction { plain, .. } = step { plain } else { step };
            self.forces.conditions[index] = self.force_step_with(plan, plain, losses);
        }
    }

    /// One step without friction. Linear in the loads, but for laws of wheels that find the senses of their forces.
    #[inline(never)]
    pub(super) fn force_step(&mut self, plan: &Plan, step: &ForceStep) -> f64 {
        let losses = if self.scratch.in_senses { Losses::InSenses } else { Losses::Found };
        self.force_step_with(plan, step, losses)
    }

    fn force_step_with(&mut self, plan: &Plan, step: &ForceStep, losses: Losses) -> f64 {
        match step {
            ForceStep::Train { train } => self.force_train(plan, *train, losses),
            ForceStep::Triad(triad) => self.force_triad(triad),
            ForceStep::General { system } => self.force_general(plan, *system, losses),
            ForceStep::Sequence(steps) => self.force_sequence(plan, steps, losses),
            closed => self.closed_force(closed),
        }
    }

    /// The groups from the first on; returns the figure of the last.
    fn force_sequence(&mut self, plan: &Plan, steps: &[ForceStep], losses: Losses) -> f64 {
        let mut last = 1.0;
        for (index, step) in steps.iter().enumerate() {
            last = self.force_step_with(plan, step, losses);
            self.forces.conditions[index] = last;
        }
        last
    }
}

impl<S: Scalar> State<S> {
    /// A step of forces that has a closed form: the figure of its condition, 0 for one that has none.
    #[cfg_attr(in_one, inline(always))]
    pub(super) fn closed_force(&mut self, step: &ForceStep) -> S {
        match step {
            ForceStep::Turn { hinge, effort, value } => self.force_turn(hinge, effort, *value),
            ForceStep::Shift { guide, effort, value } => self.force_shift(guide, effort, *value),
            ForceStep::Rrr { outer, inner, motion } => self.force_rrr(outer, inner, *motion),
            ForceStep::Rrp { outer, inner, guide, motion } => self.force_rrp(outer, inner, guide, *motion),
            ForceStep::DrivenLegs { outer, inner, ends, driven } => {
                self.force_driven_legs(outer, inner, *ends, driven)
            }
            ForceStep::Rpr { outer, guide } => self.force_rpr(outer, guide),
            ForceStep::Prp { ways, inner } => self.force_prp(ways, inner),
            ForceStep::Rpp { outer, inner, guide } => self.force_rpp(outer, inner, guide),
            ForceStep::Translation { ways } => self.force_translation(ways),
            ForceStep::Triad(_)
            | ForceStep::Train { .. }
            | ForceStep::General { .. }
            | ForceStep::Sequence(_)
            | ForceStep::Friction { .. } => S::zero(),
        }
    }

    /// Force on a body so far, and its moment about a place.
    #[inline(always)]
    pub(super) fn load_about(&self, body: usize, p: V2<S>) -> (V2<S>, S) {
        let w = &self.forces.wrenches[body];
        (w.force, w.moment - (p - self.motion.bodies[body].p).cross(w.force))
    }

    /// The place of a pin, with the force on its body so far and its moment about it.
    #[inline(always)]
    pub(super) fn load_at(&self, body: usize, pin: &Arm) -> (V2<S>, V2<S>, S) {
        let w = &self.forces.wrenches[body];
        let (p, r) = self.motion.bodies[body].pin(pin);
        (p, w.force, r.map_or(w.moment, |r| w.moment - r.cross(w.force)))
    }

    /// The opposite of a force at a place, on the body that carries it.
    #[inline(always)]
    pub(super) fn carry(&mut self, base: usize, p: V2<S>, force: V2<S>) {
        self.carry_moment(base, p, force, |moment| moment);
    }

    /// The same with a couple.
    #[inline(always)]
    pub(super) fn carry_wrench(&mut self, base: usize, p: V2<S>, force: V2<S>, couple: S) {
        self.carry_moment(base, p, force, |moment| moment + couple);
    }

    /// `all` makes the whole moment of that of the force.
    #[inline(always)]
    fn carry_moment(&mut self, base: usize, p: V2<S>, force: V2<S>, all: impl Fn(S) -> S) {
        // what the ground carries is not asked
        if base == 0 {
            return;
        }
        let r = p - self.motion.bodies[base].p;
        let w = &mut self.forces.wrenches[base];
        w.force -= force;
        w.moment = w.moment - all(r.cross(force));
    }

    #[inline(always)]
    pub(super) fn hinge_reaction(&mut self, hinge: &Hinge, p: V2<S>, force: V2<S>) {
        self.forces.reactions[hinge.slot] = Reaction { force, couple: S::zero() };
        self.carry(hinge.base, p, force);
    }

    /// Keeps the reaction of a guide, given at `p`, about the pair's reference point.
    #[inline(always)]
    pub(super) fn way_reaction(&mut self, guide: &Guide, p: V2<S>, force: V2<S>, couple: S) -> (V2<S>, S) {
        let reference = self.motion.bodies[guide.slider].position(guide.point);
        let couple = couple + (p - reference).cross(force);
        self.forces.reactions[guide.slot] = Reaction { force, couple };
        (reference, couple)
    }

    #[inline(always)]
    pub(super) fn carried_way(&mut self, guide: &Guide, p: V2<S>, force: V2<S>, couple: S) {
        let (reference, couple) = self.way_reaction(guide, p, force, couple);
        self.carry_wrench(guide.base, reference, force, couple);
    }

    #[inline(always)]
    pub(super) fn direction(&self, guide: &Guide) -> V2<S> {
        unit(guide.direction).turned(self.motion.bodies[guide.slider].u)
    }

    /// One body on a revolute: the effort is found from the moment about it.
    #[cfg_attr(in_one, inline(always))]
    pub(super) fn force_turn(&mut self, hinge: &Hinge, effort: &EffortLine, (slot, sign): (usize, f64)) -> S {
        let (p, force, moment) = self.load_at(hinge.body, &hinge.pin);
        match effort {
            EffortLine::Torque { base, .. } => {
                self.forces.efforts[slot] = -moment * S::of(sign);
                if *base != 0 {
                    let w = &mut self.forces.wrenches[*base];
                    w.moment = w.moment + moment;
                }
                self.hinge_reaction(hinge, p, -force);
                S::one()
            }
            EffortLine::Force { line, .. } => {
                let (q, n) = self.forces.lines[*line];
                let arm = (q - p).cross(n);
                let value = -moment / arm;
                self.forces.efforts[slot] = value * S::of(sign);
                self.hinge_reaction(hinge, p, -force - n * value);
                arm / (q - p).norm()
            }
            EffortLine::Along(_) => S::zero(),
        }
    }

    /// One body on a guide: the effort is found from the forces along it.
    #[cfg_attr(in_one, inline(always))]
    pub(super) fn force_shift(
        &mut self,
        guide: &Guide,
        effort: &EffortLine,
        (slot, sign): (usize, f64),
    ) -> S {
        let d = self.direction(guide);
        let p = self.motion.bodies[guide.slider].position(guide.point);
        let (mut force, mut moment) = self.load_about(guide.body, p);
        let conditioning = match effort {
            EffortLine::Along(_) => {
                let along = -force.dot(d);
                self.forces.efforts[slot] = along * S::of(sign);
                force += d * along;
                self.carry(guide.base, p, d * along);
                S::one()
            }
            EffortLine::Force { line, .. } => {
                let (q, n) = self.forces.lines[*line];
                let conditioning = n.dot(d);
                let value = -force.dot(d) / conditioning;
                self.forces.efforts[slot] = value * S::of(sign);
                force += n * value;
                moment = moment + (q - p).cross(n) * value;
                conditioning
            }
            EffortLine::Torque { .. } => S::zero(),
        };
        let normal = d.perp() * -force.dot(d.perp());
        self.carried_way(guide, p, normal, -moment);
        conditioning
    }

    /// A dyad RRR in its position and its condition figure, from the step of motion where it is the same group.
    #[cfg_attr(in_one, inline(always))]
    pub(super) fn dyad_rrr(
        &self,
        outer: &[Hinge; 2],
        inner: &Inner,
        motion: Option<usize>,
    ) -> (rrr::Rrr<S>, S) {
        if let Some(step) = motion {
            let Shared { r_1, second, inverse } = self.motion.shared[step];
            return (rrr::Rrr { r_1, r_2: second, inverse }, self.motion.conditions[step]);
        }
        let [r_1, r_2] = [0, 1].map(|i| inner.arms[i].of::<S>().turned(self.motion.bodies[outer[i].body].u));
        (rrr::Rrr::new(r_1, r_2), r_1.cross(r_2) / (r_1.norm() * r_2.norm()))
    }

    /// The same of a dyad RRP.
    #[cfg_attr(in_one, inline(always))]
    pub(super) fn dyad_rrp(
        &self,
        outer: &Hinge,
        inner: &Inner,
        guide: &Guide,
        motion: Option<usize>,
    ) -> (rrp::Rrp<S>, S) {
        if let Some(step) = motion {
            let Shared { r_1, second, inverse } = self.motion.shared[step];
            return (rrp::Rrp { r_1, d: second, inverse }, self.motion.conditions[step]);
        }
        let r_1 = if inner.on_rim {
            let place = |body: usize, pin: &Arm| self.motion.bodies[body].pin(pin).0;
            place(guide.body, &inner.second_pin) - place(outer.body, &outer.pin)
        } else {
            inner.arms[0].of::<S>().turned(self.motion.bodies[outer.body].u)
        };
        let d = self.direction(guide);
        (rrp::Rrp::new(r_1, d), r_1.dot(d) / r_1.norm())
    }

    #[cfg_attr(in_one, inline(always))]
    fn force_rrr(&mut self, outer: &[Hinge; 2], inner: &Inner, motion: Option<usize>) -> S {
        let [one, two] = outer;
        let (group, conditioning) = self.dyad_rrr(outer, inner, motion);
        let (p_A, F_1, M_1) = self.load_at(one.body, &one.pin);
        let (p_B, F_2, M_2) = self.load_at(two.body, &two.pin);
        let got = group.reactions(F_1, M_1, F_2, M_2);
        self.hinge_reaction(one, p_A, got.f_A);
        self.hinge_reaction(two, p_B, got.f_B);
        self.forces.reactions[inner.slot] =
            Reaction { force: got.f_C * S::of(inner.sign), couple: S::zero() };
        conditioning
    }

    #[cfg_attr(in_one, inline(always))]
    fn force_rrp(&mut self, outer: &Hinge, inner: &Inner, guide: &Guide, motion: Option<usize>) -> S {
        let (group, conditioning) = self.dyad_rrp(outer, inner, guide, motion);
        let (p_A, F_1, M_1) = self.load_at(outer.body, &outer.pin);
        let (p_C, F_2, M_2) = self.load_at(guide.body, &inner.second_pin);
        let got = group.reactions(F_1, M_1, F_2, M_2);
        self.hinge_reaction(outer, p_A, got.f_A);
        self.forces.reactions[inner.slot] =
            Reaction { force: got.f_C * S::of(inner.sign), couple: S::zero() };
        self.carried_way(guide, p_C, group.d.perp() * got.normal, got.couple);
        conditioning
    }

    #[cfg_attr(in_one, inline(always))]
    fn force_rpr(&mut self, outer: &[Hinge; 2], guide: &Guide) -> S {
        let [one, two] = outer;
        let (p_A, F_1, M_1) = self.load_at(one.body, &one.pin);
        let (p_B, F_2, M_2) = self.load_at(two.body, &two.pin);
        let (r, e) = (p_B - p_A, self.direction(guide));
        let s = r.dot(e);
        let got = rpr::Rpr::new(r, e, e.cross(r), s).reactions(F_1, M_1, F_2, M_2);
        self.hinge_reaction(one, p_A, got.f_A);
        self.hinge_reaction(two, p_B, got.f_B);
        // the kernel gives the force of the first body on the second
        let sign = if guide.body == two.body { S::one() } else { -S::one() };
        self.way_reaction(guide, p_B, e.perp() * (sign * got.normal), sign * got.couple);
        s / r.norm()
    }

    #[cfg_attr(in_one, inline(always))]
    fn force_prp(&mut self, ways: &[Guide; 2], inner: &Inner) -> S {
        let p_C = self.motion.bodies[ways[0].body].position(inner.pin);
        let d = [self.direction(&ways[0]), self.direction(&ways[1])];
        let (F_1, M_1) = self.load_about(ways[0].body, p_C);
        let (F_2, M_2) = self.load_about(ways[1].body, p_C);
        let got = prp::Prp::new(d[0], d[1]).reactions(F_1, M_1, F_2, M_2);
        self.forces.reactions[inner.slot] =
            Reaction { force: got.f_C * S::of(inner.sign), couple: S::zero() };
        self.carried_way(&ways[0], p_C, d[0].perp() * got.normal_1, got.couple_1);
        self.carried_way(&ways[1], p_C, d[1].perp() * got.normal_2, got.couple_2);
        d[0].cross(d[1])
    }

    #[inline(never)]
    fn force_rpp(&mut self, outer: &Hinge, inner: &Guide, guide: &Guide) -> S {
        let (p_A, F_1, M_1) = self.load_at(outer.body, &outer.pin);
        let p_R = self.motion.bodies[guide.slider].position(guide.point);
        let (d_1, d_2) = (self.direction(inner), self.direction(guide));
        let (F_2, M_2) = self.load_about(guide.body, p_R);
        let s_1 = (p_A - p_R).dot(d_1);
        let got = rpp::Rpp::new(d_1, d_2).reactions(s_1, F_1, M_1, F_2, M_2);
        self.hinge_reaction(outer, p_A, got.f_A);
        // the kernel gives the force of the first body on the second
        let sign = if inner.body == guide.body { S::one() } else { -S::one() };
        self.way_reaction(inner, p_A, d_1.perp() * (sign * got.normal_1), sign * got.couple_1);
        self.carried_way(guide, p_R, d_2.perp() * got.normal_2, got.couple_2);
        d_1.cross(d_2)
    }

    /// The couple is put on the first guide: how it is shared is not determined, and is not reported.
    #[inline(never)]
    fn force_translation(&mut self, ways: &[Guide; 2]) -> S {
        let p_R = self.motion.bodies[ways[0].slider].position(ways[0].point);
        let d = [self.direction(&ways[0]), self.direction(&ways[1])];
        let (F, M) = self.load_about(ways[0].body, p_R);
        let got = pp::Pp::new(d[0], d[1]).reactions(F, M);
        self.carried_way(&ways[0], p_R, d[0].perp() * got.normal_1, got.couple);
        self.carried_way(&ways[1], p_R, d[1].perp() * got.normal_2, S::zero());
        d[0].cross(d[1])
    }
}
