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
//! without friction is the determinant of all laws, which is positive as long as the mechanism does not lock. With more
//! friction the forces grow beyond all bounds and, in the formulas, come back reversed with a negative determinant: e is
//! therefore taken in the sense that it has without friction, so that the method converges on either side of the limit and
//! tells which it is. Where some of the forces turn round and others do not, e is that of the present force.
//!
//! The hinge of a driven link, or the guide of a driven slider, presses with what the loads give, whatever its friction.

use super::friction::STEPS;
use super::friction_steps::FrictionLog;
use super::state::State;
use super::wrench::Reaction;
use crate::group::{rrp, rrr};
use crate::math::Vec2;
use crate::plan::{EffortLine, ForceStep, Guide, Hinge, Inner, Plan};
use assur_math::math::ROUNDING;

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
    /// Newton's method has settled when the error that its step leaves is this part of the forces.
    settled: f64,
}

/// In which sense the lines of action are taken where the force turns round.
#[derive(Clone, Copy)]
enum Sense {
    /// As without friction: a force beyond infinity comes back reversed.
    Kept,
    Present,
    /// As at present, with the guide pressing on one side.
    OneSide(f64),
}

/// What Newton's method came to.
enum Found {
    /// The force f of a motion.
    Motion(Vec2),
    /// All forces have passed infinity.
    Locked,
    Nothing,
}

/// Direction of a vector, in the sense of `like`, and the reciprocal of its magnitude; nothing for the null vector.
#[inline(always)]
fn direction<const KEPT: bool>(v: Vec2, like: Vec2) -> (Vec2, f64) {
    let square = v.dot(v);
    let inverse = if square > 0.0 { 1.0 / square.sqrt() } else { 0.0 };
    (v * if KEPT { inverse.copysign(v.dot(like)) } else { inverse }, inverse)
}

impl Dyad {
    /// What presses at A, at C, at B or in the guide.
    fn presses<const GUIDE: bool>(&self, f: Vec2) -> Vec<f64> {
        let last = f + self.force_2;
        let last = if GUIDE { self.normal.dot(last).abs() } else { last.norm() };
        vec![(f - self.force_1).norm(), f.norm(), last]
    }

    /// The force f; `None` where the equations have no solution that is a motion.
    #[inline(always)]
    fn solve<const GUIDE: bool>(
        &self,
        start: Vec2,
        steps: &mut u32,
        watch: &mut impl FrictionLog,
    ) -> Option<Vec2> {
        match self.newton::<GUIDE, true>(start, Sense::Kept, steps, watch) {
            Found::Motion(f) => Some(f),
            Found::Locked => None,
            Found::Nothing => self.try_others::<GUIDE>(start, steps, watch),
        }
    }

    /// Where a force turns round on the way without passing infinity.
    #[cold]
    #[inline(never)]
    fn try_others<const GUIDE: bool>(
        &self,
        start: Vec2,
        steps: &mut u32,
        watch: &mut impl FrictionLog,
    ) -> Option<Vec2> {
        let senses = [Sense::Present, Sense::OneSide(1.0), Sense::OneSide(-1.0)];
        let tried = if GUIDE { &senses[..] } else { &senses[..1] };
        tried.iter().find_map(|sense| match self.newton::<GUIDE, false>(start, *sense, steps, watch) {
            Found::Motion(f) => Some(f),
            Found::Locked | Found::Nothing => None,
        })
    }

