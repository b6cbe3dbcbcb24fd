//! The accuracy wanted and reached.

use serde::Serialize;

use super::entries::Number;
use assur_position::plan::Numbers;
use assur_solve::measure::accuracy::{AchievedAccuracy, Source};

#[derive(Serialize)]
pub(super) struct ReachedView {
    within: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<Number>,
    reference: &'static str,
    numbers: &'static str,
    friction: Option<Number>,
    general_groups: Option<Number>,
    triads: Option<Number>,
    samples: Option<Number>,
    switching_points: Option<Number>,
}

impl ReachedView {
    pub(super) fn of(reached: &AchievedAccuracy) -> Self {
        let settings = &reached.settings;
        Self {
            within: Number::of(reached.within),
            error: Number::of(reached.error),
            reference: match reached.source {
                Source::DoubleDouble => "double-double",
                Source::Full => "condition",
            },
            numbers: match settings.scalar {
                Numbers::Double => "f64",
                Numbers::DoubleDouble => "double-double",
            },
            friction: Number::of(settings.friction),
            general_groups: Number::of(settings.newton),
            triads: Number::of(settings.triad),
            samples: Number::of(settings.samples),
            switching_points: Number::of(settings.root),
        }
    }
}
