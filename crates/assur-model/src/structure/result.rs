//! The structure of a mechanism.

use super::count::Count;
use super::effort::Effort;
use super::error::StructureError;
use super::group::Group;
use super::joint::Replaced;
use crate::model::{LinkId, PairId};

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
    pub force_defect: Option<StructureError>,
    /// Links whose rotation changes nothing (a free roller): not solved.
    pub passive: Vec<LinkId>,
    /// Prismatic pairs whose couples are not determined, in order: they close a chain of prismatic pairs.
    pub undetermined_couples: Vec<PairId>,
}
