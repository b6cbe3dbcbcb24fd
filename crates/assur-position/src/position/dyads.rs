//! The steps of motion of the dyads without a drive: each puts the two bodies of a group, from the closed forms in
//! [`crate::group`].

use super::kinematics::Shared;
use super::motion::{Branch2, Point, fixed, line, place, point, under};
use super::state::State;
use crate::group::rrr::Sides;
use crate::group::{pp, prp, rpp, rpr, rrp};
use crate::math::{Scalar, V2, Vec2};
use crate::plan::step::unit;
use crate::plan::{Anchor, Arm, ExactVec, Leg, MotionStep, Slide};

impl<S: Scalar> State<S> {
    #[cfg_attr(in_one, inline(always))]
    pub(super) fn rrr<const LEVEL: u8>(&mut self, branch: usize, legs: &[Leg; 2], sides: &Sides<f64>) {
        let [one, two] = legs;
        let a = point::<S, LEVEL>(&self.motion.bodies, &one.base);
        // written out twice: most often it is the ground, whose zeros then cost nothing
        if two.base.body == 0 {
            self.rrr_on::<LEVEL>(branch, legs, sides, a, fixed(two.base.at));
        } else {
            self.rrr_on::<LEVEL>(branch, legs, sides, a, point::<S, LEVEL>(&self.motion.bodies, &two.base));
        }
    }

    #[cfg_attr(in_one, inline(always))]
    fn rrr_on<const LEVEL: u8>(
        &mut self,
        branch: usize,
        legs: &[Leg; 2],
        sides: &Sides<f64>,
        a: Point<S>,
        b: Point<S>,
    ) {
        let [one, two] = legs;
        let sides = if S::EXTENDED { Sides::new(one.length(), two.length()) } else { sides.of() };
        let at = sides.position(a.p, b.p, S::of(self.branches[branch].root));
        self.motion.conditions[branch] = at.conditioning;
        self.closes(branch, at.closure, S::of(one.length + two.length));
        self.motion.shared[branch] = Shared { r_1: at.r_1, second: at.r_2, inverse: at.inverse };
        let u_1 = at.r_1.turned_back(one.turn());
        let u_2 = at.r_2.turned_back(two.turn());
        let (mut omega, mut alpha) = ((S::zero(), S::zero()), (S::zero(), S::zero()));
        if LEVEL > 0 {
            let group = at.group();
            omega = group.velocity(a.v, b.v);
            if LEVEL > 1 {
                alpha = group.acceleration(omega.0, omega.1, a.a, b.a);
            }
        }
        place::<S, LEVEL>(&mut self.motion.bodies[one.body], &one.pin, a, u_1, omega.0, alpha.0);
        place::<S, LEVEL>(&mut self.motion.bodies[two.body], &two.pin, b, u_2, omega.1, alpha.1);
    }

    #[cfg_attr(in_one, inline(always))]
    pub(super) fn rrp<const LEVEL: u8>(
        &mut self,
        branch: usize,
        leg: &Leg,
        slide: &Slide,
        pin: &Arm,
        from_point: ExactVec,
    ) {
        let Branch2 { root, side } = self.branch(branch, 0);
        let a = point::<S, LEVEL>(&self.motion.bodies, &leg.base);
        let guide = line(&self.motion.bodies, slide);
        let h = from_point.of::<S>().y + S::of(side * slide.radius);
        let at = rrp::position(a.p, leg.length(), guide.origin, guide.along, h, S::of(root));
        self.motion.conditions[branch] = at.conditioning;
        self.closes(branch, at.closure, leg.length());
        self.motion.shared[branch] = Shared { r_1: at.r_1, second: guide.along, inverse: at.inverse };
        let u_1 = at.r_1.turned_back(leg.turn());
        let (mut omega_1, mut alpha_1, mut s_dot, mut s_ddot) = (S::zero(), S::zero(), S::zero(), S::zero());
        if LEVEL > 0 {
            let g = under::<S, LEVEL>(&self.motion.bodies, slide.base, at.p_C);
            let group = rrp::Rrp { r_1: at.r_1, d: guide.along, inverse: at.inverse };
            (omega_1, s_dot) = group.velocity(a.v, g.v);
            if LEVEL > 1 {
                (alpha_1, s_ddot) =
                    group.acceleration(omega_1, s_dot, a.a, g.a, self.motion.bodies[slide.base].omega);
            }
        }
        place::<S, LEVEL>(&mut self.motion.bodies[leg.body], &leg.pin, a, u_1, omega_1, alpha_1);
        self.place_slider::<LEVEL>(slide, guide.along, pin, at.p_C, s_dot, s_ddot);
    }

    #[cfg_attr(in_one, inline(always))]
    pub(super) fn rpr<const LEVEL: u8>(&mut self, step: &MotionStep) {
        let MotionStep::Rpr { branch, bases, pins, slide, from_origin, from_point } = step else { return };
        let Branch2 { root, side } = self.branch(*branch, 0);
        let a = point::<S, LEVEL>(&self.motion.bodies, &bases[0]);
        let b = point::<S, LEVEL>(&self.motion.bodies, &bases[1]);
        let h = from_point.of::<S>().y + S::of(side * slide.radius) - from_origin.of::<S>().y;
        let at = rpr::position(a.p, b.p, h, S::of(root));
        self.motion.conditions[*branch] = at.conditioning;
        self.closes(*branch, at.closure, h.abs() + (b.p - a.p).norm());
        let u_1 = at.e.turned_back(unit(slide.along));
        let u_2 = at.e.turned_back(unit(slide.direction));
        let (mut omega, mut alpha) = (S::zero(), S::zero());
        if LEVEL > 0 {
            let group = rpr::Rpr::new(b.p - a.p, at.e, h, at.s);
            let (w, s_dot) = group.velocity(a.v, b.v);
            omega = w;
            if LEVEL > 1 {
                alpha = group.acceleration(w, s_dot, a.a, b.a).0;
            }
        }
        place::<S, LEVEL>(&mut self.motion.bodies[slide.base], &pins[0], a, u_1, omega, alpha);
        place::<S, LEVEL>(&mut self.motion.bodies[slide.body], &pins[1], b, u_2, omega, alpha);
    }

