//! Runs the steps of motion: positions and, as far as the plan follows motion, velocities and accelerations.
//!
//! `LEVEL` is 0 for positions, 1 with velocities, 2 with accelerations: what is not followed is not compiled in.

use super::state::{BodyState, State};
use crate::group::{pp, prp, rpp, rpr, rrp, rrr};
use crate::math::Vec2;
use crate::plan::{Anchor, Leg, MotionStep, Plan, Slide};

/// Rounding alone may leave a group at a dead centre this much short of closing, relative to its lengths.
const CLOSURE: f64 = 16.0 * f64::EPSILON;

/// Position, velocity and acceleration of a point.
#[derive(Clone, Copy)]
pub(super) struct Point {
    pub p: Vec2,
    pub v: Vec2,
    pub a: Vec2,
}

/// A line on a body of known motion at one position.
#[derive(Clone, Copy)]
pub(super) struct Line {
    pub origin: Vec2,
    pub along: Vec2,
}

#[inline(always)]
pub(super) fn point<const LEVEL: u8>(bodies: &[BodyState], anchor: &Anchor) -> Point {
    // most outer joints sit on the ground, which does not move
    if anchor.body == 0 {
        return Point { p: anchor.at, v: Vec2::new(0.0, 0.0), a: Vec2::new(0.0, 0.0) };
    }
    let body = &bodies[anchor.body];
    let r = anchor.at.turned(body.u);
    let v = if LEVEL > 0 { body.v + r.perp() * body.omega } else { Vec2::new(0.0, 0.0) };
    let a = if LEVEL > 1 {
        body.a + r.perp() * body.alpha - r * (body.omega * body.omega)
    } else {
        Vec2::new(0.0, 0.0)
    };
    Point { p: body.p + r, v, a }
}

/// Velocity and acceleration of the point of a body that lies at `p` now.
#[inline(always)]
pub(super) fn under<const LEVEL: u8>(body: &BodyState, p: Vec2) -> Point {
    let r = p - body.p;
    let v = if LEVEL > 0 { body.v + r.perp() * body.omega } else { Vec2::new(0.0, 0.0) };
    let a = if LEVEL > 1 {
        body.a + r.perp() * body.alpha - r * (body.omega * body.omega)
    } else {
        Vec2::new(0.0, 0.0)
    };
    Point { p, v, a }
}

#[inline(always)]
pub(super) fn line(bodies: &[BodyState], slide: &Slide) -> Line {
    if slide.base == 0 {
        return Line { origin: slide.origin, along: slide.along };
    }
    let base = &bodies[slide.base];
    Line { origin: base.position(slide.origin), along: slide.along.turned(base.u) }
}

/// Puts a body so that its point `at` moves as given, at direction `u`, angular velocity and acceleration as given.
#[inline(always)]
pub(super) fn place<const LEVEL: u8>(
    body: &mut BodyState,
    at: Vec2,
    point: Point,
    u: Vec2,
    omega: f64,
    alpha: f64,
) {
    let r = at.turned(u);
    body.p = point.p - r;
    body.u = u;
    if LEVEL > 0 {
        body.omega = omega;
        body.v = point.v - r.perp() * omega;
    }
    if LEVEL > 1 {
        body.alpha = alpha;
        body.a = point.a - r.perp() * alpha + r * (omega * omega);
    }
}

/// Moves a point over a body: velocity and acceleration relative to it along `d`, and Coriolis.
#[inline(always)]
fn slid<const LEVEL: u8>(base: &BodyState, under: Point, d: Vec2, s_dot: f64, s_ddot: f64) -> Point {
    let v = if LEVEL > 0 { under.v + d * s_dot } else { under.v };
    let a = if LEVEL > 1 { under.a + d * s_ddot + d.perp() * (2.0 * base.omega * s_dot) } else { under.a };
    Point { p: under.p, v, a }
}

impl State {
    /// Puts the bodies that are driven at a point where the drives say.
    pub fn start(&mut self, plan: &Plan) {
        self.open = None;
        for &(body, at, drive) in &plan.outer {
            let input = self.inputs[drive];
            let point = Point { p: input.place, v: input.velocity, a: input.point_acceleration };
            place::<2>(&mut self.bodies[body], at, point, Vec2::new(1.0, 0.0), 0.0, 0.0);
        }
    }

