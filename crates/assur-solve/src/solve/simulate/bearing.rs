//! What friction, losses and closed stops bear at an instant of a motion.

use crate::position::{Against, ContactMode, Forces, Motion};

/// What bears the loads at an instant of a motion, beside reactions.
#[derive(Clone, Debug, Default)]
pub(crate) struct Bearing {
    /// What closed stops bear.
    pub stops: Vec<f64>,
    /// How the elements of friction move, where that is known.
    pub grips: Vec<ContactMode>,
    /// How the loads against the motion act.
    pub against: Vec<Against>,
}

impl Bearing {
    pub fn set(&self, motion: &mut Motion) {
        motion.stops.clone_from(&self.stops);
        motion.grips.clone_from(&self.grips);
        motion.against.clone_from(&self.against);
    }
}

/// The same with the forces that go with it.
pub(crate) type Spread = Option<Box<(Bearing, Forces)>>;
