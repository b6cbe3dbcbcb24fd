//! Changes of a mechanism, tried before a help speaks of them.

use super::effort::{Effort, EffortKind, EffortSource};
use super::incidence::{Fit, fit};
use super::joint::{BodyId, BodyOrigin, JointKind, Replaced};
use super::replace::{self, mark_chains};
use crate::model::{DriveId, Mechanism, PairId, PairKind};

/// A mechanism to be changed.
#[derive(Clone, Copy)]
pub(super) struct Trial<'a> {
    pub mechanism: &'a Mechanism,
    pub replaced: &'a Replaced,
    /// Drives, or unknown efforts on the side of forces.
    pub efforts: &'a [Effort],
}

impl Trial<'_> {
    /// Leaves out a drive or an unknown effort.
    pub(super) fn without_effort(&self, index: usize) -> Fit {
        let mut efforts = self.efforts.to_vec();
        efforts.remove(index);
        fit(self.replaced, &efforts)
    }

    /// Leaves out pairs, and a link with them.
    pub(super) fn without_pairs(&self, pairs: &[PairId], link: Option<BodyId>) -> Fit {
        let mut replaced = self.replaced.clone();
        for joint in replaced.joints.iter_mut().filter(|j| pairs.contains(&j.pair)) {
            joint.kind = JointKind::Revolute(Vec::new());
        }
        for (i, body) in replaced.bodies.iter_mut().enumerate() {
            let imaginary = matches!(body.origin, BodyOrigin::Imaginary(p) if pairs.contains(&p));
            body.known |= imaginary || link == Some(BodyId(i));
        }
        mark_chains(&mut replaced);
        fit(&replaced, self.efforts)
    }

    /// Adds a pair.
    pub(super) fn with_pair(&self, kind: &PairKind) -> Fit {
        let mut replaced = self.replaced.clone();
        replaced.add_pair(PairId::at(self.mechanism.pairs.len()), kind);
        mark_chains(&mut replaced);
        fit(&replaced, self.efforts)
    }

    /// Makes a prismatic pair a slot. `None` where something is driven: its joint is counted anew.
    pub(super) fn as_slot(&self, pair: PairId) -> Option<Fit> {
        let PairKind::Prismatic(guide) = &self.mechanism.pair(pair).kind else { return None };
        let mut mechanism = self.mechanism.clone();
        mechanism.pairs[pair.index()].kind = PairKind::Slot(guide.clone());
        let replaced = replace::replace(&mechanism);
        let efforts = super::effort::of_drives(&mechanism, &replaced);
        (efforts.len() == self.efforts.len()).then(|| fit(&replaced, &efforts))
    }

    /// Adds drives or unknown efforts.
    pub(super) fn with_efforts(&self, kinds: &[EffortKind]) -> Fit {
        let mut efforts = self.efforts.to_vec();
        // where it would be declared makes no difference
        let source = EffortSource::Drive(DriveId::at(0));
        efforts.extend(kinds.iter().map(|&kind| Effort { source, kind }));
        fit(self.replaced, &efforts)
    }
}
