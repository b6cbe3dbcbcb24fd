//! Memory of the steps that solve a group with friction.

use super::wrench::Wrench;
use crate::math::{Lu, Vec2};
use crate::plan::FrictionGroup;

/// Memory of a group with friction.
#[derive(Clone, Debug)]
pub struct FrictionWork {
    /// Wrenches of the group's bodies and bases as the group finds them.
    pub(super) saved: Vec<Wrench>,
    /// What the law of each element measures, two numbers each: a row per element, from the loads and from each unit.
    pub(super) measured: Vec<Vec2>,
    pub(super) senses: Vec<f64>,
    pub(super) jacobian: Lu,
    pub(super) values: Vec<f64>,
    pub(super) right: Vec<f64>,
    pub(super) steps: u32,
}

impl FrictionWork {
    /// Newton's steps at the last position, all attempts counted; zero where a closed form needs none.
    #[must_use]
    pub const fn steps(&self) -> u32 {
        self.steps
    }

    /// Memory for a group.
    #[must_use]
    pub fn new(group: &FrictionGroup) -> Self {
        let count = group.elements.len();
        Self {
            saved: vec![Wrench::default(); group.bodies.len() + group.bases.len()],
            measured: vec![Vec2::zero(); count * (count + 1)],
            senses: vec![0.0; count],
            jacobian: Lu::new(count),
            values: vec![0.0; count],
            right: vec![0.0; count],
            steps: 0,
        }
    }
}
