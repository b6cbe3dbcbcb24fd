//! The step that moves the follower of a designed cam.

use crate::element::cam::Cam;
use crate::model::CamContact;

/// The follower of a designed cam, with the imaginary block that stands for the contact.
#[derive(Clone, Debug)]
pub struct CamStep {
    /// The cam.
    pub cam: Cam,
    /// Where it touches which follower.
    pub contact: CamContact,
    /// Index of the contact in the mechanism.
    pub index: usize,
    /// Slot of the block.
    pub block: usize,
}
