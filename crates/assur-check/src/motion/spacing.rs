//! Coordinates and angles at which numbers are too far apart for the digits that are printed.

use crate::expr::context::Context;
use crate::values::format_value::{digits, format_value};
use assur_text::diagnostic::Diagnosis;
use assur_text::units::Dimension;

/// Six digits are printed.
const PRINTED: f64 = 1e-6;

/// Warns of the coarsest of them.
pub(crate) fn spacing(cx: &mut Context<'_>) {
    let Some(found) = cx.builder.mech.coarsest().filter(|s| s.relative() > PRINTED) else { return };
    let dimension = if found.is_angle { Dimension::ANGLE } else { Dimension::LENGTH };
    let metres = |x: f64| format!("{} m", digits(x));
    let (at, against, help) = match found.is_angle {
        true => (
            format_value(found.at, dimension),
            "one radian".to_owned(),
            "leave out whole turns: an angle between −360 deg and 360 deg has all its digits",
        ),
        false => (
            metres(found.at),
            format!("the shortest link of {}", format_value(found.of, dimension)),
            "put the origin near the mechanism: subtract the same from all coordinates of the link",
        ),
    };
    let step = format_value(found.step, dimension);
    cx.error(
        Diagnosis::warning(
            "mech::geometry::spacing",
            format!(
                "numbers near {at} are {step} apart, too much for {against} and the six \
                 digits that are printed"
            ),
        )
        .label(found.span, "far from zero")
        .help(help),
    );
}
