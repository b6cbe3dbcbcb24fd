//! A datum and the line of its statement.

use super::kinds::GivenKind;
use crate::document::{Curve, DrivePosition, Expr, Passing, Turn};
use assur_text::source::Span;

/// Where a reader finds a datum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shown {
    /// In the text, under "Given".
    Text,
    /// In the figure, which is drawn to scale; in the text where there is no figure.
    Figure,
    /// In the heading of its position.
    Heading,
    /// In the words of its question.
    Question,
    /// Nowhere: it belongs to the method, as the steps of a motion do.
    Method,
    /// Nowhere: it is an expected answer.
    Key,
}

/// The value of a datum as it is written.
#[derive(Clone, Debug, PartialEq)]
pub enum GivenValue<'d> {
    /// The words of its kind say all.
    Flag,
    /// A value, and the sense after it.
    One(&'d Expr, Option<Turn>),
    /// Two values or more, one after another.
    Several(Vec<&'d Expr>),
    Positions(&'d DrivePosition),
    /// A condition that becomes true, or a value that is passed.
    Passing(&'d Passing),
    Curve(&'d Curve),
}

/// A statement of the file about one thing.
#[derive(Clone, Debug, PartialEq)]
pub struct Datum<'d> {
    pub kind: &'static GivenKind,
    pub value: GivenValue<'d>,
    /// The names in its words.
    pub names: Vec<String>,
    /// The name that the file has for the value itself, as that of a load.
    pub own: Option<&'d str>,
    /// What its letter is indexed by.
    pub index: String,
    pub shown: Shown,
}

impl<'d> Datum<'d> {
    /// The expressions of its value.
    #[must_use]
    pub fn expressions(&self) -> Vec<&'d Expr> {
        match &self.value {
            GivenValue::Flag | GivenValue::Curve(_) => Vec::new(),
            GivenValue::One(value, _) => vec![value],
            GivenValue::Several(values) => values.clone(),
            GivenValue::Positions(DrivePosition::Values(values)) => values.iter().map(|v| &v.value).collect(),
            GivenValue::Positions(DrivePosition::Range(range)) => {
                vec![&range.from, &range.to, range.steps.expr()]
            }
            GivenValue::Passing(passing) => std::iter::once(&passing.what).chain(&passing.value).collect(),
        }
    }

    /// The places of its value in the text.
    #[must_use]
    pub fn spans(&self) -> Vec<Span> {
        self.expressions().into_iter().map(|value| value.span).collect()
    }

    #[must_use]
    pub(super) fn called(mut self, names: &[&str]) -> Self {
        self.names = names.iter().map(|name| (*name).to_owned()).collect();
        self
    }

    #[must_use]
    pub(super) fn of(mut self, index: impl Into<String>) -> Self {
        self.index = index.into();
        self
    }

    #[must_use]
    pub(super) fn shown(mut self, shown: Shown) -> Self {
        self.shown = shown;
        self
    }
}

/// The data of a statement.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenLine<'d> {
    /// The number of its statement in the document.
    pub statement: usize,
    /// What the line is about: a key of the words for subjects; empty where its data need none.
    pub subject: &'static str,
    /// The names in those words.
    pub names: Vec<String>,
    /// The links, pairs and other parts that the statement is about, without the ground.
    pub joins: Vec<&'d str>,
    pub data: Vec<Datum<'d>>,
}

impl<'d> GivenLine<'d> {
    pub(super) fn new(statement: usize, subject: &'static str) -> Self {
        Self { statement, subject, names: Vec::new(), joins: Vec::new(), data: Vec::new() }
    }

    pub(super) fn named(&mut self, names: &[&str]) {
        self.names = names.iter().map(|name| (*name).to_owned()).collect();
    }

    /// The ground joins nothing.
    pub(super) fn join(&mut self, name: &'d str) {
        if name != "ground" {
            self.joins.push(name);
        }
    }

    pub(super) fn add(&mut self, datum: Option<Datum<'d>>) {
        self.data.extend(datum);
    }
}

/// A datum of a kind; none where the table has no such kind, which is an error of the file.
pub(super) fn datum<'d>(key: &str, value: GivenValue<'d>) -> Option<Datum<'d>> {
    let kind = GivenKind::named(key)?;
    Some(Datum { kind, value, names: Vec::new(), own: None, index: String::new(), shown: Shown::Text })
}

pub(super) fn one<'d>(key: &str, value: &'d Expr) -> Option<Datum<'d>> {
    datum(key, GivenValue::One(value, None))
}

pub(super) fn flag(key: &str) -> Option<Datum<'static>> {
    datum(key, GivenValue::Flag)
}
