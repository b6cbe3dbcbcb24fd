//! Drives, poses and the choice of assembly.

use super::{Axis, DriveId, Expr, LinkId, PairId};
use crate::math::Vec2;
use crate::source::Span;
use std::sync::Arc;

/// A drive: a motion that is known, or a start: a free coordinate of which the first instant is known.
#[derive(Clone, Debug)]
pub struct Drive {
    /// As written: `crank`, `c1`, `arm.C`.
    pub name: String,
    /// Place of the statement.
    pub span: Span,
    /// The driven link, pair or point.
    pub target: DriveTarget,
    /// Its positions, rad, m, or a vector in m for a point. Expressions depend on nothing but `dead`, `stroke`.
    pub positions: Positions,
    /// The positions as written: `phi`, `0 deg .. 360 deg in 12 steps`. `None` where they cannot be written again.
    pub written: Option<String>,
    /// Signed speed, rad/s, m/s, or a vector for a point. `None` where the file gives none.
    pub speed: Option<Expr>,
    /// Signed acceleration; `None` where the file gives none (zero).
    pub acceleration: Option<Expr>,
    /// `turning ccw`, `moving forward` +1; `cw`, `moving back` −1. A drive with a sense and no speed gives velocities as ratios.
    pub sense: Option<f64>,
    /// It is a start: its motion follows from the loads, and its effort is nothing.
    pub free: bool,
    /// Its position is that in which it needs no effort, and is found before anything else is solved.
    pub sought: Option<Sought>,
    /// Its one position is an expression of the instant, and its rates are the derivatives.
    pub of_time: bool,
}

impl Drive {
    /// Its name in the file, where one statement gives both coordinates of a point.
    #[must_use]
    pub fn written_name(&self) -> &str {
        let DriveTarget::Place(_, _, axis) = self.target else { return &self.name };
        self.name.strip_suffix(axis.name()).and_then(|name| name.strip_suffix('.')).unwrap_or(&self.name)
    }

    /// Whether its effort is nothing: it is free, or in equilibrium.
    #[must_use]
    pub const fn is_unaided(&self) -> bool {
        self.free || self.sought.is_some()
    }
}

/// Where the position of a drive is sought in which it needs no effort: rad or m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sought {
    /// The nearest one.
    Near(f64),
    /// The only one between two values.
    Between(f64, f64),
    Anywhere,
}

/// A position of equilibrium.
#[derive(Clone, Debug, PartialEq)]
pub struct Equilibrium {
    /// The values of all drives: rad or m.
    pub at: Vec<f64>,
    /// Whether the mechanism comes back to it when it is moved a little.
    pub stable: bool,
    /// The small vibrations about it, with rising frequencies; none where nothing asks for them.
    pub modes: Vec<Mode>,
    /// Where it was sought among all positions of one coordinate.
    pub sought: Option<Arc<SoughtWay>>,
}

/// The positions of one coordinate among which equilibria were sought.
#[derive(Clone, Debug, PartialEq)]
pub struct SoughtWay {
    /// The drive that is sought.
    pub drive: usize,
    /// Its values, rad or m, with the effort that holds it there, N m or N; none where the mechanism has no position.
    pub efforts: Vec<(f64, Option<f64>)>,
    /// All positions of equilibrium among them, and whether they are stable.
    pub equilibria: Vec<(f64, bool)>,
}

/// A small vibration about an equilibrium, after λ² M + λ C + K = 0; NaN where there is none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mode {
    /// ω₀ of the undamped motion, rad/s.
    pub natural: f64,
    /// ζ
    pub ratio: f64,
    /// ω₀ √(1 − ζ²), rad/s.
    pub damped: f64,
}

/// What is asked of a vibration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModePart {
    Natural,
    Ratio,
    Damped,
}

/// The target of a drive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DriveTarget {
    /// The angle of a link to the ground.
    Link(LinkId),
    /// The coordinate of a pair.
    Pair(PairId),
    /// A point (in the link's frame, m): the link is an outer link of a group given alone.
    Point(LinkId, Vec2),
    /// A coordinate of a point (in the link's frame, m) in the axes of the ground: the link stands freely.
    Place(LinkId, Vec2, Axis),
}

/// Positions of a drive, in SI.
#[derive(Clone, Debug)]
pub enum Positions {
    /// None written: rates only.
    None,
    /// Listed values; one value is a list of one.
    List(Vec<Expr>),
    /// Several numbers from outside a text.
    Numbers(Arc<Vec<f64>>),
    /// `from .. to in n steps`.
    Range {
        from: Expr,
        to: Expr,
        /// Number of steps, ≥ 1.
        steps: usize,
    },
}

impl Positions {
    /// Several values one after another, as they were given.
    #[must_use]
    pub fn is_long_list(&self) -> bool {
        match self {
            Self::List(list) => list.len() > 1,
            Self::Numbers(numbers) => numbers.len() > 1,
            Self::None | Self::Range { .. } => false,
        }
    }
}

/// A pose in addition to those of the sweep.
#[derive(Clone, Debug)]
pub struct NamedPose {
    /// Its name, as `4'`.
    pub name: String,
    /// Place of the statement.
    pub span: Span,
    pub at: Vec<(DriveId, Expr)>,
}

/// One clause of `assemble`.
#[derive(Clone, Debug)]
pub struct Hint {
    /// Place of the clause.
    pub span: Span,
    pub kind: HintKind,
}

/// A point of a link: link and coordinates in its frame, m.
pub type LinkPoint = (LinkId, Vec2);

/// A clause of `assemble`.
#[derive(Clone, Debug)]
pub enum HintKind {
    /// The point lies left (or right) of the line from one point to another.
    Side {
        point: LinkPoint,
        from: LinkPoint,
        to: LinkPoint,
        /// Left, or right.
        left: bool,
    },
    /// The point lies ahead of (or behind) another along the guide of a prismatic pair.
    Along {
        point: LinkPoint,
        other: LinkPoint,
        /// The prismatic pair whose line gives the direction.
        pair: PairId,
        /// Ahead, or behind.
        ahead: bool,
    },
    /// The pair's coordinate is greater (or less) than a value, SI.
    Coordinate {
        pair: PairId,
        bound: f64,
        /// Greater, or less.
        greater: bool,
    },
    /// The point is near a place in ground axes, m.
    Near { point: LinkPoint, place: Vec2 },
}
