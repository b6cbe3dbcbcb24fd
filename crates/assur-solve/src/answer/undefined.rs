//! Why something over the sweep has no value.

/// Why a function over the sweep has no value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Undefined {
    /// It has none at this place.
    At(SweepPlace),
    /// Friction locks the mechanism there.
    Locked(SweepPlace),
    /// The mechanism does not close there.
    Open(SweepPlace),
    /// It has none at this instant of a motion, s.
    Then(f64),
    /// It grows without bound there.
    Unbounded(SweepPlace),
    /// It changes too often.
    Unresolved,
}

/// A place of the sweep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SweepPlace {
    /// Its share of the sweep, from 0 to 1.
    pub share: f64,
    /// The value of the first drive there, rad or m.
    pub drive: f64,
}

/// Why a coordinate has no extremes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoExtreme {
    /// The one drive slides.
    Slides,
    /// There are several drives, or none.
    Drives,
    /// The drive cannot turn fully; the ends of a range, rad, in which the mechanism closes.
    NoTurn(Option<[f64; 2]>),
    /// It does not go to and fro.
    Monotonic,
}

/// Why there is no sweep to take a function over.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoSweep {
    /// The file has one position.
    OnePosition,
    /// It is too long.
    TooLong,
    /// The positions of this drive are listed out of order.
    Unordered(usize),
    /// A term of a Fourier series needs whole turns of the drive, or `two` of them; how many there are, where it turns.
    PartOfTurn { turns: Option<f64>, two: bool },
}

/// Why a flywheel cannot be found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoFlywheel {
    /// One of several efforts is to be named.
    Efforts,
    /// There are several drives, or none.
    Drives,
    /// The drive does not go through whole turns; how many, where it turns.
    NoCycle(Option<f64>),
    /// The drive stands still.
    StandsStill,
    /// The drive has no speed.
    NeedsSpeed,
    /// The shaft over the drive: least and greatest ratio.
    Uneven([f64; 2]),
    /// What it evens out has no value.
    Undefined(Undefined),
}
