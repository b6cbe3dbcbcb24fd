//! The answers of a solved text.

use super::answer::Answer;
use super::diagnostics::Diagnostics;
use crate::exercise::Outcome;
use crate::pipeline::Solved;
use crate::report::rows::AnswerColumns;
use crate::report::{Answers, Precision};
use assur_solve::message::failure;
use assur_solve::solve;
use std::ops::Index;
use std::sync::Arc;

/// A solved text: its poses with their answers.
#[derive(Clone, Debug)]
pub struct Solution {
    poses: Vec<Pose>,
    whole: Pose,
    expectations: Vec<Expectation>,
    diagnostics: Diagnostics,
}

/// A pose with its answers, by name: the values of the drives, everything that `find` asks for, and the efforts of drives.
///
/// The names are those of the columns of `assur solve --format csv`: `Mb`, `omega(rod)`, `v`, `reaction(A, crank)`.
#[derive(Clone, Debug)]
pub struct Pose {
    name: String,
    names: Arc<[String]>,
    answers: Vec<Answer>,
    failure: Option<String>,
}

/// The outcome of one `expect`.
#[derive(Clone, Debug, PartialEq)]
pub struct Expectation {
    /// Its left side, as written.
    pub text: String,
    /// The pose; `None` if it needs none.
    pub pose: Option<String>,
    /// Whether it is met.
    pub met: bool,
}

impl Expectation {
    pub(super) fn of(outcome: &Outcome) -> Self {
        Self { text: outcome.text.clone(), pose: outcome.pose.clone(), met: outcome.passed }
    }
}

impl Solution {
    pub(super) fn of(solved: &Solved, diagnostics: Diagnostics) -> Self {
        let answers = solved.answers(Precision::READABLE);
        let columns = AnswerColumns::of_file(&answers.model);
        let names: Arc<[String]> = columns.names().collect();
        let whole = columns.whole(&answers);
        let poses = answers.poses().map(|pose| Pose::of(&answers, &columns, &whole, &names, pose)).collect();
        let of_no_pose = columns.displays().zip(&whole).map(|(display, value)| Answer::of(*value, display));
        Self {
            poses,
            whole: Pose { name: String::new(), names, answers: of_no_pose.collect(), failure: None },
            expectations: solved.outcomes.iter().map(Expectation::of).collect(),
            diagnostics,
        }
    }

    /// Its poses in the order of the drive.
    #[must_use]
    pub fn poses(&self) -> &[Pose] {
        &self.poses
    }

    /// An answer that needs no pose, such as `stroke(C)` or a size of a gear pair; `None` if there is none of this name.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<&Answer> {
        self.whole.get(name)
    }

    /// The names of all answers.
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.whole.names
    }

    /// Its expectations, one per pose.
    #[must_use]
    pub fn expectations(&self) -> &[Expectation] {
        &self.expectations
    }

    /// Warnings, and the poses without a solution.
    #[must_use]
    pub const fn diagnostics(&self) -> &Diagnostics {
        &self.diagnostics
    }
}

/// An answer that needs no pose.
///
/// # Panics
/// If there is none of this name: see [`Solution::get`].
impl Index<&str> for Solution {
    type Output = Answer;

    fn index(&self, name: &str) -> &Answer {
        &self.whole[name]
    }
}

impl Pose {
    fn of(
        answers: &Answers<'_>,
        columns: &AnswerColumns,
        whole: &[Option<assur_model::model::Value>],
        names: &Arc<[String]>,
        pose: &solve::Pose,
    ) -> Self {
        let values = columns.values(answers, pose, whole);
        Self {
            name: pose.name.clone(),
            names: Arc::clone(names),
            answers: columns
                .displays()
                .zip(values)
                .map(|(display, value)| Answer::of(value, display))
                .collect(),
            failure: pose.failure().map(|why| failure(&answers.model, why).to_string()),
        }
    }

    /// Its name: that of a `pose`, or its number in the sweep, counted from 1.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// An answer by its name; `None` if there is none.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<&Answer> {
        self.answers.get(self.names.iter().position(|n| n == name)?)
    }

    /// Its answers with their names.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &Answer)> {
        self.names.iter().map(String::as_str).zip(&self.answers)
    }

    /// The reason why it has no solution; `None` if it has one.
    #[must_use]
    pub fn failure(&self) -> Option<&str> {
        self.failure.as_deref()
    }
}

/// # Panics
/// If there is no answer of this name: see [`Pose::get`].
impl Index<&str> for Pose {
    type Output = Answer;

    fn index(&self, name: &str) -> &Answer {
        match self.get(name) {
            Some(answer) => answer,
            None => panic!("no answer is called `{name}`; there are {}", self.names.join(", ")),
        }
    }
}
