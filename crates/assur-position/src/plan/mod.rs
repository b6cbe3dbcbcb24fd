//! Structure → Plan: a flat list of steps with slots, in the order of solution, with the effects that the file calls for.

mod by_pair;
mod cam;
mod cam_step;
mod checks;
mod effects;
pub mod equation;
mod exact_vec;
mod force_step;
mod forces;
mod friction;
mod friction_step;
mod general;
mod general_step;
mod geneva;
mod geneva_step;
mod geometry;
mod joint;
mod load_step;
mod loads;
mod motion;
mod opposing;
mod planned;
mod renumber;
mod settings;
pub mod step;
mod train;
mod train_losses;
mod train_step;
mod triad;
mod triad_step;
mod weld;

pub use crate::model::Level;
pub use by_pair::ByPair;
pub use cam::{contact_in, is_follower, is_turned};
pub use cam_step::CamStep;
pub use checks::{Checks, EffortCheck, JointCheck, ReactionCheck};
pub use effects::Effects;
pub use exact_vec::ExactVec;
pub use force_step::{DrivenPart, EffortLine, ForceStep, Inner};
pub use friction_step::{FrictionElement, FrictionGroup, FrictionLaw};
pub use general_step::{BalanceSystem, GeneralMotion, SharedPlace, UnknownForce};
pub use geneva::{geneva_in, is_wheel};
pub use geneva_step::GenevaStep;
pub use joint::{Guide, Hinge, OuterJoint};
pub use load_step::{ForceLine, LoadStep};
pub use opposing::{Opposing, Path};
pub use planned::Plan;
pub use settings::{Precision, Settings};
pub use step::{Anchor, Arm, DrivenJoint, DrivenLeg, Leg, MotionStep, Slide};
pub use train_losses::loss_system;
pub use triad_step::{TriadForceLeg, TriadForces, TriadHold, TriadLeg, TriadMotion};

pub use weld::{PlannedPart, PlannedWeld};

pub use train_step::{
    LawSite, PlannedLaw, TrainEffort, TrainForces, TrainMember, TrainMotion, TrainSource, TrainSupport,
};

use crate::model::Mechanism;
use crate::structure::{EffortKind, EffortSource, GroupJoint, Structure};

/// Plans what the file calls for.
#[must_use]
pub fn plan(mechanism: &Mechanism, structure: &Structure) -> Plan {
    plan_with(mechanism, structure, Effects::of(mechanism))
}

#[must_use]
pub fn plan_with(mechanism: &Mechanism, structure: &Structure, effects: Effects) -> Plan {
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
    plan.parts = weld::parts(structure);
    plan.laws = train::laws(mechanism, structure);
    motion::plan(mechanism, structure, &mut plan);
    let determinate = structure.force_defect.is_none();
    if plan.effects.simulated || (plan.effects.forces && determinate) {
        loads::plan(mechanism, &plan.effects, &mut plan.loads);
    }
    if plan.effects.simulated {
        plan.parting_cams = cam::parting(mechanism);
        plan.opposing = opposing::plan(mechanism, structure);
    }
    if plan.effects.forces && determinate {
        loads::lines(mechanism, structure, &mut plan.lines);
        forces::plan(structure, &mut plan);
        if plan.effects.friction {
            friction::plan(mechanism, structure, &mut plan);
        }
        weld::welds(structure, &mut plan);
        if plan.effects.losses {
            train::number_losses(&mut plan);
        }
        let pair_of = |joint: &GroupJoint| structure.replaced.joint(joint.joint).pair;
        plan.reactions_of = ByPair::of(&plan.reactions.iter().map(pair_of).collect::<Vec<_>>());
        plan.friction_of = ByPair::of(&plan.friction.iter().map(|e| e.pair).collect::<Vec<_>>());
    }
    if plan.effects.beyond {
        plan.rate_groups = equation::rate_groups(mechanism, structure, &plan);
    }
    plan.closed = plan.find_closed();
    if plan.effects.loaded() {
        plan.massless = plan.find_massless();
    }
    plan.checks = checks::plan(mechanism, structure, &plan);
    plan
}
