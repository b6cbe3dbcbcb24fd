//! Words for one kind each: pairs, and laws of cams.

use super::{Function, Word};

/// An enum of kinds with the table of their words.
macro_rules! kinds {
    ($(#[$of_kind:meta])* $kind:ident, $(#[$of_table:meta])* $table:ident:
     $($variant:ident $word:literal $means:literal $example:literal,)*) => {
        $(#[$of_kind])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum $kind {
            $(#[doc = $means] $variant,)*
        }

        $(#[$of_table])*
        pub static $table: &[Word] = &[$(Word { word: $word, means: $means, example: $example },)*];

        impl $kind {
            pub const ALL: &[Self] = &[$(Self::$variant),*];

            #[must_use]
            pub const fn word(self) -> &'static str {
                $table[self as usize].word
            }

            /// The kind of that word.
            #[must_use]
            pub fn named(word: &str) -> Option<Self> {
                Self::ALL.iter().copied().find(|kind| kind.word() == word)
            }
        }
    };
}

kinds! {
    /// The kinds of pairs and transmissions.
    JointKind,
    /// The words of pairs and transmissions.
    PAIRS:
    Revolute "revolute" "a pin: two links turn on each other" "revolute B: crank - rod",
    Prismatic "prismatic" "a slide: two links move along each other" "prismatic D: piston.C - ground.guide",
    Slot "slot" "a pin in a slot" "slot K: crank.B - bar.slot",
    Contact "contact" "two profiles that touch" "contact N: cam.c - lever.roller",
    Cylinder "cylinder" "barrel and rod of a hydraulic cylinder" "cylinder c1: ground.G1 - boom.K1",
    Mesh "mesh" "two gear wheels" "mesh k: w2 - w3",
    Rope "rope" "a rope over wheels and sliders" "rope a: A - over(C) - w1",
    Belt "belt" "a belt between two wheels" "belt b: w4 - w5",
    Chain "chain" "a chain between two wheels" "chain c: w4 - w5",
    Rack "rack" "a gear wheel on a toothed line" "rack r: w3 - bar.line1",
    Worm "worm" "a worm and its wheel" "worm s: screw - w5 { starts 2 }",
    Screw "screw" "a spindle and its nut" "screw n: spindle - nut { lead 5 mm }",
    Clutch "clutch" "a clutch between two shafts" "clutch k: I - II { capacity 40 N*m }",
    Weld "weld" "a rigid joint: the links are one body" "weld B: beam - post { angle 60 deg }",
}

kinds! {
    /// The laws of a follower's motion.
    CamLaw,
    /// The words of the laws of cams.
    LAWS:
    Uniform "uniform" "constant speed" "rise 60 deg through 18 mm uniform",
    Parabolic "parabolic" "constant acceleration, then constant deceleration" "rise 60 deg through 18 mm parabolic",
    Harmonic "harmonic" "a half cosine" "rise 60 deg through 18 mm harmonic",
    Cycloidal "cycloidal" "the acceleration is a whole sine" "rise 60 deg through 18 mm cycloidal",
    Poly345 "poly345" "a polynomial of the powers 3 to 5" "rise 60 deg through 18 mm poly345",
    Poly4567 "poly4567" "a polynomial of the powers 4 to 7" "rise 60 deg through 18 mm poly4567",
    ModifiedTrapezoid "modified_trapezoid" "the acceleration is a trapezoid with rounded flanks"
        "rise 60 deg through 18 mm modified_trapezoid",
    ModifiedSine "modified_sine" "the acceleration is a sine with stretched middle"
        "rise 60 deg through 18 mm modified_sine",
}

// Words of `find` that ask for many answers at once.

/// A word that asks for many answers at once, in a `find` without a name before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Collection {
    /// As it is written.
    pub word: &'static str,
    /// The functions it asks of every named point and of every link that turns; none for what is not of motion.
    pub of: Option<(Function, Function)>,
}

/// All words that ask for many answers at once.
pub static COLLECTIONS: &[Collection] = &[
    Collection::REACTIONS,
    Collection::POWERS,
    Collection::AXIAL,
    Collection { word: "positions", of: Some((Function::Position, Function::Angle)) },
    Collection { word: "velocities", of: Some((Function::Velocity, Function::Omega)) },
    Collection { word: "accelerations", of: Some((Function::Acceleration, Function::Alpha)) },
];

impl Collection {
    /// The reactions in all pairs.
    pub const REACTIONS: Self = Self { word: "reactions", of: None };

    /// The powers of all that acts.
    pub const POWERS: Self = Self { word: "powers", of: None };

    /// The forces along all links of two hinges.
    pub const AXIAL: Self = Self { word: "axial", of: None };

    /// The row of a word.
    #[must_use]
    pub fn named(word: &str) -> Option<Self> {
        COLLECTIONS.iter().copied().find(|collection| collection.word == word)
    }
}