    #[inline(always)]
    fn newton<const GUIDE: bool, const KEPT: bool>(
        &self,
        start: Vec2,
        sense: Sense,
        steps: &mut u32,
        watch: &mut impl FrictionLog,
    ) -> Found {
        let [w_A, w_C, w_B] = self.weights;
        let upright = self.p_1.cross(self.q);
        let loads = self.force_1.dot(self.force_1) + self.force_2.dot(self.force_2);
        let (start_A, start_B) = (start - self.force_1, start + self.force_2);
        let start_side = self.normal.dot(start_B).signum();
        let mut f = start;
        watch.begin(|| self.presses::<GUIDE>(f));
        for _ in 0..STEPS {
            let (e_A, inverse_A) = direction::<KEPT>(f - self.force_1, start_A);
            let (e_C, inverse_C) = direction::<KEPT>(f, start);
            let (e_B, inverse_B) = if GUIDE {
                let side = match sense {
                    Sense::Kept => start_side,
                    Sense::Present => self.normal.dot(f + self.force_2).signum(),
                    Sense::OneSide(side) => side,
                };
                (self.normal * side, 0.0)
            } else {
                direction::<KEPT>(f + self.force_2, start_B)
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
            *steps += 1;
            if !inverse.is_finite() {
                return Found::Nothing;
            }
            let change = next - f;
            f = next;
            watch.step(|| self.presses::<GUIDE>(f));
            // e·v falls short of |v| by the square of what is across e, over 2 |v|
            let across = |w: f64, e: Vec2, inverse: f64| {
                let across = e.cross(change);
                w.abs() * inverse * (across * across)
            };
            let middle = across(w_C, e_C, inverse_C);
            let left_1 = across(w_A, e_A, inverse_A) + middle;
            let left_2 = if GUIDE { 0.0 } else { across(w_B, e_B, inverse_B) + middle };
            let square = f.dot(f) + loads;
            let least = self.settled * self.settled * square;
            if left_1 * left_1 <= least * row_1.dot(row_1) && left_2 * left_2 <= least * row_2.dot(row_2) {
                let pressed = |w: f64, e: Vec2, v: Vec2| {
                    let along = w.abs() * e.dot(v);
                    if along * along <= ROUNDING * ROUNDING * (w * w) * square { 0.0 } else { along }
                };
                let forces = [
                    pressed(w_A, e_A, f - self.force_1),
                    pressed(w_C, e_C, f),
                    pressed(w_B, e_B, f + self.force_2),
                ];
                if determinant * upright > 0.0 && forces.iter().all(|x| *x >= 0.0) {
                    return Found::Motion(f);
                }
                if determinant * upright < 0.0 && forces.iter().all(|x| *x <= 0.0) {
                    return Found::Locked;
                }
                if !matches!(sense, Sense::Present) {
                    return Found::Nothing;
                }
            }
        }
        Found::Nothing
    }
}

impl State {
    /// A group whose [`crate::plan::FrictionGroup::reduced`] holds. Returns the condition figure of its plain step and Newton's steps;
    /// `None` where there is no motion.
    #[inline(always)]
    pub(super) fn force_reduced(
        &mut self,
        plan: &Plan,
        plain: &ForceStep,
        elements: &[Option<usize>; 3],
        (steps, watch): (&mut u32, &mut impl FrictionLog),
    ) -> Option<f64> {
        match plain {
            ForceStep::Rrr { outer, inner, motion } => {
                let dyad = self.dyad_rrr(outer, inner, *motion);
                self.rubbing_rrr(plan, dyad, (outer, inner), elements, (steps, watch))
            }
            ForceStep::Rrp { outer, inner, guide, motion } => {
                let dyad = self.dyad_rrp(outer, inner, guide, *motion);
                self.rubbing_rrp(plan, dyad, (outer, inner, guide), elements, (steps, watch))
            }
            ForceStep::Turn { hinge, effort: EffortLine::Torque { base, .. }, value } => {
                let (p, force, moment) = self.load_at(hinge.body, &hinge.pin);
                let friction = -self.weight(plan, elements[0]) * force.norm();
                let all = moment + friction;
                self.forces.efforts[value.0] = -all * value.1;
                self.forces.wrenches[*base].moment += all;
                self.rubbing_hinge(hinge, p, -force, friction);
                self.keep_friction(elements[0], friction);
                Some(1.0)
            }
            ForceStep::Shift { guide, effort: EffortLine::Along(_), value } => {
                let d = self.direction(guide);
                let p = self.motion.bodies[guide.slider].position(guide.point);
                let (force, moment) = self.load_about(guide.body, p);
                let normal = -force.dot(d.perp());
                let friction = -self.weight(plan, elements[0]) * normal.abs();
                self.forces.efforts[value.0] = (-force.dot(d) - friction) * value.1;
                self.forces.reactions[guide.slot] = Reaction { force: d.perp() * normal, couple: -moment };
                self.carry_wrench(guide.base, p, -force, -moment);
                self.keep_friction(elements[0], friction);
                Some(1.0)
            }
            _ => None,
        }
    }

    /// Sense times radius or coefficient; nothing where there is no friction.
    #[inline(always)]
    fn weight(&self, plan: &Plan, element: Option<usize>) -> f64 {
        element.map_or(0.0, |e| self.forces.senses[e] * plan.friction[e].kind.factor())
    }

