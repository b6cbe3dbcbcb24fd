//! Settings of one kind with what each gives and takes.

use crate::plan::{ForceStep, LoadStep, MotionStep, Plan, Settings};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// What numbers are computed with.
    Scalar,
    /// The error that the iteration of friction leaves.
    Friction,
    /// The last step of Newton's method of a general group.
    Newton,
    /// The error that Newton's method of a triad leaves.
    Triad,
    /// The estimated error at which functions over the sweep take no more samples.
    Samples,
    /// How near the roots are where a function over the sweep is not smooth.
    Root,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// In words: a scalar, a tolerance.
    pub setting: String,
    /// Samples of a cycle.
    pub samples: Option<usize>,
    /// Microseconds per position; per cycle for [`Kind::Samples`] and [`Kind::Root`].
    pub micros: f64,
    /// The greatest error; absent where there was no answer.
    pub error: Option<f64>,
    /// The error is that of the reference itself, estimated.
    pub is_floor: bool,
    /// The settings, where the solver takes them.
    pub settings: Option<Settings>,
}

impl Row {
    /// Of a scalar: no setting of the solver.
    pub(super) fn scalar(setting: &str, micros: f64, error: f64, is_floor: bool) -> Self {
        let error = Some(error).filter(|e| e.is_finite());
        Self { setting: setting.to_owned(), samples: None, micros, error, is_floor, settings: None }
    }
}

/// Settings of one kind.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    pub kind: Kind,
    /// From coarse to fine.
    pub rows: Vec<Row>,
}

/// Settings that a problem has no use for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotApplicable {
    /// What would be set.
    pub what: &'static str,
    /// Why it is not.
    pub why: &'static str,
}

impl Kind {
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Scalar => "scalar",
            Self::Friction => "friction",
            Self::Newton => "general groups",
            Self::Triad => "triads",
            Self::Samples => "samples",
            Self::Root => "switching points",
        }
    }

    /// What its settings are.
    #[must_use]
    pub const fn sets(self) -> &'static str {
        match self {
            Self::Scalar => "numbers",
            Self::Friction => "error left",
            Self::Newton => "last step",
            Self::Triad => "error left",
            Self::Samples => "error left",
            Self::Root => "root within",
        }
    }

    /// Whether its time is that of a whole cycle.
    #[must_use]
    pub const fn per_cycle(self) -> bool {
        matches!(self, Self::Samples | Self::Root)
    }

    /// Its tolerances, from coarse to fine; the last is what the solver takes unless a file asks otherwise.
    pub(super) const fn tolerances(self) -> &'static [f64] {
        match self {
            Self::Scalar => &[],
            Self::Friction => &[1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, Settings::FULL.friction],
            Self::Newton => &[1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10, Settings::FULL.newton],
            Self::Triad => &[1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, Settings::FULL.triad],
            Self::Samples => &[1e-1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, Settings::FULL.samples],
            Self::Root => &[1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, Settings::FULL.root],
        }
    }

    /// The full settings with one of its tolerances.
    pub(super) fn setting(self, tolerance: f64) -> Settings {
        let full = Settings::FULL;
        match self {
            Self::Scalar => full,
            Self::Friction => full.with_friction(tolerance),
            Self::Newton => Settings { newton: tolerance, ..full },
            Self::Triad => Settings { triad: tolerance, ..full },
            Self::Samples => Settings { samples: tolerance, ..full },
            Self::Root => Settings { root: tolerance, ..full },
        }
    }

    /// Why a plan has no use for its tolerances, if it has none.
    pub(super) fn absent(self, plan: &Plan) -> Option<&'static str> {
        let motion = |f: fn(&MotionStep) -> bool| plan.motion.iter().any(f);
        let (has, why) = match self {
            Self::Scalar | Self::Samples | Self::Root => (true, ""),
            Self::Friction if !plan.effects.friction => (false, "none in this problem"),
            Self::Friction => {
                let rubs = plan.forces.iter().any(|s| matches!(s, ForceStep::Friction { .. }));
                (rubs, "all groups have closed forms or are trains")
            }
            Self::Newton => (motion(|s| matches!(s, MotionStep::General { .. })), "none in this problem"),
            Self::Triad => (motion(|s| matches!(s, MotionStep::Triad { .. })), "none in this problem"),
        };
        (!has).then_some(why)
    }
}

/// Why positions of a plan do not go through the closed forms of any scalar.
pub(super) fn not_closed(plan: &Plan) -> &'static str {
    let motion = |f: fn(&MotionStep) -> bool| plan.motion.iter().any(f);
    if motion(|s| matches!(s, MotionStep::General { .. } | MotionStep::Triad { .. })) {
        "a group is solved by iteration"
    } else if plan.forces.iter().any(|s| matches!(s, ForceStep::Friction { .. })) {
        "friction is solved by iteration"
    } else if plan.loads.iter().any(|l| matches!(l, LoadStep::Evaluated(_))) {
        "a load is evaluated at every position"
    } else if !plan.cams.is_empty() {
        "the law of a cam has several cases"
    } else if !plan.genevas.is_empty() {
        "a Geneva wheel has several cases"
    } else if !plan.laws.is_empty() {
        "a transmission is solved as a system"
    } else {
        "a group of forces is solved as a system"
    }
}
