//! Structure → Plan: a flat list of steps with slots, in the order of solution, with the effects that the file calls for.

mod cam;
mod effects;
mod force_step;
mod forces;
mod formed;
mod friction;
mod general;
mod geometry;
mod loads;
mod motion;
mod settings;
pub mod step;
mod train;
mod train_losses;
mod triad;

pub use crate::model::Level;
pub use cam::CamStep;
pub(crate) use cam::{contact_in, is_follower};
pub use effects::Effects;
pub use force_step::{DrivenPart, EffortLine, ForceStep, Hinge, Inner, OuterJoint, Way};
pub use formed::Formed;
pub use friction::{FrictionElement, Rub, RubbingGroup};
pub use general::{BalanceSystem, GeneralMotion, UnknownForce};
pub use loads::{ForceLine, LoadStep};
pub use settings::{Numbers, Settings};
pub use step::{Anchor, Arm, DrivenJoint, DrivenLeg, Leg, MotionStep, Slide};
pub(crate) use train_losses::loss_system;
pub use triad::{TriadForceLeg, TriadForces, TriadHold, TriadLeg, TriadMotion};

pub use train::{
    LawSite, PlannedLaw, TrainEffort, TrainForces, TrainMember, TrainMotion, TrainSource, TrainSupport,
};

use crate::math::Vec2;
use crate::model::Mechanism;
use crate::structure::{BodyOrigin, EffortKind, EffortSource, GroupJoint, Structure};

/// What is done at every position, in this order: motion, loads, forces.
#[derive(Clone, Debug, Default)]
pub struct Plan {
    /// Number of bodies, imaginary ones among them.
    pub bodies: usize,
    /// Number of drives.
    pub drives: usize,
    /// Bodies driven at a point: slot, the point in the body's frame (m), slot of the drive.
    pub outer: Vec<(usize, Vec2, usize)>,
    /// Steps of motion.
    pub motion: Vec<MotionStep>,
    /// Followers of designed cams.
    pub cams: Vec<CamStep>,
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
    /// Train groups of forces.
    pub train_forces: Vec<TrainForces>,
    /// Bodies without mass that something may act on: they start without load.
    pub massless: Vec<usize>,
    /// Steps that add loads to the bodies.
    pub loads: Vec<LoadStep>,
    /// Lines of unknown forces.
    pub lines: Vec<ForceLine>,
    /// Steps of forces.
    pub forces: Vec<ForceStep>,
    /// Systems of the general steps of forces.
    pub balance_systems: Vec<BalanceSystem>,
    /// The joint of every reaction slot.
    pub reactions: Vec<GroupJoint>,
    /// What rubs, group by group.
    pub friction: Vec<FrictionElement>,
    /// Slots of reactions with their signs: what presses on a link in a hinge of several, see [`FrictionElement::pin`].
    pub pin_slots: Vec<(usize, f64)>,
    /// Number of unknown efforts.
    pub efforts: usize,
    /// What is computed.
    pub effects: Effects,
    /// How accurately.
    pub settings: Settings,
}

/// Plans what the file calls for.
#[must_use]
pub fn plan(mechanism: &Mechanism, structure: &Structure) -> Plan {
    let effects = Effects::of(mechanism);
    let mut plan = Plan {
        bodies: structure.replaced.bodies.len(),
        drives: mechanism.drives.len(),
        efforts: structure.efforts.len(),
        effects,
        cam_contacts: mechanism.cam_contacts.len(),
        ..Plan::default()
    };
    for effort in &structure.drives {
        if let (EffortKind::Point(body), EffortSource::Drive(id)) = (effort.kind, effort.source)
            && let crate::model::DriveTarget::Point(_, at) = mechanism.drives[id.index()].target
        {
            plan.outer.push((body.0, at, id.index()));
        }
    }
    plan.laws = train::laws(mechanism, structure);
    motion::plan(mechanism, structure, &mut plan);
    if plan.effects.forces && structure.force_defect.is_none() {
        plan.loads = loads::plan(mechanism, &plan.effects);
        plan.lines = loads::lines(mechanism, structure);
        forces::plan(structure, &mut plan);
        if plan.effects.friction {
            friction::plan(mechanism, structure, &mut plan);
        }
        plan.massless = plan.find_massless();
    }
    plan
}

impl Plan {
    /// Whether every step has a closed form and every load is a number, so that several positions go side by side.
    #[must_use]
    pub fn laned(&self) -> bool {
        let closed = |step: &ForceStep| {
            !matches!(
                step,
                ForceStep::Triad(_)
                    | ForceStep::General { .. }
                    | ForceStep::Sequence(_)
                    | ForceStep::Rubbing { .. }
            )
        };
        let followed = |step: &MotionStep| matches!(step, MotionStep::Triad { .. });
        self.general.is_empty()
            && !self.motion.iter().any(followed)
            && self.cams.is_empty()
            && self.laws.is_empty()
            && self.forces.iter().all(closed)
            && !self.loads.iter().any(|load| matches!(load, LoadStep::Evaluated(_)))
    }

    /// What [`Plan::massless`] is for the loads and forces planned. The closed forms do not ask what the ground carries: where
    /// all is closed it is among them only if a load acts on it.
    pub(crate) fn find_massless(&self) -> Vec<usize> {
        let asked =
            |slot: usize| slot > 0 || !self.laned() || self.loads.iter().any(|load| load.acts_on(slot));
        let heavy = |slot: usize| {
            self.loads.iter().any(|l| matches!(l, LoadStep::Mass { body, .. } if *body == slot))
        };
        (0..self.bodies).filter(|&slot| !heavy(slot) && asked(slot)).collect()
    }

    /// Whether a step of motion starts from where its bodies stand.
    #[must_use]
    pub fn goes_on(&self) -> bool {
        let goes_on = |step: &MotionStep| {
            matches!(step, MotionStep::Triad { .. } | MotionStep::Train { .. } | MotionStep::General { .. })
        };
        self.motion.iter().any(goes_on)
    }

    /// Whether a body replaces a higher pair.
    #[must_use]
    pub fn is_imaginary(structure: &Structure, body: usize) -> bool {
        matches!(structure.replaced.bodies[body].origin, BodyOrigin::Imaginary(_))
    }
}