    #[inline(always)]
    fn keep_friction(&mut self, element: Option<usize>, effort: f64) {
        if let Some(element) = element {
            self.forces.frictions[element] = effort;
        }
    }

    /// The reaction of a hinge with its friction torque, passed on.
    #[inline(always)]
    fn rubbing_hinge(&mut self, hinge: &Hinge, p: Vec2, force: Vec2, friction: f64) {
        self.forces.reactions[hinge.slot] = Reaction { force, couple: 0.0 };
        self.carry_wrench(hinge.base, p, force, friction);
    }

    #[inline(always)]
    fn rubbing_rrr(
        &mut self,
        plan: &Plan,
        (group, conditioning): (rrr::Rrr<f64>, f64),
        ([one, two], inner): (&[Hinge; 2], &Inner),
        elements: &[Option<usize>; 3],
        (steps, watch): (&mut u32, &mut impl FrictionLog),
    ) -> Option<f64> {
        let (p_A, F_1, M_1) = self.load_at(one.body, &one.pin);
        let (p_B, F_2, M_2) = self.load_at(two.body, &two.pin);
        let [w_A, w_C, w_B] = elements.map(|e| self.weight(plan, e));
        let dyad = Dyad {
            p_1: group.r_1.perp(),
            q: group.r_2.perp(),
            load_1: M_1,
            load_2: M_2,
            force_1: F_1,
            force_2: F_2,
            weights: [w_A, w_C * inner.sign, w_B],
            normal: Vec2::zero(),
            settled: plan.settings.friction,
        };
        let start = group.reactions(F_1, M_1, F_2, M_2).f_C;
        let f = dyad.solve::<false>(start, steps, watch)?;
        let (f_A, f_B) = (f - F_1, -f - F_2);
        let frictions = [-w_A * f_A.norm(), -w_C * f.norm(), -w_B * f_B.norm()];
        elements.iter().zip(frictions).for_each(|(e, x)| self.keep_friction(*e, x));
        self.rubbing_hinge(one, p_A, f_A, frictions[0]);
        self.rubbing_hinge(two, p_B, f_B, frictions[2]);
        self.forces.reactions[inner.slot] = Reaction { force: f * inner.sign, couple: 0.0 };
        Some(conditioning)
    }

    #[inline(always)]
    fn rubbing_rrp(
        &mut self,
        plan: &Plan,
        (group, conditioning): (rrp::Rrp<f64>, f64),
        (outer, inner, guide): (&Hinge, &Inner, &Guide),
        elements: &[Option<usize>; 3],
        (steps, watch): (&mut u32, &mut impl FrictionLog),
    ) -> Option<f64> {
        let (p_A, F_1, M_1) = self.load_at(outer.body, &outer.pin);
        let p_C = p_A + group.r_1;
        let (d, p) = (group.d, self.motion.bodies[guide.slider].position(guide.point));
        let n = d.perp();
        let (F_2, M_2) = self.load_about(guide.body, p);
        let [w_A, w_C, w_B] = elements.map(|e| self.weight(plan, e));
        let dyad = Dyad {
            p_1: group.r_1.perp(),
            q: d,
            load_1: M_1,
            load_2: F_2.dot(d),
            force_1: F_1,
            force_2: F_2,
            weights: [w_A, w_C * inner.sign, w_B],
            normal: n,
            settled: plan.settings.friction,
        };
        let start = group.reactions(F_1, M_1, F_2, 0.0).f_C;
        let f = dyad.solve::<true>(start, steps, watch)?;
        let f_A = f - F_1;
        let normal = -n.dot(f + F_2);
        let frictions = [-w_A * f_A.norm(), -w_C * f.norm(), -w_B * normal.abs()];
        elements.iter().zip(frictions).for_each(|(e, x)| self.keep_friction(*e, x));
        self.rubbing_hinge(outer, p_A, f_A, frictions[0]);
        self.forces.reactions[inner.slot] = Reaction { force: f * inner.sign, couple: 0.0 };
        // about the guide's reference point, through which its friction passes
        let couple = -M_2 - (p_C - p).cross(f) - frictions[1] * inner.sign;
        self.forces.reactions[guide.slot] = Reaction { force: n * normal, couple };
        self.carry_wrench(guide.base, p, n * normal + d * frictions[2], couple);
        Some(conditioning)
    }
}
