//! Machine elements as designed, and tables of what they are.

use super::{BalanceId, Display, Expr, LinkId, LoadId, PairId};
use crate::element::{cam::Cam, geneva::Geneva};
use crate::math::{Piece, TableFunction, Vec2};
use crate::source::Span;
use crate::units::significant;
pub use assur_text::language::Function as FormulaFunction;

/// A designed plate cam.
#[derive(Clone, Debug)]
pub struct PlateCam {
    pub name: String,
    /// Place of the name.
    pub span: Span,
    pub cam: Cam,
    /// Its speed, rad/s, > 0, where given: rates of the follower by time depend on it.
    pub speed: Option<f64>,
}

/// A contact of a designed cam with the follower it was designed for. Cam and follower are joined to the same frame.
#[derive(Clone, Debug)]
pub struct CamContact {
    pub pair: PairId,
    /// The cam: index into [`super::Mechanism::cams`].
    pub cam: usize,
    /// The link that is the cam.
    pub disk: LinkId,
    /// Its centre in its frame, m.
    pub centre: Vec2,
    /// The link on which cam and follower stand.
    pub frame: LinkId,
    /// The cam's centre in the frame's axes, m.
    pub frame_centre: Vec2,
    /// Unit direction from the cam's centre towards the follower, in the frame's axes: along the way of a translating
    /// one, towards the pivot of an oscillating one.
    pub towards: Vec2,
    pub follower: LinkId,
    /// The roller, where it is a link of its own, and the pair on which it turns.
    pub roller: Option<(LinkId, PairId)>,
    /// The point of the follower that the design places, in its frame, m: knife edge, centre of the roller, a point of a
    /// translating face, the pivot of an oscillating follower.
    pub point: Vec2,
    /// For a translating follower the distance of that point to the left of the line from the cam's centre along
    /// `towards`, m.
    pub beside: f64,
    /// For a translating follower the direction of its frame that lies along `towards`, for an oscillating one the
    /// direction of its frame from the pivot along its arm or face.
    pub direction: Vec2,
    /// The face in the follower's frame: a point, m, and a unit direction; `None` for knife edge and roller.
    pub face: Option<(Vec2, Vec2)>,
    /// The knife edge or the centre of the roller in the follower's frame, m; zero for a face.
    pub tip: Vec2,
}

/// A table of numbers: given ones, those over the sweep, or those of a position.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// One entry per column (per row where `upright`).
    pub entries: Vec<TableEntry>,
    /// Few values with many names: the entries are printed below each other.
    pub upright: bool,
}

/// One kind of number in a table.
#[derive(Clone, Debug, PartialEq)]
pub struct TableEntry {
    pub name: String,
    /// How it is printed.
    pub display: Display,
    /// Its values, SI; not a number where there is none.
    pub values: Vec<f64>,
    /// Those that are found, over the sweep or at a position.
    pub found: Vec<Expr>,
}

/// A pin in the slots of a Geneva wheel. Crank and wheel are hinged to the same frame.
#[derive(Clone, Copy, Debug)]
pub struct GenevaPair {
    /// The pair: a slot.
    pub pair: PairId,
    /// The law of the wheel.
    pub law: Geneva,
    /// The link with the pin.
    pub crank: LinkId,
    /// The pin in the crank's frame, m.
    pub pin: Vec2,
    /// The crank's centre in its frame, m.
    pub crank_centre: Vec2,
    /// Unit direction from that centre to the pin, in the crank's frame.
    pub arm: Vec2,
    /// The link with the slots.
    pub wheel: LinkId,
    /// Its centre in its frame, m.
    pub hub: Vec2,
    /// Unit direction of the named slot from that centre outwards, in the wheel's frame.
    pub slot: Vec2,
    /// The link on which both turn.
    pub frame: LinkId,
    /// The wheel's centre in the frame's axes, m.
    pub frame_hub: Vec2,
    /// Unit direction from the crank's centre to the wheel's, in the frame's axes.
    pub towards: Vec2,
}

// Flywheels that are to be found, and what is asked of them.

