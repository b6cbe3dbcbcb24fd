//! Dyads whose links hold a driven joint, such as a boom on a hydraulic cylinder.
//!
//! At one instant such a link is a stiff one from its outer revolute A to the inner one C, with the arm w(t) in the frame
//! of its first body. C moves in that frame by ẇ and ẅ, so that with r = w turned into ground axes
//!
//! ```text
//! v_C = v_A + ω × r + ẇ,    a_C = a_A + α × r − ω² r + 2 ω × ẇ + ẅ:
//! ```
//!
//! the equations of the dyad, with v_A + ẇ in place of v_A and a_A + 2 ω × ẇ + ẅ in place of a_A.

use super::motion::{Branch2, Point, line, place, point, under};
use super::state::State;
use crate::group::{rrp, rrr};
use crate::math::{Scalar, V2};
use crate::plan::step::unit;
use crate::plan::{self, DrivenJoint, DrivenLeg, DrivenPart, ExactVec, Hinge, Inner, OuterJoint, Slide};

/// The arm of a leg in the frame of its first body, with its derivatives.
struct Arm<S> {
    w: V2<S>,
    rate: V2<S>,
    second: V2<S>,
}

/// The outer revolute of a leg, moved on by what the driven joint adds in ground axes.
#[inline(always)]
fn drifted<S: Scalar, const LEVEL: u8>(a: Point<S>, arm: &Arm<S>, u: V2<S>, omega: S) -> Point<S> {
    let mut moved = a;
    if LEVEL > 0 {
        let rate = arm.rate.turned(u);
        moved.v += rate;
        moved.a += rate.perp() * (S::of(2.0) * omega) + arm.second.turned(u);
    }
    moved
}

impl<S: Scalar> State<S> {
    #[inline(always)]
    fn arm(&self, leg: &DrivenLeg) -> Arm<S> {
        match &leg.joint {
            None => Arm { w: leg.arm.of(), rate: V2::zero(), second: V2::zero() },
            Some(DrivenJoint::Shift { slide, drive }) => {
                let input = self.motion.inputs[*drive];
                let along = unit::<S>(slide.along) * S::of(slide.sense);
                Arm {
                    w: leg.arm.of::<S>() + along * input.value,
                    rate: along * input.rate,
                    second: along * input.acceleration,
                }
            }
            Some(DrivenJoint::Turn { arm, drive, sign, .. }) => {
                let input = self.motion.inputs[*drive];
                let sign = S::of(*sign);
                let r = arm.of::<S>().turned(V2::new(input.place.x, sign * input.place.y));
                Arm {
                    w: leg.arm.of::<S>() + r,
                    rate: r.perp() * (sign * input.rate),
                    second: r.perp() * (sign * input.acceleration) - r * (input.rate * input.rate),
                }
            }
        }
    }

    /// The length of a leg, m.
    #[inline(always)]
    pub fn leg_length(&self, leg: &DrivenLeg) -> S {
        self.arm(leg).w.norm()
    }

    /// Places the body after a driven joint.
    #[inline(never)]
    fn follow<const LEVEL: u8>(&mut self, leg: &DrivenLeg) {
        match &leg.joint {
            None => {}
            Some(DrivenJoint::Shift { slide, drive }) => self.shift::<LEVEL>(slide, *drive),
            Some(DrivenJoint::Turn { base, body, pin, drive, sign, .. }) => {
                self.turn::<LEVEL>(*body, base, pin, *drive, (true, *sign, None));
            }
        }
    }

    #[inline(never)]
    pub(super) fn driven_rrr<const LEVEL: u8>(&mut self, branch: usize, legs: &[DrivenLeg; 2]) {
        let ends = [0, 1].map(|i| point::<S, LEVEL>(&self.motion.bodies, &legs[i].base));
        let arms = [self.arm(&legs[0]), self.arm(&legs[1])];
        let lengths = [arms[0].w.norm(), arms[1].w.norm()];
        let at =
            rrr::position(ends[0].p, ends[1].p, lengths[0], lengths[1], S::of(self.branches[branch].root));
        self.closes(branch, at.closure, lengths[0] + lengths[1]);
        let r = [at.r_1, at.r_2];
        let u = [0, 1].map(|i| r[i].turned_back(arms[i].w) / (lengths[i] * lengths[i]));
        let (mut omega, mut alpha) = ((S::zero(), S::zero()), (S::zero(), S::zero()));
        if LEVEL > 0 {
            let group = rrr::Rrr::new(at.r_1, at.r_2);
            let still = [0, 1].map(|i| drifted::<S, LEVEL>(ends[i], &arms[i], u[i], S::zero()));
            omega = group.velocity(still[0].v, still[1].v);
            if LEVEL > 1 {
                let a_1 = drifted::<S, LEVEL>(ends[0], &arms[0], u[0], omega.0).a;
                let a_2 = drifted::<S, LEVEL>(ends[1], &arms[1], u[1], omega.1).a;
                alpha = group.acceleration(omega.0, omega.1, a_1, a_2);
            }
        }
        place::<S, LEVEL>(
            &mut self.motion.bodies[legs[0].body],
            &legs[0].pin,
            ends[0],
            u[0],
            omega.0,
            alpha.0,
        );
        place::<S, LEVEL>(
            &mut self.motion.bodies[legs[1].body],
            &legs[1].pin,
            ends[1],
            u[1],
            omega.1,
            alpha.1,
        );
        self.follow::<LEVEL>(&legs[0]);
        self.follow::<LEVEL>(&legs[1]);
        self.motion.conditions[branch] = at.conditioning;
    }

