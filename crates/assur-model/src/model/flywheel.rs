//! Flywheels that are to be found, and what is asked of them.

use super::{BalanceId, LinkId, LoadId};
use crate::source::Span;

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
