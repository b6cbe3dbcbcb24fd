//! Which losses of transmissions a step of forces takes into account.

/// What becomes of the power that passes through transmissions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Losses {
    /// All of it arrives.
    None,
    /// The direction in which it flows is found.
    Found,
    /// It flows in the senses that are set.
    InSenses,
}
