//! From a word to a unit.

use super::spelling::nearest;
use super::unit::whole_reciprocal;
use super::{Dimension, Kind, Unit, UnitError};
use crate::language::symbol;

/// A factor of a composite unit, as written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Factor<'a> {
    /// The symbol without its power.
    pub symbol: &'a str,
    /// The power, negative behind a stroke; `None` if it is too large.
    pub power: Option<i8>,
    /// First byte of the symbol in the word.
    pub start: usize,
    /// One past the last byte of the power.
    pub end: usize,
    /// Whether a stroke stands before it.
    pub divided: bool,
}

/// What stands between two factors: a blank and a point mean a product.
pub(super) const BETWEEN: [char; 6] = ['*', '/', '·', '⋅', '.', ' '];

/// The factors of a unit word, left to right. `1/s` is one factor.
#[must_use]
pub fn factors(word: &str) -> Vec<Factor<'_>> {
    let mut found = Vec::new();
    let mut start = 0;
    let mut divided = false;
    let mut push = |start: usize, end: usize, divided: bool| {
        let text = &word[start..end];
        if !(found.is_empty() && text == "1") {
            found.push(factor(text, start, end, divided));
        }
    };
    for (i, c) in word.char_indices() {
        if BETWEEN.contains(&c) {
            push(start, i, divided);
            start = i + c.len_utf8();
            divided = c == '/';
        }
    }
    push(start, word.len(), divided);
    found
}

fn factor(text: &str, start: usize, end: usize, divided: bool) -> Factor<'_> {
    let (symbol, digits) = split_power(text);
    let power = match digits {
        Some(digits) => digits.parse::<i8>().ok().filter(|p| *p != i8::MIN),
        None => Some(1),
    };
    Factor { symbol, power: power.map(|p| if divided { -p } else { p }), start, end, divided }
}

/// `s^-1` and `s⁻¹` into `s` and `-1`.
fn split_power(text: &str) -> (&str, Option<String>) {
    if let Some((symbol, digits)) = text.split_once('^') {
        return (symbol, Some(digits.replace('−', "-")));
    }
    let at = text.find(|c| superscript(c).is_some()).unwrap_or(text.len());
    let (symbol, raised) = text.split_at(at);
    let digits = raised.chars().map(|c| superscript(c).unwrap_or('?')).collect::<String>();
    (symbol, (!digits.is_empty()).then_some(digits))
}

fn superscript(c: char) -> Option<char> {
    let index = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻".chars().position(|s| s == c)?;
    "0123456789-".chars().nth(index)
}

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
