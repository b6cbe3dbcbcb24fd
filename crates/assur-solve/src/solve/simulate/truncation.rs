//! What a run leaves off, by its own estimates.

/// What the series of functions over a run leave off counts so many times for their error.
const OF_FUNCTIONS: f64 = 2.0;

/// What steps leave off, relative to what is much.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct TruncationError {
    /// The most that one of them does, or the series of a function over the run.
    pub worst: f64,
    /// What all of them do together.
    pub all: f64,
}

impl TruncationError {
    /// Of steps to a tolerance: the greatest error and the sum of all, over what it allows.
    pub fn of_steps(tolerance: f64, (worst, all): (f64, f64)) -> Self {
        Self { worst: tolerance * worst, all: tolerance * all }
    }

    /// Of series of mass and force over the coordinate: the worst, and all in the mean over time.
    pub const fn of_series((worst, all): (f64, f64)) -> Self {
        Self { worst, all }
    }

    /// With what the steps before leave off.
    pub const fn with(self, before: Self) -> Self {
        Self { worst: self.worst.max(before.worst), all: self.all + before.all }
    }

    /// With what the series of functions over the run leave off.
    pub fn with_functions(self, functions: f64) -> Self {
        Self { worst: self.worst.max(OF_FUNCTIONS * functions), ..self }
    }
}
