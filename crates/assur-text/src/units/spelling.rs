//! Suggestions for an unknown unit.

use super::unit::factors;
use crate::diagnostic::did_you_mean;
use crate::language::{Symbol, UNITS, symbol};

/// Words that mean a unit as a whole.
const WHOLE: &[(&str, &str)] = &[
    ("U/min", "rpm"),
    ("u/min", "rpm"),
    ("U/m", "rpm"),
    ("u/m", "rpm"),
    ("r/min", "rpm"),
    ("r/m", "rpm"),
    ("rot/min", "rpm"),
    ("tr/min", "rpm"),
    ("rps", "rev/s"),
    ("mps", "m/s"),
    ("rads", "rad/s"),
    ("radps", "rad/s"),
    ("kmh", "km/h"),
    ("kph", "km/h"),
];

/// Spellings of the whole word that are units, the nearest first; at most three.
pub(super) fn nearest(word: &str) -> Vec<String> {
    spellings(word, true)
}

/// Spellings of the whole word that certainly were meant: other words for units, powers without `^`.
#[must_use]
pub fn suggestions(word: &str) -> Vec<String> {
    spellings(word, false)
}

fn spellings(word: &str, roughly: bool) -> Vec<String> {
    if let Some((_, unit)) = WHOLE.iter().find(|(whole, _)| *whole == word) {
        return vec![(*unit).to_owned()];
    }
    let mut spellings = vec![String::new()];
    let mut from = 0;
    for part in factors(word) {
        let before = &word[from..part.start];
        let choices = part_choices(&word[part.start..part.end], part.symbol, roughly);
        spellings = spellings
            .iter()
            .flat_map(|s| choices.iter().map(move |c| format!("{s}{before}{c}")))
            .take(3)
            .collect();
        from = part.end;
    }
    spellings
}

/// Spellings for one factor; `text` is the symbol with its power.
fn part_choices(text: &str, written: &str, roughly: bool) -> Vec<String> {
    if symbol(written).is_some() {
        return vec![text.to_owned()];
    }
    let power = &text[written.len()..];
    let whole = symbol_choices(written);
    if !whole.is_empty() {
        return whole.into_iter().map(|s| format!("{s}{power}")).collect();
    }
    let bare = written.trim_end_matches(|c: char| c.is_ascii_digit());
    let digits = &written[bare.len()..];
    if !digits.is_empty() && power.is_empty() {
        let fixed = if symbol(bare).is_some() { vec![bare.to_owned()] } else { product(bare) };
        if !fixed.is_empty() {
            return fixed.into_iter().map(|s| format!("{s}^{digits}")).collect();
        }
    }
    let split = product(written);
    if !split.is_empty() {
        return split.into_iter().map(|s| format!("{s}{power}")).collect();
    }
    if !roughly {
        return Vec::new();
    }
    // of the other words for a unit the long ones: a short word is near to many
    let words = UNITS.iter().flat_map(|s| s.also.iter().filter(|w| w.len() > 4).chain([&s.text]));
    let mut near = Vec::new();
    // of a long word the nearest alone: `milimeters` is not `kilometers`
    let most = if written.len() > 4 { 1 } else { 3 };
    for word in did_you_mean(written, words.copied()).into_iter().take(most) {
        let unit = UNITS.iter().find(|s| s.text == word || s.also.contains(&word)).map_or(word, |s| s.text);
        let unit = format!("{unit}{power}");
        if !near.contains(&unit) {
            near.push(unit);
        }
    }
    near
}

/// Other words for a symbol, then symbols that differ in their capitals alone.
fn symbol_choices(written: &str) -> Vec<&'static str> {
    let is_alias = |s: &&Symbol| s.also.contains(&written) || s.also.contains(&&*written.to_lowercase());
    let aliases = UNITS.iter().filter(is_alias).map(|s| s.text).collect::<Vec<_>>();
    if !aliases.is_empty() {
        return aliases;
    }
    let alike = |s: &&Symbol| s.text.to_lowercase() == written.to_lowercase();
    UNITS.iter().filter(alike).map(|s| s.text).collect()
}

/// `Nm` as `N*m`, `kgm` as `kg*m`; nobody multiplies two units of one dimension.
fn product(written: &str) -> Vec<String> {
    let splits = written.char_indices().skip(1).map(|(i, _)| written.split_at(i));
    let units = splits.filter_map(|(a, b)| Some((symbol(a)?, symbol(b)?)));
    units.filter(|(a, b)| a.dimension != b.dimension).map(|(a, b)| format!("{}*{}", a.text, b.text)).collect()
}
