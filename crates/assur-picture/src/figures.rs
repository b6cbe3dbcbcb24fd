//! Numbers as they stand in pictures: what is rounding beside the quantities of its kind is 0.

use crate::scene::Scene;
use assur_model::model::{Display, Value};
use assur_text::units::significant;

/// Digits of numbers in sentences, and of marked values.
const DIGITS: usize = 5;
const MARKED: usize = 4;
/// What is less than this part of what quantities of its dimension are large against is rounding: that of series over the sweep,
/// too.
const ROUNDING: f64 = 1e-11;
/// The same of places where something is least or greatest: there it hardly changes.
const PLACE: f64 = 1e-8;

/// Dimensions: exponents of length, mass and time, and the kind of angle.
pub const VELOCITY: [i8; 4] = [1, 0, -1, 0];
pub const ACCELERATION: [i8; 4] = [1, 0, -2, 0];
pub const TURNING: [i8; 4] = [0, 0, -1, 0];
pub const FORCE: [i8; 4] = [1, 1, -2, 0];
pub const MOMENT: [i8; 4] = [2, 1, -2, 0];

/// What is no greater than this is rounding beside another number.
pub fn rounding(large: f64) -> f64 {
    if large.is_finite() { ROUNDING * large } else { 0.0 }
}

/// A number, or 0 where it is rounding beside another.
pub fn cleared(si: f64, large: f64) -> f64 {
    if si.abs() <= rounding(large) { 0.0 } else { si }
}

/// A place where something is least or greatest, or 0 where it differs from that by rounding.
pub fn place(si: f64, large: f64) -> f64 {
    cleared(si, large * (PLACE / ROUNDING))
}

/// Five digits with a true minus.
pub fn plain(x: f64) -> String {
    significant(x, DIGITS).replace('-', "−")
}

/// A unit as printed: `N·m`, `°`, `m/s²`.
pub fn unit_text(unit: &str) -> String {
    let spelled = unit.replace('*', "·").replace("^-1", "⁻¹").replace("^2", "²").replace("^3", "³");
    let degrees = spelled.split('/').map(|part| if part == "deg" { "°" } else { part });
    degrees.collect::<Vec<_>>().join("/")
}

/// A value in the author's unit with four digits.
pub fn value_text(display: &Display, si: f64) -> String {
    value_in_digits(display, si, MARKED)
}

/// A value in the author's unit.
pub fn value_in_digits(display: &Display, si: f64, digits: usize) -> String {
    let figures = display.figures(Value::Scalar(si), digits).replace('-', "−");
    match unit_text(&display.unit).as_str() {
        "" => figures,
        "°" => format!("{figures}°"),
        unit => format!("{figures} {unit}"),
    }
}

impl Scene<'_> {
    /// What is no greater than this, SI, is rounding of a quantity of a dimension.
    #[must_use]
    pub fn rounding(&self, dimension: [i8; 4]) -> f64 {
        rounding(self.greatest.in_si(dimension))
    }

    /// Five digits with a true minus; 0 for what is rounding.
    pub(crate) fn figure(&self, si: f64, dimension: [i8; 4]) -> String {
        plain(cleared(si, self.greatest.in_si(dimension)))
    }

    /// A value in the author's unit with four digits; 0 for what is rounding.
    pub(crate) fn value_text(&self, display: &Display, si: f64) -> String {
        value_text(display, cleared(si, self.greatest.in_si(display.dimension)))
    }

    /// A place where something is least or greatest, in the author's unit.
    pub(crate) fn place_text(&self, display: &Display, si: f64) -> String {
        value_text(display, place(si, self.greatest.in_si(display.dimension)))
    }
}
