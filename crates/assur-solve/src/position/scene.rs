//! What every position is computed from.

use crate::model::Mechanism;
use crate::plan::Plan;
use crate::structure::Structure;

/// A compiled mechanism: what every position is solved from.
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a> {
    /// The mechanism.
    pub mechanism: &'a Mechanism,
    /// Its structure.
    pub structure: &'a Structure,
    /// Its plan.
    pub plan: &'a Plan,
}