    /// Whether a step has a second assembly of the other root.
    #[must_use]
    pub fn has_two_roots(&self, step: &MotionStep) -> bool {
        matches!(
            step,
            MotionStep::Rrr { .. }
                | MotionStep::Rrp { .. }
                | MotionStep::Rpr { .. }
                | MotionStep::DrivenRrr { .. }
                | MotionStep::DrivenRrp { .. }
        )
    }

    /// Runs all steps of motion for the drives' inputs and the branches set. Allocates nothing.
    pub fn run_motion<const LEVEL: u8>(&mut self, plan: &Plan) {
        self.start(plan);
        for step in &plan.motion {
            self.step::<LEVEL>(plan, step);
        }
    }

    /// Runs one step of motion.
    #[inline(always)]
    pub fn step<const LEVEL: u8>(&mut self, plan: &Plan, step: &MotionStep) {
        match step {
            MotionStep::Turn { branch, body, base, pin, drive, relative } => {
                self.turn::<LEVEL>(*branch, *body, base, *pin, *drive, *relative);
            }
            MotionStep::Shift { branch, slide, drive } => self.shift::<LEVEL>(*branch, slide, *drive),
            MotionStep::Rrr { branch, legs } => self.rrr::<LEVEL>(*branch, legs),
            MotionStep::Rrp { branch, leg, slide, pin, from_point } => {
                self.rrp::<LEVEL>(*branch, leg, slide, *pin, *from_point);
            }
            MotionStep::DrivenRrr { branch, legs } => self.driven_rrr::<LEVEL>(*branch, legs),
            MotionStep::DrivenRrp { branch, leg, slide, pin, from_point } => {
                self.driven_rrp::<LEVEL>(*branch, leg, slide, *pin, *from_point);
            }
            MotionStep::Rpr { .. } => self.rpr::<LEVEL>(step),
            MotionStep::Prp { branch, slides, pins, from_point } => {
                self.prp::<LEVEL>(*branch, slides, pins, from_point);
            }
            MotionStep::Rpp { branch, base, pin, inner, outer } => {
                self.rpp::<LEVEL>(*branch, base, *pin, inner, outer);
            }
            MotionStep::Translation { branch, slides } => self.translation::<LEVEL>(*branch, slides),
            MotionStep::Triad { branch, triad } => self.triad::<LEVEL>(*branch, triad),
            MotionStep::General { branch, problem } => {
                self.general::<LEVEL>(*branch, *problem, &plan.general[*problem]);
            }
        }
    }

    #[inline(always)]
    pub(super) fn closes(&mut self, branch: usize, closure: f64, scale: f64) {
        if (closure < -CLOSURE * scale || closure.is_nan()) && self.open.is_none() {
            self.open = Some(branch);
        }
    }

    #[inline(never)]
    pub(super) fn turn<const LEVEL: u8>(
        &mut self,
        branch: usize,
        body: usize,
        base: &Anchor,
        pin: Vec2,
        drive: usize,
        relative: Option<f64>,
    ) {
        let input = self.inputs[drive];
        let hinge = point::<LEVEL>(&self.bodies, base);
        let (u, omega, alpha) = match relative {
            None => (input.place, input.rate, input.acceleration),
            Some(sign) => {
                let carrier = &self.bodies[base.body];
                let direction = Vec2::new(input.place.x, sign * input.place.y);
                (
                    direction.turned(carrier.u),
                    carrier.omega + sign * input.rate,
                    carrier.alpha + sign * input.acceleration,
                )
            }
        };
        self.sines[branch] = 1.0;
        place::<LEVEL>(&mut self.bodies[body], pin, hinge, u, omega, alpha);
    }

    #[inline(never)]
    pub(super) fn shift<const LEVEL: u8>(&mut self, branch: usize, slide: &Slide, drive: usize) {
        let input = self.inputs[drive];
        let guide = line(&self.bodies, slide);
        let p = guide.origin + guide.along * (slide.sense * input.value);
        self.sines[branch] = 1.0;
        self.place_slider::<LEVEL>(
            slide,
            guide.along,
            slide.point,
            p,
            slide.sense * input.rate,
            slide.sense * input.acceleration,
        );
    }

    /// Puts a sliding body with its point `at` at `p`, moving along the guide.
    #[inline(always)]
    pub(super) fn place_slider<const LEVEL: u8>(
        &mut self,
        slide: &Slide,
        d: Vec2,
        at: Vec2,
        p: Vec2,
        s_dot: f64,
        s_ddot: f64,
    ) {
        let base = self.bodies[slide.base];
        let moved = slid::<LEVEL>(&base, under::<LEVEL>(&base, p), d, s_dot, s_ddot);
        let u = d.turned_back(slide.direction);
        place::<LEVEL>(&mut self.bodies[slide.body], at, moved, u, base.omega, base.alpha);
    }

