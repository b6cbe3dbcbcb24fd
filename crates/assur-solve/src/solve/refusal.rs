//! What is refused before any position is looked at: data alone, of which `message` makes the sentences.

use crate::model::{DriveId, LinkId, LoadId, PairId};
use crate::plan::Level;
use crate::source::Span;

/// A request, or a construct, that is refused.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// A construct that is understood and cannot be solved yet, as the checker calls it.
    Unsupported { what: String, places: Vec<Span> },
    /// A designed cam and its follower of which neither moves the other by itself.
    CamFollower(PairId),
    /// Forces through the contact of a designed cam that no step knows.
    CamForces(PairId),
    /// A Geneva wheel that its crank does not move by itself.
    GenevaWheel(PairId),
    /// Forces between the crank and the wheel of a Geneva drive that no step knows.
    GenevaForces(PairId),
    /// Rates are asked for, and no drive has a speed, or not even a sense.
    NeedsSpeed {
        drive: DriveId,
        /// The highest derivative that is needed.
        level: Level,
        places: Vec<Span>,
    },
    /// The range of a drive ends where it begins, which is known only once dead positions are found.
    EmptyRange {
        drive: DriveId,
        /// Its one position, rad or m.
        at: f64,
    },
    /// The rotation of a roller that turns freely is asked for.
    FreeRotation {
        roller: LinkId,
        /// Where it is asked for.
        places: Vec<Span>,
    },
    /// A position depends on a drive that has none.
    NoPosition {
        /// Index into [`crate::model::Mechanism::drives`].
        drive: usize,
        /// What depends on it.
        what: Unpositioned,
    },
    /// A reaction that is asked for has no place.
    NoPlace {
        pair: PairId,
        /// Where it is asked for.
        place: Span,
    },
    /// Friction in these pairs, on which forces of transmissions press whose places are not known.
    FrictionWithoutPlace(Vec<PairId>),
    /// Friction in these pairs goes by the forces at two contacts, and the couple that shares them is not determined.
    OpenCouple(Vec<PairId>),
}

/// What depends on the position of a drive that has none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unpositioned {
    /// How the links of a group are placed: index into [`crate::structure::Structure::motion`].
    Group(usize),
    /// A result that is asked for.
    Asked {
        what: &'static str,
        /// Where it is asked for.
        place: Span,
    },
    /// The place of a force.
    Force(LoadId),
    /// The links, of which all is asked for here.
    Links(Span),
}
