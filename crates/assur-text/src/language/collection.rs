//! Words of `find` that ask for many answers at once.

use super::Function;

/// A word that asks for many answers at once, in a `find` without a name before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Collection {
    /// As it is written.
    pub word: &'static str,
    /// The functions it asks of every named point and of every link that turns; none for what is not of motion.
    pub of: Option<(Function, Function)>,
}

/// All words that ask for many answers at once.
pub const COLLECTIONS: &[Collection] = &[
    Collection::REACTIONS,
    Collection::POWERS,
    Collection { word: "positions", of: Some((Function::Position, Function::Angle)) },
    Collection { word: "velocities", of: Some((Function::Velocity, Function::Omega)) },
    Collection { word: "accelerations", of: Some((Function::Acceleration, Function::Alpha)) },
];

impl Collection {
    /// The reactions in all pairs.
    pub const REACTIONS: Self = Self { word: "reactions", of: None };

    /// The powers of all that acts.
    pub const POWERS: Self = Self { word: "powers", of: None };

    /// The row of a word.
    #[must_use]
    pub fn named(word: &str) -> Option<Self> {
        COLLECTIONS.iter().copied().find(|collection| collection.word == word)
    }
}
