//! Given answers held against an answer key.

mod sheet;
mod slip;

pub use sheet::{Entry, NAMES, Quantity, Sheet, SheetRow};
pub use slip::Slip;

use crate::exercise::table::{Fault, TableError};
use assur_text::source::Span;
use assur_text::units::Dimension;
use std::f64::consts::TAU;
use std::path::Path;

/// A key below this part of what stands beside it is a rounding error of zero.
const ZERO: f64 = 1e-9;
/// An answer this many tolerances away is not far off.
const NEAR: f64 = 3.0;

/// What became of one answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// Within the tolerance.
    Right,
    /// Outside.
    Wrong(Option<Slip>),
    /// No answer.
    Missing,
    /// No number: as written, and why.
    Unreadable(String, String),
}

/// One answer.
#[derive(Clone, Debug)]
pub struct Mark {
    /// Which of the answers' quantities.
    pub quantity: usize,
    /// What was given, SI.
    pub given: Option<f64>,
    /// What the key says, SI.
    pub key: f64,
    /// The difference over what the tolerance is a part of.
    pub error: Option<f64>,
    /// Whether it is right.
    pub verdict: Verdict,
}

/// The answers of one row.
#[derive(Clone, Debug)]
pub struct GradedRow {
    /// Its line among the answers.
    pub line: usize,
    /// What names the row, in the order of [`NAMES`].
    pub names: [Option<String>; 4],
    /// Who answered.
    pub person: Option<String>,
    /// One mark per quantity that the key has a value for.
    pub marks: Vec<Mark>,
}

/// All answers.
#[derive(Clone, Debug)]
pub struct Graded {
    /// The greatest relative difference allowed.
    pub within: f64,
    /// The quantities that are answered, in the units of the answers.
    pub quantities: Vec<Quantity>,
    /// Quantities of the key that no column answers.
    pub unasked: Vec<String>,
    /// Rows of the answers.
    pub rows: Vec<GradedRow>,
    /// Rows of the key that nobody answered, in words.
    pub unanswered: Vec<String>,
}

impl GradedRow {
    /// How many answers are right.
    #[must_use]
    pub fn right(&self) -> usize {
        self.marks.iter().filter(|m| m.verdict == Verdict::Right).count()
    }

    /// The row in words: `row 3, pose 1, A. Student`.
    #[must_use]
    pub fn words(&self) -> String {
        let mut words = row_words(&self.names);
        words.extend(self.person.clone());
        words.join(", ")
    }
}

fn row_words(names: &[Option<String>; 4]) -> Vec<String> {
    let shown = NAMES.iter().zip(names).filter_map(|(what, name)| Some((*what, name.as_deref()?)));
    shown.filter(|(_, name)| !name.is_empty()).map(|(what, name)| format!("{what} {name}")).collect()
}

impl Graded {
    /// Right answers, and all.
    #[must_use]
    pub fn totals(&self) -> (usize, usize) {
        let right = self.rows.iter().map(GradedRow::right).sum();
        (right, self.rows.iter().map(|r| r.marks.len()).sum())
    }

    /// Right answers for a quantity, and all.
    #[must_use]
    pub fn totals_of(&self, quantity: usize) -> (usize, usize) {
        let marks = || self.rows.iter().flat_map(|r| &r.marks).filter(|m| m.quantity == quantity);
        (marks().filter(|m| m.verdict == Verdict::Right).count(), marks().count())
    }
}

/// Holds answers against a key.
///
/// # Errors
/// A row of the answers that the key does not have, or has more than once.
pub fn grade(key: &Sheet, answers: &Sheet, within: f64) -> Result<Graded, Fault> {
    let place = |q: &Quantity| key.place(&q.name, q.unit.dimension);
    let places: Vec<Option<usize>> = answers.quantities.iter().map(place).collect();
    let mut met = vec![false; key.rows.len()];
    let mut rows = Vec::new();
    for row in &answers.rows {
        let found = find(key, answers, row)?;
        met[found] = true;
        let marker = Marker { key, row: &key.rows[found], index: found, within };
        let marks = places
            .iter()
            .enumerate()
            .filter_map(|(quantity, place)| marker.mark(quantity, (*place)?, &row.entries[quantity]));
        let names =
            std::array::from_fn(|i| row.names[i].clone().or_else(|| key.rows[found].names[i].clone()));
        rows.push(GradedRow { line: row.line, names, person: row.person.clone(), marks: marks.collect() });
    }
    let answered = |q: &&Quantity| answers.place(&q.name, q.unit.dimension).is_none();
    let unanswered = key.rows.iter().zip(met).filter(|(_, met)| !met && !answers.persons);
    Ok(Graded {
        within,
        quantities: answers.quantities.clone(),
        unasked: key.quantities.iter().filter(answered).map(|q| q.name.clone()).collect(),
        rows,
        unanswered: unanswered.map(|(row, _)| row_words(&row.names).join(", ")).collect(),
    })
}

