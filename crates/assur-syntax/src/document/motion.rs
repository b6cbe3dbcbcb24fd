//! How the machine moves and what acts on it.

use super::{CompareOp, Expr, Name, Path};
use assur_text::source::{Span, Spanned};

/// A sense of turning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turn {
    /// Counter-clockwise, positive.
    Ccw,
    /// Clockwise, negative.
    Cw,
}

/// A sense of travel along a coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    Forward,
    Back,
}

/// A side of a directed line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Counter-clockwise of its direction.
    Left,
    Right,
}

/// An order along a directed line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    Ahead,
    Behind,
}

/// A value that may be followed by `cw` (which negates it) or `ccw`.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensed {
    /// The value as written.
    pub value: Expr,
    /// The sense after it.
    pub sense: Option<Spanned<Turn>>,
}

/// `drive crank = 45 deg at 20 rad/s cw accelerating -5 rad/s^2`
#[derive(Clone, Debug, PartialEq)]
pub struct Drive {
    /// A link, a pair's coordinate, or a point.
    pub target: Path,
    /// Where it stands; absent where only rates are given.
    pub position: Option<DrivePosition>,
    pub rate: Option<Sensed>,
    pub acceleration: Option<Sensed>,
    /// The sense of a motion without speed.
    pub direction: Option<Spanned<Direction>>,
}

/// The positions of a drive.
#[derive(Clone, Debug, PartialEq)]
pub enum DrivePosition {
    /// One value or several.
    Values(Vec<Sensed>),
    /// `0 deg .. 360 deg in 12 steps`
    Range(Box<DriveRange>),
}

/// `0 deg .. 360 deg in 12 steps`
#[derive(Clone, Debug, PartialEq)]
pub struct DriveRange {
    pub from: Expr,
    pub to: Expr,
    /// How it is divided.
    pub steps: Steps,
}

/// The steps of a range.
#[derive(Clone, Debug, PartialEq)]
pub enum Steps {
    /// `in 12 steps`
    In(Expr),
    /// `step 30 deg`
    Of(Expr),
}

impl Steps {
    /// The number of steps, or the size of one.
    #[must_use]
    pub const fn expr(&self) -> &Expr {
        match self {
            Self::In(expr) | Self::Of(expr) => expr,
        }
    }
}

/// `turning cw`, `moving forward`
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// `turning ccw`, `turning cw`
    Turning(Turn),
    /// `moving forward`, `moving back`
    Moving(Way),
}

/// `crank = 90 deg` after `at`.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// The drive, or `time`.
    pub target: Path,
    pub value: Sensed,
}

/// `pose 4' at crank = 90 deg`
#[derive(Clone, Debug, PartialEq)]
pub struct Pose {
    /// Its name, which may begin with a digit.
    pub name: Name,
    pub settings: Vec<Setting>,
}

/// `assemble s > 0, F behind B`
#[derive(Clone, Debug, PartialEq)]
pub struct Assemble {
    pub clauses: Vec<Spanned<AssembleClause>>,
}

/// The name of one of several poses.
#[derive(Clone, Debug, PartialEq)]
pub enum AssembleClause {
    /// `C near (420 mm, 0)`
    Near {
        what: Path,
        /// A place in the ground's axes.
        at: Expr,
    },
    /// `k phase 40 deg`
    Phase {
        /// A mesh, a belt or a chain.
        what: Path,
        /// The angle of the second wheel's link when that of the first is 0.
        phase: Expr,
    },
    /// `C left of B-D`
    Side {
        what: Path,
        side: Spanned<Side>,
        /// From where one looks.
        from: Path,
        to: Path,
    },
    /// `F ahead of B`, `F behind B`
    Order {
        what: Path,
        /// Further or less far along the guide.
        order: Spanned<Order>,
        than: Path,
    },
    /// `s > 0`
    Sign { what: Path, op: Spanned<CompareOp>, bound: Expr },
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LoadKind {
    Force,
    Torque,
}

/// On what a load acts.
#[derive(Clone, Debug, PartialEq)]
pub enum Site {
    /// `in c1`: between the two links of a pair.
    Pair(Name),
    /// `on crank at B`: on one link.
    Link { link: Name, at: Option<Place> },
    /// `on beam from A to B`: along the line between two points of a link.
    Segment { link: Name, from: Name, to: Name },
    /// `at B`: on the pin of a revolute pair.
    Pin(Name),
}

/// The point of a force.
#[derive(Clone, Debug, PartialEq)]
pub enum Place {
    /// A point of the link.
    Point(Name),
    /// A place in the ground's axes, at this instant.
    Ground(Expr),
}

/// `balance force Fb on crank at B along 90 deg in crank`
#[derive(Clone, Debug, PartialEq)]
pub struct Balance {
    pub kind: Spanned<LoadKind>,
    pub name: Name,
    /// On what it acts.
    pub site: Site,
    /// On what it acts as well.
    pub also: Vec<Name>,
    /// The direction of a force.
    pub along: Option<Expr>,
    /// The link that direction turns with; the ground where nothing is said.
    pub frame: Option<Name>,
}

/// `force R on ram at Q = 1400 N against motion when …`
#[derive(Clone, Debug, PartialEq)]
pub struct Load {
    pub kind: Spanned<LoadKind>,
    pub name: Option<Name>,
    /// On what it acts.
    pub site: Site,
    pub value: Sensed,
    /// The value at the end of a segment, where it is another one.
    pub last: Option<Expr>,
    /// The link its direction turns with; the ground where nothing is said.
    pub frame: Option<Name>,
    /// `against motion`
    pub against_motion: Option<Span>,
    /// The condition under which it acts.
    pub when: Option<Expr>,
}
