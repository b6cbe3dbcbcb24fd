//! Links that carry no bending.

use super::{LinkId, LoadId, PairId};

/// A link with two hinges and nothing between them: only a force along it can act.
#[derive(Clone, Debug, PartialEq)]
pub struct Bar {
    pub link: LinkId,
    /// The hinge at its one end.
    pub from: PairId,
    /// The hinge at its other end, whose forces are known.
    pub to: PairId,
    /// All pairs at that end.
    pub pairs: Vec<PairId>,
    /// All loads on the link at that end.
    pub loads: Vec<LoadId>,
}
