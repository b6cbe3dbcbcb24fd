//! The plan: flat lists of steps with slots.

use super::by_pair::ByPair;
use super::cam_step::CamStep;
use super::checks::Checks;
use super::effects::Effects;
use super::equation::RateGroup;
use super::force_step::ForceStep;
use super::friction_step::FrictionElement;
use super::general_step::{BalanceSystem, GeneralMotion};
use super::geneva_step::GenevaStep;
use super::load_step::{ForceLine, LoadStep};
use super::opposing::Opposing;
use super::settings::Settings;
use super::step::MotionStep;
use super::train_step::{PlannedLaw, TrainForces, TrainMotion};
use super::weld::{PlannedPart, PlannedWeld};
use crate::math::Vec2;
use crate::structure::GroupJoint;

/// What is done at every position, in this order: motion, loads, forces.
#[derive(Clone, Debug, Default)]
pub struct Plan {
    /// Number of bodies, imaginary ones among them.
    pub bodies: usize,
    pub drives: usize,
    /// Bodies driven at a point: slot, the point in the body's frame (m), slot of the drive.
    pub outer: Vec<(usize, Vec2, usize)>,
    pub motion: Vec<MotionStep>,
    /// Links that move with others to which they are welded.
    pub parts: Vec<PlannedPart>,
    /// Designed cams with their followers.
    pub cams: Vec<CamStep>,
    /// Designed cams from which their followers part.
    pub parting_cams: Vec<CamStep>,
    pub genevas: Vec<GenevaStep>,
    /// Number of contacts of designed cams.
    pub cam_contacts: usize,
    /// Problems of the general steps.
    pub general: Vec<GeneralMotion>,
    /// Train groups of motion.
    pub trains: Vec<TrainMotion>,
    /// Slots of the bodies that turn in train groups: their angles count whole turns.
    pub turning: Vec<usize>,
    /// All laws of transmissions.
    pub laws: Vec<PlannedLaw>,
    /// The equations of all groups, where rates beyond accelerations are asked for.
    pub rate_groups: Option<Vec<RateGroup>>,
    /// Slots of those that lose power, where that counts.
    pub losing: Vec<usize>,
    /// Loads against the motion that a run may hold.
    pub opposing: Vec<Opposing>,
    /// Train groups of forces.
    pub train_forces: Vec<TrainForces>,
    /// Bodies without mass that something may act on: they start without load.
    pub massless: Vec<usize>,
    /// Steps that add loads to the bodies.
    pub loads: Vec<LoadStep>,
    /// Lines of unknown forces.
    pub lines: Vec<ForceLine>,
    pub forces: Vec<ForceStep>,
    /// Systems of the general steps of forces.
    pub balance_systems: Vec<BalanceSystem>,
    /// What holds welded links, from those whose frames bodies have outwards.
    pub welds: Vec<PlannedWeld>,
    /// The joint of every reaction slot.
    pub reactions: Vec<GroupJoint>,
    /// The reaction slots of every pair.
    pub reactions_of: ByPair,
    /// What rubs, group by group.
    pub friction: Vec<FrictionElement>,
    /// What rubs in every pair.
    pub friction_of: ByPair,
    /// Slots of reactions with their signs: what presses on a link in a hinge of several, see [`FrictionElement::pin`].
    pub pin_slots: Vec<(usize, f64)>,
    /// Number of unknown efforts.
    pub efforts: usize,
    /// The equations by which positions are checked.
    pub checks: Checks,
    pub effects: Effects,
    pub settings: Settings,
    /// See [`Plan::is_batchable`].
    pub closed: bool,
}

impl Plan {
    /// All designed cams, those last from which followers part.
    pub fn all_cams(&self) -> impl Iterator<Item = &CamStep> {
        self.cams.iter().chain(&self.parting_cams)
    }

    /// Whether every step has a closed form and every load is a number, so that several positions go side by side.
    #[must_use]
    pub const fn is_batchable(&self) -> bool {
        self.closed
    }

    /// What [`Plan::is_batchable`] is for the steps planned.
    pub fn find_closed(&self) -> bool {
        let closed = |step: &ForceStep| {
            !matches!(
                step,
                ForceStep::Triad(_)
                    | ForceStep::General { .. }
                    | ForceStep::Sequence(_)
                    | ForceStep::Friction { .. }
            )
        };
        let followed = |step: &MotionStep| matches!(step, MotionStep::Triad { .. });
        self.general.is_empty()
            && !self.effects.beyond
            && !self.motion.iter().any(followed)
            && self.parts.is_empty()
            && self.cams.is_empty()
            && self.genevas.is_empty()
            && self.laws.is_empty()
            && self.forces.iter().all(closed)
            && !self.loads.iter().any(|load| matches!(load, LoadStep::Evaluated(_)))
    }

    /// Whether forces are wanted and there is something to solve for them.
    #[must_use]
    pub const fn has_forces(&self) -> bool {
        self.effects.forces && !(self.forces.is_empty() && self.welds.is_empty())
    }

    /// What [`Plan::massless`] is for the loads and forces planned. The closed forms do not ask what the ground carries: where
    /// all is closed it is among them only if a load acts on it.
    pub fn find_massless(&self) -> Vec<usize> {
        let asked = |slot: usize| {
            slot > 0 || !self.is_batchable() || self.loads.iter().any(|load| load.acts_on(slot))
        };
        let mut heavy = vec![false; self.bodies];
        for load in &self.loads {
            if let LoadStep::Mass { body, .. } = load {
                heavy[*body] = true;
            }
        }
        (0..self.bodies).filter(|&slot| !heavy[slot] && asked(slot)).collect()
    }

    /// Whether a step of motion starts from where its bodies stand.
    #[must_use]
    pub fn goes_on(&self) -> bool {
        let goes_on = |step: &MotionStep| {
            matches!(
                step,
                MotionStep::Triad { .. }
                    | MotionStep::Train { .. }
                    | MotionStep::General { .. }
                    | MotionStep::Geneva { .. }
            )
        };
        self.motion.iter().any(goes_on)
    }
}
