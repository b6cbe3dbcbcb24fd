//! Marks, and what they add up to.

use super::common_mistake::CommonMistake;
use super::sheet::{RowNames, Unread};
use std::sync::Arc;

/// What became of one answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    Right,
    Wrong(Option<Box<CommonMistake>>),
    Missing,
    Unreadable(Box<Unread>),
    /// The key has no value there: what was written where it is not a number.
    NotAsked(Box<Unread>),
}

/// A number that may not be there, in the memory of a number: a class has millions.
#[derive(Clone, Copy, Debug)]
pub struct Known(f64);

impl Known {
    #[must_use]
    pub const fn get(self) -> Option<f64> {
        if self.0.is_nan() { None } else { Some(self.0) }
    }
}

impl From<Option<f64>> for Known {
    fn from(number: Option<f64>) -> Self {
        Self(number.unwrap_or(f64::NAN))
    }
}

#[derive(Clone, Debug)]
pub struct Mark {
    /// Which of the quantities.
    pub quantity: u32,
    /// What was given, SI.
    pub given: Known,
    /// What the key says, SI; `None` where it says nothing or nothing tells which row it is.
    pub key: Known,
    /// What was given less the key, SI; angles modulo a turn.
    pub deviation: Known,
    /// The difference over what the tolerance is a part of; `None` where the key is 0.
    pub error: Known,
    /// Whether it is right.
    pub verdict: Verdict,
    /// Whether it is part of the totals.
    pub counts: bool,
    pub points: f64,
    /// Points that can be earned.
    pub possible: f64,
}

/// The answers of one row.
#[derive(Clone, Debug)]
pub struct GradedRow {
    /// Its line among the answers; `None` where the student did not hand it in.
    pub line: Option<usize>,
    /// What names the row.
    pub names: Arc<RowNames>,
    pub person: Option<Arc<str>>,
    /// One mark per quantity that the key or the student has a value for.
    pub marks: Box<[Mark]>,
}

impl GradedRow {
    /// The sum of its marks.
    #[must_use]
    pub fn sum(&self) -> Sum {
        Sum::of(&self.marks)
    }

    /// The row in words: `A. Student, engine, row 3, pose 1`.
    #[must_use]
    pub fn words(&self) -> String {
        let mut words: Vec<String> = self.person.as_deref().map(str::to_owned).into_iter().collect();
        let names = self.names.words();
        if names.is_empty() && self.line.is_none() {
            words.push("row unknown".to_owned());
        }
        words.extend(names);
        words.join(", ")
    }
}

/// A row that was handed in again.
#[derive(Clone, Debug)]
pub struct NotCounted {
    /// The row that does not count.
    pub row: GradedRow,
    /// The line of the one that counts.
    pub counted: usize,
}

/// A sum of marks.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sum {
    pub right: usize,
    /// All answers that count.
    pub total: usize,
    pub points: f64,
    /// Points that can be earned.
    pub possible: f64,
}

impl Sum {
    pub fn of<'a>(marks: impl IntoIterator<Item = &'a Mark>) -> Self {
        let mut sum = Self::default();
        sum.add(marks);
        sum
    }

    pub(super) fn add<'a>(&mut self, marks: impl IntoIterator<Item = &'a Mark>) {
        for mark in marks.into_iter().filter(|m| m.counts) {
            self.right += usize::from(mark.verdict == Verdict::Right);
            self.total += 1;
            self.points += mark.points;
            self.possible += mark.possible;
        }
    }

    /// Points over those that can be earned; `None` where there are none.
    #[must_use]
    pub fn part(&self) -> Option<f64> {
        (self.possible > 0.0).then(|| self.points / self.possible)
    }
}

/// What one student, or all answers to a problem, come to.
#[derive(Clone, Copy, Debug)]
pub struct Part<'a> {
    /// The student, or the problem; `None` where nothing names it.
    pub name: Option<&'a str>,
    /// How many rows it has.
    pub rows: usize,
    /// The sum of their marks.
    pub sum: Sum,
}
