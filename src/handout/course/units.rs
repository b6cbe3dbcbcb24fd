//! The units that an answer may have.

use assur_text::language::UNITS;
use assur_text::units::{Unit, lookup, significant};
use assur_worked::Language;

/// Units of several words that people use.
const COMPOSITE: [&str; 24] = [
    "N*m", "kN*m", "N*mm", "N*cm", "m/s", "mm/s", "cm/s", "km/h", "m/s^2", "mm/s^2", "cm/s^2", "rad/s",
    "deg/s", "rad/s^2", "deg/s^2", "kg*m^2", "kg*cm^2", "kg*mm^2", "g*m^2", "m^2", "cm^2", "mm^2", "N/m",
    "N/mm",
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
