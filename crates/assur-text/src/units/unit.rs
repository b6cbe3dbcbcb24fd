//! A unit as an author wrote it.

use super::spelling::nearest;
use super::{Dimension, Kind};
use crate::language::symbol;
use std::fmt;
use thiserror::Error;

/// A unit: how many SI units it is, and how it was written.
#[derive(Clone, Debug, PartialEq)]
pub struct Unit {
    /// How many SI units it is.
    pub factor: f64,
    pub dimension: Dimension,
    /// Its spelling, as found in the text.
    pub text: String,
}

impl Unit {
    /// The SI unit of a dimension; its spelling is empty for a plain number.
    #[must_use]
    pub fn si(dimension: Dimension) -> Self {
        Self { factor: 1.0, dimension, text: dimension.si_text() }
    }

    /// A value in this unit, in SI.
    #[must_use]
    pub fn to_si(&self, value: f64) -> f64 {
        whole_reciprocal(self.factor).map_or(value * self.factor, |n| value / n)
    }

    /// An SI value, in this unit.
    #[must_use]
    pub fn from_si(&self, value: f64) -> f64 {
        Conversion::into_units_of(self.factor).of(value)
    }
}

/// 2⁵²: what is added to it has no digits behind the point.
const WHOLE: f64 = 4_503_599_627_370_496.0;

/// The whole number that a factor below one is the reciprocal of: dividing by 1000 rounds right where multiplying by
/// 0.001 need not.
pub(super) fn whole_reciprocal(factor: f64) -> Option<f64> {
    if factor >= 1.0 {
        return None;
    }
    // the nearest whole number, where there is one that is meant
    let n = (1.0 / factor + WHOLE) - WHOLE;
    (n <= 1e15 && 1.0 / n == factor).then_some(n)
}

/// From SI into a unit, as [`Unit::from_si`], with what does not depend on the number found once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Conversion {
    None,
    Times(f64),
    Over(f64),
}

impl Conversion {
    /// Into units of so many SI units; 0 stands for 1.
    #[must_use]
    pub fn into_units_of(factor: f64) -> Self {
        match whole_reciprocal(factor) {
            _ if factor == 0.0 || factor == 1.0 => Self::None,
            Some(n) => Self::Times(n),
            None => Self::Over(factor),
        }
    }

    /// A number of SI units in this unit.
    #[inline]
    #[must_use]
    pub fn of(self, si: f64) -> f64 {
        match self {
            Self::None => si,
            Self::Times(n) => si * n,
            Self::Over(factor) => si / factor,
        }
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

// The factors of a unit word.

/// A factor of a composite unit, as written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Factor<'a> {
    /// The symbol without its power.
    pub symbol: &'a str,
    /// The power, negative after a stroke; `None` if it is too large.
    pub power: Option<i8>,
    /// First byte of the symbol in the word.
    pub start: usize,
    /// One past the last byte of the power.
    pub end: usize,
    /// Whether a stroke stands before it.
    pub divided: bool,
}

/// What stands between two factors: a blank and a point mean a product.
const BETWEEN: [char; 6] = ['*', '/', '·', '⋅', '.', ' '];

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
    if text.is_ascii() {
        return (text, None);
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

// From a word to a unit.

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

// Errors of a unit.

/// Why a word is no unit. Ranges are bytes within the word.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum UnitError {
    /// A part of the word is in no table.
    #[error("`{part}` is not a unit")]
    Unknown {
        part: String,
        /// First byte of the part.
        start: usize,
        /// One past its last byte.
        end: usize,
        /// Spellings of the whole word that are units, the nearest first.
        nearest: Vec<String>,
    },
    /// The exponent does not fit.
    #[error("the exponent of `{part}` is too large")]
    Power {
        /// The part with its exponent.
        part: String,
        /// First byte of the part.
        start: usize,
        /// One past its last byte.
        end: usize,
    },
    /// The word is empty.
    #[error("a unit is missing")]
    Empty,
}

impl UnitError {
    /// The bytes of the word that are wrong.
    #[must_use]
    pub fn range(&self) -> (usize, usize) {
        match *self {
            Self::Unknown { start, end, .. } | Self::Power { start, end, .. } => (start, end),
            Self::Empty => (0, 0),
        }
    }

    /// Spellings of the whole word that are units, the nearest first.
    #[must_use]
    pub fn nearest(&self) -> &[String] {
        match self {
            Self::Unknown { nearest, .. } => nearest,
            _ => &[],
        }
    }

    /// What to write instead, if anything is near.
    #[must_use]
    pub fn help(&self) -> Option<String> {
        let list = self.nearest().iter().map(|n| format!("`{n}`")).collect::<Vec<_>>();
        (!list.is_empty()).then(|| format!("write {}", list.join(" or ")))
    }
}
