//! Friction where the force in the inner hinge of a dyad is all that is unknown, and where nothing is.
//!
//! Dyads RRR and RRP: let f be the force of link 1 on link 2 at C; then f − F_1 acts on link 1 at A, and −f − F_2 on link 2
//! at B or in the guide (letters as in [`crate::group::rrr`] and [`crate::group::rrp`]). The friction torques on link 1 at
//! A, on link 2 at C and at B, w = s ρ each with its sense, are −w_A |f − F_1|, −w_C |f|, −w_B |f + F_2|; the force of
//! friction of a guide along d, normal n, is −w_B |n·(f + F_2)|. Two equations are left:
//!
//! ```text
//! link 1 about A:             M_1 − r_1 × f − w_A |f − F_1| + w_C |f| = 0,
//! RRR, link 2 about B:        M_2 + r_2 × f − w_B |f + F_2| − w_C |f| = 0,
//! RRP, body 2 along d:        d·F_2 + d·f − w_B |n·(f + F_2)| = 0.
//! ```
//!
//! A step of Newton's method puts e·v for |v|, e = v / |v| of the present value: the lines of action are taken as
//! parallel to the present ones and touch the friction circles. What is left then is linear in f. Its determinant over that
//! without friction is the determinant of all laws, which is positive as long as the mechanism does not lock.
//!
//! The hinge of a driven link, or the guide of a driven slider, presses with what the loads give, whatever its friction.

use super::friction::STEPS;
use super::state::{Reaction, State};
use crate::group::{rrp, rrr};
use crate::math::Vec2;
use crate::plan::{EffortLine, ForceStep, Hinge, Inner, Plan, Way};

/// Newton's method has settled when the error that its step leaves is this part of the forces.
const SETTLED: f64 = 1e-15;
/// A normal force below this part of the forces is none.
const NOTHING: f64 = 1e-12;

/// The two equations of a dyad: the first has p_1·f, the second q·f.
struct Dyad {
    /// perp(r_1).
    p_1: Vec2,
    /// perp(r_2) or d.
    q: Vec2,
    load_1: f64,
    load_2: f64,
    force_1: Vec2,
    force_2: Vec2,
    /// Weights s ρ at A, at C, at B or in the guide; at C with the sense of the torque on link 2.
    weights: [f64; 3],
    /// Normal of the guide.
    normal: Vec2,
}

/// The side of the guide that presses.
#[derive(Clone, Copy)]
enum Side {
    /// As the present value says.
    Present,
    /// As assumed.
    Given(f64),
}

/// Direction of a vector and the reciprocal of its magnitude; nothing for the null vector.
#[inline(always)]
fn direction(v: Vec2) -> (Vec2, f64) {
    let square = v.dot(v);
    let inverse = if square > 0.0 { 1.0 / square.sqrt() } else { 0.0 };
    (v * inverse, inverse)
}

impl Dyad {
    /// The force f, and the steps taken; `None` where the equations have no solution that is a motion.
    #[inline(always)]
    fn solve<const GUIDE: bool>(&self, start: Vec2, steps: &mut u32) -> Option<Vec2> {
        let found = self.newton::<GUIDE>(start, Side::Present, steps);
        if found.is_some() || !GUIDE {
            return found;
        }
        [1.0, -1.0].into_iter().find_map(|side| self.newton::<GUIDE>(start, Side::Given(side), steps))
    }

