//! Mobility F = 3n − 2P_L − P_H, corrected for passive freedoms and chains of prismatic pairs.

use super::effort::{Effort, EffortKind};
use super::group::Group;
use super::joint::{BodyId, GroupJoint, JointKind, Replaced};
use crate::model::{DriveTarget, LinkId, Mechanism, PairId};
use assur_text::diagnostic::Diagnosis;

/// Numbers of links and pairs, and what follows from them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Count {
    /// Moving links n (outer links driven at a point are not counted).
    pub n: usize,
    /// Lower pairs P_L.
    pub lower: usize,
    /// Higher pairs P_H.
    pub higher: usize,
    /// Passive freedoms: rotations that change nothing.
    pub passive: usize,
    /// Conditions that repeat others: closed chains of prismatic pairs.
    pub redundant: usize,
    /// Mobility: 3n − 2P_L − P_H − passive + redundant.
    pub mobility: i64,
    /// Declared drives of that mobility (driven points are not counted).
    pub drives: usize,
}

pub(super) fn count(mechanism: &Mechanism, replaced: &Replaced, drives: &[Effort]) -> Count {
    let outer = mechanism.drives.iter().filter(|d| matches!(d.target, DriveTarget::Point(..))).count();
    let parts = replaced.parts.iter().flatten().count();
    let n = mechanism.links.len().saturating_sub(1 + outer + parts);
    let lower = mechanism.pairs.iter().map(|p| p.kind.lower()).sum();
    let higher = mechanism.pairs.iter().map(|p| p.kind.higher()).sum();
    let passive = replaced.passive.len();
    let redundant = replaced
        .joints
        .iter()
        .filter(|j| matches!(j.kind, JointKind::Prismatic { angle_redundant: true, .. }))
        .count();
    let signed = |x: usize| i64::try_from(x).unwrap_or(i64::MAX);
    Count {
        n,
        lower,
        higher,
        passive,
        redundant,
        mobility: 3 * signed(n) - 2 * signed(lower) - signed(higher) - signed(passive) + signed(redundant),
        drives: drives.iter().filter(|e| !matches!(e.kind, EffortKind::Point(_))).count(),
    }
}

impl Count {
    /// The count in figures, as `3·3 − 2·4 = 1`.
    #[must_use]
    pub fn formula(&self) -> String {
        let mut text = format!("3·{} − 2·{}", self.n, self.lower);
        if self.higher > 0 {
            text += &format!(" − {}", self.higher);
        }
        if self.passive > 0 {
            text += &format!(" − {} passive", self.passive);
        }
        if self.redundant > 0 {
            text += &format!(" + {} repeated", self.redundant);
        }
        format!("{text} = {}", self.mobility)
    }
}

// The class of a structural group after Artobolevsky: the number of sides of its most complex closed contour.

/// Class I with a drive inside and one body, II for a dyad; III where a rigid link carries three or more pairs of the
/// group; k where k inner pairs close a contour that can change its shape.
pub(super) fn class(bodies: &[BodyId], joints: &[GroupJoint], efforts: &[usize]) -> u8 {
    if bodies.len() == 1 && !efforts.is_empty() {
        return 1;
    }
    if bodies.len() <= 2 {
        return 2;
    }
    let contour = joints
        .iter()
        .filter(|j| j.inner)
        .filter_map(|closing| shortest_contour(bodies, joints, *closing))
        .max()
        .unwrap_or(0);
    u8::try_from(contour.max(3)).unwrap_or(u8::MAX)
}

/// The number of pairs in the shortest closed contour of inner joints through one of them.
fn shortest_contour(bodies: &[BodyId], joints: &[GroupJoint], closing: GroupJoint) -> Option<usize> {
    let mut distance: Vec<Option<usize>> = vec![None; bodies.len()];
    let place = |b: BodyId| bodies.iter().position(|&x| x == b);
    let (start, goal) = (place(closing.body)?, place(closing.base)?);
    distance[start] = Some(0);
    let mut queue = std::collections::VecDeque::from([start]);
    while let Some(at) = queue.pop_front() {
        for j in joints.iter().filter(|j| j.inner && **j != closing) {
            let (Some(a), Some(b)) = (place(j.body), place(j.base)) else { continue };
            let next = if a == at {
                b
            } else if b == at {
                a
            } else {
                continue;
            };
            if distance[next].is_none() {
                distance[next] = distance[at].map(|d| d + 1);
                queue.push_back(next);
            }
        }
    }
    distance[goal].map(|d| d + 1)
}

// The structure of a mechanism.

/// The structure of the mechanism.
#[derive(Clone, Debug)]
pub struct Structure {
    /// Numbers of links and pairs, mobility.
    pub count: Count,
    /// Bodies and joints after every higher pair is replaced by lower ones.
    pub replaced: Replaced,
    /// The known motions, one per drive (several numbers for a driven point).
    pub drives: Vec<Effort>,
    /// Structural groups in the order in which motion is solved, from the drives outwards.
    pub motion: Vec<Group>,
    /// The unknown efforts: balances or, where there is none, the drives' own.
    pub efforts: Vec<Effort>,
    /// Structural groups in the order in which forces are solved, from the outermost loads to the balances. Empty where
    /// efforts do not determine them (see [`Structure::force_defect`]).
    pub forces: Vec<Group>,
    /// Why forces are not determined, where they are not.
    pub force_defect: Option<Diagnosis>,
    /// Links whose rotation changes nothing (a free roller): not solved.
    pub passive: Vec<LinkId>,
    /// Prismatic pairs whose couples are not determined, in order: they close a chain of prismatic pairs.
    pub undetermined_couples: Vec<PairId>,
}
