//! The answers of a solved text.

use crate::exercise::Outcome;
use crate::pipeline::Solved;
use crate::report::{Answers, PrintedDigits, rows::AnswerColumns};
use assur_math::math::Vec2;
use assur_model::model::{Display, Value};
use assur_solve::message::failure;
use assur_solve::solve;
use assur_text::diagnostic::{DiagnosticView, Problems, Style, render};
use assur_text::source::Source;
use std::fmt;
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
        let answers = solved.answers(PrintedDigits::READABLE);
        let columns = AnswerColumns::of_file(&answers.model);
        let names: Arc<[String]> = columns.names().collect();
        let whole = columns.whole(&answers);
        let poses = answers.poses().map(|pose| Pose::of(&answers, &columns, &whole, &names, pose)).collect();
        let of_no_pose = columns.values(&answers, None, &whole);
        let of_no_pose =
            columns.displays().zip(of_no_pose).map(|(display, value)| Answer::of(value, display));
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
        whole: &[Option<Value>],
        names: &Arc<[String]>,
        pose: &solve::Pose,
    ) -> Self {
        let values = columns.values(answers, Some(pose), whole);
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

// One answer at one pose.

/// The kind of an answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Quantity {
    /// A number.
    Number(f64),
    /// A vector in ground axes: x to the right, y up.
    Vector(f64, f64),
    /// A condition, true or false.
    Condition(bool),
    /// It does not exist at this pose.
    Undefined,
}

/// An answer in the author's unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    quantity: Quantity,
    si: Quantity,
    unit: String,
}

impl Answer {
    pub(super) fn of(value: Option<Value>, display: &Display) -> Self {
        let si = match value {
            Some(Value::Scalar(x)) if x.is_finite() => Quantity::Number(x),
            Some(Value::Vector(Vec2 { x, y })) if x.is_finite() && y.is_finite() => Quantity::Vector(x, y),
            Some(Value::Bool(holds)) => Quantity::Condition(holds),
            _ => Quantity::Undefined,
        };
        let quantity = match si {
            Quantity::Number(x) => Quantity::Number(display.of_si(x)),
            Quantity::Vector(x, y) => Quantity::Vector(display.of_si(x), display.of_si(y)),
            other => other,
        };
        Self { quantity, si, unit: display.unit.clone() }
    }

    /// Its value in [`Answer::unit`].
    #[must_use]
    pub const fn quantity(&self) -> Quantity {
        self.quantity
    }

    /// Its value in SI units, angles in radians.
    #[must_use]
    pub const fn si(&self) -> Quantity {
        self.si
    }

    /// The number in [`Answer::unit`]; `None` if it is not a number.
    #[must_use]
    pub const fn number(&self) -> Option<f64> {
        match self.quantity {
            Quantity::Number(x) => Some(x),
            _ => None,
        }
    }

    /// The components in [`Answer::unit`]; `None` if it is not a vector.
    #[must_use]
    pub const fn vector(&self) -> Option<(f64, f64)> {
        match self.quantity {
            Quantity::Vector(x, y) => Some((x, y)),
            _ => None,
        }
    }

    /// The unit: of the `as` of its `find`, else as the file writes quantities of this kind; empty for a pure number.
    #[must_use]
    pub fn unit(&self) -> &str {
        &self.unit
    }
}

/// With all digits: `12.5 N*m`.
impl fmt::Display for Answer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.quantity {
            Quantity::Number(x) => write!(f, "{x}")?,
            Quantity::Vector(x, y) => write!(f, "({x}, {y})")?,
            Quantity::Condition(holds) => return write!(f, "{holds}"),
            Quantity::Undefined => return f.write_str("undefined"),
        }
        if self.unit.is_empty() { Ok(()) } else { write!(f, " {}", self.unit) }
    }
}

// The messages about a text.

/// Errors and warnings about a text, by position in the text. Printed, they look as on the command line, without
/// colour and 100 columns wide.
#[derive(Clone, Debug, Default)]
pub struct Diagnostics {
    views: Vec<DiagnosticView>,
    text: String,
}

impl Diagnostics {
    pub(super) fn of(problems: &Problems, source: &Source) -> Self {
        Self { views: problems.views(source), text: render(problems, source, Style::PLAIN) }
    }

    /// Whether there is nothing to report.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.views.is_empty()
    }

    /// Whether one of them is an error.
    #[must_use]
    pub fn has_errors(&self) -> bool {
        self.views.iter().any(|d| d.severity == "error")
    }

    /// One after another: code, severity, message, spans, help.
    pub fn iter(&self) -> impl Iterator<Item = &DiagnosticView> {
        self.views.iter()
    }
}

impl fmt::Display for Diagnostics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl std::error::Error for Diagnostics {}
