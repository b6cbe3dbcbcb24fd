//! From a word to a unit.

use super::factors::factors;
use super::spelling::nearest;
use super::table::symbol;
use super::unit::whole_reciprocal;
use super::{Dimension, Kind, Unit, UnitError};

/// Whether the word without a power is a unit's symbol.
#[must_use]
pub fn is_unit(word: &str) -> bool {
    symbol(word).is_some()
}

/// The unit that a word means: `kN*m`, `N m`, `kg·m²`, `s^-1`, `1/s`, `m/s^2`, `°`.
///
/// # Errors
/// Names the part that is no unit, with the nearest spellings that are.
pub fn lookup(word: &str) -> Result<Unit, UnitError> {
    let mut factor = 1.0;
    let (mut length, mut mass, mut time, mut angle) = (0_i8, 0_i8, 0_i8, 0_i8);
    let mut plain = true;
    if word.is_empty() {
        return Err(UnitError::Empty);
    }
    for part in factors(word) {
        let range = || (word[part.start..part.end].to_owned(), part.start, part.end);
        let Some(unit) = symbol(part.symbol) else {
            let (text, start, end) = range();
            return Err(UnitError::Unknown { part: text, start, end, nearest: nearest(word) });
        };
        let Some(power) = part.power else {
            let (text, start, end) = range();
            return Err(UnitError::Power { part: text, start, end });
        };
        factor *= power_of(unit.factor, power);
        let raised = unit.dimension.powi(power);
        length = length.saturating_add(raised.length);
        mass = mass.saturating_add(raised.mass);
        time = time.saturating_add(raised.time);
        if unit.dimension.kind == Kind::Angle {
            angle = angle.saturating_add(power);
        }
        plain &= unit.dimension.kind == Kind::Plain;
    }
    let kind = match (length, mass, angle) {
        (0, 0, 1) => Kind::Angle,
        (0, 0, 0) if plain || per_minute(word) => Kind::Plain,
        _ => Kind::Free,
    };
    let text = word.replace([' ', '.'], "*");
    Ok(Unit { factor, dimension: Dimension { length, mass, time, kind }, text })
}

/// Whether a word is `1/min` or the like: what is counted per minute or hour, revolutions or radians, it does not say.
/// In `1/s` it is radians.
fn per_minute(word: &str) -> bool {
    let factors = factors(word);
    let [only] = factors.as_slice() else { return false };
    matches!(only.symbol, "min" | "h") && only.power == Some(-1)
}

/// Repeated multiplication, of the reciprocal where that is whole: powers of ten stay exact.
fn power_of(base: f64, power: i8) -> f64 {
    let reciprocal = whole_reciprocal(base);
    let raised = (0..power.unsigned_abs()).fold(1.0, |product, _| product * reciprocal.unwrap_or(base));
    if (power < 0) == reciprocal.is_some() { raised } else { 1.0 / raised }
}
