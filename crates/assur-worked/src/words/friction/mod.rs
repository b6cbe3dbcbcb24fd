//! Sentences about friction: its sense, its steps, what holds, what is lost.

mod chinese;
mod english;
mod russian;

use super::{Language, Sentence};

/// A message; its parts are numbered in the sentences of the languages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrictionMessage {
    /// Friction is a known load first.
    FrictionFirst,
    /// The law of friction with the reactions found.
    FrictionLaws,
    /// Nothing slides; 0: pair.
    PairStill,
    /// Friction holds a pair; 0: pair, 1: what holds.
    PairHeld,
    /// A pair that friction holds, which a balance gives; the same.
    PairHeldByBalance,
    /// Where a contact touches; 0: the letters of the point, 1: pair.
    ContactPoint,
    /// A pair that rests on a stop; 0: pair, 1: the force of the stop.
    RestsOnStop,
    /// What holds a link on a hinge; 0: link, 1: hinge, 2: it.
    HoldTurn,
    /// What holds a link on a guide; 0: link, 1: it.
    HoldShift,
    /// Friction of one pair that follows from the loads.
    FrictionDirect,
    /// Senses of friction in a group.
    FrictionSenses,
    /// A pair moves; 0: pair, 1: link, 2: other link, 3: relative rate, 4: friction.
    PairMovesPositive,
    /// The same, backwards.
    PairMovesNegative,
    /// The sense of a pair that begins to move; 0: pair, 1: body, 2: friction.
    PairBeginsPositive,
    PairBeginsNegative,
    /// A pair of the ground moves; 0: pair, 1: link, 2: rate, 3: friction.
    PairOnGroundPositive,
    /// The same, backwards.
    PairOnGroundNegative,
    /// The iteration of friction.
    FrictionSteps,
    /// The whole mechanism was searched.
    FrictionSearched,
    /// Header: change in a step.
    Change,
    /// Heading: what friction takes.
    Losses,
    PairsLose,
    WithoutFriction,
    /// Efficiency of driving efforts.
    EffortsDrive,
    /// Efficiency of resisting efforts.
    EffortsResist,
    NotLocked,
    LocksItself,
    OnlyFriction,
    /// A critical value; 0: given, 1: it.
    LocksFrom,
    Locked,
    /// Pairs share by friction what they hold.
    FrictionShares,
    /// A group in which pairs share by friction what one of them could hold.
    FrictionSharesHere,
}

impl Sentence for FrictionMessage {
    fn template(self, language: Language) -> &'static str {
        match language {
            Language::English => english::template(self),
            Language::Chinese => chinese::template(self),
            Language::Russian => russian::template(self),
        }
    }
}
