//! What trades accuracy for time.

/// What trades accuracy for time; the plan carries it to everything that solves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// What every position is computed with.
    pub scalar: Precision,
    /// Newton's method on the force of a dyad with friction has settled when the error that its step leaves is this part of
    /// the forces.
    pub friction: f64,
    /// Newton's method on the efforts of friction of any other group has settled when its step is this part of them: what is
    /// left is of the order of its square.
    pub friction_step: f64,
    /// A step below this, relative to the length of the group, ends Newton's method of a general group.
    pub newton: f64,
    /// An error below this, relative to the greatest coordinate, ends Newton's method of a triad.
    pub triad: f64,
    /// Functions over the sweep take samples until their estimated error is this part of the greatest value.
    pub samples: f64,
    /// Places where a quantity over the sweep is not smooth are roots found to this part of the greater end of the interval.
    pub root: f64,
}

/// What every position is computed with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Precision {
    /// `f64`.
    #[default]
    F64,
    /// Twice its digits, rounded to it at the end.
    DoubleDouble,
}

impl Settings {
    /// All digits that `f64` has.
    pub const FULL: Self = Self {
        scalar: Precision::F64,
        friction: 1e-15,
        friction_step: 1e-9,
        newton: 1e-12,
        triad: 4.0 * f64::EPSILON,
        samples: 2e-15,
        root: 4.0 * f64::EPSILON,
    };

    /// With an error left in friction, as a part of the forces.
    #[must_use]
    pub fn with_friction(self, left: f64) -> Self {
        let left = left.max(Self::FULL.friction);
        // from the one error to the other step as between the full ones
        let step = Self::FULL.friction_step * (left / Self::FULL.friction).sqrt();
        Self { friction: left, friction_step: step.max(Self::FULL.friction_step), ..self }
    }
}

impl Default for Settings {
    fn default() -> Self {
        Self::FULL
    }
}
