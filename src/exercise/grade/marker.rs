//! One answer held against the key.

use super::common_mistake::{self, CommonMistake};
use super::mark::{Known, Mark, Verdict};
use super::rules::Rules;
use super::sheet::{Entry, Sheet, Unread};
use crate::exercise::expect::is_within;
use assur_text::units::Dimension;
use std::f64::consts::{PI, TAU};

/// A key below this part of what is next to it is a rounding error of zero.
const ZERO: f64 = 1e-9;
/// The tolerance of a smaller angle is that of this one, rad.
const LEAST_ANGLE: f64 = 1e-3;
/// An answer this many tolerances away is close.
const NEAR: f64 = 3.0;

/// Marks the answers of one row.
pub(super) struct Marker<'a> {
    pub key: &'a Sheet,
    /// Which row of the key.
    pub index: usize,
    pub rules: &'a Rules,
}

/// What was found of an answer.
#[derive(Default)]
struct Found {
    given: Option<f64>,
    key: Option<f64>,
    deviation: Option<f64>,
    error: Option<f64>,
}

impl Marker<'_> {
    /// The mark of an answer; an entry that is not there is in no column. `None` where there is nothing to mark.
    pub fn mark(&self, quantity: usize, place: usize, entry: Option<&Entry>) -> Option<Mark> {
        let (found, verdict) = self.verdict(place, entry)?;
        let points = self.rules.points.of(self.key, &self.key.rows[self.index], place);
        let missing = verdict == Verdict::Missing;
        let left_out = missing && self.rules.only_answered;
        if missing && (points == 0.0 || left_out && entry.is_none()) {
            return None;
        }
        let counts = points > 0.0 && found.key.is_some() && !left_out;
        let possible = if counts { points } else { 0.0 };
        let part = match &verdict {
            Verdict::Right => 1.0,
            Verdict::Wrong(Some(slip)) => self.rules.credit.of(slip),
            _ => 0.0,
        };
        let Found { given, key, deviation, error } = found;
        let points = possible * part;
        let [given, key, deviation, error] = [given, key, deviation, error].map(Known::from);
        let quantity = u32::try_from(quantity).ok()?;
        Some(Mark { quantity, given, key, deviation, error, verdict, counts, points, possible })
    }

    /// `None` where neither the key nor the student has a value.
    fn verdict(&self, place: usize, entry: Option<&Entry>) -> Option<(Found, Verdict)> {
        let truth = |t: bool| f64::from(u8::from(t));
        let of_key = |key| Found { key: Some(key), ..Found::default() };
        let unreadable = |text: &str, why: &str| Verdict::Unreadable(Unread::new(text, why));
        Some(match (&self.key.rows[self.index].entries[place], entry.unwrap_or(&Entry::Empty)) {
            (Entry::Empty | Entry::Unreadable(..), Entry::Empty) => return None,
            (Entry::Empty | Entry::Unreadable(..), entry) => {
                let given = match entry {
                    Entry::Number(x) => Some(*x),
                    Entry::Bool(t) => Some(truth(*t)),
                    _ => None,
                };
                let text = match entry {
                    Entry::Unreadable(unread) => unread.text.as_str(),
                    _ => "",
                };
                (
                    Found { given, ..Found::default() },
                    Verdict::NotAsked(Unread::new(text, "the key has no value here")),
                )
            }
            (Entry::Number(key), Entry::Empty) => (of_key(*key), Verdict::Missing),
            (Entry::Bool(key), Entry::Empty) => (of_key(truth(*key)), Verdict::Missing),
            (Entry::Bool(key), Entry::Bool(given)) => {
                let found = Found { given: Some(truth(*given)), ..of_key(truth(*key)) };
                (found, if given == key { Verdict::Right } else { Verdict::Wrong(None) })
            }
            (Entry::Number(key), Entry::Number(given)) => self.compared(place, *given, *key),
            (Entry::Number(key), Entry::Unreadable(unread)) => {
                (of_key(*key), Verdict::Unreadable(unread.clone()))
            }
            (Entry::Number(key), Entry::Bool(given)) => {
                (of_key(*key), unreadable(&given.to_string(), "it is not a number"))
            }
            (Entry::Bool(key), Entry::Number(given)) => {
                let text = assur_text::units::significant(*given, 6);
                (of_key(truth(*key)), unreadable(&text, "write true or false"))
            }
            (Entry::Bool(key), Entry::Unreadable(unread)) => {
                (of_key(truth(*key)), unreadable(&unread.text, "write true or false"))
            }
        })
    }

    fn compared(&self, place: usize, given: f64, key: f64) -> (Found, Verdict) {
        let deviation = self.difference(place, given, key);
        let error = deviation.abs() / self.scale(place, key);
        // equal where there is nothing to compare with
        let error = if error.is_nan() { 0.0 } else { error };
        let verdict = if is_within(error, self.rules.within) {
            Verdict::Right
        } else {
            Verdict::Wrong(self.slip(place, given, key).map(Box::new))
        };
        // a part of zero is no number to print
        let error = (!self.is_zero(place, key)).then_some(error);
        (Found { given: Some(given), key: Some(key), deviation: Some(deviation), error }, verdict)
    }

    /// Whether the key is zero, or its rounding error.
    fn is_zero(&self, place: usize, key: f64) -> bool {
        key.abs() <= ZERO * self.scale(place, key)
    }

    fn number(&self, place: usize) -> Option<f64> {
        match self.key.rows[self.index].entries[place] {
            Entry::Number(x) => Some(x),
            _ => None,
        }
    }

    /// The other component of the same vector.
    fn partner(&self, place: usize) -> Option<usize> {
        let name = &self.key.quantities[place].name;
        let other = match name.rsplit_once('.')? {
            (stem, "x") => format!("{stem}.y"),
            (stem, "y") => format!("{stem}.x"),
            _ => return None,
        };
        self.key.quantities.iter().position(|q| q.name == other)
    }

    fn dimension(&self, place: usize) -> Dimension {
        self.key.quantities[place].unit.dimension
    }

    /// What the tolerance is a part of: the value; of a component the magnitude of its vector; of zero the greatest
    /// value of its kind in the row.
    fn scale(&self, place: usize, key: f64) -> f64 {
        let greatest = || {
            let alike =
                (0..self.key.quantities.len()).filter(|i| self.dimension(*i) == self.dimension(place));
            alike.filter_map(|i| self.number(i)).fold(0.0, |greatest: f64, x| greatest.max(x.abs()))
        };
        let other = self.partner(place).and_then(|i| self.number(i)).unwrap_or(0.0);
        let own = libm::hypot(key, other);
        if own > ZERO * greatest() { own } else { greatest() }
    }

    /// Modulo a turn for angles.
    fn difference(&self, place: usize, given: f64, key: f64) -> f64 {
        let plain = given - key;
        if self.dimension(place) == Dimension::ANGLE { plain - TAU * (plain / TAU).round() } else { plain }
    }

    /// What a wrong answer would be right for; the value of another row only where nothing else explains it.
    fn slip(&self, place: usize, given: f64, key: f64) -> Option<CommonMistake> {
        let is = |x: f64, of: usize, value: f64| {
            self.difference(of, x, value).abs() <= self.rules.within * self.scale(of, value)
        };
        let zero = self.is_zero(place, key);
        // a component is small beside its vector: what it would be right for is measured by itself
        let near = |x: f64| self.difference(place, x, key).abs() <= self.rules.within * key.abs();
        // whole turns are taken off the key alone: a thousandfold angle would come near anything
        let in_turn = self.difference(place, key, 0.0);
        let off = |x: f64| {
            let parts = [key, in_turn].map(|key| (x - key).abs() / key.abs());
            parts.into_iter().filter(|part| *part <= self.rules.within).reduce(f64::min)
        };
        let other_sign =
            || (!zero && near(-given)).then(|| self.other_link(place).unwrap_or(CommonMistake::Sign));
        let by_factor = || if zero { None } else { common_mistake::factor(given, &off) };
        let elsewhere = || if given == 0.0 { None } else { self.other_quantity(place, given, &is) };
        let far = self.difference(place, given, key).abs() / self.scale(place, key);
        let close = || (far <= NEAR * self.rules.within).then_some(CommonMistake::Close);
        self.of_angle(place, given, key)
            .or_else(other_sign)
            .or_else(by_factor)
            .or_else(|| self.of_vector(place, given, key, &is))
            .or_else(elsewhere)
            .or_else(close)
            .or_else(|| if given == 0.0 { None } else { self.other_row(place, given) })
    }

    /// Of an angle the nearest of the opposite sign, the opposite direction and the supplement.
    fn of_angle(&self, place: usize, given: f64, key: f64) -> Option<CommonMistake> {
        if self.dimension(place) != Dimension::ANGLE {
            return None;
        }
        let meant = [
            (-key, CommonMistake::Sign),
            (key + PI, CommonMistake::Opposite),
            (PI - key, CommonMistake::Supplement),
        ];
        let off = |angle: f64| {
            let size = self.difference(place, angle, 0.0).abs();
            let off = self.difference(place, given, angle).abs();
            (off <= self.rules.within * size.max(LEAST_ANGLE)).then_some(off)
        };
        let found = meant.into_iter().filter_map(|(angle, slip)| Some((off(angle)?, slip)));
        found
            .reduce(|least, next| if next.0 < least.0 - LEAST_ANGLE * ZERO { next } else { least })
            .map(|(_, slip)| slip)
    }

    fn other_link(&self, place: usize) -> Option<CommonMistake> {
        let name = &self.key.quantities[place].name;
        name.starts_with("reaction(").then_some(CommonMistake::OtherLink)
    }

    fn of_vector(
        &self,
        place: usize,
        given: f64,
        key: f64,
        is: &dyn Fn(f64, usize, f64) -> bool,
    ) -> Option<CommonMistake> {
        let partner = self.partner(place)?;
        let other = self.number(partner)?;
        if is(given, partner, other) {
            return Some(CommonMistake::Swapped);
        }
        is(given, place, libm::hypot(key, other)).then_some(CommonMistake::Magnitude)
    }

    fn other_quantity(
        &self,
        place: usize,
        given: f64,
        is: &dyn Fn(f64, usize, f64) -> bool,
    ) -> Option<CommonMistake> {
        let others = (0..self.key.quantities.len())
            .filter(|i| *i != place && self.dimension(*i) == self.dimension(place));
        let close = |x: f64, value: f64, i: usize| {
            value != 0.0 && is(x, i, value) && (x - value).abs() <= self.rules.within * value.abs()
        };
        for (sign, wrong) in [(1.0, false), (-1.0, true)] {
            let mut all = others.clone().filter_map(|i| Some((i, self.number(i)?)));
            if let Some((i, _)) = all.find(|(i, value)| close(sign * given, *value, *i)) {
                return Some(CommonMistake::OtherQuantity {
                    name: self.key.quantities[i].name.clone(),
                    sign: wrong,
                });
            }
        }
        None
    }

    fn other_row(&self, place: usize, given: f64) -> Option<CommonMistake> {
        let rows = self.key.rows.iter().enumerate().filter(|(i, _)| *i != self.index);
        let mut found = rows.filter(|(_, row)| match row.entries[place] {
            Entry::Number(x) => x != 0.0 && (given - x).abs() <= self.rules.within * x.abs(),
            _ => false,
        });
        let (_, row) = found.next()?;
        let words = row.names.words().join(", ");
        Some(CommonMistake::OtherRow(if words.is_empty() { format!("line {}", row.line) } else { words }))
    }
}
