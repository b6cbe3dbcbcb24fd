//! Runs the steps of forces: reactions group by group, each passed on to the bodies that carry it.

use super::state::{Reaction, State};
use crate::group::{pp, prp, rpp, rpr, rrp, rrr};
use crate::math::Vec2;
use crate::plan::{EffortLine, ForceStep, Hinge, Inner, Plan, Way};

impl State {
    /// Runs all steps of forces from the loads in `wrenches`, to which it adds the reactions. Allocates nothing.
    pub fn run_forces(&mut self, plan: &Plan) {
        for (index, step) in plan.forces.iter().enumerate() {
            self.force_sines[index] = match step {
                ForceStep::Rubbing { plain, group } => self.force_rubbing(plan, index, plain, group),
                plain => self.force_step(plan, plain),
            };
        }
    }

    /// The same without friction.
    pub fn run_forces_without_friction(&mut self, plan: &Plan) {
        for (index, step) in plan.forces.iter().enumerate() {
            self.force_sines[index] = match step {
                ForceStep::Rubbing { plain, .. } => self.force_step(plan, plain),
                plain => self.force_step(plan, plain),
            };
        }
    }

    /// One step without friction. Linear in the loads.
    #[inline(always)]
    pub(super) fn force_step(&mut self, plan: &Plan, step: &ForceStep) -> f64 {
        match step {
            ForceStep::Turn { hinge, effort, value } => self.force_turn(hinge, effort, *value),
            ForceStep::Shift { way, effort, value } => self.force_shift(way, effort, *value),
            ForceStep::Rrr { outer, inner, scale } => self.force_rrr(outer, inner, *scale),
            ForceStep::Rrp { outer, inner, way, scale } => self.force_rrp(outer, inner, way, *scale),
            ForceStep::DrivenLegs { outer, inner, ends, driven } => {
                self.force_driven_legs(outer, inner, *ends, driven)
            }
            ForceStep::Rpr { outer, way } => self.force_rpr(outer, way),
            ForceStep::Prp { ways, inner } => self.force_prp(ways, inner),
            ForceStep::Rpp { outer, inner, way } => self.force_rpp(outer, inner, way),
            ForceStep::Translation { ways } => self.force_translation(ways),
            ForceStep::Triad(triad) => self.force_triad(triad),
            ForceStep::General { system } => self.force_general(*system, &plan.balance_systems[*system]),
            ForceStep::Sequence(steps) => self.force_sequence(plan, steps),
            // a step with friction holds a plain one
            ForceStep::Rubbing { .. } => 0.0,
        }
    }

    /// The groups from the first on; returns the figure of the last.
    fn force_sequence(&mut self, plan: &Plan, steps: &[ForceStep]) -> f64 {
        let mut last = 1.0;
        for (index, step) in steps.iter().enumerate() {
            last = self.force_step(plan, step);
            self.force_sines[index] = last;
        }
        last
    }

    /// Force on a body so far, and its moment about a place.
    #[inline(always)]
    pub(super) fn load_about(&self, body: usize, p: Vec2) -> (Vec2, f64) {
        let w = &self.wrenches[body];
        (w.force, w.moment - (p - self.bodies[body].p).cross(w.force))
    }

    /// The opposite of a force and couple at a place, on the body that carries it.
    #[inline(always)]
    pub(super) fn carry(&mut self, base: usize, p: Vec2, force: Vec2, couple: f64) {
        // what the ground carries is not asked
        if base == 0 {
            return;
        }
        let r = p - self.bodies[base].p;
        let w = &mut self.wrenches[base];
        w.force -= force;
        w.moment -= r.cross(force) + couple;
    }

    #[inline(always)]
    pub(super) fn hinge_reaction(&mut self, hinge: &Hinge, p: Vec2, force: Vec2) {
        self.reactions[hinge.slot] = Reaction { force, couple: 0.0 };
        self.carry(hinge.base, p, force, 0.0);
    }

    /// Keeps the reaction of a guide, given at `p`, about the pair's reference point.
    #[inline(always)]
    fn way_reaction(&mut self, way: &Way, p: Vec2, force: Vec2, couple: f64) -> (Vec2, f64) {
        let reference = self.bodies[way.slider].position(way.point);
        let couple = couple + (p - reference).cross(force);
        self.reactions[way.slot] = Reaction { force, couple };
        (reference, couple)
    }

