//! A text that is checked and solved.

use super::diagnostics::Diagnostics;
use super::solution::Solution;
use crate::pipeline::{FileVariants, compile_document, solve_within, test_document};
use assur_check::Overrides;
use assur_syntax as syntax;
use assur_syntax::document::Document;
use assur_text::diagnostic::Problems;
use assur_text::source::Source;
use std::sync::Arc;

/// What is set from outside a text.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Values in place of those of `given` statements: name and value with its unit, as `("r", "120 mm")`. A later one wins.
    pub set: Vec<(String, String)>,
    /// The relative error that is allowed: the fastest settings that keep it are used. Without it, the settings are those of
    /// `docs/accuracy.md`.
    pub within: Option<f64>,
}

/// A text, read once, to be solved any number of times.
///
/// ```
/// let problem = assur::Problem::new("gears", "shaft I { wheel a teeth 20 }
/// shaft O { wheel b teeth 50 }
/// mesh k: a - b
/// drive I at 10 rad/s
/// find omega(O)
/// ");
/// assert!(problem.check().is_empty());
/// # Ok::<(), assur::Diagnostics>(())
/// ```
#[derive(Clone, Debug)]
pub struct Problem {
    source: Source,
    document: Arc<Document>,
    options: Options,
}

/// Solves a text: [`Problem::solve`] without options.
///
/// # Errors
/// What keeps it from being solved.
pub fn solve(text: impl Into<String>) -> Result<Solution, Diagnostics> {
    Problem::new("problem.mech", text).solve()
}

impl Problem {
    /// Reads a text; `name` stands in its messages, usually the name of its file. A text that does not read is reported by
    /// every method that follows.
    #[must_use]
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        let source = Source::new(name, text);
        let (document, _) = syntax::parse(&source);
        Self { source, document: Arc::new(document), options: Options::default() }
    }

    /// With other options.
    #[must_use]
    pub fn with(self, options: Options) -> Self {
        Self { options, ..self }
    }

    /// With a value in place of that of a `given`: `problem.set("r", "120 mm")`.
    #[must_use]
    pub fn set(mut self, name: &str, value: &str) -> Self {
        self.options.set.push((name.to_owned(), value.to_owned()));
        self
    }

    /// Checks names, units, geometry and structure, without solving anything.
    #[must_use]
    pub fn check(&self) -> Diagnostics {
        let (_, problems) = compile_document(&self.source, &self.document, self.found(), &self.overrides());
        self.told(&problems)
    }

    /// Solves it at all its positions. Of a text with variants it is the row that its `given` statements make.
    ///
    /// # Errors
    /// What keeps it from being solved. A single position without a solution is no error where others have one: see
    /// [`Pose::failure`](super::Pose::failure).
    pub fn solve(&self) -> Result<Solution, Diagnostics> {
        let overrides = self.overrides();
        let (compiled, mut problems) =
            compile_document(&self.source, &self.document, self.found(), &overrides);
        let solved = match compiled.filter(|_| !problems.has_errors()) {
            Some(compiled) => {
                let (solved, found) = solve_within(compiled, self.options.within);
                problems.append(found);
                solved.ok()
            }
            None => None,
        };
        let diagnostics = self.told(&problems);
        solved.map(|solved| Solution::of(&solved, diagnostics.clone())).ok_or(diagnostics)
    }

    /// Solves every row of the text's own table of `variants`; empty where it has none, or where the table itself is wrong.
    #[must_use]
    pub fn solve_variants(&self) -> Vec<Result<Solution, Diagnostics>> {
        let overrides = self.overrides();
        let Some(Ok(rows)) = FileVariants::of(&self.document, &overrides) else { return Vec::new() };
        let rows = rows.within(self.options.within).solve(false);
        rows.map(|row| {
            let diagnostics = self.told(&row.problems);
            let solved = row.solved.as_ref();
            solved.map(|solved| Solution::of(solved, diagnostics.clone())).ok_or(diagnostics)
        })
        .collect()
    }

    /// Solves it and compares the answers with its `expect` lines. What comes back is empty where all is well.
    #[must_use]
    pub fn test(&self) -> Diagnostics {
        let (_, problems) = test_document(&self.source, &self.document, self.found(), &self.overrides());
        self.told(&problems)
    }

    /// What was found on reading, once more: messages are not copied.
    fn found(&self) -> Problems {
        syntax::parse(&self.source).1
    }

    fn overrides(&self) -> Overrides {
        Overrides::set(self.options.set.clone())
    }

    fn told(&self, problems: &Problems) -> Diagnostics {
        Diagnostics::of(problems, &self.source)
    }
}