    #[inline(never)]
    fn rrr<const LEVEL: u8>(&mut self, branch: usize, legs: &[Leg; 2]) {
        let [one, two] = legs;
        let a = point::<LEVEL>(&self.bodies, &one.base);
        let b = point::<LEVEL>(&self.bodies, &two.base);
        let at = rrr::position(a.p, b.p, one.length, two.length, self.branches[branch].root);
        self.sines[branch] = at.sine;
        self.closes(branch, at.closure, one.length + two.length);
        let u_1 = (at.r_1 * one.inverse).turned_back(one.direction);
        let u_2 = (at.r_2 * two.inverse).turned_back(two.direction);
        let (mut omega, mut alpha) = ((0.0, 0.0), (0.0, 0.0));
        if LEVEL > 0 {
            let group = rrr::Rrr::new(at.r_1, at.r_2);
            omega = group.velocity(a.v, b.v);
            if LEVEL > 1 {
                alpha = group.acceleration(omega.0, omega.1, a.a, b.a);
            }
        }
        place::<LEVEL>(&mut self.bodies[one.body], one.pin, a, u_1, omega.0, alpha.0);
        place::<LEVEL>(&mut self.bodies[two.body], two.pin, b, u_2, omega.1, alpha.1);
    }

    #[inline(never)]
    fn rrp<const LEVEL: u8>(&mut self, branch: usize, leg: &Leg, slide: &Slide, pin: Vec2, from_point: Vec2) {
        let Branch2 { root, side } = self.branch(branch, 0);
        let a = point::<LEVEL>(&self.bodies, &leg.base);
        let guide = line(&self.bodies, slide);
        let h = from_point.y + side * slide.radius;
        let at = rrp::position(a.p, leg.length, guide.origin, guide.along, h, root);
        self.sines[branch] = at.sine;
        self.closes(branch, at.closure, leg.length);
        let u_1 = (at.r_1 * leg.inverse).turned_back(leg.direction);
        let (mut omega_1, mut alpha_1, mut s_dot, mut s_ddot) = (0.0, 0.0, 0.0, 0.0);
        if LEVEL > 0 {
            let base = &self.bodies[slide.base];
            let g = under::<LEVEL>(base, at.p_C);
            let group = rrp::Rrp::new(at.r_1, guide.along);
            (omega_1, s_dot) = group.velocity(a.v, g.v);
            if LEVEL > 1 {
                (alpha_1, s_ddot) = group.acceleration(omega_1, s_dot, a.a, g.a, base.omega);
            }
        }
        place::<LEVEL>(&mut self.bodies[leg.body], leg.pin, a, u_1, omega_1, alpha_1);
        self.place_slider::<LEVEL>(slide, guide.along, pin, at.p_C, s_dot, s_ddot);
    }

    #[inline(never)]
    fn rpr<const LEVEL: u8>(&mut self, step: &MotionStep) {
        let MotionStep::Rpr { branch, bases, pins, slide, from_origin, from_point } = step else { return };
        let Branch2 { root, side } = self.branch(*branch, 0);
        let a = point::<LEVEL>(&self.bodies, &bases[0]);
        let b = point::<LEVEL>(&self.bodies, &bases[1]);
        let h = from_point.y + side * slide.radius - from_origin.y;
        let at = rpr::position(a.p, b.p, h, root);
        self.sines[*branch] = at.sine;
        self.closes(*branch, at.closure, h.abs() + (b.p - a.p).norm());
        let u_1 = at.e.turned_back(slide.along);
        let u_2 = at.e.turned_back(slide.direction);
        let (mut omega, mut alpha) = (0.0, 0.0);
        if LEVEL > 0 {
            let group = rpr::Rpr::new(b.p - a.p, at.e, h, at.s);
            let (w, s_dot) = group.velocity(a.v, b.v);
            omega = w;
            if LEVEL > 1 {
                alpha = group.acceleration(w, s_dot, a.a, b.a).0;
            }
        }
        place::<LEVEL>(&mut self.bodies[slide.base], pins[0], a, u_1, omega, alpha);
        place::<LEVEL>(&mut self.bodies[slide.body], pins[1], b, u_2, omega, alpha);
    }

