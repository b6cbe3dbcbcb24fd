//! One answer held against the key.

use super::common_mistake::CommonMistake;
use super::mark::{Known, Mark, Verdict};
use super::rules::Rules;
use super::sheet::{Entry, Sheet, Unread};
use crate::exercise::turns::{self, difference};
use assur_text::units::Dimension;

/// A key below this part of what is next to it is a rounding error of zero.
const ZERO: f64 = 1e-9;

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
        if !self.key.positions.is_asked(self.index, place) {
            return None;
        }
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
        let deviation = difference(self.turns(place, key), given, key);
        let error = deviation.abs() / self.scale(place, key);
        // equal where there is nothing to compare with
        let error = if error.is_nan() { 0.0 } else { error };
        let region = self.regions(place, key).find(|region| region.contains(given));
        // the value of another row only where nothing else explains it
        let other_row = || self.other_row(place, given).filter(|_| given != 0.0);
        let verdict = match region.map(|region| region.slip) {
            Some(None) => Verdict::Right,
            Some(slip) => Verdict::Wrong(slip.map(Box::new)),
            None => Verdict::Wrong(other_row().map(Box::new)),
        };
        // a part of zero is no number to print
        let error = (!self.is_zero(place, key)).then_some(error);
        (Found { given: Some(given), key: Some(key), deviation: Some(deviation), error }, verdict)
    }

    /// Whether the key is zero, or its rounding error.
    pub(super) fn is_zero(&self, place: usize, key: f64) -> bool {
        key.abs() <= ZERO * self.scale(place, key)
    }

    pub(super) fn number(&self, place: usize) -> Option<f64> {
        self.key.rows[self.index].entries[place].number()
    }

    /// The other component of the same vector.
    pub(super) fn partner(&self, place: usize) -> Option<usize> {
        let name = &self.key.quantities[place].name;
        let other = match name.rsplit_once('.')? {
            (stem, "x") => format!("{stem}.y"),
            (stem, "y") => format!("{stem}.x"),
            _ => return None,
        };
        self.key.quantities.iter().position(|q| q.name == other)
    }

    pub(super) fn dimension(&self, place: usize) -> Dimension {
        self.key.quantities[place].unit.dimension
    }

    /// What the tolerance is a part of: the value; of a component the magnitude of its vector; of zero the greatest
    /// value of its kind in the row.
    pub(super) fn scale(&self, place: usize, key: f64) -> f64 {
        let greatest = || {
            let alike =
                (0..self.key.quantities.len()).filter(|i| self.dimension(*i) == self.dimension(place));
            alike.filter_map(|i| self.number(i)).fold(0.0, |greatest: f64, x| greatest.max(x.abs()))
        };
        let other = self.partner(place).and_then(|i| self.number(i)).unwrap_or(0.0);
        let own = libm::hypot(key, other);
        let own = turns::scale(self.turns(place, key), own);
        if own > ZERO * greatest() { own } else { greatest() }
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
