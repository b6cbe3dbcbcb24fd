//! What belongs to every cam angle of a designed cam, by name.

use super::{Display, PlateCam, Table, TableEntry, Value};
use crate::element::cam::{CamPoint, Quantity};
use crate::math::Vec2;
use crate::units::Dimension;
use std::f64::consts::TAU;

/// A number or vector that belongs to a cam angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CamPart {
    /// Lift (0) and its derivatives by the cam angle.
    Lift(u8),
    /// Derivatives of the lift by time.
    Rate(u8),
    /// Knife edge or centre of the roller in the axes of the cam.
    Pitch,
    /// Place of contact in the axes of the cam.
    Point,
    PressureAngle,
    /// Radius of curvature of the pitch curve.
    CurvatureRadius,
}

pub const CAM_PARTS: [(&str, CamPart); 11] = [
    ("s", CamPart::Lift(0)),
    ("s'", CamPart::Lift(1)),
    ("s''", CamPart::Lift(2)),
    ("s'''", CamPart::Lift(3)),
    ("velocity", CamPart::Rate(1)),
    ("acceleration", CamPart::Rate(2)),
    ("jerk", CamPart::Rate(3)),
    ("pitch", CamPart::Pitch),
    ("point", CamPart::Point),
    ("pressure_angle", CamPart::PressureAngle),
    ("curvature_radius", CamPart::CurvatureRadius),
];

impl CamPart {
    /// The dimension of the number, or of the vector's components; the lift of an oscillating follower is an angle.
    #[must_use]
    pub fn dimension(self, oscillates: bool) -> Dimension {
        let way = if oscillates { Dimension::ANGLE } else { Dimension::LENGTH };
        match self {
            Self::Lift(0) => way,
            Self::Lift(_) if oscillates => Dimension::NUMBER,
            Self::Lift(_) | Self::CurvatureRadius | Self::Pitch | Self::Point => Dimension::LENGTH,
            #[allow(clippy::cast_possible_wrap)] // 1 to 3
            Self::Rate(n) => Dimension { time: -(n as i8), ..way },
            Self::PressureAngle => Dimension::ANGLE,
        }
    }

    /// Whether it is a vector.
    #[must_use]
    pub const fn is_vector(self) -> bool {
        matches!(self, Self::Pitch | Self::Point)
    }

    /// Its value at a cam angle, rad, in SI. Not a number for a rate of a cam without a speed.
    #[must_use]
    pub fn value(self, plate: &PlateCam, phi: f64, at: &CamPoint) -> Value {
        Value::Scalar(match self {
            Self::Lift(n) => at.value(Quantity::Lift(n)),
            Self::Rate(n) => at.value(Quantity::Lift(n)) * plate.rate(n),
            Self::Pitch => return Value::Vector(plate.cam.in_cam(at.tip, phi)),
            Self::Point => return Value::Vector(plate.cam.in_cam(at.contact, phi)),
            Self::PressureAngle => at.value(Quantity::PressureAngle),
            Self::CurvatureRadius => at.value(Quantity::CurvatureRadius),
        })
    }
}

impl PlateCam {
    /// What the n-th derivative by the cam angle is multiplied by to be one by time; not a number without a speed.
    #[must_use]
    pub fn rate(&self, n: u8) -> f64 {
        self.speed.map_or(f64::NAN, |omega| (0..n).fold(1.0, |k, _| k * omega))
    }

    /// A table of parts over a turn in equal steps from cam angle zero on. What does not exist is left out.
    #[must_use]
    pub fn table(
        &self,
        parts: &[(&str, CamPart)],
        steps: usize,
        display: impl Fn(Dimension) -> Display,
    ) -> Table {
        let angles: Vec<f64> = (0..steps).map(|i| TAU * i as f64 / steps as f64).collect();
        let points: Vec<CamPoint> = angles.iter().map(|phi| self.cam.at(*phi)).collect();
        let mut table = Table::default();
        let mut entry = |name: String, dimension: Dimension, values: Vec<f64>| {
            table.entries.push(TableEntry { name, display: display(dimension), values, found: Vec::new() });
        };
        entry("cam angle".into(), Dimension::ANGLE, angles.clone());
        let oscillates = self.cam.follower.oscillates();
        for &(name, part) in parts {
            if matches!(part, CamPart::Rate(_)) && self.speed.is_none() {
                continue;
            }
            let each = |pick: fn(Value) -> f64| {
                angles.iter().zip(&points).map(|(phi, at)| pick(part.value(self, *phi, at))).collect()
            };
            let dimension = part.dimension(oscillates);
            if part.is_vector() {
                entry(format!("{name}.x"), dimension, each(|v| vector(v).x));
                entry(format!("{name}.y"), dimension, each(|v| vector(v).y));
            } else {
                entry(
                    name.to_owned(),
                    dimension,
                    each(|v| if let Value::Scalar(x) = v { x } else { f64::NAN }),
                );
            }
        }
        table
    }
}

fn vector(value: Value) -> Vec2 {
    if let Value::Vector(v) = value { v } else { Vec2::new(f64::NAN, f64::NAN) }
}
