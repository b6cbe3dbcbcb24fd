//! Motion under given loads.

use super::{Expr, LinkId, PairId};
use crate::source::Span;

/// `simulate 0 s .. 2 s in 200 steps within 1e-8`
#[derive(Clone, Debug)]
pub struct Simulation {
    /// Place of the statement.
    pub span: Span,
    /// The first instant, s.
    pub from: f64,
    /// The last, s; after the first. Without bound where it is to be found.
    pub to: f64,
    /// The motion that comes again is wanted: after what.
    pub steady: Option<Steady>,
    /// Number of steps between printed instants; `None` for the first and the last alone.
    pub steps: Option<usize>,
    /// The wanted accuracy of all that is printed, relative to the greatest of its kind; `None` where the file says nothing.
    pub within: Option<f64>,
}

impl Simulation {
    /// The accuracy where nothing else is wanted.
    pub const WITHIN: f64 = 1e-9;

    /// How many instants are printed.
    #[must_use]
    pub fn instants(&self) -> usize {
        self.steps.unwrap_or(1) + 1
    }

    /// A printed instant, s, counted from 0.
    #[must_use]
    #[allow(clippy::cast_precision_loss)] // steps are at most a million
    pub fn instant(&self, index: usize) -> f64 {
        let steps = self.steps.unwrap_or(1);
        if index >= steps {
            self.to
        } else {
            self.from + (self.to - self.from) * (index as f64 / steps as f64)
        }
    }
}

/// After what a motion comes again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Steady {
    /// Turns of a link that is started or driven.
    Turns { link: LinkId, count: u32 },
    /// From one time that an event happens to the next: index into [`super::Mechanism::events`].
    Cycle(usize),
}

/// `event top: omega(bar) = 0 rad/s falling`, `until angle(crank) = 360 deg`
#[derive(Clone, Debug)]
pub struct Event {
    /// Its name; an end by `until` has none.
    pub name: Option<String>,
    /// Place of the statement.
    pub span: Span,
    /// A number that passes zero where it happens; of a condition one that is positive where it is true.
    pub value: Expr,
    /// It counts where the number rises, or falls, alone.
    pub rising: Option<bool>,
    /// Of a condition: where the number is zero it is not true.
    pub strict: bool,
    /// Exponents of length, mass and time of the number; `None` where it has no one unit.
    pub dimension: Option<[i8; 3]>,
    /// The motion, or the sweep, ends there.
    pub ends: bool,
    /// It happens where this begins to be as said, instead of where the number passes zero.
    pub situation: Option<(Situation, bool)>,
}

/// What a motion is in for a while.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Situation {
    /// A stop of this pair is closed.
    Rests(PairId),
    /// The pair is held by friction.
    Sticks(PairId),
}

/// `stop G > 0 mm { restitution 0.7 }`
#[derive(Clone, Debug)]
pub struct Stop {
    pub pair: PairId,
    /// Place of the statement.
    pub span: Span,
    pub turns: bool,
    /// 1 where the coordinate stays above the bound, −1 where it stays below.
    pub side: f64,
    /// The bound, m or rad.
    pub bound: f64,
    /// Ratio of the speeds after and before an impact.
    pub restitution: f64,
}

/// The instant of a motion that an expectation is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Occasion {
    Begin,
    End,
    /// An event, by index into [`super::Mechanism::events`], and which time, counted from 1.
    Event(usize, usize),
}

// Functions over the sweep.

/// A function over the sweep.
#[derive(Clone, Debug)]
pub struct Cycle {
    /// Place of the call.
    pub span: Span,
    pub how: CycleFunction,
    /// Of what: a number.
    pub expr: Expr,
    /// Its exponents of length, mass and time.
    pub dimension: [i8; 3],
    /// The part of a motion under loads over which it is taken.
    pub part: Part,
}

/// A part of a motion under loads; the whole of it where no bound is given.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Part {
    pub after: Option<Bound>,
    pub before: Option<Bound>,
}

/// Where a part of a motion begins or ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bound {
    /// An instant, s.
    At(f64),
    /// An event, by index into [`super::Mechanism::events`], and which time, counted from 1.
    Event(usize, usize),
}

/// Functions over the sweep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CycleFunction {
    Max,
    Min,
    /// The mean over the drive's way.
    Mean,
    /// The integral over the drive's value, in the sense of the sweep.
    Integral,
    /// The drive's value at the greatest value.
    Argmax,
    /// A coefficient of its Fourier series.
    Harmonic(Harmonic),
}

/// A term of a Fourier series over whole turns, or over the period of a steady motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Harmonic {
    /// Twice its order: over two turns there are halves.
    pub halves: u32,
    /// It goes with the sine, not the cosine.
    pub sine: bool,
}

impl Harmonic {
    /// What the quantity is multiplied by at an angle, rad: the mean of the product is half the coefficient.
    #[must_use]
    pub fn weight(self, phi: f64) -> f64 {
        let angle = 0.5 * f64::from(self.halves) * phi;
        if self.sine { libm::sin(angle) } else { libm::cos(angle) }
    }
}

impl CycleFunction {
    /// The term of a series of which it is a coefficient.
    #[must_use]
    pub const fn harmonic(self) -> Option<Harmonic> {
        match self {
            Self::Harmonic(term) => Some(term),
            _ => None,
        }
    }
}
