//! Positions from outside a text.

use assur_math::math::Vec2;
use assur_model::model::{DriveTarget, Expr, Mechanism, Positions, Value};
use assur_text::diagnostic::did_you_mean;
use std::sync::Arc;
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
    #[error("position {row} of drive `{name}`, counted from 0, is not a finite number")]
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
    /// The positions are sought as equilibria.
    #[error("the positions of this text are found from its loads: it seeks an equilibrium")]
    OfEquilibrium,
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

/// Positions by the names of drives, without a name for the only one.
pub type GivenPositions = Vec<(Option<String>, DrivePositions)>;

/// The mechanism at other positions, without what is about those of its own: poses, expectations.
pub(super) fn moved(mechanism: &Mechanism, given: GivenPositions) -> Result<Mechanism, PositionsError> {
    let mut moved = mechanism.clone();
    (moved.poses, moved.expects) = (Vec::new(), Vec::new());
    place(mechanism, given, &mut moved)?;
    Ok(moved)
}

/// Puts the drives of a mechanism at positions; those that are not given have their own.
pub(super) fn place(
    mechanism: &Mechanism,
    given: GivenPositions,
    moved: &mut Mechanism,
) -> Result<(), PositionsError> {
    if mechanism.simulation.is_some() {
        return Err(PositionsError::OfMotion);
    }
    if mechanism.seeks_equilibrium() {
        return Err(PositionsError::OfEquilibrium);
    }
    let mut placed: Vec<Option<DrivePositions>> = vec![None; mechanism.drives.len()];
    for (name, positions) in given {
        let index = drive_of(mechanism, name.as_deref())?;
        let name = || mechanism.drives[index].name.clone();
        if placed[index].is_some() {
            return Err(PositionsError::Twice(name()));
        }
        if matches!(mechanism.drives[index].positions, Positions::None) {
            return Err(PositionsError::NoPosition(name()));
        }
        placed[index] = Some(positions);
    }
    fits(mechanism, &placed)?;
    for ((own, drive), positions) in mechanism.drives.iter().zip(&mut moved.drives).zip(placed) {
        drive.positions = match positions {
            Some(positions) => positions.of_drive(own)?,
            None => own.positions.clone(),
        };
    }
    Ok(())
}

fn drive_of(mechanism: &Mechanism, name: Option<&str>) -> Result<usize, PositionsError> {
    let drives = &mechanism.drives;
    let Some(name) = name else {
        return match drives.len() {
            0 => Err(PositionsError::NoDrive),
            1 => Ok(0),
            _ => Err(PositionsError::Several(drives.iter().map(|d| d.name.clone()).collect())),
        };
    };
    drives.iter().position(|d| d.name == name).ok_or_else(|| unknown(name, mechanism))
}

/// Whether all drives have as many positions, or one that stays.
fn fits(mechanism: &Mechanism, placed: &[Option<DrivePositions>]) -> Result<(), PositionsError> {
    let mut longest: Option<(&str, usize)> = None;
    for (drive, positions) in mechanism.drives.iter().zip(placed) {
        let count = match (positions, &drive.positions) {
            (Some(positions), _) => positions.len(),
            (None, Positions::None) => continue,
            (None, Positions::List(list)) if list.len() == 1 => continue,
            (None, _) => return Err(PositionsError::Missing(drive.name.clone())),
        };
        match longest {
            Some((other, longest)) if longest != 1 && count != 1 && count != longest => {
                let (name, other) = (drive.name.clone(), other.to_owned());
                return Err(PositionsError::Length { name, found: count, other, count: longest });
            }
            Some((_, longest)) if longest != 1 => {}
            _ => longest = Some((&drive.name, count)),
        }
    }
    Ok(())
}

fn unknown(name: &str, mechanism: &Mechanism) -> PositionsError {
    let names = || mechanism.drives.iter().map(|d| d.name.as_str());
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

    fn of_drive(self, drive: &assur_model::model::Drive) -> Result<Positions, PositionsError> {
        let (name, is_point) = (|| drive.name.clone(), matches!(drive.target, DriveTarget::Point(..)));
        let all_finite = |wrong: Option<usize>| match wrong {
            Some(row) => Err(PositionsError::NotFinite { name: name(), row }),
            None => Ok(()),
        };
        match self {
            Self::Numbers(numbers) if !is_point => {
                all_finite(numbers.iter().position(|x| !x.is_finite()))?;
                Ok(match numbers.as_slice() {
                    [one] => Positions::List(vec![Expr::number(*one)]),
                    _ => Positions::Numbers(Arc::new(numbers)),
                })
            }
            Self::Points(points) if is_point => {
                all_finite(points.iter().position(|[x, y]| !(x.is_finite() && y.is_finite())))?;
                let point = |[x, y]: [f64; 2]| Expr::Constant(Value::Vector(Vec2::new(x, y)));
                Ok(Positions::List(points.into_iter().map(point).collect()))
            }
            Self::Numbers(_) => Err(PositionsError::Shape { name: name(), takes: "two numbers" }),
            Self::Points(_) => Err(PositionsError::Shape { name: name(), takes: "one number" }),
        }
    }
}
