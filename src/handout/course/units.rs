//! The units that an answer may have.

use assur_text::language::UNITS;
use assur_text::units::{Unit, lookup, significant};
use assur_worked::Language;

/// Units of several words that people use.
const COMPOSITE: [&str; 73] = [
    "N*m", "kN*m", "MN*m", "daN*m", "N*mm", "N*cm", "kN*mm", "kN*cm", "kgf*m", "lbf*ft", "lbf*inch", "m/s",
    "mm/s", "cm/s", "km/h", "m/min", "ft/s", "inch/s", "m/s^2", "mm/s^2", "cm/s^2", "ft/s^2", "rad/s",
    "deg/s", "rev/s", "rev/min", "rad/min", "1/s", "rad/s^2", "deg/s^2", "rev/s^2", "1/s^2", "m/s^3",
    "mm/s^3", "rad/s^3", "kg*m^2", "kg*cm^2", "kg*mm^2", "g*m^2", "g*cm^2", "g*mm^2", "t*m^2", "lb*ft^2",
    "m^2", "cm^2", "mm^2", "dm^2", "m^3", "dm^3", "cm^3", "mm^3", "N/m", "N/mm", "N/cm", "kN/m", "kN/mm",
    "lbf/inch", "N*s/m", "N*s/mm", "kg/s", "N*m*s", "N*m/s", "kg/m^3", "g/cm^3", "kg/dm^3", "N/m^3", "N/m^2",
    "N/cm^2", "N/mm^2", "kN/m^2", "kgf/cm^2", "lbf/ft", "kg*m/s",
];
/// Digits of a multiplier.
const DIGITS: usize = 12;

/// The names of units with how many of them make one of a unit, which is the first; none for a plain number. `used` are the
/// others of the file. No name has a blank, and none begins with a figure: neither would be met after a number.
#[must_use]
pub fn accepted(own: &Unit, used: &[Unit], language: Language) -> Vec<(String, String)> {
    let mut all: Vec<(String, String)> = Vec::new();
    if own.text.is_empty() {
        return all;
    }
    let words = UNITS.iter().map(|symbol| symbol.text).chain(COMPOSITE);
    let known = words.filter_map(|word| lookup(word).ok());
    let fitting = known.filter(|unit| unit.dimension.fits(own.dimension));
    for unit in std::iter::once(own.clone()).chain(used.iter().cloned()).chain(fitting) {
        let multiplier = significant(own.factor / unit.factor, DIGITS);
        for name in spellings(&unit.text, language) {
            if all.iter().all(|(known, _)| *known != name) {
                all.push((name, multiplier.clone()));
            }
        }
    }
    all
}

/// A unit with `*`, with `·` and with nothing between its factors, with powers behind `^` and raised, and as a language writes it.
fn spellings(unit: &str, language: Language) -> Vec<String> {
    let plain = match unit.split_whitespace().collect::<Vec<_>>().join("*").replace(['·', '⋅'], "*") {
        per if per.starts_with("1/") => format!("{}^-1", &per[2..]),
        plain => plain,
    };
    let raised = plain.replace("^-1", "⁻¹").replace("^2", "²").replace("^3", "³");
    let spelled = [plain.clone(), plain.replace('*', "·"), raised.replace('*', "·"), plain.replace('*', "")];
    let own = language.unit(&plain);
    let all = spelled.into_iter().chain([own.replace(char::is_whitespace, "")]);
    all.filter(|name| !name.is_empty() && !name.starts_with(|c: char| c.is_ascii_digit())).collect()
}
