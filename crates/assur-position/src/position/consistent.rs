//! How many states of the forces satisfy the laws of friction and of losses at a position.

/// Forces depend on the signs of normal forces and on the direction in which power flows, and these on the forces.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Consistent {
    /// The one reported is the only one, or is reached continuously from that without friction and losses.
    #[default]
    One,
    /// Several, one of which is reported.
    Several {
        count: usize,
        /// The one reported is reached continuously from that without friction and losses.
        followed: bool,
    },
    None,
    /// The search was given up.
    Undecided,
}

/// Multiplications or so that all searches of a solution may take together: about a second.
const MOST_WORK: f64 = 1e9;
/// What a search may always take, whatever was searched before.
const LEAST_WORK: f64 = 1e6;

/// What searches have taken so far: the more it is, the earlier the next one is given up. No clock decides, so that every
/// machine answers the same.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Searched(f64);

impl Searched {
    /// What the next search may take.
    pub(super) fn left(self) -> f64 {
        (0.5 * (MOST_WORK - self.0)).max(LEAST_WORK)
    }

    pub(super) fn add(&mut self, work: f64) {
        self.0 += work;
    }

    /// With little left: for searches that only improve a message.
    pub fn nearly_spent(self) -> Self {
        Self(self.0.max(0.95 * MOST_WORK))
    }
}
