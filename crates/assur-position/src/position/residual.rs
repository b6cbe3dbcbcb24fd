//! How well a solved position satisfies equations that its closed forms did not use: every joint closes, every body is
//! in equilibrium, the powers add up to nothing.

use super::model::Model;
use super::state::State;
use super::wrench::Wrench;
use crate::math::Vec2;
use crate::structure::{BodyId, BodyOrigin, BodyRate, EffortKind, JointId, JointKind};

/// How well independent equations hold, relative to the quantities in play.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Residuals {
    /// Worst mismatch of a pair's points and directions over the mechanism's size.
    pub closure: f64,
    /// Worst equilibrium of a body over the greatest force (or moment) in play; `None` without forces.
    pub equilibrium: Option<f64>,
    /// Sum of the powers over the greatest force times the greatest velocity; `None` without forces or velocities.
    pub power: Option<f64>,
}

/// Residuals of a position. Forces are checked where the plan solves them and they exist, powers where it follows
/// velocities.
#[must_use]
pub fn residuals(model: &Model<'_>, state: &State) -> Residuals {
    residuals_in(model, state, &mut Vec::new())
}

/// As [`residuals`], with memory for the sums of forces on the bodies.
pub fn residuals_in(model: &Model<'_>, state: &State, totals: &mut Vec<Wrench>) -> Residuals {
    // a locked mechanism has none
    let forces = model.plan.effects.forces && !model.plan.forces.is_empty() && !state.forces.locked;
    let velocities = model.plan.effects.level >= crate::plan::Level::Velocities;
    Residuals {
        closure: closure(model, state),
        equilibrium: forces.then(|| equilibrium(model, state, totals)),
        power: (forces && velocities).then(|| power(model, state)),
    }
}

/// Greatest distance between what a joint joins, over the extent of the mechanism.
fn closure(model: &Model<'_>, state: &State) -> f64 {
    let (mut worst, mut size) = (0.0_f64, f64::MIN_POSITIVE);
    for step in &model.plan.cams {
        worst = worst.max(state.cam_gap(step));
    }
    for step in &model.plan.genevas {
        worst = worst.max(state.geneva_gap(step));
    }
    let by_law = |pair| model.mechanism.is_by_law(pair);
    for joint in model.structure.replaced.joints.iter().filter(|j| !by_law(j.pair)) {
        match &joint.kind {
            JointKind::Revolute(members) => {
                let Some(&(first, at)) = members.first() else { continue };
                let p = state.motion.bodies[first.0].position(at);
                for &(body, at) in members {
                    let b = &state.motion.bodies[body.0];
                    let q = b.position(at);
                    worst = worst.max((q - p).norm());
                    size = size.max(q.norm()).max(b.p.norm());
                }
            }
            JointKind::Prismatic { slider, point, direction, guide, through, along, offset, .. } => {
                let (s, g) = (&state.motion.bodies[slider.0], &state.motion.bodies[guide.0]);
                let (d, n) = (along.turned(g.u), along.turned(g.u).perp());
                let from_line = s.position(*point) - g.position(*through);
                let extent = from_line.norm();
                worst = worst.max((from_line.dot(n).abs() - offset).abs());
                worst = worst.max((direction.turned(s.u) - d).norm() * extent);
                size = size.max(extent).max(s.p.norm());
            }
            JointKind::Law(_) => {}
        }
    }
    (worst / size).max(turns(model, state))
}

/// By how much the laws of wheels that are solved together with links do not hold, over the greatest of their terms.
fn turns(model: &Model<'_>, state: &State) -> f64 {
    let laws = || model.structure.replaced.joints.iter().filter_map(|j| j.kind.law());
    let mut worst = 0.0_f64;
    for slot in model.plan.general.iter().flat_map(|g| &g.laws) {
        let Some(terms) = laws().nth(*slot) else { continue };
        let constant = model.plan.laws[*slot].constant;
        let (mut sum, mut most) = (-constant, constant.abs());
        for (rate, coefficient) in terms {
            let value = match rate {
                BodyRate::Turn(body) => state.motion.bodies[body.0].turned,
                BodyRate::Slide(joint) => slider_place(model, state, *joint),
            };
            sum += coefficient * value;
            most = most.max((coefficient * value).abs());
        }
        worst = worst.max(sum.abs() / most.max(f64::MIN_POSITIVE));
    }
    worst
}