    #[cfg_attr(in_one, inline(always))]
    pub(super) fn prp<const LEVEL: u8>(
        &mut self,
        branch: usize,
        slides: &[Slide; 2],
        pins: &[Arm; 2],
        from_point: &[ExactVec; 2],
    ) {
        let sides = self.branches[branch].sides;
        let guides = [line(&self.motion.bodies, &slides[0]), line(&self.motion.bodies, &slides[1])];
        let h = [0, 1].map(|i| from_point[i].of::<S>().y + S::of(sides[i] * slides[i].radius));
        let group = prp::Prp::new(guides[0].along, guides[1].along);
        let at = group.position(guides[0].origin, h[0], guides[1].origin, h[1]);
        self.motion.conditions[branch] = at.conditioning;
        let (mut rate, mut second) = ((S::zero(), S::zero()), (S::zero(), S::zero()));
        if LEVEL > 0 {
            let bases = [&self.motion.bodies[slides[0].base], &self.motion.bodies[slides[1].base]];
            let g = [0, 1].map(|i| under::<S, LEVEL>(&self.motion.bodies, slides[i].base, at.p_C));
            rate = group.velocity(g[0].v, g[1].v);
            if LEVEL > 1 {
                second = group.acceleration(rate.0, g[0].a, bases[0].omega, rate.1, g[1].a, bases[1].omega);
            }
        }
        self.place_slider::<LEVEL>(&slides[0], guides[0].along, &pins[0], at.p_C, rate.0, second.0);
        self.place_slider::<LEVEL>(&slides[1], guides[1].along, &pins[1], at.p_C, rate.1, second.1);
    }

    #[inline(never)]
    pub(super) fn rpp<const LEVEL: u8>(
        &mut self,
        branch: usize,
        base: &Anchor,
        pin: &Arm,
        inner: &Slide,
        outer: &Slide,
    ) {
        let sides = self.branches[branch].sides;
        let a = point::<S, LEVEL>(&self.motion.bodies, base);
        let guide = line(&self.motion.bodies, outer);
        let d_1 = unit(inner.along).turned(guide.along.turned_back(unit(outer.direction)));
        let apart =
            |from: Vec2, to: Vec2, axis: Vec2| (V2::of(to) - V2::of(from)).turned_back(unit::<S>(axis)).y;
        let h_1 =
            apart(inner.point, pin.unwrap_or(Vec2::zero()), inner.direction) + S::of(sides[0] * inner.radius);
        let h_2 = apart(outer.point, inner.origin, outer.direction) + S::of(sides[1] * outer.radius);
        let group = rpp::Rpp::new(d_1, guide.along);
        let at = group.position(a.p, h_1, guide.origin, h_2);
        self.motion.conditions[branch] = at.conditioning;
        let carrier = self.motion.bodies[outer.base];
        let (mut rate, mut second) = ((S::zero(), S::zero()), (S::zero(), S::zero()));
        if LEVEL > 0 {
            let g = under::<S, LEVEL>(&self.motion.bodies, outer.base, a.p);
            rate = group.velocity(a.v, g.v);
            if LEVEL > 1 {
                second = group.acceleration(rate.0, rate.1, a.a, g.a, carrier.omega);
            }
        }
        self.place_slider::<LEVEL>(outer, guide.along, &Some(inner.origin), at.p_R, rate.1, second.1);
        let u_1 = d_1.turned_back(unit(inner.direction));
        place::<S, LEVEL>(&mut self.motion.bodies[inner.body], pin, a, u_1, carrier.omega, carrier.alpha);
    }

    #[inline(never)]
    pub(super) fn translation<const LEVEL: u8>(&mut self, branch: usize, slides: &[Slide; 2]) {
        let sides = self.branches[branch].sides;
        let guides = [line(&self.motion.bodies, &slides[0]), line(&self.motion.bodies, &slides[1])];
        let apart = V2::of(slides[0].point) - V2::of(slides[1].point);
        let from_second = apart.turned_back(unit::<S>(slides[1].direction));
        let h = [S::of(sides[0] * slides[0].radius), from_second.y + S::of(sides[1] * slides[1].radius)];
        let group = pp::Pp::new(guides[0].along, guides[1].along);
        let at = group.position(guides[0].origin, h[0], guides[1].origin, h[1]);
        self.motion.conditions[branch] = at.conditioning;
        let (mut rate, mut second) = ((S::zero(), S::zero()), (S::zero(), S::zero()));
        if LEVEL > 0 {
            let bases = [&self.motion.bodies[slides[0].base], &self.motion.bodies[slides[1].base]];
            let g = [0, 1].map(|i| under::<S, LEVEL>(&self.motion.bodies, slides[i].base, at.p_C));
            rate = group.velocity(g[0].v, g[1].v);
            if LEVEL > 1 {
                second = group.acceleration(rate.0, g[0].a, rate.1, g[1].a, bases[0].omega);
            }
        }
        self.place_slider::<LEVEL>(
            &slides[0],
            guides[0].along,
            &Some(slides[0].point),
            at.p_C,
            rate.0,
            second.0,
        );
    }
}
