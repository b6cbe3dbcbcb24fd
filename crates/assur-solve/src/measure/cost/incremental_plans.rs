//! Plans between the empty one and the whole.

use crate::plan::{ForceStep, Level, LoadStep, Plan};
use crate::position::Model;

/// A plan to be timed, and what is done beside it.
pub(super) struct Trial {
    pub plan: Plan,
    pub residuals: bool,
    pub quantities: bool,
}

impl Trial {
    fn of(plan: Plan) -> Self {
        Self { plan, residuals: false, quantities: false }
    }
}

/// The plan that moves nothing.
fn empty(plan: &Plan) -> Plan {
    let mut empty = Plan { motion: Vec::new(), ..plan.clone() };
    (empty.effects.forces, empty.effects.simulated) = (false, false);
    empty
}

/// The plan with the first so many steps of loads and of forces.
fn loaded(plan: &Plan, loads: impl Fn(&LoadStep) -> Option<LoadStep>, forces: usize) -> Plan {
    let loads: Vec<LoadStep> = plan.loads.iter().filter_map(loads).collect();
    let mut part = Plan { forces: plan.forces[..forces].to_vec(), loads, ..plan.clone() };
    part.closed = part.find_closed();
    part.massless = part.find_massless();
    part
}

/// The empty plan, then one step more at a time: motion, loads, forces.
pub(super) fn steps(plan: &Plan) -> Vec<Trial> {
    let mut trials = vec![empty(plan)];
    for count in 1..=plan.motion.len() {
        trials.push(Plan { motion: plan.motion[..count].to_vec(), ..empty(plan) });
    }
    if plan.effects.loaded() {
        for count in 1..=plan.loads.len() {
            let some = Plan { loads: plan.loads[..count].to_vec(), ..plan.clone() };
            trials.push(loaded(&some, |load| Some(load.clone()), 0));
        }
        for count in 1..=plan.forces.len() {
            trials.push(loaded(plan, |load| Some(load.clone()), count));
        }
    }
    trials.into_iter().map(Trial::of).collect()
}

/// The empty plan, then one effect more at a time, by name.
pub(super) fn effects(model: &Model<'_>) -> Vec<(&'static str, Trial)> {
    let plan = model.plan;
    let mut trials = vec![("", empty(plan))];
    let levels = [
        (Level::Positions, "positions"),
        (Level::Velocities, "velocities"),
        (Level::Accelerations, "accelerations"),
    ];
    for (level, name) in levels.into_iter().filter(|(level, _)| *level <= plan.effects.level) {
        let mut motion = Plan { motion: plan.motion.clone(), ..empty(plan) };
        motion.effects.level = level;
        trials.push((name, motion));
    }
    if plan.effects.loaded() {
        trials.extend(loads(plan));
    }
    if plan.effects.forces {
        trials.extend(forces(plan));
    }
    trials.into_iter().map(|(name, plan)| (name, Trial::of(plan))).collect()
}

/// Whether a load counts when effects are added up to this one.
type Counts = fn(&LoadStep) -> Option<LoadStep>;

/// Without forces: weights, then inertia forces, springs, given loads.
fn loads(plan: &Plan) -> Vec<(&'static str, Plan)> {
    let row: [(bool, &'static str, Counts); 4] = [
        (plan.effects.gravity, "gravity", weights),
        (plan.effects.inertia, "inertia", masses),
        (plan.effects.springs, "springs", masses_and_springs),
        (plan.loads.iter().any(given), "loads", |load| Some(load.clone())),
    ];
    let there = row.into_iter().filter(|(is_there, ..)| *is_there);
    there.map(|(_, name, counts)| (name, without_losses(loaded(plan, counts, 0)))).collect()
}

fn given(load: &LoadStep) -> bool {
    !matches!(load, LoadStep::Mass { .. } | LoadStep::Spring { .. })
}

fn weights(load: &LoadStep) -> Option<LoadStep> {
    let mut load = masses(load)?;
    if let LoadStep::Mass { inertia, .. } = &mut load {
        *inertia = false;
    }
    Some(load)
}

fn masses(load: &LoadStep) -> Option<LoadStep> {
    matches!(load, LoadStep::Mass { .. }).then(|| load.clone())
}

fn masses_and_springs(load: &LoadStep) -> Option<LoadStep> {
    (!given(load)).then(|| load.clone())
}

/// Reactions without losses, then friction in the pairs, then losses of transmissions.
fn forces(plan: &Plan) -> Vec<(&'static str, Plan)> {
    let mut row = vec![("reactions", without_losses(plan.clone()))];
    if plan.effects.friction {
        row.push(("friction", without_efficiencies(plan.clone())));
    }
    if plan.effects.losses {
        row.push(("losses", plan.clone()));
    }
    row
}

/// The plan with the steps that its groups have without friction.
fn without_losses(mut plan: Plan) -> Plan {
    for step in &mut plan.forces {
        if let ForceStep::Friction { plain, .. } = step {
            *step = (**plain).clone();
        }
    }
    plan.effects.friction = false;
    without_efficiencies(plan)
}

fn without_efficiencies(mut plan: Plan) -> Plan {
    for law in &mut plan.laws {
        law.efficiency = None;
    }
    plan.effects.losses = false;
    plan
}

/// The whole plan, with what is done at every position beside it.
pub(super) fn beside(model: &Model<'_>) -> Vec<(&'static str, Trial)> {
    let whole = || Trial::of(model.plan.clone());
    let mut trials = vec![("residuals", Trial { residuals: true, ..whole() })];
    if !model.mechanism.quantities.is_empty() {
        trials.push(("quantities", Trial { quantities: true, ..whole() }));
    }
    trials
}