    #[inline(never)]
    pub(super) fn driven_rrp<const LEVEL: u8>(
        &mut self,
        branch: usize,
        leg: &DrivenLeg,
        slide: &Slide,
        pin: &plan::Arm,
        from_point: ExactVec,
    ) {
        let Branch2 { root, .. } = self.branch(branch, 0);
        let a = point::<S, LEVEL>(&self.motion.bodies, &leg.base);
        let guide = line(&self.motion.bodies, slide);
        let arm = self.arm(leg);
        let length = arm.w.norm();
        let at = rrp::position(a.p, length, guide.origin, guide.along, from_point.of::<S>().y, S::of(root));
        self.closes(branch, at.closure, length);
        let u = at.r_1.turned_back(arm.w) / (length * length);
        let (mut omega, mut alpha, mut s_dot, mut s_ddot) = (S::zero(), S::zero(), S::zero(), S::zero());
        if LEVEL > 0 {
            let g = under::<S, LEVEL>(&self.motion.bodies, slide.base, at.p_C);
            let group = rrp::Rrp::new(at.r_1, guide.along);
            (omega, s_dot) = group.velocity(drifted::<S, LEVEL>(a, &arm, u, S::zero()).v, g.v);
            if LEVEL > 1 {
                let a_A = drifted::<S, LEVEL>(a, &arm, u, omega).a;
                (alpha, s_ddot) =
                    group.acceleration(omega, s_dot, a_A, g.a, self.motion.bodies[slide.base].omega);
            }
        }
        place::<S, LEVEL>(&mut self.motion.bodies[leg.body], &leg.pin, a, u, omega, alpha);
        self.place_slider::<LEVEL>(slide, guide.along, pin, at.p_C, s_dot, s_ddot);
        self.follow::<LEVEL>(leg);
        self.motion.conditions[branch] = at.conditioning;
    }

    /// Loads on a link of one or two bodies about a place.
    #[inline(always)]
    fn link_load(&self, root: usize, end: usize, p: V2<S>) -> (V2<S>, S) {
        let (mut force, mut moment) = self.load_about(root, p);
        if end != root {
            let (f, m) = self.load_about(end, p);
            force += f;
            moment = moment + m;
        }
        (force, moment)
    }

    #[inline(never)]
    pub(super) fn force_driven_legs(
        &mut self,
        (first, second): &(Hinge, OuterJoint),
        inner: &Inner,
        ends: [usize; 2],
        driven: &[Option<DrivenPart>; 2],
    ) -> S {
        let p_A = self.motion.bodies[first.body].pin(&first.pin).0;
        let p_C = self.motion.bodies[ends[0]].position(inner.pin);
        let r_1 = p_C - p_A;
        let (F_1, M_1) = self.link_load(first.body, ends[0], p_A);
        let (f_C, conditioning) = match second {
            OuterJoint::Hinge(hinge) => {
                let p_B = self.motion.bodies[hinge.body].pin(&hinge.pin).0;
                let r_2 = p_C - p_B;
                let (F_2, M_2) = self.link_load(hinge.body, ends[1], p_B);
                let got = rrr::Rrr::new(r_1, r_2).reactions(F_1, M_1, F_2, M_2);
                self.hinge_reaction(first, p_A, got.f_A);
                self.hinge_reaction(hinge, p_B, got.f_B);
                (got.f_C, r_1.cross(r_2) / (r_1.norm() * r_2.norm()))
            }
            OuterJoint::Guide(guide) => {
                let d = self.direction(guide);
                let (F_2, M_2) = self.load_about(guide.body, p_C);
                let got = rrp::Rrp::new(r_1, d).reactions(F_1, M_1, F_2, M_2);
                self.hinge_reaction(first, p_A, got.f_A);
                self.carried_way(guide, p_C, d.perp() * got.normal, got.couple);
                (got.f_C, r_1.dot(d) / r_1.norm())
            }
        };
        self.forces.reactions[inner.slot].force = f_C * S::of(inner.sign);
        self.load(ends[0], p_C, -f_C);
        self.load(ends[1], p_C, f_C);
        for part in driven.iter().flatten() {
            match &part.joint {
                OuterJoint::Hinge(hinge) => self.force_turn(hinge, &part.effort, part.value),
                OuterJoint::Guide(guide) => self.force_shift(guide, &part.effort, part.value),
            };
        }
        conditioning
    }

    /// Adds a force at a place to what a body carries.
    #[inline(always)]
    fn load(&mut self, body: usize, p: V2<S>, force: V2<S>) {
        self.carry(body, p, -force);
    }
}
