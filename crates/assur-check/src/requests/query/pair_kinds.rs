//! Which kinds of pairs have what is asked of them.

use assur_model::model::{Pair, PairKind};

/// Which kinds have it, and what is said where another is named.
type Kinds = (fn(&Pair) -> bool, Option<&'static str>);

/// Pairs in which a point slides along a line.
pub(super) const ALONG_LINE: Kinds = (slides, Some("it is defined where a point slides along a line"));
pub(super) const GUIDE: Kinds = (is_guide, Some("it is defined for prismatic pairs"));

const fn slides(pair: &Pair) -> bool {
    match &pair.kind {
        PairKind::Prismatic(_) | PairKind::Slot(_) | PairKind::Cylinder { .. } => true,
        PairKind::Revolute(_)
        | PairKind::Contact { .. }
        | PairKind::Weld { .. }
        | PairKind::Transmission(_) => false,
    }
}

const fn is_guide(pair: &Pair) -> bool {
    matches!(pair.kind, PairKind::Prismatic(_))
}

/// Whether a pair exchanges a couple.
pub(super) fn has_moment(pair: &Pair) -> bool {
    match &pair.kind {
        PairKind::Prismatic(_)
        | PairKind::Revolute(_)
        | PairKind::Weld { .. }
        | PairKind::Transmission(_) => true,
        PairKind::Contact { .. } => pair.friction.is_some_and(|friction| friction.arm() > 0.0),
        PairKind::Slot(_) | PairKind::Cylinder { .. } => false,
    }
}

/// Whether a pair has a normal, and friction across it.
pub(super) const fn has_normal(pair: &Pair) -> bool {
    match &pair.kind {
        PairKind::Prismatic(_) | PairKind::Slot(_) | PairKind::Contact { .. } => true,
        PairKind::Revolute(_)
        | PairKind::Cylinder { .. }
        | PairKind::Weld { .. }
        | PairKind::Transmission(_) => false,
    }
}
