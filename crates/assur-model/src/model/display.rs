//! How a value is printed.

use super::{Drive, DriveTarget, Expr, LinkId, Mechanism, PairKind, Positions, Value};
use crate::math::Vec2;
use crate::source::Span;
use crate::units::{Conversion, Dimension, Kind, significant};

/// How a value is printed: SI value over `factor`, followed by `unit`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Display {
    /// Unit as the author writes it; empty for plain numbers and conditions.
    pub unit: String,
    /// SI value of one unit.
    pub factor: f64,
    /// Exponents of length, mass, time; the angle kind.
    pub dimension: [i8; 4],
}

impl Display {
    /// A number of SI units in the author's unit.
    #[must_use]
    pub fn of_si(&self, si: f64) -> f64 {
        Conversion::into_units_of(self.factor).of(si)
    }

    /// A vector of SI units in the author's unit.
    #[must_use]
    pub fn of_si_vector(&self, si: Vec2) -> Vec2 {
        Vec2::new(self.of_si(si.x), self.of_si(si.y))
    }
}

// Values in the author's units.

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
            DriveTarget::Point(..) | DriveTarget::Place(..) => false,
        };
        self.display_of(if turns { Dimension::ANGLE } else { Dimension::LENGTH })
    }
}

// How far numbers are apart where coordinates and angles are great: no answer has more digits.

/// Where numbers are far apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spacing {
    /// The point, line or drive.
    pub span: Span,
    /// An angle, else a length.
    pub is_angle: bool,
    /// The greatest coordinate, m, or the angle, rad.
    pub at: f64,
    /// From a number to the next there.
    pub step: f64,
    /// The length of the shortest link, m, or 1 rad.
    pub of: f64,
}

impl Spacing {
    /// The step as a part of what is to be resolved.
    #[must_use]
    pub fn relative(&self) -> f64 {
        self.step / self.of
    }
}

impl Mechanism {
    /// Where numbers are farthest apart for what they have to tell apart.
    #[must_use]
    pub fn coarsest(&self) -> Option<Spacing> {
        let lengths = self.shortest_link().into_iter().flat_map(|of| self.coordinates(of));
        let angles = self.drives.iter().filter(|d| self.turns(d)).flat_map(angles);
        lengths.chain(angles).max_by(|a, b| a.relative().total_cmp(&b.relative()))
    }

    fn coordinates(&self, of: f64) -> impl Iterator<Item = Spacing> + '_ {
        let places = self.links.iter().flat_map(|link| {
            let points = link.points.iter().map(|p| (p.span, p.at));
            points.chain(link.lines.iter().map(|l| (l.span, l.through)))
        });
        places.map(move |(span, at)| {
            let at = at.x.abs().max(at.y.abs());
            Spacing { span, is_angle: false, at, step: at * f64::EPSILON, of }
        })
    }

    /// The least distance of two points of a moving link.
    fn shortest_link(&self) -> Option<f64> {
        let spans = self.links.iter().skip(1).flat_map(|link| {
            let first = link.points.first().map(|p| p.at);
            link.points.iter().filter_map(move |p| Some((p.at - first?).norm()))
        });
        spans.filter(|length| *length > 0.0 && length.is_finite()).reduce(f64::min)
    }

    fn turns(&self, drive: &Drive) -> bool {
        match drive.target {
            DriveTarget::Link(id) => id != LinkId::GROUND,
            DriveTarget::Pair(pair) => matches!(self.pair(pair).kind, PairKind::Revolute(_)),
            DriveTarget::Point(..) | DriveTarget::Place(..) => false,
        }
    }
}

/// The angles that a drive takes, as far as they are numbers.
fn angles(drive: &Drive) -> impl Iterator<Item = Spacing> + '_ {
    let values: Vec<&Expr> = match &drive.positions {
        Positions::List(all) => all.iter().collect(),
        Positions::Range { from, to, .. } => vec![from, to],
        Positions::None | Positions::Numbers(_) => Vec::new(),
    };
    values.into_iter().filter_map(|value| {
        let Expr::Constant(Value::Scalar(at)) = value else { return None };
        let at = at.abs();
        Some(Spacing { span: drive.span, is_angle: true, at, step: at * f64::EPSILON, of: 1.0 })
    })
}