    #[inline(always)]
    pub(super) fn carried_way(&mut self, way: &Way, p: Vec2, force: Vec2, couple: f64) {
        let (reference, couple) = self.way_reaction(way, p, force, couple);
        self.carry(way.base, reference, force, couple);
    }

    #[inline(always)]
    pub(super) fn direction(&self, way: &Way) -> Vec2 {
        way.direction.turned(self.bodies[way.slider].u)
    }

    /// One body on a revolute: the effort is found from the moment about it.
    pub(super) fn force_turn(
        &mut self,
        hinge: &Hinge,
        effort: &EffortLine,
        (slot, sign): (usize, f64),
    ) -> f64 {
        let p = self.bodies[hinge.body].position(hinge.pin);
        let (force, moment) = self.load_about(hinge.body, p);
        match effort {
            EffortLine::Torque { base, .. } => {
                self.efforts[slot] = -moment * sign;
                self.wrenches[*base].moment += moment;
                self.hinge_reaction(hinge, p, -force);
                1.0
            }
            EffortLine::Force { line, .. } => {
                let (q, n) = self.lines[*line];
                let arm = (q - p).cross(n);
                let value = -moment / arm;
                self.efforts[slot] = value * sign;
                self.hinge_reaction(hinge, p, -force - n * value);
                arm / (q - p).norm()
            }
            EffortLine::Along(_) => 0.0,
        }
    }

    /// One body on a guide: the effort is found from the forces along it.
    pub(super) fn force_shift(&mut self, way: &Way, effort: &EffortLine, (slot, sign): (usize, f64)) -> f64 {
        let d = self.direction(way);
        let p = self.bodies[way.slider].position(way.point);
        let (mut force, mut moment) = self.load_about(way.body, p);
        let sine = match effort {
            EffortLine::Along(_) => {
                let along = -force.dot(d);
                self.efforts[slot] = along * sign;
                force += d * along;
                self.carry(way.base, p, d * along, 0.0);
                1.0
            }
            EffortLine::Force { line, .. } => {
                let (q, n) = self.lines[*line];
                let sine = n.dot(d);
                let value = -force.dot(d) / sine;
                self.efforts[slot] = value * sign;
                force += n * value;
                moment += (q - p).cross(n) * value;
                sine
            }
            EffortLine::Torque { .. } => 0.0,
        };
        let normal = d.perp() * -force.dot(d.perp());
        self.carried_way(way, p, normal, -moment);
        sine
    }

    #[inline(always)]
    fn force_rrr(&mut self, outer: &[Hinge; 2], inner: &Inner, scale: f64) -> f64 {
        let [one, two] = outer;
        let (body_1, body_2) = (&self.bodies[one.body], &self.bodies[two.body]);
        let (p_A, p_B) = (body_1.position(one.pin), body_2.position(two.pin));
        let r_1 = (inner.pin - one.pin).turned(body_1.u);
        let r_2 = (inner.second_pin - two.pin).turned(body_2.u);
        let (F_1, M_1) = self.load_about(one.body, p_A);
        let (F_2, M_2) = self.load_about(two.body, p_B);
        let got = rrr::Rrr::new(r_1, r_2).reactions(F_1, M_1, F_2, M_2);
        self.hinge_reaction(one, p_A, got.f_A);
        self.hinge_reaction(two, p_B, got.f_B);
        self.reactions[inner.slot] = Reaction { force: got.f_C * inner.sign, couple: 0.0 };
        r_1.cross(r_2) * scale
    }

