//! Runs the steps of motion: positions and, as far as the plan follows motion, velocities and accelerations.
//!
//! `LEVEL` is 0 for positions, 1 with velocities, 2 with accelerations: what is not followed is not compiled in.

use super::body::BodyState;
use super::state::State;
use crate::math::{LaneMask, Scalar, V2, Vec2};
use crate::plan::step::unit;
use crate::plan::{Anchor, Arm, MotionStep, Plan, Slide};

/// Rounding alone may leave a group at a dead centre this much short of closing, relative to its lengths, in units of ε.
pub(super) const CLOSURE: f64 = 16.0;

/// Position, velocity and acceleration of a point.
#[derive(Clone, Copy)]
pub(super) struct Point<S> {
    pub p: V2<S>,
    pub v: V2<S>,
    pub a: V2<S>,
}

/// A line on a body of known motion at one position.
#[derive(Clone, Copy)]
pub(super) struct Line<S> {
    pub origin: V2<S>,
    pub along: V2<S>,
}

/// A point of the ground.
#[inline(always)]
pub(super) fn fixed<S: Scalar>(at: Vec2) -> Point<S> {
    Point { p: V2::of(at), v: V2::zero(), a: V2::zero() }
}

#[inline(always)]
pub(super) fn point<S: Scalar, const LEVEL: u8>(bodies: &[BodyState<S>], anchor: &Anchor) -> Point<S> {
    // most outer joints sit on the ground, which does not move
    if anchor.body == 0 {
        return fixed(anchor.at);
    }
    let body = &bodies[anchor.body];
    let r = V2::of(anchor.at).turned(body.u);
    let v = if LEVEL > 0 { body.v + r.perp() * body.omega } else { V2::zero() };
    let a =
        if LEVEL > 1 { body.a + r.perp() * body.alpha - r * (body.omega * body.omega) } else { V2::zero() };
    Point { p: body.p + r, v, a }
}

/// Velocity and acceleration of the point of a body that lies at `p` now.
#[inline(always)]
pub(super) fn under<S: Scalar, const LEVEL: u8>(bodies: &[BodyState<S>], body: usize, p: V2<S>) -> Point<S> {
    if body == 0 {
        return Point { p, v: V2::zero(), a: V2::zero() };
    }
    let body = &bodies[body];
    let r = p - body.p;
    let v = if LEVEL > 0 { body.v + r.perp() * body.omega } else { V2::zero() };
    let a =
        if LEVEL > 1 { body.a + r.perp() * body.alpha - r * (body.omega * body.omega) } else { V2::zero() };
    Point { p, v, a }
}

#[inline(always)]
pub(super) fn line<S: Scalar>(bodies: &[BodyState<S>], slide: &Slide) -> Line<S> {
    if slide.base == 0 {
        return Line { origin: V2::of(slide.origin), along: unit(slide.along) };
    }
    let base = &bodies[slide.base];
    Line { origin: base.position(slide.origin), along: unit(slide.along).turned(base.u) }
}

/// Puts a body so that its pin moves as given, at direction `u`, angular velocity and acceleration as given.
#[inline(always)]
pub fn place<S: Scalar, const LEVEL: u8>(
    body: &mut BodyState<S>,
    pin: &Arm,
    point: Point<S>,
    u: V2<S>,
    omega: S,
    alpha: S,
) {
    body.u = u;
    if LEVEL > 0 {
        body.omega = omega;
    }
    if LEVEL > 1 {
        body.alpha = alpha;
    }
    let Some(at) = pin else {
        body.p = point.p;
        if LEVEL > 0 {
            body.v = point.v;
        }
        if LEVEL > 1 {
            body.a = point.a;
        }
        return;
    };
    let r = V2::of(*at).turned(u);
    body.p = point.p - r;
    if LEVEL > 0 {
        body.v = point.v - r.perp() * omega;
    }
    if LEVEL > 1 {
        body.a = point.a - r.perp() * alpha + r * (omega * omega);
    }
}

/// Moves a point over a body: velocity and acceleration relative to it along `d`, and Coriolis.
#[inline(always)]
fn slid<S: Scalar, const LEVEL: u8>(
    base: &BodyState<S>,
    under: Point<S>,
    d: V2<S>,
    s_dot: S,
    s_ddot: S,
) -> Point<S> {
    let v = if LEVEL > 0 { under.v + d * s_dot } else { under.v };
    let a =
        if LEVEL > 1 { under.a + d * s_ddot + d.perp() * (S::of(2.0) * base.omega * s_dot) } else { under.a };
    Point { p: under.p, v, a }
}

