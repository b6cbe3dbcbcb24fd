//! Motion under given loads.

use super::{CompareOp, Expr, Name, Path, Property, Sensed};
use assur_text::source::{Span, Spanned};

/// `start OF = -0.0617 rad at 0 rad/s`
#[derive(Clone, Debug, PartialEq)]
pub struct Start {
    /// A link or a pair's coordinate.
    pub target: Path,
    /// Its first value; absent of a shaft whose place nothing asks for.
    pub value: Option<Sensed>,
    pub rate: Option<Sensed>,
}

/// `bar near 60 deg at 0.2 rad/s`, as part of `equilibrium`
#[derive(Clone, Debug, PartialEq)]
pub struct Balanced {
    /// A link or a pair's coordinate.
    pub target: Path,
    pub sought: Sought,
    /// Its rate at the first instant of a motion.
    pub rate: Option<Sensed>,
}

/// Where an equilibrium is sought.
#[derive(Clone, Debug, PartialEq)]
pub enum Sought {
    /// The nearest one.
    Near(Expr),
    /// The only one between two values.
    Between(Expr, Expr),
    Anywhere,
}

impl Sought {
    /// The values that are written.
    pub fn values(&self) -> impl Iterator<Item = &Expr> {
        let values = match self {
            Self::Near(value) => [Some(value), None],
            Self::Between(from, to) => [Some(from), Some(to)],
            Self::Anywhere => [None, None],
        };
        values.into_iter().flatten()
    }
}

/// `simulate 0 s .. 0.03 s in 30 steps within 1e-9`
#[derive(Clone, Debug, PartialEq)]
pub struct Simulate {
    pub course: TimeCourse,
    /// The number of steps between printed instants.
    pub steps: Option<Expr>,
    pub within: Option<Expr>,
}

/// How long a motion is followed.
#[derive(Clone, Debug, PartialEq)]
pub enum TimeCourse {
    /// `0 s .. 2 s`, or `2 s` alone.
    Between {
        /// The first instant, where it is written.
        from: Option<Expr>,
        to: Expr,
    },
    /// `steady turn of crank`, `steady cycle of down`
    Steady(Steady),
}

#[derive(Clone, Debug, PartialEq)]
pub struct Steady {
    /// From `steady` on.
    pub span: Span,
    /// Turns of a link; of a cycle from one time that an event happens to the next there are none.
    pub turns: Option<usize>,
    /// The link, or the event.
    pub of: Path,
}

/// `event top: omega(bar) = 0 rad/s falling`
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    pub name: Name,
    pub passing: Passing,
}

/// `until angle(crank) = 360 deg`
#[derive(Clone, Debug, PartialEq)]
pub struct Until {
    /// When the motion ends.
    pub passing: Passing,
}

/// `stop G > 0 mm { restitution 0.7 }`
#[derive(Clone, Debug, PartialEq)]
pub struct Stop {
    pub pair: Name,
    /// On which side of the bound its coordinate stays.
    pub op: Spanned<CompareOp>,
    pub bound: Expr,
    /// `{ … }`
    pub properties: Vec<Property>,
}

/// A value that is passed, or a condition that becomes true.
#[derive(Clone, Debug, PartialEq)]
pub struct Passing {
    /// The watched quantity or condition.
    pub what: Expr,
    /// The value that it passes; absent for a condition.
    pub value: Option<Expr>,
    /// The way in which it passes, where only one counts.
    pub way: Option<Spanned<PassingSense>>,
}

/// A way in which a value is passed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PassingSense {
    /// `rising`
    Rising,
    /// `falling`
    Falling,
}
