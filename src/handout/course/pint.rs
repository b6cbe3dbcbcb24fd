//! Units in the words of pint, which reads the answers that students of PrairieLearn type.

use assur_text::units::{Dimension, Unit};

/// Units that both know. Others are asked for as plain numbers.
const WORDS: [(&str, &str); 38] = [
    ("m", "meter"),
    ("mm", "millimeter"),
    ("um", "micrometer"),
    ("µm", "micrometer"),
    ("cm", "centimeter"),
    ("dm", "decimeter"),
    ("km", "kilometer"),
    ("inch", "inch"),
    ("ft", "foot"),
    ("kg", "kilogram"),
    ("g", "gram"),
    ("t", "metric_ton"),
    ("lb", "pound"),
    ("slug", "slug"),
    ("s", "second"),
    ("ms", "millisecond"),
    ("min", "minute"),
    ("h", "hour"),
    ("rad", "radian"),
    ("deg", "degree"),
    ("rev", "turn"),
    ("rpm", "revolutions_per_minute"),
    ("Hz", "hertz"),
    ("N", "newton"),
    ("daN", "decanewton"),
    ("kN", "kilonewton"),
    ("MN", "meganewton"),
    ("lbf", "force_pound"),
    ("kgf", "force_kilogram"),
    ("J", "joule"),
    ("kJ", "kilojoule"),
    ("W", "watt"),
    ("kW", "kilowatt"),
    ("hp", "horsepower"),
    ("Pa", "pascal"),
    ("kPa", "kilopascal"),
    ("MPa", "megapascal"),
    ("bar", "bar"),
];

/// A unit as pint writes it: `newton * meter`, `meter / second ** 2`. None where pint does not know it, and for angles, which are
/// plain numbers there.
#[must_use]
pub fn in_pint(unit: &Unit) -> Option<String> {
    let plain = unit.dimension == Dimension::NUMBER || unit.dimension == Dimension::ANGLE;
    if plain || unit.text.is_empty() {
        return None;
    }
    let text = unit.text.replace(['·', '⋅'], "*").replace('²', "^2").replace('³', "^3");
    let mut out = String::new();
    let (mut rest, mut sign) = (text.as_str(), "*");
    loop {
        let end = rest.find(['*', '/']).unwrap_or(rest.len());
        let factor = rest[..end].trim();
        let (word, power) = factor.split_once('^').unwrap_or((factor, "1"));
        if factor != "1" {
            let name = WORDS.iter().find(|(own, _)| *own == word)?.1;
            let power = power.parse::<u8>().ok()?;
            let before = if out.is_empty() && sign == "*" { String::new() } else { format!(" {sign} ") };
            let behind = if power == 1 { String::new() } else { format!(" ** {power}") };
            out += &format!("{before}{name}{behind}");
        }
        let Some(next) = rest.get(end..=end).filter(|next| !next.is_empty()) else { break };
        sign = if next == "/" { "/" } else { "*" };
        rest = &rest[end + 1..];
    }
    Some(out.trim().to_owned())
}
