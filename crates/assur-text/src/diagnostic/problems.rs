//! The collection.

use super::{Diagnosis, Fix};
use crate::source::Span;
use miette::{Diagnostic, Severity};
use std::sync::Arc;

/// Errors about something that the whole file lacks, which a part of it that was not read may have.
const OF_WHOLE: &[&str] = &["mech::request::no_mass", "mech::request::which_drive"];

/// A diagnostic that can offer fixes.
pub trait Problem: Diagnostic + Send + Sync + 'static {
    /// What can be changed in the text; each fix alone makes the problem go.
    fn fixes(&self) -> Vec<Fix> {
        Vec::new()
    }

    /// What is used and not declared.
    fn undeclared(&self) -> Option<&Undeclared> {
        None
    }
}

/// A name that is used and not declared.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Undeclared {
    /// The kind that is expected: `link`, `point`.
    pub kind: &'static str,
    pub name: String,
    /// The link in which it was looked for.
    pub owner: Option<String>,
    pub at: Span,
}

pub type AnyDiagnostic = Arc<dyn Problem>;

/// All errors, warnings and notes about one text.
#[derive(Clone, Debug, Default)]
pub struct Problems {
    items: Vec<AnyDiagnostic>,
    /// Errors that are counted, not kept.
    more_errors: usize,
    /// The same of what is no error.
    more_warnings: usize,
}

impl Problems {
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    #[must_use]
    pub fn of<D: Problem>(problems: impl IntoIterator<Item = D>) -> Self {
        let mut all = Self::new();
        all.extend(problems);
        all
    }

    /// Counts errors of which enough are kept.
    pub const fn count_errors(&mut self, more: usize) {
        self.more_errors += more;
    }

    /// Counts warnings of which enough are kept.
    pub const fn count_warnings(&mut self, more: usize) {
        self.more_warnings += more;
    }

    pub fn push(&mut self, problem: impl Problem) {
        self.items.push(Arc::new(problem));
    }

    /// Adds all of another collection.
    pub fn append(&mut self, other: Self) {
        self.items.extend(other.items);
        self.more_errors += other.more_errors;
        self.more_warnings += other.more_warnings;
    }

    /// Adds the diagnostics of a later stage, except at spans where this collection has an error, and except those that a part
    /// that was not read may cause: one mistake is reported once.
    pub fn append_later(&mut self, mut later: Self) {
        if self.has_errors() {
            let follows = |p: &AnyDiagnostic| {
                let lacks = p.code().is_some_and(|code| OF_WHOLE.contains(&code.to_string().as_str()));
                lacks || !is_error(p.as_ref())
            };
            later.items.retain(|p| !follows(p));
            later.more_warnings = 0;
        }
        let reported = self.items.iter().filter(|p| is_error(p.as_ref())).filter_map(|p| primary(p.as_ref()));
        let mut reported = reported.collect::<Vec<_>>();
        reported.sort_unstable();
        // the furthest end of all that begin no later
        let mut furthest = 0;
        for (_, end) in &mut reported {
            furthest = furthest.max(*end);
            *end = furthest;
        }
        let overlaps = |(start, end): (usize, usize)| {
            let before = reported.partition_point(|&(s, _)| s < end);
            before > 0 && start < reported[before - 1].1
        };
        self.items.extend(later.items.into_iter().filter(|p| !primary(p.as_ref()).is_some_and(overlaps)));
        self.more_errors += later.more_errors;
        self.more_warnings += later.more_warnings;
    }

    /// Names that are used and not declared.
    pub fn undeclared(&self) -> impl Iterator<Item = &Undeclared> {
        self.items.iter().filter_map(|problem| problem.undeclared())
    }

    /// Those that are no errors of these codes.
    #[must_use]
    pub fn without(&self, codes: &[&str]) -> Self {
        let is_kept = |p: &&Arc<dyn Problem>| {
            !is_error(p.as_ref()) || p.code().is_none_or(|code| !codes.contains(&code.to_string().as_str()))
        };
        Self { items: self.items.iter().filter(is_kept).cloned().collect(), ..*self }
    }