/// The row of the key that a row of the answers is about.
fn find(key: &Sheet, answers: &Sheet, row: &SheetRow) -> Result<usize, Fault> {
    let number = |text: &str| text.parse::<u64>().ok();
    let stem = |text: &str| Path::new(text).file_stem().map(ToOwned::to_owned);
    let same =
        |a: &str, b: &str| a == b || number(a).is_some_and(|a| number(b) == Some(a)) || stem(a) == stem(b);
    let fits = |k: &&(usize, &SheetRow)| {
        row.names.iter().zip(&k.1.names).all(|(a, k)| match (a, k) {
            (Some(a), Some(k)) => same(a, k),
            _ => true,
        })
    };
    let all: Vec<_> = key.rows.iter().enumerate().collect();
    let found: Vec<usize> = all.iter().filter(fits).map(|(i, _)| *i).collect();
    if let [one] = found[..] {
        return Ok(one);
    }
    let words = row_words(&row.names).join(", ");
    let (why, help) = match (found.len(), words.is_empty()) {
        (0, _) => (format!("the key has no {words}"), named_in_key(key, row)),
        (n, true) => {
            let help = "add a column `row`, or `variant`, that names the row of the key".to_owned();
            (format!("nothing says which of the {n} rows of the key this is"), help)
        }
        (n, false) => {
            let missing = (0..4).find(|i| key.named[*i] && !answers.named[*i]).map_or("pose", |i| NAMES[i]);
            (format!("the key has {n} rows for {words}"), format!("add a column `{missing}`"))
        }
    };
    let span = Span::new(0, row.text.text.len());
    Err((row.text.clone(), Box::new(TableError::UnknownRow { line: row.line, why, help, span })))
}

/// How the key names its rows, where a row of the answers is none of them.
fn named_in_key(key: &Sheet, row: &SheetRow) -> String {
    /// The most names that are listed.
    const MOST: usize = 8;
    let as_the_key = "number the rows as the key does".to_owned();
    let names_of = |i: usize| key.rows.iter().filter_map(move |k| k.names[i].as_deref());
    let missing = |i: &usize| row.names[*i].as_deref().is_some_and(|name| names_of(*i).all(|k| k != name));
    let Some(i) = (0..4).find(missing) else { return as_the_key };
    let mut names = names_of(i).collect::<Vec<_>>();
    names.dedup();
    let what = NAMES[i];
    let numbered = names.iter().enumerate().all(|(at, name)| name.parse() == Ok(at + 1));
    match names.as_slice() {
        [] => as_the_key,
        [only] => format!("{as_the_key}: it has {what} {only} alone"),
        [first, .., last] if numbered => format!("{as_the_key}: it has {what}s {first} to {last}"),
        all if all.len() <= MOST => format!("{as_the_key}: it has {what}s {}", all.join(", ")),
        _ => as_the_key,
    }
}

/// Marks the answers of one row.
struct Marker<'a> {
    key: &'a Sheet,
    row: &'a SheetRow,
    index: usize,
    within: f64,
}