impl<S: Scalar> State<S> {
    /// Puts the bodies that are driven at a point where the drives say.
    #[cfg_attr(in_one, inline(always))]
    pub fn start(&mut self, plan: &Plan) {
        self.motion.open = None;
        for &(body, at, drive) in &plan.outer {
            let input = &self.motion.inputs[drive];
            let point = Point { p: input.place, v: input.velocity, a: input.point_acceleration };
            let along = V2::new(S::one(), S::zero());
            place::<S, 2>(&mut self.motion.bodies[body], &Some(at), point, along, S::zero(), S::zero());
        }
        self.carry_parts(plan, None);
    }

    /// Runs a step of motion that has a closed form; one that has none leaves its group open.
    #[cfg_attr(in_one, inline(always))]
    pub(super) fn closed_form<const LEVEL: u8>(&mut self, step: &MotionStep) {
        match step {
            MotionStep::Turn { body, base, pin, drive, relative, sign, ahead, .. } => {
                self.turn::<LEVEL>(*body, base, pin, *drive, (*relative, *sign, *ahead));
            }
            MotionStep::Free { body, at, place, turn, .. } => self.free::<LEVEL>(*body, at, *place, *turn),
            MotionStep::Shift { slide, drive, .. } => self.shift::<LEVEL>(slide, *drive),
            MotionStep::Rrr { branch, legs, sides } => self.rrr::<LEVEL>(*branch, legs, sides),
            MotionStep::Rrp { branch, leg, slide, pin, from_point } => {
                self.rrp::<LEVEL>(*branch, leg, slide, pin, *from_point);
            }
            MotionStep::DrivenRrr { branch, legs } => self.driven_rrr::<LEVEL>(*branch, legs),
            MotionStep::DrivenRrp { branch, leg, slide, pin, from_point } => {
                self.driven_rrp::<LEVEL>(*branch, leg, slide, pin, *from_point);
            }
            MotionStep::Rpr { .. } => self.rpr::<LEVEL>(step),
            MotionStep::Prp { branch, slides, pins, from_point } => {
                self.prp::<LEVEL>(*branch, slides, pins, from_point);
            }
            MotionStep::Rpp { branch, base, pin, inner, outer } => {
                self.rpp::<LEVEL>(*branch, base, pin, inner, outer);
            }
            MotionStep::Translation { branch, slides } => self.translation::<LEVEL>(*branch, slides),
            MotionStep::Cam { branch, .. }
            | MotionStep::CamTurned { branch, .. }
            | MotionStep::Geneva { branch, .. }
            | MotionStep::Train { branch, .. }
            | MotionStep::Triad { branch, .. }
            | MotionStep::General { branch, .. } => {
                self.motion.open.get_or_insert(*branch);
            }
        }
    }

    /// Keeps the first group that does not close.
    #[inline(always)]
    pub(super) fn closes(&mut self, branch: usize, closure: S, scale: S) {
        if !(S::of(-CLOSURE * f64::EPSILON) * scale).lt(closure).all() {
            self.motion.open.get_or_insert(branch);
        }
    }

    #[cfg_attr(in_one, inline(always))]
    pub(super) fn turn<const LEVEL: u8>(
        &mut self,
        body: usize,
        base: &Anchor,
        pin: &Arm,
        drive: usize,
        (relative, sign, ahead): (bool, f64, Option<Vec2>),
    ) {
        let input = &self.motion.inputs[drive];
        let hinge = point::<S, LEVEL>(&self.motion.bodies, base);
        let sign = S::of(sign);
        // cosine and sine are read one by one, as they were written: to read them as a pair waits until both are in memory
        let direction = V2::new(input.place.x, sign * input.place.y);
        let direction = ahead.map_or(direction, |ahead| direction.turned(unit(ahead)));
        let (u, omega, alpha, turned) = if relative {
            let carrier = &self.motion.bodies[base.body];
            (
                direction.turned(carrier.u),
                carrier.omega + sign * input.rate,
                carrier.alpha + sign * input.acceleration,
                carrier.turned + sign * input.value,
            )
        } else {
            (direction, input.rate, input.acceleration, input.value)
        };
        let body = &mut self.motion.bodies[body];
        body.turned = turned;
        place::<S, LEVEL>(body, pin, hinge, u, omega, alpha);
    }

