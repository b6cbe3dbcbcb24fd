//! How well a solved position satisfies equations that its closed forms did not use: every joint closes, every body is
//! in equilibrium, the powers add up to nothing.

use super::check::Sums;
use super::model::Model;
use super::state::State;
use super::wrench::Wrench;
use crate::structure::{BodyRate, JointId, JointKind};

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
    let forces = model.plan.has_forces() && !state.forces.locked;
    let velocities = model.plan.effects.level >= crate::plan::Level::Velocities;
    Residuals {
        closure: closure(model, state),
        equilibrium: forces.then(|| equilibrium(model, state, totals)),
        power: (forces && velocities).then(|| power(model, state)),
    }
}

/// The closure as the only residual: of forces that are neither lost nor out of scale nothing else is reported.
#[must_use]
pub fn closure_alone(model: &Model<'_>, state: &State) -> Residuals {
    Residuals { closure: closure(model, state), ..Residuals::default() }
}

/// Greatest distance between what a joint joins, over the extent of the mechanism.
fn closure(model: &Model<'_>, state: &State) -> f64 {
    let (mut worst, size) = state.gaps(&model.plan.checks);
    for step in &model.plan.cams {
        worst = worst.max(state.cam_gap(step));
    }
    for step in &model.plan.genevas {
        worst = worst.max(state.geneva_gap(step));
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
        JointKind::Revolute(_) | JointKind::Weld { .. } | JointKind::Law(_) => 0.0,
    }
}

/// Worst equilibrium of a body, from the reactions as they are reported, over the greatest force or moment.
fn equilibrium(model: &Model<'_>, state: &State, totals: &mut Vec<Wrench>) -> f64 {
    let mut sums = Sums::of(&state.forces.applied, std::mem::take(totals));
    let checks = &model.plan.checks;
    state.acts(model.plan, &mut |act| sums.add(state, act));
    let worst = sums.worst(checks);
    *totals = sums.into_memory();
    worst
}

/// Virtual power: the loads and efforts on all moving bodies, with what known bodies put in through their joints, over the
/// greatest force times the greatest velocity of a joint: at dead positions every single power is nothing.
fn power(model: &Model<'_>, state: &State) -> f64 {
    let checks = &model.plan.checks;
    let mut sum = state.power(checks);
    for (element, &value) in model.plan.friction.iter().zip(&state.forces.frictions) {
        sum += value * state.sliding_speed(element);
    }
    for (slot, law) in model.plan.laws.iter().enumerate() {
        sum += state.law_power(law, slot);
    }
    state.over_most_power(sum, checks)
}
