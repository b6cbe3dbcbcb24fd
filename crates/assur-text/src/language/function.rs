//! Rows of the table of functions.

use super::{Dimension, FUNCTIONS, Function};
use std::fmt;

/// A function of the language.
#[derive(Clone, Copy, Debug)]
pub struct FunctionRow {
    pub function: Function,
    pub name: &'static str,
    pub group: FunctionGroup,
    /// A call that can be read, with names that are usual.
    pub usage: &'static str,
    /// The ways to call it, at least one.
    pub forms: &'static [Form],
}

/// One way to call a function.
#[derive(Clone, Copy, Debug)]
pub struct Form {
    pub takes: &'static [Argument],
    pub gives: Gives,
    /// Its meaning, in one sentence without its full stop.
    pub means: &'static str,
}

#[derive(Clone, Copy, Debug)]
pub struct Argument {
    /// What the reference calls it; the name before `=` where it is written with one.
    pub name: &'static str,
    pub takes: Takes,
    /// It may be left out.
    pub optional: bool,
    /// It is written with its name: `load = 5 kN`.
    pub named: bool,
}

/// The kind of an argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Takes {
    /// A value, of this dimension where only one will do.
    Value(Option<Dimension>),
    Angle,
    /// `1` or `2`.
    OneOrTwo,
    /// A word: how the pressure in a bearing is spread.
    Fit,
    /// A point: `L.P`, or the name of a point shared only by links joined there.
    Point,
    /// A point of the link named before it.
    OwnPoint,
    /// A link, a shaft, or a wheel on it.
    Link,
    /// A pair or a transmission.
    Pair,
    Slider,
    Wheel,
    Mesh,
    Rope,
    /// An end of a rope.
    RopeEnd,
    Group,
    /// The target of a drive.
    Drive,
    /// A load, an unknown effort, or what a drive moves.
    Effort,
    /// A `given`.
    Given,
    Cam,
    Flywheel,
    Event,
    /// A whole number, as written.
    Count,
    /// 1/2, 1, 3/2, 2, …
    Order,
}

/// What comes out of a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gives {
    /// A number of this dimension.
    Number(Dimension),
    /// A vector of this dimension.
    Vector(Dimension),
    /// A condition, true or false.
    Condition,
    /// Depends on the arguments.
    Varies(&'static str),
    /// Several values, one of which is asked for by its name: `rim(F).width`.
    Parts(&'static str),
}

/// The subject of a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FunctionGroup {
    Math,
    Bearing,
    Motion,
    Force,
    Inertia,
    Friction,
    Cycle,
    Cam,
    Gear,
    /// Wheels, ropes, trains.
    Train,
    Flywheel,
    Simulation,
}

impl FunctionRow {
    /// Whether it asks for something that is known only once the mechanism is solved.
    #[must_use]
    pub const fn is_result(&self) -> bool {
        !matches!(self.group, FunctionGroup::Math | FunctionGroup::Bearing)
    }

    /// Whether its arguments are values, not names of things.
    #[must_use]
    pub fn takes_values(&self) -> bool {
        self.forms.iter().flat_map(|f| f.takes).any(|a| matches!(a.takes, Takes::Value(_)))
    }
}

impl Function {
    /// Its row in the table.
    #[must_use]
    pub const fn row(self) -> &'static FunctionRow {
        &FUNCTIONS[self as usize]
    }

    #[must_use]
    pub const fn name(self) -> &'static str {
        self.row().name
    }

    /// Whether a curve may have its name, as curves had before there was the function.
    #[must_use]
    pub const fn yields_to_curve(self) -> bool {
        matches!(
            self,
            Self::Mass
                | Self::MassCentre
                | Self::Inertia
                | Self::Axial
                | Self::Internal
                | Self::Argmin
                | Self::CurvatureCentre
                | Self::Stable
                | Self::NaturalFrequency
                | Self::DampingRatio
                | Self::DampedFrequency
                | Self::Drive
                | Self::Fourier
                | Self::ShakingForce
                | Self::ShakingMoment
                | Self::RockingCouple
        )
    }

    /// The function of that name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        FUNCTIONS.iter().find(|row| row.name == name).map(|row| row.function)
    }
}

impl fmt::Display for Gives {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(dimension) => f.write_str(&word(*dimension)),
            Self::Vector(dimension) => write!(f, "{}, a vector", word(*dimension)),
            Self::Condition => f.write_str("true or false"),
            Self::Varies(text) | Self::Parts(text) => f.write_str(text),
        }
    }
}

/// A dimension without its article.
fn word(dimension: Dimension) -> String {
    match dimension {
        Dimension::NUMBER => "number".to_owned(),
        Dimension::TORQUE => "torque".to_owned(),
        other => {
            let name = other.to_string();
            name.split_once(' ').map_or_else(|| name.clone(), |(_, rest)| rest.to_owned())
        }
    }
}

impl fmt::Display for Argument {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.named { write!(f, "{} = …", self.name) } else { f.write_str(self.name) }
    }
}