    #[inline(never)]
    fn prp<const LEVEL: u8>(
        &mut self,
        branch: usize,
        slides: &[Slide; 2],
        pins: &[Vec2; 2],
        from_point: &[Vec2; 2],
    ) {
        let sides = self.branches[branch].sides;
        let guides = [line(&self.bodies, &slides[0]), line(&self.bodies, &slides[1])];
        let h = [0, 1].map(|i| from_point[i].y + sides[i] * slides[i].radius);
        let group = prp::Prp::new(guides[0].along, guides[1].along);
        let at = group.position(guides[0].origin, h[0], guides[1].origin, h[1]);
        self.sines[branch] = at.sine;
        let (mut rate, mut second) = ((0.0, 0.0), (0.0, 0.0));
        if LEVEL > 0 {
            let bases = [&self.bodies[slides[0].base], &self.bodies[slides[1].base]];
            let g = bases.map(|b| under::<LEVEL>(b, at.p_C));
            rate = group.velocity(g[0].v, g[1].v);
            if LEVEL > 1 {
                second = group.acceleration(rate.0, g[0].a, bases[0].omega, rate.1, g[1].a, bases[1].omega);
            }
        }
        self.place_slider::<LEVEL>(&slides[0], guides[0].along, pins[0], at.p_C, rate.0, second.0);
        self.place_slider::<LEVEL>(&slides[1], guides[1].along, pins[1], at.p_C, rate.1, second.1);
    }

    #[inline(never)]
    fn rpp<const LEVEL: u8>(
        &mut self,
        branch: usize,
        base: &Anchor,
        pin: Vec2,
        inner: &Slide,
        outer: &Slide,
    ) {
        let sides = self.branches[branch].sides;
        let a = point::<LEVEL>(&self.bodies, base);
        let guide = line(&self.bodies, outer);
        let d_1 = inner.along.turned(guide.along.turned_back(outer.direction));
        let h_1 = (pin - inner.point).turned_back(inner.direction).y + sides[0] * inner.radius;
        let h_2 = (inner.origin - outer.point).turned_back(outer.direction).y + sides[1] * outer.radius;
        let group = rpp::Rpp::new(d_1, guide.along);
        let at = group.position(a.p, h_1, guide.origin, h_2);
        self.sines[branch] = at.sine;
        let carrier = self.bodies[outer.base];
        let (mut rate, mut second) = ((0.0, 0.0), (0.0, 0.0));
        if LEVEL > 0 {
            let g = under::<LEVEL>(&carrier, a.p);
            rate = group.velocity(a.v, g.v);
            if LEVEL > 1 {
                second = group.acceleration(rate.0, rate.1, a.a, g.a, carrier.omega);
            }
        }
        self.place_slider::<LEVEL>(outer, guide.along, inner.origin, at.p_R, rate.1, second.1);
        let u_1 = d_1.turned_back(inner.direction);
        place::<LEVEL>(&mut self.bodies[inner.body], pin, a, u_1, carrier.omega, carrier.alpha);
    }

    #[inline(never)]
    fn translation<const LEVEL: u8>(&mut self, branch: usize, slides: &[Slide; 2]) {
        let sides = self.branches[branch].sides;
        let guides = [line(&self.bodies, &slides[0]), line(&self.bodies, &slides[1])];
        let from_second = (slides[0].point - slides[1].point).turned_back(slides[1].direction);
        let h = [sides[0] * slides[0].radius, from_second.y + sides[1] * slides[1].radius];
        let group = pp::Pp::new(guides[0].along, guides[1].along);
        let at = group.position(guides[0].origin, h[0], guides[1].origin, h[1]);
        self.sines[branch] = at.sine;
        let (mut rate, mut second) = ((0.0, 0.0), (0.0, 0.0));
        if LEVEL > 0 {
            let bases = [&self.bodies[slides[0].base], &self.bodies[slides[1].base]];
            let g = bases.map(|b| under::<LEVEL>(b, at.p_C));
            rate = group.velocity(g[0].v, g[1].v);
            if LEVEL > 1 {
                second = group.acceleration(rate.0, g[0].a, rate.1, g[1].a, bases[0].omega);
            }
        }
        self.place_slider::<LEVEL>(&slides[0], guides[0].along, slides[0].point, at.p_C, rate.0, second.0);
    }

    #[inline(always)]
    pub(super) fn branch(&self, branch: usize, joint: usize) -> Branch2 {
        let b = &self.branches[branch];
        Branch2 { root: b.root, side: b.sides[joint] }
    }
}

pub(super) struct Branch2 {
    pub root: f64,
    pub side: f64,
}