    #[inline(always)]
    fn newton<const GUIDE: bool>(&self, start: Vec2, side: Side, steps: &mut u32) -> Option<Vec2> {
        let [w_A, w_C, w_B] = self.weights;
        let upright = self.p_1.cross(self.q);
        let loads = self.force_1.dot(self.force_1) + self.force_2.dot(self.force_2);
        let mut f = start;
        for step in 1..=STEPS {
            let (e_A, inverse_A) = direction(f - self.force_1);
            let (e_C, inverse_C) = direction(f);
            let ahead = f + self.force_2;
            let (e_B, inverse_B) = if GUIDE {
                let sign = match side {
                    Side::Present => self.normal.dot(ahead).signum(),
                    Side::Given(sign) => sign,
                };
                (self.normal * sign, 0.0)
            } else {
                direction(ahead)
            };
            let row_1 = self.p_1 + e_A * w_A - e_C * w_C;
            let right_1 = self.load_1 + w_A * e_A.dot(self.force_1);
            let pull_2 = self.q - e_B * w_B;
            let row_2 = if GUIDE { pull_2 } else { pull_2 - e_C * w_C };
            let right_2 = w_B * e_B.dot(self.force_2) - self.load_2;
            let determinant = row_1.cross(row_2);
            let inverse = 1.0 / determinant;
            let next = Vec2::new(
                (right_1 * row_2.y - right_2 * row_1.y) * inverse,
                (right_2 * row_1.x - right_1 * row_2.x) * inverse,
            );
            if determinant == 0.0 || !inverse.is_finite() {
                *steps += step;
                return None;
            }
            let change = next - f;
            f = next;
            // e·v falls short of |v| by at most the square of what is across, over 2 |v|
            let square = change.dot(change);
            let curved_C = w_C.abs() * inverse_C;
            let left_1 = (w_A.abs() * inverse_A + curved_C) * square;
            let left_2 = if GUIDE { 0.0 } else { (w_B.abs() * inverse_B + curved_C) * square };
            let scale = SETTLED * SETTLED * (f.dot(f) + loads);
            let curved =
                left_1 * left_1 <= scale * row_1.dot(row_1) && left_2 * left_2 <= scale * row_2.dot(row_2);
            // the side that was taken is the side that presses, or nothing presses
            let pressed = e_B.dot(f + self.force_2);
            let kept =
                !GUIDE || pressed >= 0.0 || pressed * pressed <= NOTHING * NOTHING * (f.dot(f) + loads);
            if curved && (kept || matches!(side, Side::Given(_))) {
                *steps += step;
                return (kept && determinant * upright > 0.0).then_some(f);
            }
        }
        *steps += STEPS;
        None
    }
}

impl State {
    /// A group whose [`crate::plan::RubbingGroup::reduced`] holds. Returns the condition figure of its plain step and Newton's steps;
    /// `None` where there is no motion.
    #[inline(always)]
    pub(super) fn force_reduced(
        &mut self,
        plan: &Plan,
        plain: &ForceStep,
        elements: &[Option<usize>; 3],
        steps: &mut u32,
    ) -> Option<f64> {
        match plain {
            ForceStep::Rrr { outer, inner, scale } => {
                self.rubbing_rrr(plan, outer, inner, elements, steps).map(|d| d * scale)
            }
            ForceStep::Rrp { outer, inner, way, scale } => {
                self.rubbing_rrp(plan, (outer, inner, way), elements, steps).map(|d| d * scale)
            }
            ForceStep::Turn { hinge, effort: EffortLine::Torque { base, .. }, value } => {
                let p = self.bodies[hinge.body].position(hinge.pin);
                let (force, moment) = self.load_about(hinge.body, p);
                let friction = -self.weight(plan, elements[0]) * force.norm();
                let all = moment + friction;
                self.efforts[value.0] = -all * value.1;
                self.wrenches[*base].moment += all;
                self.rubbing_hinge(hinge, p, -force, friction);
                self.keep_friction(elements[0], friction);
                Some(1.0)
            }
            ForceStep::Shift { way, effort: EffortLine::Along(_), value } => {
                let d = self.direction(way);
                let p = self.bodies[way.slider].position(way.point);
                let (force, moment) = self.load_about(way.body, p);
                let normal = -force.dot(d.perp());
                let friction = -self.weight(plan, elements[0]) * normal.abs();
                self.efforts[value.0] = (-force.dot(d) - friction) * value.1;
                self.reactions[way.slot] = Reaction { force: d.perp() * normal, couple: -moment };
                self.carry(way.base, p, -force, -moment);
                self.keep_friction(elements[0], friction);
                Some(1.0)
            }
            _ => None,
        }
    }

    /// Sense times radius or coefficient; nothing where there is no friction.
    #[inline(always)]
    fn weight(&self, plan: &Plan, element: Option<usize>) -> f64 {
        element.map_or(0.0, |e| self.senses[e] * plan.friction[e].kind.factor())
    }

    #[inline(always)]
    fn keep_friction(&mut self, element: Option<usize>, effort: f64) {
        if let Some(element) = element {
            self.frictions[element] = effort;
        }
    }