fn slider_place(model: &Model<'_>, state: &State, joint: JointId) -> f64 {
    match model.structure.replaced.joint(joint).kind {
        JointKind::Prismatic { slider, point, guide, through, along, .. } => {
            let (s, g) = (&state.motion.bodies[slider.0], &state.motion.bodies[guide.0]);
            (s.position(point) - g.position(through)).dot(along.turned(g.u))
        }
        JointKind::Revolute(_) | JointKind::Law(_) => 0.0,
    }
}

/// Sums of all forces on every body, from the reactions as they are reported.
fn totals(model: &Model<'_>, state: &State, total: &mut Vec<Wrench>) -> (f64, f64) {
    total.clone_from(&state.forces.applied);
    let (mut most_force, mut most_moment) = (f64::MIN_POSITIVE, f64::MIN_POSITIVE);
    let mut add = |body: usize, p: Vec2, force: Vec2, couple: f64| {
        let r = p - state.motion.bodies[body].p;
        let moment = r.cross(force) + couple;
        total[body].force += force;
        total[body].moment += moment;
        most_force = most_force.max(force.norm());
        most_moment = most_moment.max(r.norm() * force.norm()).max(couple.abs());
    };
    for (slot, joint) in model.plan.reactions.iter().enumerate() {
        let p = match &model.structure.replaced.joint(joint.joint).kind {
            JointKind::Revolute(members) => {
                // the block of a cam's contact has its hinge at its origin, wherever on the cam that is
                let pair = model.structure.replaced.joint(joint.joint).pair;
                let is_block =
                    |b: BodyId| model.structure.replaced.bodies[b.0].origin == BodyOrigin::Imaginary(pair);
                let block = members.iter().find(|m| model.mechanism.is_by_law(pair) && is_block(m.0));
                let member = block.or_else(|| members.iter().find(|m| m.0 == joint.body));
                let (on, at) = member.map_or((joint.body, Vec2::zero()), |m| *m);
                state.motion.bodies[on.0].position(at)
            }
            JointKind::Prismatic { slider, point, .. } => state.motion.bodies[slider.0].position(*point),
            JointKind::Law(_) => continue,
        };
        let reaction = state.forces.reactions[slot];
        add(joint.body.0, p, reaction.force, reaction.couple);
        add(joint.base.0, p, -reaction.force, -reaction.couple);
    }
    for (slot, law) in model.plan.laws.iter().enumerate() {
        state.forces_of_law(law, slot, &mut add);
    }
    for (element, &value) in model.plan.friction.iter().zip(&state.forces.frictions) {
        match state.friction_line(element) {
            None => {
                add(element.through, state.motion.bodies[element.through].p, Vec2::zero(), value);
                add(element.base, state.motion.bodies[element.base].p, Vec2::zero(), -value);
            }
            Some((p, d)) => {
                add(element.through, p, d * value, 0.0);
                add(element.base, p, d * -value, 0.0);
            }
        }
    }
    for (slot, effort) in model.structure.efforts.iter().enumerate() {
        let value = state.forces.efforts[slot];
        effort.places().for_each(|kind| match kind {
            EffortKind::Angle(b) => add(b.0, state.motion.bodies[b.0].p, Vec2::zero(), value),
            EffortKind::RelativeAngle { first, second, .. } => {
                add(second.0, state.motion.bodies[second.0].p, Vec2::zero(), value);
                add(first.0, state.motion.bodies[first.0].p, Vec2::zero(), -value);
            }
            EffortKind::Line(b) => {
                add(b.0, state.forces.lines[slot].0, state.forces.lines[slot].1 * value, 0.0)
            }
            EffortKind::Coordinate(joint) => {
                if let JointKind::Prismatic { slider, point, direction, guide, .. } =
                    model.structure.replaced.joint(joint).kind
                {
                    let s = &state.motion.bodies[slider.0];
                    let (p, force) = (s.position(point), direction.turned(s.u) * value);
                    add(slider.0, p, force, 0.0);
                    add(guide.0, p, -force, 0.0);
                }
            }
            EffortKind::Point(_) => {}
        });
    }
    for w in &state.forces.applied {
        most_force = most_force.max(w.force.norm());
        most_moment = most_moment.max(w.moment.abs());
    }
    (most_force, most_moment)
}

