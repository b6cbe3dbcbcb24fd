//! What is found over the sweep.

use super::undefined::Undefined;
use crate::math::chebyshev::Series;

/// A function over the sweep with what it took.
#[derive(Clone, Debug, Default)]
pub struct CycleAnswer {
    /// Its value, SI; NaN where it has none.
    pub value: f64,
    /// Estimated error, rounding included, SI.
    pub error: f64,
    /// The greatest magnitude in play, SI: what the errors are relative to.
    pub scale: f64,
    /// What its rounding is small against, SI.
    pub size: f64,
    /// Over a motion under loads, where an extreme is, s.
    pub at: f64,
    /// Positions solved for it.
    pub samples: usize,
    /// Drive values where the quantity is not smooth.
    pub splits: Vec<f64>,
    /// Why it has no value.
    pub why: Option<Undefined>,
}

/// A flywheel that was found.
#[derive(Clone, Debug, Default)]
pub struct FlywheelAnswer {
    /// Its moment of inertia, kg m²; zero where the links alone run evenly enough.
    pub inertia: f64,
    /// The fluctuation \[W\], J.
    pub fluctuation: f64,
    /// Mean torque on its shaft, N m: what balances the other side.
    pub mean_torque: f64,
    /// Mean speed of its shaft, rad/s.
    pub speed: f64,
    /// Angular velocity of its shaft over that of the drive.
    pub ratio: f64,
    /// Drive values of the least and the greatest work, rad.
    pub extremes: [f64; 2],
    /// Reduced moment of inertia of the moving links on its shaft, kg m²: mean, least, greatest.
    pub links: [f64; 3],
    /// Estimated error of \[W\], J.
    pub error: f64,
    /// Positions solved for it.
    pub samples: usize,
    /// Drive values where the torque is not smooth.
    pub splits: Vec<f64>,
    /// The work over the sweep, panel by panel, in the sweep's own coordinate from 0 to 1, J.
    pub work: Vec<Series>,
    /// First drive value and length of the sweep, rad.
    pub interval: (f64, f64),
}

impl CycleAnswer {
    pub(crate) fn undefined(why: Undefined) -> Self {
        Self { value: f64::NAN, why: Some(why), ..Self::default() }
    }
}

impl FlywheelAnswer {
    /// The work at a value of the drive, J.
    #[must_use]
    pub fn work(&self, value: f64) -> f64 {
        let turns = (value - self.interval.0) / self.interval.1;
        let s = turns - turns.floor();
        let panel = self.work.iter().find(|p| s <= p.to).or(self.work.last());
        panel.map_or(f64::NAN, |p| p.value(s))
    }
}
