//! Which kinds of pairs have what is asked of them.

use assur_model::model::PairKind;

/// Which kinds have it, and what is said where another is named.
type Kinds = (fn(&PairKind) -> bool, Option<&'static str>);

/// Pairs in which a point slides along a line.
pub(super) const ALONG_LINE: Kinds = (slides, Some("it is defined where a point slides along a line"));
pub(super) const GUIDE: Kinds = (is_guide, Some("it is defined for prismatic pairs"));

const fn slides(kind: &PairKind) -> bool {
    match kind {
        PairKind::Prismatic(_) | PairKind::Slot(_) | PairKind::Cylinder { .. } => true,
        PairKind::Revolute(_)
        | PairKind::Contact { .. }
        | PairKind::Weld { .. }
        | PairKind::Transmission(_) => false,
    }
}

const fn is_guide(kind: &PairKind) -> bool {
    matches!(kind, PairKind::Prismatic(_))
}

/// Whether a pair exchanges a couple.
pub(super) const fn has_moment(kind: &PairKind) -> bool {
    match kind {
        PairKind::Prismatic(_)
        | PairKind::Revolute(_)
        | PairKind::Weld { .. }
        | PairKind::Transmission(_) => true,
        PairKind::Slot(_) | PairKind::Contact { .. } | PairKind::Cylinder { .. } => false,
    }
}

/// Whether a pair has a normal, and friction across it.
pub(super) const fn has_normal(kind: &PairKind) -> bool {
    match kind {
        PairKind::Prismatic(_) | PairKind::Slot(_) | PairKind::Contact { .. } => true,
        PairKind::Revolute(_)
        | PairKind::Cylinder { .. }
        | PairKind::Weld { .. }
        | PairKind::Transmission(_) => false,
    }
}