    #[inline(always)]
    fn force_rrp(&mut self, outer: &Hinge, inner: &Inner, way: &Way, scale: f64) -> f64 {
        let body_1 = &self.bodies[outer.body];
        let p_A = body_1.position(outer.pin);
        let r_1 = (inner.pin - outer.pin).turned(body_1.u);
        let p_C = p_A + r_1;
        let d = self.direction(way);
        let (F_1, M_1) = self.load_about(outer.body, p_A);
        let (F_2, M_2) = self.load_about(way.body, p_C);
        let got = rrp::Rrp::new(r_1, d).reactions(F_1, M_1, F_2, M_2);
        self.hinge_reaction(outer, p_A, got.f_A);
        self.reactions[inner.slot] = Reaction { force: got.f_C * inner.sign, couple: 0.0 };
        self.carried_way(way, p_C, d.perp() * got.normal, got.couple);
        r_1.dot(d) * scale
    }

    #[inline(always)]
    fn force_rpr(&mut self, outer: &[Hinge; 2], way: &Way) -> f64 {
        let [one, two] = outer;
        let p_A = self.bodies[one.body].position(one.pin);
        let p_B = self.bodies[two.body].position(two.pin);
        let (r, e) = (p_B - p_A, self.direction(way));
        let (F_1, M_1) = self.load_about(one.body, p_A);
        let (F_2, M_2) = self.load_about(two.body, p_B);
        let s = r.dot(e);
        let got = rpr::Rpr::new(r, e, e.cross(r), s).reactions(F_1, M_1, F_2, M_2);
        self.hinge_reaction(one, p_A, got.f_A);
        self.hinge_reaction(two, p_B, got.f_B);
        // the kernel gives the force of the first body on the second
        let sign = if way.body == two.body { 1.0 } else { -1.0 };
        self.way_reaction(way, p_B, e.perp() * (sign * got.normal), sign * got.couple);
        s / r.norm()
    }

    #[inline(always)]
    fn force_prp(&mut self, ways: &[Way; 2], inner: &Inner) -> f64 {
        let p_C = self.bodies[ways[0].body].position(inner.pin);
        let d = [self.direction(&ways[0]), self.direction(&ways[1])];
        let (F_1, M_1) = self.load_about(ways[0].body, p_C);
        let (F_2, M_2) = self.load_about(ways[1].body, p_C);
        let got = prp::Prp::new(d[0], d[1]).reactions(F_1, M_1, F_2, M_2);
        self.reactions[inner.slot] = Reaction { force: got.f_C * inner.sign, couple: 0.0 };
        self.carried_way(&ways[0], p_C, d[0].perp() * got.normal_1, got.couple_1);
        self.carried_way(&ways[1], p_C, d[1].perp() * got.normal_2, got.couple_2);
        d[0].cross(d[1])
    }

    #[inline(always)]
    fn force_rpp(&mut self, outer: &Hinge, inner: &Way, way: &Way) -> f64 {
        let p_A = self.bodies[outer.body].position(outer.pin);
        let p_R = self.bodies[way.slider].position(way.point);
        let (d_1, d_2) = (self.direction(inner), self.direction(way));
        let (F_1, M_1) = self.load_about(outer.body, p_A);
        let (F_2, M_2) = self.load_about(way.body, p_R);
        let s_1 = (p_A - p_R).dot(d_1);
        let got = rpp::Rpp::new(d_1, d_2).reactions(s_1, F_1, M_1, F_2, M_2);
        self.hinge_reaction(outer, p_A, got.f_A);
        // the kernel gives the force of the first body on the second
        let sign = if inner.body == way.body { 1.0 } else { -1.0 };
        self.way_reaction(inner, p_A, d_1.perp() * (sign * got.normal_1), sign * got.couple_1);
        self.carried_way(way, p_R, d_2.perp() * got.normal_2, got.couple_2);
        d_1.cross(d_2)
    }

    /// The couple is put on the first guide: how it is shared is not determined, and is not reported.
    #[inline(always)]
    fn force_translation(&mut self, ways: &[Way; 2]) -> f64 {
        let p_R = self.bodies[ways[0].slider].position(ways[0].point);
        let d = [self.direction(&ways[0]), self.direction(&ways[1])];
        let (F, M) = self.load_about(ways[0].body, p_R);
        let got = pp::Pp::new(d[0], d[1]).reactions(F, M);
        self.carried_way(&ways[0], p_R, d[0].perp() * got.normal_1, got.couple);
        self.carried_way(&ways[1], p_R, d[1].perp() * got.normal_2, 0.0);
        d[0].cross(d[1])
    }
}
