//! What a motion under loads says of itself.

/// How the equations are integrated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Method {
    /// The pair of order 8(5,3) of Dormand and Prince, as Hairer, Nørsett and Wanner give it.
    #[default]
    Dop853,
    /// Radau IIA of order 5, of Hairer and Wanner, from where the explicit method is held up by stability.
    Radau,
}

/// What a run says of itself.
#[derive(Clone, Debug, Default)]
pub struct SimulationReport {
    /// How it was integrated.
    pub method: Method,
    /// Accepted steps of the finer run.
    pub steps: usize,
    /// Rejected steps of the finer run.
    pub rejected: usize,
    /// Evaluations of the equations in all runs.
    pub evaluations: usize,
    /// The wanted accuracy.
    pub within: f64,
    /// The estimated error, the worst of all kinds, relative to the greatest of its kind.
    pub error: f64,
    /// The kind that has it.
    pub worst: &'static str,
    /// Energy, where no drive that is prescribed moves.
    pub energy: Option<Energy>,
    /// The least condition figure of a group, and its instant, s.
    pub worst_condition: (f64, f64),
    /// Free coordinates, by drive.
    pub coordinates: Vec<usize>,
    /// Instants of every event of the mechanism, s.
    pub events: Vec<Vec<f64>>,
    /// When the coordinate comes to rest by friction, and when it leaves again, s.
    pub rests: Vec<(f64, Option<f64>)>,
    /// The event that ended the run.
    pub ended_by: Option<usize>,
    /// The last instant that was reached, s.
    pub end: f64,
}

/// What becomes of energy.
#[derive(Clone, Copy, Debug, Default)]
pub struct Energy {
    /// Kinetic energy at the first instant, J.
    pub begin: f64,
    /// At the last, J.
    pub end: f64,
    /// Work of all loads, weights and springs between them, J.
    pub work: f64,
    /// What is missing at the worst instant, over the greatest energy exchanged.
    pub balance: f64,
}
