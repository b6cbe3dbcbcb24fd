//! Typed indices into the tables of a mechanism.

macro_rules! ids {
    ($($(#[$doc:meta])* $name:ident),* $(,)?) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct $name(pub u32);

        impl $name {
            /// The place in the table.
            #[must_use]
            pub const fn index(self) -> usize {
                self.0 as usize
            }

            /// The id of the item at a place in the table.
            #[must_use]
            #[allow(clippy::cast_possible_truncation)] // a file has fewer than 2³² items
            pub const fn at(index: usize) -> Self {
                Self(index as u32)
            }
        }
    )*};
}

ids! {
    /// A link; 0 is the ground.
    LinkId,
    /// A pair as declared.
    PairId,
    DriveId,
    LoadId,
    SpringId,
    BalanceId,
    /// A quantity with one value per pose.
    QuantityId,
}

impl LinkId {
    pub const GROUND: Self = Self(0);
}