fn equilibrium(model: &Model<'_>, state: &State, total: &mut Vec<Wrench>) -> f64 {
    let (most_force, most_moment) = totals(model, state, total);
    let mut worst = 0.0_f64;
    for (body, w) in model.structure.replaced.bodies.iter().zip(total) {
        if !body.known {
            worst = worst.max(w.force.norm() / most_force).max(w.moment.abs() / most_moment);
        }
    }
    worst
}

/// Virtual power: the loads and efforts on all moving bodies, with what known bodies put in through their joints.
fn power(model: &Model<'_>, state: &State) -> f64 {
    let mut sum = 0.0;
    let mut add = |p: f64| sum += p;
    let bodies = model.structure.replaced.bodies.iter().zip(&state.motion.bodies);
    for ((_, body), w) in bodies.zip(&state.forces.applied).filter(|((b, _), _)| !b.known) {
        add(w.force.dot(body.v));
        add(w.moment * body.omega);
    }
    for (slot, effort) in model.structure.efforts.iter().enumerate() {
        let value = state.forces.efforts[slot];
        effort.places().for_each(|kind| {
            add(match kind {
                EffortKind::Angle(b) => value * state.motion.bodies[b.0].omega,
                EffortKind::RelativeAngle { first, second, .. } => {
                    value * (state.motion.bodies[second.0].omega - state.motion.bodies[first.0].omega)
                }
                EffortKind::Line(b) => {
                    let (p, n) = state.forces.lines[slot];
                    let body = &state.motion.bodies[b.0];
                    value * (body.v + (p - body.p).perp() * body.omega).dot(n)
                }
                EffortKind::Coordinate(joint) => value * slider_speed(model, state, joint),
                EffortKind::Point(_) => 0.0,
            })
        });
    }
    for (slot, joint) in model.plan.reactions.iter().enumerate() {
        if model.structure.replaced.bodies[joint.base.0].known
            && let JointKind::Revolute(members) = &model.structure.replaced.joint(joint.joint).kind
        {
            let at = members.iter().find(|m| m.0 == joint.base).map_or(Vec2::zero(), |m| m.1);
            add(state.forces.reactions[slot].force.dot(state.motion.bodies[joint.base.0].velocity(at)));
        }
    }
    for (element, &value) in model.plan.friction.iter().zip(&state.forces.frictions) {
        add(value * state.sliding_speed(element));
    }
    for (slot, law) in model.plan.laws.iter().enumerate() {
        add(state.law_power(law, slot));
    }
    sum.abs() / most_power(model, state)
}

/// The greatest force times the greatest velocity of a joint: at dead positions every single power is nothing.
fn most_power(model: &Model<'_>, state: &State) -> f64 {
    let forces = state.forces.applied.iter().map(|w| w.force.norm());
    let force = forces.chain(state.forces.reactions.iter().map(|r| r.force.norm())).fold(0.0, f64::max);
    let (mut speed, mut turn) = (0.0_f64, 0.0_f64);
    let mut look = |body: BodyId, at: Vec2| {
        speed = speed.max(state.motion.bodies[body.0].velocity(at).norm());
        turn = turn.max(state.motion.bodies[body.0].omega.abs());
    };
    for joint in &model.structure.replaced.joints {
        match &joint.kind {
            JointKind::Revolute(members) => members.iter().for_each(|(body, at)| look(*body, *at)),
            JointKind::Prismatic { slider, point, guide, through, .. } => {
                look(*slider, *point);
                look(*guide, *through);
            }
            JointKind::Law(_) => {}
        }
    }
    let moments = state.forces.applied.iter().map(|w| w.moment.abs());
    let moment = moments.chain(state.forces.efforts.iter().map(|e| e.abs())).fold(0.0, f64::max);
    (force * speed + moment * turn).max(f64::MIN_POSITIVE)
}

fn slider_speed(model: &Model<'_>, state: &State, joint: JointId) -> f64 {
    let JointKind::Prismatic { slider, point, guide, along, .. } = model.structure.replaced.joint(joint).kind
    else {
        return 0.0;
    };
    let (s, g) = (&state.motion.bodies[slider.0], &state.motion.bodies[guide.0]);
    let p = s.position(point);
    (s.velocity(point) - g.v - (p - g.p).perp() * g.omega).dot(along.turned(g.u))
}