/// A flywheel that is to be found.
#[derive(Clone, Debug)]
pub struct Flywheel {
    /// Its name, that of its moment of inertia too.
    pub name: String,
    /// Place of the name.
    pub span: Span,
    /// The link it sits on.
    pub on: LinkId,
    /// The effort whose work it evens out; `None`: the one unknown effort.
    pub torque: Option<FlywheelTorque>,
    /// Greatest less least speed over the mean speed, δ > 0.
    pub fluctuation: f64,
    /// Mean speed of its shaft, rad/s, where the drive has none.
    pub speed: Option<f64>,
    /// Angular velocity of its shaft over that of the link `on`, where the shaft is no part of the file.
    pub ratio: f64,
    /// The reduced moment of inertia of the links takes its share.
    pub with_links: bool,
    /// Its rim, where described.
    pub rim: Option<Rim>,
}

/// The effort whose work a flywheel evens out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FlywheelTorque {
    Balance(BalanceId),
    Load(LoadId),
}

/// The rim of a flywheel: a ring in which all of its mass sits on one diameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rim {
    /// Mean diameter, m.
    pub diameter: f64,
    /// Density, kg/m³.
    pub density: f64,
    /// Radial height over axial width.
    pub height_to_width: f64,
}

/// A question about a flywheel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FlywheelPart {
    /// Its moment of inertia, kg m². Needs no pose.
    Inertia,
    /// The fluctuation \[W\], the greatest less the least of the work, J. Needs no pose.
    Fluctuation,
    /// Axial width of the rim, m. Needs no pose.
    RimWidth,
    /// Radial height of the rim, m. Needs no pose.
    RimHeight,
    /// Mass of the rim, kg. Needs no pose.
    RimMass,
    /// The torque reduced to its shaft, N m.
    Torque,
    /// Moment of inertia of all moving links reduced to its shaft, kg m².
    LinksInertia,
    /// Work of the torque less its mean since the sweep's beginning, J.
    Work,
}

impl FlywheelPart {
    /// Whether it has one value, whatever the pose.
    #[must_use]
    pub const fn needs_no_pose(self) -> bool {
        !matches!(self, Self::Torque | Self::LinksInertia | Self::Work)
    }
}

// Functions that the file gives by tables of values.

/// A curve: a function from a table.
#[derive(Clone, Debug)]
pub struct Curve {
    pub name: String,
    /// Place of its name.
    pub span: Span,
    /// The function, SI to SI.
    pub function: TableFunction,
    /// The unit of its arguments.
    pub argument: Display,
}

/// A long table is seldom compared with another one.
impl PartialEq for Curve {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self, other) || (self.span == other.span && self.function == other.function)
    }
}

/// What is asked of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurvePart {
    Value,
    /// The derivative by the argument.
    Slope,
}

impl Curve {
    /// The value or the slope at an argument, SI; not a number beyond the table.
    #[must_use]
    pub fn at(&self, part: CurvePart, x: f64) -> f64 {
        match part {
            CurvePart::Value => self.function.value(x),
            CurvePart::Slope => self.function.derivatives(x)[1],
        }
    }

    /// The same of the function that holds on a piece, also beside it.
    #[must_use]
    pub fn on(&self, part: CurvePart, piece: Piece, x: f64) -> f64 {
        let [value, slope, ..] = self.function.derivatives_on(piece, x);
        match part {
            CurvePart::Value => value,
            CurvePart::Slope => slope,
        }
    }

    /// An argument in the unit of the table.
    #[must_use]
    pub fn shown(&self, argument: f64) -> String {
        let text = significant(self.argument.of_si(argument), 6);
        format!("{text} {}", self.argument.unit).trim_end().to_owned()
    }

    /// The arguments of the table: `0 deg to 360 deg`.
    #[must_use]
    pub fn extent(&self) -> String {
        let (first, last) = self.function.range();
        format!("{} to {}", self.shown(first), self.shown(last))
    }
}

/// A formula of a machine element whose numbers are known: `journal_torque(load = 5 kN, …)`.
#[derive(Clone, Debug, PartialEq)]
pub struct FormulaCall {
    pub function: FormulaFunction,
    /// Its arguments, SI.
    pub values: Vec<(&'static str, f64)>,
    pub result: f64,
}

impl FormulaCall {
    /// An argument, where it is given.
    #[must_use]
    pub fn value(&self, name: &str) -> Option<f64> {
        self.values.iter().find(|(known, _)| *known == name).map(|(_, value)| *value)
    }

    /// An argument that is not optional: it is there.
    #[must_use]
    pub fn must(&self, name: &str) -> f64 {
        self.value(name).unwrap_or(f64::NAN)
    }
}
