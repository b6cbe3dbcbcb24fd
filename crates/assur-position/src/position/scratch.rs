//! Memory of the steps that iterate or search, laid out once before the loop.

use super::consistent::Searched;
use super::friction_work::FrictionWork;
use super::general_work::Workspace;
use super::rate_work::RateWork;
use super::train_work::TrainWork;
use super::wrench::Wrench;
use crate::group::general::General;
use crate::plan::{ForceStep, Plan};

/// Memory of the steps that have no closed form. Nothing of it is an answer.
#[derive(Clone, Debug, Default)]
pub struct Scratch {
    /// What searches for states of the forces have taken.
    pub searched: Searched,
    /// Laws of wheels act in the senses that are set, whatever their multipliers: forces are then linear in the loads.
    pub(super) in_senses: bool,
    /// Loads before the first reaction was added, where there is friction.
    pub(super) loads_before: Vec<Wrench>,
    /// Sums of what acts on links, where some are welded.
    pub(super) totals: Vec<Wrench>,
    /// Train groups of forces. A step takes its memory out while it runs: in a box it does not move.
    pub train_work: Vec<Option<Box<TrainWork>>>,
    /// Groups with friction, by step of forces; nothing where nothing rubs.
    pub friction_work: Vec<Option<Box<FrictionWork>>>,
    /// Systems for rates beyond accelerations.
    pub(super) rate_work: Option<Box<RateWork>>,
    /// General groups of motion.
    pub motion_work: Vec<Option<Workspace>>,
    /// General groups of forces.
    pub force_work: Vec<Option<Workspace>>,
}

impl Scratch {
    /// Memory for the steps of a plan.
    pub(super) fn of(plan: &Plan) -> Self {
        let memory = |equations: &Option<General>, bodies: &[usize], moving| {
            equations.as_ref().map(|e| Workspace::new(e, bodies.len(), moving))
        };
        let rubs = plan.forces.iter().any(|step| matches!(step, ForceStep::Friction { .. }));
        let rubbing = plan.forces.iter().map(|step| match step {
            ForceStep::Friction { group, .. } => Some(Box::new(FrictionWork::new(group))),
            _ => None,
        });
        let (motion, forces) = (plan.general.iter(), plan.balance_systems.iter());
        Self {
            train_work: plan.train_forces.iter().map(|t| Some(Box::new(TrainWork::new(t)))).collect(),
            friction_work: if rubs { rubbing.collect() } else { Vec::new() },
            rate_work: plan.rate_groups.as_ref().map(|groups| Box::new(RateWork::new(plan, groups))),
            motion_work: motion.map(|g| memory(&g.equations, &g.bodies, g.moving)).collect(),
            totals: Vec::with_capacity(if plan.welds.is_empty() { 0 } else { plan.bodies }),
            force_work: forces.map(|g| memory(&g.equations, &g.bodies, g.moving)).collect(),
            ..Self::default()
        }
    }
}
