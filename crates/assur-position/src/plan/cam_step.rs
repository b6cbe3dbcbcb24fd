//! The step that moves the follower of a designed cam, or the cam by its follower.

use crate::element::cam::{Cam, Flank};
use crate::model::CamContact;

/// A designed cam with its follower, one of which moves the other, with the imaginary block that stands for the contact.
#[derive(Clone, Debug)]
pub struct CamStep {
    pub cam: Cam,
    /// Where it touches which follower.
    pub contact: CamContact,
    /// Index of the contact in the mechanism.
    pub index: usize,
    /// Slot of the block; none where they part.
    pub block: usize,
    /// The flanks on which the follower can turn the cam; a branch has the number of one. Empty where the cam moves the
    /// follower.
    pub flanks: Vec<Flank>,
}
