//! Memory of the steps that solve the forces of a train.

use crate::math::{Lu, Vec2};
use crate::plan::TrainForces;

/// Memory of a train group of forces.
#[derive(Clone, Debug, Default)]
pub struct TrainWork {
    pub(super) system: Lu,
    /// Loads on the members' coordinates.
    pub(super) loads: Vec<f64>,
    /// Forces that members get from those that stand on them.
    pub(super) carried: Vec<(Vec2, f64)>,
    pub(super) found: Vec<f64>,
    /// Unknowns with directions of the power that are tried.
    pub(super) trial: Vec<f64>,
}

impl TrainWork {
    pub(super) fn new(train: &TrainForces) -> Self {
        let (n, unknowns) = (train.members.len(), train.laws.len() + train.efforts.len());
        Self {
            system: Lu::new(n),
            loads: vec![0.0; n],
            carried: vec![(Vec2::zero(), 0.0); n],
            found: vec![0.0; unknowns],
            trial: vec![0.0; unknowns],
        }
    }
}
