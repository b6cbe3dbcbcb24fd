//! Marks, and what they add up to.

use super::slip::Slip;

/// What became of one answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// Within the tolerance.
    Right,
    /// Outside.
    Wrong(Option<Slip>),
    /// No answer.
    Missing,
    /// Not a number: as written, and why.
    Unreadable(String, String),
    /// The key has no value there: what was written where it is not a number.
    NotAsked(String),
}

/// One answer.
#[derive(Clone, Debug)]
pub struct Mark {
    /// Which of the quantities.
    pub quantity: usize,
    /// What was given, SI.
    pub given: Option<f64>,
    /// What the key says, SI; `None` where it says nothing or nothing tells which row it is.
    pub key: Option<f64>,
    /// What was given less the key, SI; angles modulo a turn.
    pub deviation: Option<f64>,
    /// The difference over what the tolerance is a part of; `None` where the key is 0.
    pub error: Option<f64>,
    /// Whether it is right.
    pub verdict: Verdict,
    /// Whether it is part of the totals.
    pub counts: bool,
    /// Points earned.
    pub points: f64,
    /// Points that can be earned.
    pub possible: f64,
}

/// The answers of one row.
#[derive(Clone, Debug)]
pub struct GradedRow {
    /// Its line among the answers; `None` where the student did not hand it in.
    pub line: Option<usize>,
    /// What names the row, in the order of [`super::NAMES`].
    pub names: [Option<String>; 4],
    /// Who answered.
    pub person: Option<String>,
    /// One mark per quantity that the key or the student has a value for.
    pub marks: Vec<Mark>,
}

impl GradedRow {
    /// The sum of its marks.
    #[must_use]
    pub fn sum(&self) -> Sum {
        Sum::of(&self.marks)
    }

    /// The row in words: `row 3, pose 1, A. Student`.
    #[must_use]
    pub fn words(&self) -> String {
        let mut words = super::sheet::row_words(&self.names);
        if words.is_empty() && self.line.is_none() {
            words.push("row unknown".to_owned());
        }
        words.extend(self.person.clone());
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
    /// Right answers.
    pub right: usize,
    /// All answers that count.
    pub total: usize,
    /// Points earned.
    pub points: f64,
    /// Points that can be earned.
    pub possible: f64,
}

impl Sum {
    /// Of some marks.
    pub fn of<'a>(marks: impl IntoIterator<Item = &'a Mark>) -> Self {
        let mut sum = Self::default();
        for mark in marks.into_iter().filter(|m| m.counts) {
            sum.right += usize::from(mark.verdict == Verdict::Right);
            sum.total += 1;
            sum.points += mark.points;
            sum.possible += mark.possible;
        }
        sum
    }

    /// Points over those that can be earned; `None` where there are none.
    #[must_use]
    pub fn part(&self) -> Option<f64> {
        (self.possible > 0.0).then(|| self.points / self.possible)
    }
}

/// What one student, or all answers to a problem, come to.
#[derive(Clone, Debug)]
pub struct Part {
    /// The student, or the problem; `None` where nothing names it.
    pub name: Option<String>,
    /// How many rows it has.
    pub rows: usize,
    /// The sum of their marks.
    pub sum: Sum,
}