    /// All of them, of this row of variants: `row` is it in words, `span` its place in the file's own table.
    #[must_use]
    pub fn of_row(self, row: &str, span: Option<Span>) -> Self {
        Self::of(self.items.iter().map(|p| Diagnosis::copied(p.as_ref()).of_row(row, span)))
    }

    /// Whether the same is reported at the same place.
    #[must_use]
    pub fn has_alike(&self, problem: &dyn Problem) -> bool {
        let place = primary(problem);
        let text = || (problem.code().map(|code| code.to_string()), problem.to_string());
        self.items.iter().any(|p| {
            primary(p.as_ref()) == place && (p.code().map(|code| code.to_string()), p.to_string()) == text()
        })
    }

    /// Whether both have the same texts at the same places.
    #[must_use]
    pub fn is_alike(&self, other: &Self) -> bool {
        let text = |p: &AnyDiagnostic| {
            (
                p.code().map(|c| c.to_string()),
                p.to_string(),
                p.help().map(|h| h.to_string()),
                primary(p.as_ref()),
            )
        };
        self.items.iter().map(text).eq(other.items.iter().map(text))
    }

    /// Whether it is empty.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// How many there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.items.len() + self.more_errors + self.more_warnings
    }

    /// How many of them are errors.
    #[must_use]
    pub fn errors(&self) -> usize {
        self.items.iter().filter(|p| is_error(p.as_ref())).count() + self.more_errors
    }

    /// How many of the errors have this code.
    #[must_use]
    pub fn errors_of(&self, code: &str) -> usize {
        let of = |p: &&AnyDiagnostic| is_error(p.as_ref()) && p.code().is_some_and(|c| c.to_string() == code);
        self.items.iter().filter(of).count()
    }

    /// How many are no errors.
    #[must_use]
    pub fn warnings(&self) -> usize {
        self.len() - self.errors()
    }

    /// Whether the text cannot be used.
    #[must_use]
    pub fn has_errors(&self) -> bool {
        self.more_errors > 0 || self.items.iter().any(|p| is_error(p.as_ref()))
    }

    /// Whether one has this code.
    #[must_use]
    pub fn has(&self, code: &str) -> bool {
        self.items.iter().any(|p| p.code().is_some_and(|c| c.to_string() == code))
    }

    /// Everything that can be changed, in the order of the problems.
    #[must_use]
    pub fn fixes(&self) -> Vec<Fix> {
        self.sorted().into_iter().flat_map(Problem::fixes).collect()
    }

    /// All of them by place; at equal place errors first, then in the order found. Those without place come first.
    #[must_use]
    pub fn sorted(&self) -> Vec<&dyn Problem> {
        let mut all = self.items.iter().map(AsRef::as_ref).collect::<Vec<_>>();
        all.sort_by_cached_key(|p| (offset(*p), !is_error(*p)));
        all
    }
}

impl<D: Problem> Extend<D> for Problems {
    fn extend<I: IntoIterator<Item = D>>(&mut self, problems: I) {
        problems.into_iter().for_each(|p| self.push(p));
    }
}

impl IntoIterator for Problems {
    type Item = AnyDiagnostic;
    type IntoIter = std::vec::IntoIter<AnyDiagnostic>;

    fn into_iter(self) -> Self::IntoIter {
        self.items.into_iter()
    }
}

/// Whether it is an error; a diagnostic without severity is one.
pub(super) fn is_error(problem: &dyn Diagnostic) -> bool {
    matches!(problem.severity(), None | Some(Severity::Error))
}

/// The first byte of the place it is about.
fn offset(problem: &dyn Diagnostic) -> Option<usize> {
    primary(problem).map(|(start, _)| start)
}

/// The place it is about: that of the primary label, else of the first.
fn primary(problem: &dyn Diagnostic) -> Option<(usize, usize)> {
    let labels = problem.labels()?.collect::<Vec<_>>();
    let label = labels.iter().find(|l| l.primary()).or(labels.first())?;
    Some((label.offset(), label.offset() + label.len()))
}