    /// The reaction of a hinge with its friction torque, passed on.
    #[inline(always)]
    fn rubbing_hinge(&mut self, hinge: &Hinge, p: Vec2, force: Vec2, friction: f64) {
        self.reactions[hinge.slot] = Reaction { force, couple: 0.0 };
        self.carry(hinge.base, p, force, friction);
    }

    #[inline(always)]
    fn rubbing_rrr(
        &mut self,
        plan: &Plan,
        [one, two]: &[Hinge; 2],
        inner: &Inner,
        elements: &[Option<usize>; 3],
        steps: &mut u32,
    ) -> Option<f64> {
        let (body_1, body_2) = (&self.bodies[one.body], &self.bodies[two.body]);
        let (p_A, p_B) = (body_1.position(one.pin), body_2.position(two.pin));
        let r_1 = (inner.pin - one.pin).turned(body_1.u);
        let r_2 = (inner.second_pin - two.pin).turned(body_2.u);
        let (F_1, M_1) = self.load_about(one.body, p_A);
        let (F_2, M_2) = self.load_about(two.body, p_B);
        let [w_A, w_C, w_B] = elements.map(|e| self.weight(plan, e));
        let dyad = Dyad {
            p_1: r_1.perp(),
            q: r_2.perp(),
            load_1: M_1,
            load_2: M_2,
            force_1: F_1,
            force_2: F_2,
            weights: [w_A, w_C * inner.sign, w_B],
            normal: Vec2::zero(),
        };
        let start = rrr::Rrr::new(r_1, r_2).reactions(F_1, M_1, F_2, M_2).f_C;
        let f = dyad.solve::<false>(start, steps)?;
        let (f_A, f_B) = (f - F_1, -f - F_2);
        let frictions = [-w_A * f_A.norm(), -w_C * f.norm(), -w_B * f_B.norm()];
        elements.iter().zip(frictions).for_each(|(e, x)| self.keep_friction(*e, x));
        self.rubbing_hinge(one, p_A, f_A, frictions[0]);
        self.rubbing_hinge(two, p_B, f_B, frictions[2]);
        self.reactions[inner.slot] = Reaction { force: f * inner.sign, couple: 0.0 };
        Some(r_1.cross(r_2))
    }

    #[inline(always)]
    fn rubbing_rrp(
        &mut self,
        plan: &Plan,
        (outer, inner, way): (&Hinge, &Inner, &Way),
        elements: &[Option<usize>; 3],
        steps: &mut u32,
    ) -> Option<f64> {
        let body_1 = &self.bodies[outer.body];
        let p_A = body_1.position(outer.pin);
        let r_1 = (inner.pin - outer.pin).turned(body_1.u);
        let p_C = p_A + r_1;
        let (d, p) = (self.direction(way), self.bodies[way.slider].position(way.point));
        let n = d.perp();
        let (F_1, M_1) = self.load_about(outer.body, p_A);
        let (F_2, M_2) = self.load_about(way.body, p);
        let [w_A, w_C, w_B] = elements.map(|e| self.weight(plan, e));
        let dyad = Dyad {
            p_1: r_1.perp(),
            q: d,
            load_1: M_1,
            load_2: F_2.dot(d),
            force_1: F_1,
            force_2: F_2,
            weights: [w_A, w_C * inner.sign, w_B],
            normal: n,
        };
        let start = rrp::Rrp::new(r_1, d).reactions(F_1, M_1, F_2, 0.0).f_C;
        let f = dyad.solve::<true>(start, steps)?;
        let f_A = f - F_1;
        let normal = -n.dot(f + F_2);
        let frictions = [-w_A * f_A.norm(), -w_C * f.norm(), -w_B * normal.abs()];
        elements.iter().zip(frictions).for_each(|(e, x)| self.keep_friction(*e, x));
        self.rubbing_hinge(outer, p_A, f_A, frictions[0]);
        self.reactions[inner.slot] = Reaction { force: f * inner.sign, couple: 0.0 };
        // about the guide's reference point, through which its friction passes
        let couple = -M_2 - (p_C - p).cross(f) - frictions[1] * inner.sign;
        self.reactions[way.slot] = Reaction { force: n * normal, couple };
        self.carry(way.base, p, n * normal + d * frictions[2], couple);
        Some(r_1.dot(d))
    }
}
