//! A rate whose angle is not said: revolutions or radians.

use assur_text::units::{Unit, significant};

/// A number per time in revolutions, and in radians per second.
pub fn revolutions_or_radians(number: &str, unit: &Unit) -> [String; 2] {
    let turns = match unit.text.as_str() {
        "Hz" => "rev/s",
        _ if unit.factor < PER_MINUTE / 2.0 => "rev/h",
        _ => "rpm",
    };
    let radians = significant(unit.to_si(number.parse().unwrap_or(f64::NAN)), 12);
    [format!("{number} {turns}"), format!("{radians} rad/s")]
}

/// One per minute in one per second.
const PER_MINUTE: f64 = 1.0 / 60.0;
