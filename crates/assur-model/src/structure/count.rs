//! Mobility F = 3n − 2P_L − P_H, corrected for passive freedoms and chains of prismatic pairs.

use super::effort::{Effort, EffortKind};
use super::joint::{JointKind, Replaced};
use crate::model::{DriveTarget, Mechanism};

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
    let n = mechanism.links.len().saturating_sub(1 + outer);
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