    /// Puts a body where drives say.
    #[cfg_attr(in_one, inline(always))]
    fn free<const LEVEL: u8>(&mut self, body: usize, at: &Arm, [x, y]: [usize; 2], turn: Option<usize>) {
        let [x, y] = [x, y].map(|drive| self.motion.inputs[drive]);
        let point = Point {
            p: V2::new(x.value, y.value),
            v: V2::new(x.rate, y.rate),
            a: V2::new(x.acceleration, y.acceleration),
        };
        let still = (V2::new(S::one(), S::zero()), S::zero(), S::zero(), S::zero());
        let (u, omega, alpha, turned) = turn.map_or(still, |drive| {
            let input = &self.motion.inputs[drive];
            (input.place, input.rate, input.acceleration, input.value)
        });
        let body = &mut self.motion.bodies[body];
        body.turned = turned;
        place::<S, LEVEL>(body, at, point, u, omega, alpha);
    }

    #[cfg_attr(in_one, inline(always))]
    pub(super) fn shift<const LEVEL: u8>(&mut self, slide: &Slide, drive: usize) {
        let input = self.motion.inputs[drive];
        let guide = line(&self.motion.bodies, slide);
        let p = guide.origin + guide.along * (S::of(slide.sense) * input.value);
        self.place_slider::<LEVEL>(
            slide,
            guide.along,
            &Some(slide.point),
            p,
            S::of(slide.sense) * input.rate,
            S::of(slide.sense) * input.acceleration,
        );
    }

    /// Puts a sliding body with its pin at `p`, moving along the guide.
    #[cfg_attr(in_one, inline(always))]
    pub(super) fn place_slider<const LEVEL: u8>(
        &mut self,
        slide: &Slide,
        d: V2<S>,
        pin: &Arm,
        p: V2<S>,
        s_dot: S,
        s_ddot: S,
    ) {
        if slide.base == 0 {
            let moved = Point { p, v: d * s_dot, a: d * s_ddot };
            place::<S, LEVEL>(
                &mut self.motion.bodies[slide.body],
                pin,
                moved,
                slide.turn(),
                S::zero(),
                S::zero(),
            );
            return;
        }
        let base = self.motion.bodies[slide.base];
        let moved =
            slid::<S, LEVEL>(&base, under::<S, LEVEL>(&self.motion.bodies, slide.base, p), d, s_dot, s_ddot);
        let u = slide.turn().turned(base.u);
        place::<S, LEVEL>(&mut self.motion.bodies[slide.body], pin, moved, u, base.omega, base.alpha);
    }

    #[inline(always)]
    pub(super) fn branch(&self, branch: usize, joint: usize) -> Branch2 {
        let b = &self.branches[branch];
        Branch2 { root: b.root, side: b.sides[joint] }
    }
}

impl State {
    /// Runs all steps of motion for the drives' inputs and the branches set. Allocates nothing.
    pub fn run_motion<const LEVEL: u8>(&mut self, plan: &Plan) {
        self.start(plan);
        for step in &plan.motion {
            self.step::<LEVEL>(plan, step);
        }
    }

    /// Runs one step of motion.
    #[inline(never)]
    pub fn step<const LEVEL: u8>(&mut self, plan: &Plan, step: &MotionStep) {
        match step {
            MotionStep::Train { branch, train } => self.train::<LEVEL>(*branch, &plan.trains[*train]),
            MotionStep::Cam { branch, cam } => self.cam::<LEVEL>(*branch, &plan.cams[*cam]),
            MotionStep::CamTurned { branch, cam } => self.cam_turned::<LEVEL>(*branch, &plan.cams[*cam]),
            MotionStep::Geneva { branch, geneva } => self.geneva::<LEVEL>(*branch, &plan.genevas[*geneva]),
            MotionStep::Triad { branch, triad } => {
                self.triad::<LEVEL>(*branch, triad, plan.settings.triad, &mut ());
            }
            MotionStep::General { branch, problem } => {
                let (group, small) = (&plan.general[*problem], plan.settings.newton);
                self.general::<LEVEL>(*branch, *problem, group, small, &mut ());
            }
            closed => self.closed_form::<LEVEL>(closed),
        }
        if !plan.parts.is_empty() {
            self.carry_parts(plan, Some(step.branch()));
        }
    }
}

pub(super) struct Branch2 {
    pub root: f64,
    pub side: f64,
}
