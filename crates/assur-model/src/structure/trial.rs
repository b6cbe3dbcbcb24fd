//! Changes of a mechanism, tried before a help speaks of them.

use super::defect::Fit;
use super::effort::{self, Effort, EffortKind, EffortSource, X_AXES};
use super::incidence::Incidence;
use super::islands::floating_islands;
use super::joint::Replaced;
use super::lines;
use super::places;
use super::replace;
use super::replace::mark_chains;
use super::roller::turned;
use super::weld_defects;
use crate::model::{DriveId, LinkId, Mechanism, Pair, PairId, PairKind};
use crate::source::Span;

/// A mechanism to be changed.
#[derive(Clone, Copy)]
pub(super) struct Trial<'a> {
    pub mechanism: &'a Mechanism,
    pub replaced: &'a Replaced,
    /// Drives, or unknown efforts on the side of forces.
    pub efforts: &'a [Effort],
}

/// A statement that may be left out; a drive or an unknown effort by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Statement {
    Pair(PairId),
    Link(LinkId),
    Effort(usize),
}

/// Statements that go, pairs as they would be written, and more pairs.
#[derive(Clone, Debug, Default)]
pub(super) struct Change {
    pub out: Vec<Statement>,
    pub written: Vec<(PairId, PairKind)>,
    pub added: Vec<PairKind>,
}

impl Change {
    pub(super) fn without(statement: Statement) -> Self {
        Self::without_all(vec![statement])
    }

    pub(super) fn without_all(out: Vec<Statement>) -> Self {
        Self { out, ..Self::default() }
    }

    pub(super) fn adding(kind: PairKind) -> Self {
        Self { added: vec![kind], ..Self::default() }
    }

    pub(super) fn writing(pair: PairId, kind: PairKind) -> Self {
        Self { written: vec![(pair, kind)], ..Self::default() }
    }
}

/// What a change makes of a mechanism.
pub(super) struct Outcome {
    pub fit: Fit,
    /// No link is loose of the ground, and no weld, line or roller is wrong.
    pub is_whole: bool,
    pub incidence: Incidence,
}

impl Outcome {
    /// Nothing is too many and nothing loose.
    pub(super) fn is_sound(&self) -> bool {
        self.is_whole && self.fit == Fit::default() && self.incidence.split().is_none()
    }
}

/// Bodies times changes tried for one help: a help comes at once in a long file too.
const EFFORT: usize = 10_000;

impl Trial<'_> {
    /// How many changes are tried, of those that might be.
    pub(super) fn most_tried(&self, might: usize) -> usize {
        might.min(4 + EFFORT / self.replaced.bodies.len())
    }

    /// Leaves out a drive or an unknown effort.
    pub(super) fn without_effort(&self, effort: usize) -> Incidence {
        let left = self.efforts.iter().enumerate().filter(|(i, _)| *i != effort);
        Incidence::new(self.replaced, &left.map(|(_, e)| e.clone()).collect::<Vec<_>>())
    }

    /// The mechanism with statements left out or written anew. Pairs keep their numbers: one that goes joins nothing.
    pub(super) fn after(&self, change: &Change) -> Outcome {
        let mut mechanism = self.mechanism.clone();
        let mut gone = Vec::new();
        let mut drives = Vec::new();
        for statement in &change.out {
            match *statement {
                Statement::Pair(pair) => gone.extend(leave_out(&mut mechanism.pairs[pair.index()].kind)),
                Statement::Link(link) => {
                    gone.push(link);
                    leave_out_link(&mut mechanism, link);
                }
                Statement::Effort(effort) => drives.extend(match self.efforts[effort].source {
                    EffortSource::Drive(id) => Some(id.index()),
                    EffortSource::Balance(_) => None,
                }),
            }
        }
        for (pair, kind) in &change.written {
            mechanism.pairs[pair.index()].kind = kind.clone();
        }
        mechanism.pairs.extend(change.added.iter().cloned().map(|kind| Pair {
            name: String::new(),
            span: Span::default(),
            kind,
            friction: None,
            bearing: None,
        }));
        let mut index = 0..;
        mechanism.drives.retain(|_| index.next().is_some_and(|i| !drives.contains(&i)));
        let mut replaced = replace::replace(&mechanism);
        gone.iter().for_each(|link| replaced.bodies[link.index()].known = true);
        let efforts = effort::of_drives(&mechanism, &replaced);
        let incidence = Incidence::new(&replaced, &efforts);
        let islands = floating_islands(&mechanism);
        let is_whole = islands.iter().flatten().all(|link| gone.contains(link))
            && lines::agree(&mechanism, &replaced)
            && places::agree(&mechanism, &replaced, &efforts)
            && weld_defects::defects(&mechanism, &replaced).is_empty()
            && turned(&mechanism, &replaced.passive).is_empty();
        Outcome { fit: incidence.fit(), is_whole, incidence }
    }

    /// Whether added pairs lay no lines on each other that cannot be parallel.
    pub(super) fn agrees_with(&self, pairs: &[PairKind]) -> bool {
        let replaced = self.replaced_with(pairs);
        lines::agree(self.mechanism, &replaced) && places::agree(self.mechanism, &replaced, &[])
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

/// Makes a pair one that joins nothing. The links that it brought along go too.
pub(super) fn leave_out(kind: &mut PairKind) -> Vec<LinkId> {
    match std::mem::replace(kind, PairKind::Revolute(Vec::new())) {
        PairKind::Cylinder { barrel, rod, .. } => vec![barrel, rod],
        _ => Vec::new(),
    }
}

/// Leaves out the pairs of a link; a pin of several links keeps the others.
pub(super) fn leave_out_link(mechanism: &mut Mechanism, link: LinkId) {
    for pair in mechanism.pairs.iter_mut().filter(|pair| pair.kind.links().contains(&link)) {
        match &mut pair.kind {
            PairKind::Revolute(pins) if pins.len() > 2 => pins.retain(|pin| pin.link != link),
            kind => {
                leave_out(kind);
            }
        }
    }
}
