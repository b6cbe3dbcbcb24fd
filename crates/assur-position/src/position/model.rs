//! What every position is computed from.

use crate::model::{Drive, DriveTarget, Mechanism};
use crate::plan::Plan;
use crate::structure::{JointKind, Structure};

/// A compiled mechanism: what every position is solved from.
#[derive(Clone, Copy, Debug)]
pub struct Model<'a> {
    pub mechanism: &'a Mechanism,
    pub structure: &'a Structure,
    pub plan: &'a Plan,
}

/// Whether a drive's value is an angle.
pub fn turns(model: &Model<'_>, drive: &Drive) -> bool {
    match drive.target {
        DriveTarget::Link(_) => true,
        DriveTarget::Pair(pair) => {
            matches!(model.mechanism.pair(pair).kind, crate::model::PairKind::Revolute(_))
        }
        DriveTarget::Point(..) | DriveTarget::Place(..) => false,
    }
}

/// A length of the mechanism's order, m: the farthest point of a joint from the origin of its body.
#[must_use]
pub fn extent(model: &Model<'_>) -> f64 {
    let of = |kind: &JointKind| match kind {
        JointKind::Revolute(members) => members.iter().map(|m| m.1.norm()).fold(0.0, f64::max),
        JointKind::Prismatic { point, through, offset, .. } => point.norm().max(through.norm()).max(*offset),
        JointKind::Weld { at, .. } => at.norm(),
        JointKind::Law(_) => 0.0,
    };
    let extent = model.structure.replaced.joints.iter().map(|j| of(&j.kind)).fold(0.0, f64::max);
    // of links that stand freely
    let points =
        || model.mechanism.links.iter().flat_map(|link| link.points.iter().map(|point| point.at.norm()));
    let extent = if extent > 0.0 { extent } else { points().fold(0.0, f64::max) };
    if extent > 0.0 { extent } else { 1.0 }
}
