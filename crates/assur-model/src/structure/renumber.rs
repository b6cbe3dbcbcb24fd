//! The same structure with the numbers of another mechanism, in the memory that it has.

use super::EffortKind;
use super::count::Structure;
use super::joint::{Joint, JointKind};
use crate::model::{Guide, Mechanism, PairKind};

impl Structure {
    /// Whether [`Structure::renumber`] knows all of a mechanism's pairs, and the structure holds for all lengths: hinges, guides,
    /// slots and cylinders, forces that are determined, no driven point.
    #[must_use]
    pub fn is_renumbered(&self, mechanism: &Mechanism) -> bool {
        let points =
            self.drives.iter().any(|d| matches!(d.kind, EffortKind::Point(_) | EffortKind::Place(..)));
        let other = |kind: &PairKind| matches!(kind, PairKind::Contact { .. } | PairKind::Transmission(_));
        !self.replaced.has_parts()
            && self.force_defect.is_none()
            && !points
            && !mechanism.pairs.iter().any(|pair| other(&pair.kind))
    }

    /// Takes over the numbers of a mechanism that differs in nothing else from the one whose structure this is, see
    /// [`Structure::is_renumbered`].
    pub fn renumber(&mut self, mechanism: &Mechanism) {
        for joint in &mut self.replaced.joints {
            match &mechanism.pair(joint.pair).kind {
                PairKind::Revolute(pins) => {
                    if let JointKind::Revolute(members) = &mut joint.kind {
                        members.iter_mut().zip(pins).for_each(|(member, pin)| member.1 = pin.at);
                    }
                }
                PairKind::Prismatic(line) => {
                    if let JointKind::Prismatic { point, direction, .. } = &mut joint.kind {
                        (*point, *direction) = (line.point, line.direction);
                    }
                    lie(joint, line);
                }
                PairKind::Slot(line) => {
                    // the pin comes before the block
                    if let JointKind::Revolute(members) = &mut joint.kind
                        && let Some(pin) = members.first_mut()
                    {
                        pin.1 = line.point;
                    }
                    lie(joint, line);
                }
                PairKind::Cylinder { barrel, from, to, .. } => {
                    // barrel and rod are hinged at their origins
                    if let JointKind::Revolute(members) = &mut joint.kind
                        && let [first, second] = members.as_mut_slice()
                    {
                        if second.0.0 == barrel.index() { first.1 = from.at } else { second.1 = to.at }
                    }
                }
                PairKind::Contact { .. } | PairKind::Transmission(_) | PairKind::Weld { .. } => {}
            }
        }
    }
}

/// Puts the line of a prismatic joint where it lies in the guide.
fn lie(joint: &mut Joint, line: &Guide) {
    if let JointKind::Prismatic { through, along, .. } = &mut joint.kind {
        (*through, *along) = (line.through, line.along);
    }
}