impl Marker<'_> {
    /// `None` where the key has no value.
    fn mark(&self, quantity: usize, place: usize, entry: &Entry) -> Option<Mark> {
        let right = |is: bool| if is { Verdict::Right } else { Verdict::Wrong(None) };
        let mark = |given, key, error, verdict| Some(Mark { quantity, given, key, error, verdict });
        let truth = |t: bool| f64::from(u8::from(t));
        match (&self.row.entries[place], entry) {
            (Entry::Empty | Entry::Unreadable(..), _) => None,
            (Entry::Number(key), Entry::Empty) => mark(None, *key, None, Verdict::Missing),
            (Entry::Bool(key), Entry::Empty) => mark(None, truth(*key), None, Verdict::Missing),
            (Entry::Bool(key), Entry::Bool(given)) => {
                mark(Some(truth(*given)), truth(*key), None, right(given == key))
            }
            (Entry::Number(key), Entry::Number(given)) => {
                let scale = self.scale(place, *key);
                let error = self.difference(place, *given, *key).abs() / scale;
                // equal where there is nothing to compare with
                let error = if error.is_nan() { 0.0 } else { error };
                let verdict = if error <= self.within {
                    Verdict::Right
                } else {
                    Verdict::Wrong(self.slip(place, *given, *key))
                };
                mark(Some(*given), *key, Some(error), verdict)
            }
            (Entry::Number(key), Entry::Unreadable(text, why)) => {
                mark(None, *key, None, Verdict::Unreadable(text.clone(), why.clone()))
            }
            (Entry::Number(key), Entry::Bool(_)) => {
                let verdict = Verdict::Unreadable("a truth".to_owned(), "a number is asked".to_owned());
                mark(None, *key, None, verdict)
            }
            (Entry::Bool(key), _) => {
                let verdict = Verdict::Unreadable("a number".to_owned(), "write true or false".to_owned());
                mark(None, truth(*key), None, verdict)
            }
        }
    }

    fn number(&self, place: usize) -> Option<f64> {
        match self.row.entries[place] {
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

    /// What a wrong answer would be right for.
    fn slip(&self, place: usize, given: f64, key: f64) -> Option<Slip> {
        let is = |x: f64, of: usize, value: f64| {
            self.difference(of, x, value).abs() <= self.within * self.scale(of, value)
        };
        let zero = key.abs() <= ZERO * self.scale(place, key);
        // a component is small beside its vector: what it would be right for is measured by itself
        let near = |x: f64| self.difference(place, x, key).abs() <= self.within * key.abs();
        if !zero && near(-given) {
            return Some(self.other_link(place).unwrap_or(Slip::Sign));
        }
        if !zero && let Some(slip) = slip::factor(given, &near) {
            return Some(slip);
        }
        if let Some(slip) = self.of_vector(place, given, key, &is) {
            return Some(slip);
        }
        if given != 0.0
            && let Some(slip) =
                self.other_quantity(place, given, &is).or_else(|| self.other_row(place, given))
        {
            return Some(slip);
        }
        let far = self.difference(place, given, key).abs() / self.scale(place, key);
        (far <= NEAR * self.within).then_some(Slip::Near)
    }

    fn other_link(&self, place: usize) -> Option<Slip> {
        let name = &self.key.quantities[place].name;
        name.starts_with("reaction(").then_some(Slip::OtherLink)
    }

    fn of_vector(
        &self,
        place: usize,
        given: f64,
        key: f64,
        is: &dyn Fn(f64, usize, f64) -> bool,
    ) -> Option<Slip> {
        let partner = self.partner(place)?;
        let other = self.number(partner)?;
        if is(given, partner, other) {
            return Some(Slip::Swapped);
        }
        is(given, place, libm::hypot(key, other)).then_some(Slip::Magnitude)
    }

    fn other_quantity(&self, place: usize, given: f64, is: &dyn Fn(f64, usize, f64) -> bool) -> Option<Slip> {
        let others = (0..self.key.quantities.len())
            .filter(|i| *i != place && self.dimension(*i) == self.dimension(place));
        let close = |x: f64, value: f64, i: usize| {
            value != 0.0 && is(x, i, value) && (x - value).abs() <= self.within * value.abs()
        };
        for (sign, wrong) in [(1.0, false), (-1.0, true)] {
            let mut all = others.clone().filter_map(|i| Some((i, self.number(i)?)));
            if let Some((i, _)) = all.find(|(i, value)| close(sign * given, *value, *i)) {
                return Some(Slip::OtherQuantity { name: self.key.quantities[i].name.clone(), sign: wrong });
            }
        }
        None
    }

    fn other_row(&self, place: usize, given: f64) -> Option<Slip> {
        let rows = self.key.rows.iter().enumerate().filter(|(i, _)| *i != self.index);
        let mut found = rows.filter(|(_, row)| match row.entries[place] {
            Entry::Number(x) => x != 0.0 && (given - x).abs() <= self.within * x.abs(),
            _ => false,
        });
        let (_, row) = found.next()?;
        let words = row_words(&row.names).join(", ");
        Some(Slip::OtherRow(if words.is_empty() { format!("line {}", row.line) } else { words }))
    }
}
