//! How many states of the forces satisfy the laws of friction and of losses at a position.

/// Forces depend on the signs of normal forces and on the direction in which power flows, and these on the forces.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Consistent {
    /// The one reported is the only one, or is reached continuously from that without friction and losses.
    #[default]
    One,
    /// Several, one of which is reported.
    Several {
        /// How many.
        count: usize,
        /// The one reported is reached continuously from that without friction and losses.
        followed: bool,
    },
    /// None.
    None,
    /// The search was given up.
    Undecided,
}
