//! How large the terms are that results are sums of: what rounding is small against.
//!
//! A result is known to a rounding of the terms it is computed from, not of itself: the velocity of a point that rests in a
//! moving mechanism is a sum of lengths times angular velocities. Its size is the sum of the sizes of such terms; what is
//! below [`ROUNDING`] of it is zero.

/// A result below this part of its size is zero but for rounding: it contains at most 64 roundings.
pub(crate) const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Rounding is not said to grow more than by this condition.
pub(crate) const LEAST_CONDITION: f64 = 1e-3;

/// By what power of the condition rounding of positions and velocities grows, and that of accelerations and forces.
pub(crate) const OF_MOTION: i32 = 2;
pub(crate) const OF_FORCES: i32 = 3;

/// Whether a number is zero but for rounding.
pub(crate) fn is_zero(x: f64, size: f64) -> bool {
    x.abs() <= ROUNDING * size
}

/// The greatest of what results are made of, over all positions looked at, SI.
#[derive(Clone, Debug, Default)]
pub struct Sizes {
    pub(super) length: f64,
    /// Velocities of bodies, m/s: over the length they count as angular ones, once the greatest length is known.
    pub(super) moving: f64,
    /// The same of accelerations, m/s².
    pub(super) gaining: f64,
    /// Angular velocities.
    pub(super) turning: f64,
    /// Angular accelerations.
    pub(super) speeding: f64,
    /// What the loads would make of the angular accelerations, each alone.
    pub(super) alone: f64,
    /// All loads together without those of inertia, N.
    pub(super) applied: f64,
    /// All loads together, or a reaction.
    pub(super) force: f64,
    /// The same of torques.
    pub(super) moment: f64,
    /// Rounding is so much greater where the formulas of positions and velocities have lost digits; 0 is not at all.
    pub(super) doubt: f64,
    /// Of each quantity of the file, at the position looked at last.
    pub(super) quantities: Vec<f64>,
}

impl Sizes {
    pub(crate) const NONE: Self = Self {
        length: 0.0,
        moving: 0.0,
        gaining: 0.0,
        turning: 0.0,
        speeding: 0.0,
        alone: 0.0,
        applied: 0.0,
        force: 0.0,
        moment: 0.0,
        doubt: 0.0,
        quantities: Vec::new(),
    };

    /// Nothing is looked at yet. From here on nothing is allocated.
    #[must_use]
    pub(crate) fn new(quantities: usize) -> Self {
        Self { quantities: Vec::with_capacity(quantities), ..Self::default() }
    }

    /// Loads would accelerate bodies so much, over the length.
    pub(crate) fn may_accelerate(&mut self, speeding: f64) {
        if speeding.is_finite() {
            self.alone = self.alone.max(speeding);
        }
    }

    /// Rounding at this position is so much greater than [`ROUNDING`].
    pub(crate) const fn doubt(&mut self, times: f64) {
        self.doubt = times;
    }

    /// Whether what has a size is zero but for rounding of positions and velocities.
    pub(super) fn is_nothing(&self, x: f64, size: f64) -> bool {
        is_zero(x, size * self.doubt.max(1.0))
    }

    /// All loads together without those of inertia, N.
    pub(crate) const fn applied(&self) -> f64 {
        self.applied
    }

    pub(super) fn over_length(&self, x: f64) -> f64 {
        if self.length > 0.0 { x / self.length } else { 0.0 }
    }

    /// Of a quantity of the file.
    pub(super) fn quantity(&self, index: usize) -> f64 {
        self.quantities.get(index).copied().unwrap_or(f64::NAN)
    }

    /// Coordinates and lengths, m.
    pub(crate) const fn length(&self) -> f64 {
        self.length
    }

    /// Angular velocities, rad/s.
    pub(crate) fn turning(&self) -> f64 {
        self.seen_turning().max(self.alone.sqrt())
    }

    /// Those that there were.
    pub(crate) fn seen_turning(&self) -> f64 {
        self.turning.max(self.over_length(self.moving))
    }

    /// Angular accelerations, rad/s².
    pub(crate) fn speeding(&self) -> f64 {
        self.speeding.max(self.over_length(self.gaining)).max(self.turning * self.turning).max(self.alone)
    }

    /// Velocities, m/s.
    pub(crate) fn speed(&self) -> f64 {
        self.length * self.turning()
    }

    /// m/s².
    pub(crate) fn acceleration(&self) -> f64 {
        self.length * self.speeding()
    }

    /// N.
    pub(crate) fn all_force(&self) -> f64 {
        self.force + self.over_length(self.moment)
    }

    /// N·m.
    pub(crate) fn all_moment(&self) -> f64 {
        self.moment + self.force * self.length
    }

    pub(super) fn power(&self) -> f64 {
        self.all_moment() * self.turning()
    }
}
