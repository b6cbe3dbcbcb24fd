//! Values in the author's units.

use super::{Display, DriveTarget, Mechanism, PairKind, Value};
use crate::units::{Dimension, Kind, significant};

impl Display {
    /// An SI value in figures, without its unit.
    #[must_use]
    pub fn figures(&self, value: Value, digits: usize) -> String {
        match value {
            Value::Scalar(x) => significant(self.of_si(x), digits),
            Value::Vector(v) => {
                let v = self.of_si_vector(v);
                format!("({}, {})", significant(v.x, digits), significant(v.y, digits))
            }
            Value::Bool(truth) => truth.to_string(),
        }
    }

    /// An SI value in figures, with its unit.
    #[must_use]
    pub fn text(&self, value: Value, digits: usize) -> String {
        let figures = self.figures(value, digits);
        match value {
            Value::Scalar(_) | Value::Vector(_) if !self.unit.is_empty() => {
                format!("{figures} {}", self.unit)
            }
            _ => figures,
        }
    }
}

impl Mechanism {
    /// How a value of this dimension is printed where nobody says: in the unit the file uses most, else in SI.
    #[must_use]
    pub fn display_of(&self, dimension: Dimension) -> Display {
        let exponents = [dimension.length, dimension.mass, dimension.time];
        let angular = |d: &Display| d.dimension[3] == 1;
        let turning = exponents[..2] == [0, 0];
        let fits = |d: &&Display| {
            d.dimension[..3] == exponents && (!turning || angular(d) == (dimension.kind == Kind::Angle))
        };
        // torques and energies share a dimension, but nobody reads a torque in joules
        let found = self.displays.iter().filter(fits).find(|d| !d.unit.contains('J'));
        found.cloned().unwrap_or_else(|| Display {
            unit: dimension.si_text(),
            factor: 1.0,
            dimension: [
                dimension.length,
                dimension.mass,
                dimension.time,
                i8::from(dimension.kind == Kind::Angle),
            ],
        })
    }

    /// An instant, s, in the file's unit of time, without the unit: the name of its position.
    #[must_use]
    pub fn instant_text(&self, time: f64) -> String {
        // digits that survive the way into another unit
        const DIGITS: usize = 15;
        significant(self.display_of(Dimension::TIME).of_si(time), DIGITS)
    }

    /// How the value of a drive is printed.
    #[must_use]
    pub fn drive_display(&self, target: DriveTarget) -> Display {
        let turns = match target {
            DriveTarget::Link(_) => true,
            DriveTarget::Pair(pair) => matches!(self.pair(pair).kind, PairKind::Revolute(_)),
            DriveTarget::Point(..) => false,
        };
        self.display_of(if turns { Dimension::ANGLE } else { Dimension::LENGTH })
    }
}
