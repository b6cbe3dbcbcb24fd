//! Positions from outside a text.

use assur_math::math::Vec2;
use assur_model::model::{DriveTarget, Expr, Mechanism, Positions, Value};
use assur_text::diagnostic::did_you_mean;
use thiserror::Error;

/// The positions of a drive, SI: angles in radians, coordinates in metres.
#[derive(Clone, Debug, PartialEq)]
pub enum DrivePositions {
    /// One number per position.
    Numbers(Vec<f64>),
    /// One point per position, of a drive that carries a point.
    Points(Vec<[f64; 2]>),
}

/// What a drive takes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Drive {
    /// Its name: that of the link, of the pair, of the point.
    pub name: String,
    /// It carries a point: its positions are points.
    pub is_point: bool,
    /// The SI unit of its positions: `rad` or `m`.
    pub unit: String,
}

/// Why positions from outside cannot be used.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum PositionsError {
    /// No drive of this name.
    #[error("no drive is called `{name}`; {help}")]
    Unknown {
        /// The name.
        name: String,
        /// What may be meant.
        help: String,
    },
    /// Positions of one drive for a text of several.
    #[error("there are {} drives: give positions by name, of {}", .0.len(), listed(.0))]
    Several(Vec<String>),
    /// A drive without positions.
    #[error("the positions of drive `{0}` are missing")]
    Missing(String),
    /// A drive that is named twice.
    #[error("the positions of drive `{0}` are given twice")]
    Twice(String),
    /// Numbers where points are due, or points where numbers are.
    #[error("drive `{name}` takes {takes} per position")]
    Shape {
        /// The drive.
        name: String,
        /// `one number`, `two numbers`
        takes: &'static str,
    },
    /// Not as many positions as another drive has.
    #[error("drive `{name}` has {found} positions, but `{other}` has {count}")]
    Length {
        /// The drive.
        name: String,
        /// How many it has.
        found: usize,
        /// Another drive.
        other: String,
        /// How many that has.
        count: usize,
    },
    /// Not a number.
    #[error("position {row} of drive `{name}` is not a finite number")]
    NotFinite {
        /// The drive.
        name: String,
        /// The position, from 0.
        row: usize,
    },
    /// A drive of which the text gives no position.
    #[error("drive `{0}` has a speed and no position: nothing depends on its position")]
    NoPosition(String),
    /// A text without drives.
    #[error("the problem has no drive")]
    NoDrive,
    /// A motion under loads.
    #[error("the problem is a motion under loads: its instants follow from `simulate`")]
    OfMotion,
}

fn listed(names: &[String]) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

/// The drives of a mechanism.
pub(super) fn drives(mechanism: &Mechanism) -> Vec<Drive> {
    let drive = |drive: &assur_model::model::Drive| {
        let turns = mechanism.drive_display(drive.target).dimension[..3] == [0, 0, 0];
        Drive {
            name: drive.name.clone(),
            is_point: matches!(drive.target, DriveTarget::Point(..)),
            unit: if turns { "rad" } else { "m" }.to_owned(),
        }
    };
    mechanism.drives.iter().map(drive).collect()
}

/// The mechanism at other positions, without what is about those of its own: poses, expectations.
pub(super) fn moved(
    mechanism: &Mechanism,
    mut given: Vec<(Option<String>, DrivePositions)>,
) -> Result<Mechanism, PositionsError> {
    if mechanism.simulation.is_some() {
        return Err(PositionsError::OfMotion);
    }
    let drives = drives(mechanism);
    if let Some(unnamed) = given.iter_mut().find(|(name, _)| name.is_none()) {
        match drives.as_slice() {
            [] => return Err(PositionsError::NoDrive),
            [only] => unnamed.0 = Some(only.name.clone()),
            _ => return Err(PositionsError::Several(drives.into_iter().map(|d| d.name).collect())),
        }
    }
    let mut moved = mechanism.clone();
    (moved.poses, moved.expects) = (Vec::new(), Vec::new());
    let mut longest: Option<(String, usize)> = None;
    let mut placed = vec![false; drives.len()];
    for (name, positions) in given {
        let name = name.unwrap_or_default();
        let index = drives.iter().position(|d| d.name == name).ok_or_else(|| unknown(&name, &drives))?;
        if std::mem::replace(&mut placed[index], true) {
            return Err(PositionsError::Twice(name));
        }
        let drive = &mut moved.drives[index];
        if matches!(drive.positions, Positions::None) {
            return Err(PositionsError::NoPosition(name));
        }
        let count = positions.len();
        match &longest {
            Some((_, longest)) if count == *longest || count == 1 => {}
            Some((other, longest)) if *longest != 1 => {
                return Err(PositionsError::Length {
                    name,
                    found: count,
                    other: other.clone(),
                    count: *longest,
                });
            }
            _ => longest = Some((name, count)),
        }
        drive.positions = Positions::List(positions.exprs(&drives[index])?);
    }
    let has_several = |positions: &Positions| match positions {
        Positions::None => false,
        Positions::List(list) => list.len() != 1,
        Positions::Range { .. } => true,
    };
    let open =
        moved.drives.iter().zip(&placed).find(|(drive, placed)| !**placed && has_several(&drive.positions));
    match open {
        Some((drive, _)) => Err(PositionsError::Missing(drive.name.clone())),
        None => Ok(moved),
    }
}

fn unknown(name: &str, drives: &[Drive]) -> PositionsError {
    let names = || drives.iter().map(|d| d.name.as_str());
    let help = match did_you_mean(name, names()).first() {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("there are {}", listed(&names().map(str::to_owned).collect::<Vec<_>>())),
    };
    PositionsError::Unknown { name: name.to_owned(), help }
}

impl DrivePositions {
    /// How many there are.
    #[must_use]
    pub const fn len(&self) -> usize {
        match self {
            Self::Numbers(numbers) => numbers.len(),
            Self::Points(points) => points.len(),
        }
    }

    /// Whether there are none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.len() == 0
    }

    fn exprs(self, drive: &Drive) -> Result<Vec<Expr>, PositionsError> {
        let name = || drive.name.clone();
        let finite = |row: usize, value: Value, finite: bool| {
            if finite {
                Ok(Expr::Constant(value))
            } else {
                Err(PositionsError::NotFinite { name: name(), row })
            }
        };
        match self {
            Self::Numbers(numbers) if !drive.is_point => {
                let number = |(row, x): (usize, f64)| finite(row, Value::Scalar(x), x.is_finite());
                numbers.into_iter().enumerate().map(number).collect()
            }
            Self::Points(points) if drive.is_point => {
                let point = |(row, [x, y]): (usize, [f64; 2])| {
                    finite(row, Value::Vector(Vec2::new(x, y)), x.is_finite() && y.is_finite())
                };
                points.into_iter().enumerate().map(point).collect()
            }
            Self::Numbers(_) => Err(PositionsError::Shape { name: name(), takes: "two numbers" }),
            Self::Points(_) => Err(PositionsError::Shape { name: name(), takes: "one number" }),
        }
    }
}
