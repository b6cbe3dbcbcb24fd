//! By how much a group does not close.

use crate::group::triad::{Miss, gap};
use crate::group::{Gap, rpr, rrp, rrr};
use crate::math::Vec2;
use crate::model::PairId;
use crate::plan::{Anchor, MotionStep};
use crate::position::{Model, State};
use crate::structure::{BodyId, EffortKind, EffortSource, GroupJoint, JointKind};

/// By how much a group does not close, with the lengths that make it so. A gap is absent where the closed form sees none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GroupGap {
    /// Two links between two hinges do not meet.
    Reach {
        /// Distance of the outer hinges, m.
        distance: f64,
        /// Lengths of the links, m.
        lengths: [f64; 2],
        gap: Option<Gap>,
    },
    /// A link does not reach the path of the hinge at its end.
    Path {
        /// Its length, m.
        length: f64,
        /// The length that is missing, m.
        short: Option<f64>,
    },
    /// Two hinges are nearer than a guide passes one of them.
    Guide {
        /// Distance of the hinges, m.
        distance: f64,
        /// Offset of the guide, m.
        offset: f64,
        /// The distance that is missing, m.
        near: Option<f64>,
    },
    /// Driven links do not meet.
    Driven,
    /// A link does not close on its three legs.
    Legs(Option<Miss>),
    Parallel,
    /// The follower of a designed cam stands at a lift that the cam has not, m or rad.
    Lift {
        pair: PairId,
        lift: f64,
        /// The least and the greatest of the cam.
        range: [f64; 2],
        /// The lift is an angle.
        oscillates: bool,
        /// The cam angles of the dwell at this lift, rad, from and to.
        dwell: Option<[f64; 2]>,
    },
}

/// Where over a turn of the drive the first group that stays open is farthest from closing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TurnGap {
    /// The value of the drive, rad.
    pub at: f64,
    /// Index into [`crate::structure::Structure::motion`].
    pub group: usize,
    pub gap: GroupGap,
}

impl GroupGap {
    /// What is missing, m or rad; `None` where no number is known.
    pub(super) fn missing(&self) -> Option<f64> {
        match *self {
            Self::Reach { gap: Some(Gap::TooFar(gap) | Gap::TooNear(gap)), .. }
            | Self::Path { short: Some(gap), .. }
            | Self::Guide { near: Some(gap), .. }
            | Self::Legs(Some(Miss::Pair { gap, .. })) => Some(gap),
            Self::Legs(Some(Miss::Third { gap, .. })) => Some(gap.abs()),
            Self::Lift { lift, range: [least, most], dwell: None, .. } => {
                Some((lift - most).max(least - lift))
            }
            _ => None,
        }
    }
}

/// By how much a group does not close in a state in which its step was run.
pub(super) fn group_gap(model: &Model<'_>, state: &State, index: usize) -> GroupGap {
    let at = |a: &Anchor| state.motion.bodies[a.body].position(a.at);
    match &model.plan.motion[index] {
        MotionStep::Rrr { legs, .. } => {
            reach([at(&legs[0].base), at(&legs[1].base)], [legs[0].length, legs[1].length])
        }
        MotionStep::DrivenRrr { legs, .. } => {
            reach([at(&legs[0].base), at(&legs[1].base)], [0, 1].map(|i| state.leg_length(&legs[i])))
        }
        MotionStep::Rrp { branch, leg, slide, from_point, .. } => {
            let base = &state.motion.bodies[slide.base];
            let (q, d) = (base.position(slide.origin), slide.along.turned(base.u));
            let h = from_point.of::<f64>().y + state.branches[*branch].sides[0] * slide.radius;
            let short = rrp::gap(at(&leg.base), leg.length, q, d, h).map(missing);
            GroupGap::Path { length: leg.length, short }
        }
        MotionStep::Rpr { branch, bases, slide, from_origin, from_point, .. } => {
            let (p_A, p_B) = (at(&bases[0]), at(&bases[1]));
            let side = state.branches[*branch].sides[0];
            let h = from_point.of::<f64>().y + side * slide.radius - from_origin.of::<f64>().y;
            let near = rpr::gap(p_A, p_B, h).map(missing);
            GroupGap::Guide { distance: (p_B - p_A).norm(), offset: h.abs(), near }
        }
        MotionStep::DrivenRrp { .. } => GroupGap::Driven,
        MotionStep::Triad { triad, .. } => GroupGap::Legs(gap(&triad.plate, &state.triad_ends(triad))),
        MotionStep::CamTurned { cam, .. } => {
            let step = &model.plan.cams[*cam];
            let still = || step.cam.program.phases().iter().map(|phase| phase.from);
            let lifts = || step.flanks.iter().flat_map(|flank| flank.lifts).chain(still());
            let dwell = state.cam_dwell(step);
            GroupGap::Lift {
                pair: step.contact.pair,
                lift: dwell.map_or_else(|| state.cam_lift(step).0, |d| d.0),
                range: [lifts().fold(f64::INFINITY, f64::min), lifts().fold(f64::NEG_INFINITY, f64::max)],
                oscillates: step.cam.follower.oscillates(),
                dwell: dwell.map(|d| d.1),
            }
        }
        _ => GroupGap::Parallel,
    }
}

/// By how much an arm of two links does not reach the place of its driven tip; `None` of other groups.
pub(super) fn arm_gap(model: &Model<'_>, state: &State, index: usize) -> Option<GroupGap> {
    let (replaced, group) = (&model.structure.replaced, &model.structure.motion[index]);
    let [upper, fore] = group.bodies[..] else { return None };
    let (outer, inner) = match group.joints[..] {
        [a, b] if !a.prismatic && !b.prismatic && a.inner != b.inner => {
            if a.inner {
                (b, a)
            } else {
                (a, b)
            }
        }
        _ => return None,
    };
    let mut tip = Vec2::zero();
    let mut on = None;
    for &effort in &group.efforts {
        let effort = &model.structure.drives[effort];
        let (EffortKind::Place(body, at, axis), EffortSource::Drive(drive)) = (effort.kind, effort.source)
        else {
            return None;
        };
        tip += axis.unit() * state.motion.inputs[drive.index()].value;
        on = Some((body, at));
    }
    let (fore, at) = on.filter(|(body, _)| [upper, fore].contains(body) && *body != outer.body)?;
    let pin = |joint: GroupJoint, body: BodyId| match &replaced.joint(joint.joint).kind {
        JointKind::Revolute(members) => members.iter().find(|member| member.0 == body).map(|member| member.1),
        _ => None,
    };
    let base = state.motion.bodies[outer.base.0].position(pin(outer, outer.base)?);
    let upper = (pin(inner, outer.body)? - pin(outer, outer.body)?).norm();
    Some(reach([base, tip], [upper, (at - pin(inner, fore)?).norm()]))
}

fn reach([p_A, p_B]: [Vec2; 2], lengths: [f64; 2]) -> GroupGap {
    let gap = rrr::gap(p_A, p_B, lengths[0], lengths[1]);
    GroupGap::Reach { distance: (p_B - p_A).norm(), lengths, gap }
}

const fn missing(gap: Gap) -> f64 {
    match gap {
        Gap::TooFar(gap) | Gap::TooNear(gap) => gap,
    }
}
