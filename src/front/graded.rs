//! Answers marked by a key.

use super::solution::Diagnostics;
use crate::exercise::grade::{self, Credit, Points, Rules, Sheet};
use crate::exercise::table::Fault;
use crate::report;
use assur_text::diagnostic::Problems;
use std::io::BufRead;

/// How answers are marked. Without a word of its own each is as in `assur grade`.
#[derive(Clone, Debug, Default)]
pub struct Marking {
    /// The greatest relative difference allowed.
    pub within: Option<f64>,
    /// Answers that are missing are left out of the totals; else they are wrong.
    pub only_answered: bool,
    /// Points of quantities: `Mb=2,F_A=1`.
    pub points: Option<String>,
    /// Parts of the points for slips: `sign=0.5`.
    pub credit: Option<String>,
}

/// Why answers cannot be marked.
#[derive(Clone, Debug)]
pub enum GradeError {
    /// The key or the answers cannot be read.
    Diagnostics(Diagnostics),
    /// The rules cannot be used.
    Rules(String),
}

/// Marks a table of answers by a key, both as comma-separated values: the document of `assur grade --format json`.
///
/// # Errors
/// Tables that cannot be read, rules that name what the key does not have.
pub fn grade(key: &str, answers: &str, marking: &Marking) -> Result<String, GradeError> {
    let rules = rules(marking).map_err(GradeError::Rules)?;
    let key = sheet("key", key.as_bytes(), None)?;
    if let Some((name, help)) = rules.points.unknown(&key) {
        return Err(GradeError::Rules(format!("the key has no `{name}`; {help}")));
    }
    let answers = sheet("answers", answers.as_bytes(), Some(&key))?;
    let graded = grade::grade(&key, answers, &rules).map_err(wrong)?;
    Ok(report::grade::json(&graded))
}

fn rules(marking: &Marking) -> Result<Rules, String> {
    let default = Rules::default();
    let within = marking.within.unwrap_or(default.within);
    if !(within.is_finite() && within >= 0.0) {
        return Err(format!("`within` must be a number of at least 0, but is {within}"));
    }
    Ok(Rules {
        within,
        only_answered: marking.only_answered,
        points: marking.points.as_deref().map_or_else(|| Ok(Points::default()), Points::read)?,
        credit: marking.credit.as_deref().map_or_else(|| Ok(Credit::default()), Credit::read)?,
        ..default
    })
}

fn sheet(name: &str, text: impl BufRead, key: Option<&Sheet>) -> Result<Sheet, GradeError> {
    match Sheet::read(name, text, key) {
        Ok(read) => read.map_err(wrong),
        // a text in memory is always read
        Err(error) => Err(GradeError::Rules(error.to_string())),
    }
}

fn wrong((source, error): Fault) -> GradeError {
    GradeError::Diagnostics(Diagnostics::of(&Problems::of([*error]), &source))
}
