//! Times, errors and shares in words.

use super::answers::NONE;
use assur_text::units::significant;

/// Units of time with the microseconds in each, from the smallest on.
pub(super) const UNITS: [(&str, f64); 4] = [("ns", 1e-3), ("µs", 1.0), ("ms", 1e3), ("s", 1e6)];

/// The greatest unit of which a time has at least one.
pub(super) fn unit(micros: f64) -> (&'static str, f64) {
    UNITS.into_iter().rfind(|(_, size)| micros >= *size).unwrap_or(UNITS[0])
}

/// A time in a unit that fits: `2.3 ms`.
pub(super) fn time(micros: f64) -> String {
    // what rounds to a thousand has one of the next unit
    let (name, size) = unit(micros * 1.005);
    let amount = micros / size;
    if amount < 9.95 { format!("{amount:.1} {name}") } else { format!("{amount:.0} {name}") }
}

/// An error in one figure.
pub(super) fn size(error: f64) -> String {
    match error {
        0.0 => "0".to_owned(),
        error if error.is_finite() => format!("{error:.0e}"),
        _ => NONE.to_owned(),
    }
}

/// The digits that an error leaves.
pub(super) fn digits(error: f64) -> String {
    if error.is_finite() { format!("{:.1}", -libm::log10(error.max(1e-40))) } else { NONE.to_owned() }
}

/// A count with its thousands apart.
pub(super) fn count(count: usize) -> String {
    let figures = count.to_string();
    let mut out = String::new();
    for (i, figure) in figures.chars().enumerate() {
        out.push_str(if i > 0 && (figures.len() - i).is_multiple_of(3) { "," } else { "" });
        out.push(figure);
    }
    out
}

/// How much more or less something is: `+9 %`, `−35 %`; in times from twice on.
pub(super) fn change(ratio: f64) -> String {
    let percent = (100.0 * (ratio - 1.0)).round();
    if !percent.is_finite() {
        return NONE.to_owned();
    }
    match percent {
        100.0.. => format!("{} times", significant(ratio, 2)),
        0.0.. => format!("+{percent} %"),
        _ => format!("−{} %", -percent),
    }
}

/// A part of something or a multiple of it, before `of …`: `33 %`, `2.1 times`.
pub(super) fn part(ratio: f64) -> String {
    if ratio < 1.995 {
        format!("{} %", significant(100.0 * ratio, 2))
    } else {
        format!("{} times", significant(ratio, 2))
    }
}
