//! Changes of a mechanism, tried before a help speaks of them.

use super::effort::{self, Effort, EffortKind, EffortSource, X_AXES};
use super::incidence::Incidence;
use super::joint::{BodyOrigin, Joint, JointKind, Replaced};
use super::lines;
use super::replace;
use super::replace::mark_chains;
use crate::model::{DriveId, LinkId, Mechanism, PairId, PairKind};

/// A mechanism to be changed.
#[derive(Clone, Copy)]
pub(super) struct Trial<'a> {
    pub mechanism: &'a Mechanism,
    pub replaced: &'a Replaced,
    /// Drives, or unknown efforts on the side of forces.
    pub efforts: &'a [Effort],
}

/// Bodies times changes tried for one help: a help comes at once in a long file too.
const EFFORT: usize = 10_000;

impl Trial<'_> {
    /// How many changes are tried, of those that might be.
    pub(super) fn most_tried(&self, might: usize) -> usize {
        might.min(4 + EFFORT / self.replaced.bodies.len())
    }

    /// Leaves out pairs, and drives or unknown efforts.
    pub(super) fn without(&self, pairs: &[PairId], efforts: &[usize]) -> Incidence {
        let mut replaced = self.replaced.clone();
        remove_pairs(&mut replaced, pairs);
        mark_chains(&mut replaced);
        let left = self.efforts.iter().enumerate().filter(|(i, _)| !efforts.contains(i));
        Incidence::new(&replaced, &left.map(|(_, e)| e.clone()).collect::<Vec<_>>())
    }

    /// Takes one link out of a pin of several.
    pub(super) fn without_member(&self, pair: PairId, link: LinkId) -> Incidence {
        let mut replaced = self.replaced.clone();
        remove_member(&mut replaced, pair, link);
        self.after(replaced)
    }

    /// Leaves out links with their pairs; a pin of several links keeps the others.
    pub(super) fn without_links(&self, links: &[LinkId]) -> Incidence {
        let mut replaced = self.replaced.clone();
        for &link in links {
            for (i, pair) in self.mechanism.pairs.iter().enumerate() {
                match &pair.kind {
                    kind if !kind.links().contains(&link) => {}
                    PairKind::Revolute(pins) if pins.len() > 2 => {
                        remove_member(&mut replaced, PairId::at(i), link);
                    }
                    _ => remove_pairs(&mut replaced, &[PairId::at(i)]),
                }
            }
            let body = self.replaced.body_of(link);
            replaced.bodies[body.0].known |= self.replaced.links_of(body).len() == 1;
        }
        self.after(replaced)
    }

    fn after(&self, mut replaced: Replaced) -> Incidence {
        mark_chains(&mut replaced);
        Incidence::new(&replaced, self.efforts)
    }

    /// Makes a prismatic pair a slot. `None` where something is driven: its joint is counted anew.
    pub(super) fn as_slot(&self, pair: PairId) -> Option<Incidence> {
        let PairKind::Prismatic(guide) = &self.mechanism.pair(pair).kind else { return None };
        self.with_kind(pair, PairKind::Slot(guide.clone()))
    }

    /// Makes a slot a prismatic pair.
    pub(super) fn as_prismatic(&self, pair: PairId) -> Option<Incidence> {
        let PairKind::Slot(guide) = &self.mechanism.pair(pair).kind else { return None };
        self.with_kind(pair, PairKind::Prismatic(guide.clone()))
    }

    /// Makes a pair one of another kind.
    fn with_kind(&self, pair: PairId, kind: PairKind) -> Option<Incidence> {
        let mut mechanism = self.mechanism.clone();
        mechanism.pairs[pair.index()].kind = kind;
        let replaced = replace::replace(&mechanism);
        let efforts = effort::of_drives(&mechanism, &replaced);
        (efforts.len() == self.efforts.len()).then(|| Incidence::new(&replaced, &efforts))
    }

    /// Whether added pairs lay no lines on each other that cannot be parallel.
    pub(super) fn agrees_with(&self, pairs: &[PairKind]) -> bool {
        lines::agree(self.mechanism, &self.replaced_with(pairs))
    }

    fn replaced_with(&self, pairs: &[PairKind]) -> Replaced {
        let mut replaced = self.replaced.clone();
        for (i, kind) in pairs.iter().enumerate() {
            replaced.add_pair(PairId::at(self.mechanism.pairs.len() + i), kind);
        }
        replaced
    }

    /// Adds pairs, and drives or unknown efforts.
    pub(super) fn with(&self, pairs: &[PairKind], kinds: &[EffortKind]) -> Incidence {
        let mut replaced = self.replaced_with(pairs);
        mark_chains(&mut replaced);
        let mut efforts = self.efforts.to_vec();
        // where it would be declared makes no difference
        let source = EffortSource::Drive(DriveId::at(0));
        efforts.extend(kinds.iter().map(|&kind| Effort { source, kind, also: Vec::new(), axes: X_AXES }));
        Incidence::new(&replaced, &efforts)
    }
}

/// Empties the joints of pairs: joints keep their numbers.
fn remove_pairs(replaced: &mut Replaced, pairs: &[PairId]) {
    for joint in replaced.joints.iter_mut().filter(|j| pairs.contains(&j.pair)) {
        joint.kind = JointKind::Revolute(Vec::new());
    }
    for body in &mut replaced.bodies {
        body.known |= matches!(body.origin, BodyOrigin::Imaginary(p) if pairs.contains(&p));
    }
}

fn remove_member(replaced: &mut Replaced, pair: PairId, link: LinkId) {
    let body = replaced.body_of(link);
    let of_pair = |j: &&mut Joint| j.pair == pair;
    for joint in replaced.joints.iter_mut().filter(of_pair) {
        if let JointKind::Revolute(members) = &mut joint.kind {
            members.retain(|m| m.0 != body);
        }
    }
}
