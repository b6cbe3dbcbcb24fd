//! A text that is checked and solved.

use super::checked::Checked;
use super::rows::Rows;
use super::solution::{Diagnostics, Solution};
use crate::pipeline::{Compiled, FileVariants, SolvedRow, compile_document, solve_within, test_text};
use crate::report::{PrintedDigits, json::render};
use assur_check::Overrides;
use assur_syntax as syntax;
use assur_syntax::document::Document;
use assur_text::diagnostic::{self, Problems};
use assur_text::source::{Source, edited};
use std::sync::Arc;

/// Options from outside a text.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Values that replace those of `given` statements: name and value with its unit, as `("r", "120 mm")`. The last one counts.
    pub set: Vec<(String, String)>,
    /// The greatest relative error allowed: the fastest sufficient settings are used. Without it, the settings are those of
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
    pub(super) source: Source,
    pub(super) document: Arc<Document>,
    /// The problems found on reading.
    pub(super) found: Problems,
    pub(super) options: Options,
}

/// Solves a text: [`Problem::solve`] without options.
///
/// # Errors
/// The diagnostics of a text that cannot be solved.
pub fn solve(text: impl Into<String>) -> Result<Solution, Diagnostics> {
    Problem::new("problem.mech", text).solve()
}

impl Problem {
    /// Reads a text. Messages show `name`, usually the name of its file. If the text cannot be read, the methods below report
    /// the errors.
    #[must_use]
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        let source = Source::new(name, text);
        let (document, found) = syntax::parse(&source);
        Self { source, document: Arc::new(document), found, options: Options::default() }
    }

    /// With other options.
    #[must_use]
    pub fn with(self, options: Options) -> Self {
        Self { options, ..self }
    }

    /// With another value of a `given`: `problem.set("r", "120 mm")`.
    #[must_use]
    pub fn set(mut self, name: &str, value: &str) -> Self {
        self.options.set.push((name.to_owned(), value.to_owned()));
        self
    }

    /// Checks names, units, geometry and structure, without solving anything.
    #[must_use]
    pub fn check(&self) -> Diagnostics {
        let (_, problems) =
            compile_document(&self.source, &self.document, self.found.clone(), &self.overrides());
        self.diagnostics(&problems)
    }

    /// Checks the text for solving it at many positions, or again and again: see [`Checked::columns`]. A table of `variants` is
    /// ignored, as in [`Problem::solve`].
    ///
    /// # Errors
    /// The diagnostics of a text with errors.
    pub fn checked(&self) -> Result<Checked, Diagnostics> {
        let (compiled, problems) =
            compile_document(&self.source, &self.document, self.found.clone(), &self.overrides());
        match compiled.filter(|_| !problems.has_errors()) {
            Some(compiled) => Ok(Checked::new(self.source.clone(), compiled, problems, self.options.within)),
            None => Err(self.diagnostics(&problems)),
        }
    }

    /// Prepares the text for rows of values from outside, whose columns have these names and units. A name may have its unit in brackets, as
    /// in a table of text; without a unit a column has that of its `given`.
    ///
    /// # Errors
    /// The diagnostics of a text that cannot be read, or of columns that fit nothing.
    pub fn rows(&self, header: &[(String, Option<String>)]) -> Result<Rows, Diagnostics> {
        if self.found.has_errors() {
            return Err(self.diagnostics(&self.found));
        }
        let (source, document) = (self.source.clone(), Arc::clone(&self.document));
        Rows::new(source, document, self.overrides(), self.options.within, header)
    }

    /// Solves the text at all its positions. A table of `variants` is ignored: the `given` values are used, see
    /// [`Problem::solve_variants`].
    ///
    /// # Errors
    /// The diagnostics of a text that cannot be solved. A position without a solution is reported by
    /// [`Pose::failure`](super::Pose::failure).
    pub fn solve(&self) -> Result<Solution, Diagnostics> {
        let overrides = self.overrides();
        let (compiled, mut problems) =
            compile_document(&self.source, &self.document, self.found.clone(), &overrides);
        let solved = match compiled.filter(|_| !problems.has_errors()) {
            Some(compiled) => {
                let (solved, found) = solve_within(compiled, self.options.within);
                problems.append(found);
                solved.ok()
            }
            None => None,
        };
        let diagnostics = self.diagnostics(&problems);
        solved.map(|solved| Solution::of(&solved, diagnostics.clone())).ok_or(diagnostics)
    }

    /// Solves every row of the text's own table of `variants`, in order; no row if it has no table.
    ///
    /// # Errors
    /// The diagnostics of a text or a table that cannot be read, and errors common to all rows. The errors of one row are
    /// at its position in the list.
    pub fn solve_variants(&self) -> Result<Vec<Result<Solution, Diagnostics>>, Diagnostics> {
        if self.found.has_errors() {
            return Err(self.diagnostics(&self.found));
        }
        let overrides = self.overrides();
        let Some(rows) = FileVariants::of(&self.document, &overrides) else { return Ok(Vec::new()) };
        let rows = rows.map_err(|problems| self.diagnostics(&problems))?;
        let rows = rows.within(self.options.within).solve(false);
        let answer = |row: SolvedRow| {
            let diagnostics = self.diagnostics(&row.problems);
            let solved = row.solved.as_ref();
            solved.map(|solved| Solution::of(solved, diagnostics.clone())).ok_or(diagnostics)
        };
        Ok(rows.map(answer).collect())
    }

    /// Solves the text, every row of a table of `variants` too, and compares the answers with its `expect` lines. Empty if
    /// all are met and there is no warning.
    #[must_use]
    pub fn test(&self) -> Diagnostics {
        let (_, problems) = test_text(&self.source, &self.document, self.found.clone(), &self.overrides());
        self.diagnostics(&problems)
    }

    pub(super) fn overrides(&self) -> Overrides {
        Overrides::set(self.options.set.clone())
    }

    pub(super) fn diagnostics(&self, problems: &Problems) -> Diagnostics {
        Diagnostics::of(problems, &self.source)
    }
}

// A text as the program's JSON, and in the one style.

impl Problem {
    /// Structure, effects and diagnostics as a line of JSON, `docs/json-schema/solution-1.json`. Nothing is solved.
    #[must_use]
    pub fn check_json(&self) -> String {
        let (compiled, problems) = self.compiled();
        self.json(compiled.as_ref(), &problems)
    }

    /// The solution as the line of JSON that the program prints.
    #[must_use]
    pub fn solve_json(&self) -> String {
        let (compiled, mut problems) = self.compiled();
        let Some(compiled) = compiled.filter(|_| !problems.has_errors()) else {
            return self.json(None, &problems);
        };
        let (solved, found) = solve_within(compiled, self.options.within);
        problems.append(found);
        match solved {
            Ok(solved) => {
                let answers = solved.answers(PrintedDigits::READABLE);
                let views = problems.views(&self.source);
                render(&self.source.name, Some(&answers.model), Some(&answers), &views)
            }
            Err(compiled) => self.json(Some(&compiled), &problems),
        }
    }

    fn json(&self, compiled: Option<&Compiled>, problems: &Problems) -> String {
        let model = compiled.map(Compiled::model);
        render(&self.source.name, model.as_ref(), None, &problems.views(&self.source))
    }

    fn compiled(&self) -> (Option<Compiled>, Problems) {
        compile_document(&self.source, &self.document, self.found.clone(), &self.overrides())
    }
}

impl Diagnostics {
    /// As a list in JSON, as in the program's output.
    #[must_use]
    pub fn to_json(&self) -> String {
        let views: Vec<_> = self.iter().collect();
        // texts and numbers are always written
        serde_json::to_string(&views).unwrap_or_default()
    }
}

/// Puts a text in the one style, as `assur fmt` does.
///
/// # Errors
/// The diagnostics of a text that cannot be read.
pub fn format(text: &str) -> Result<String, Diagnostics> {
    let source = Source::new("problem.mech", text);
    match assur_format::edits(&source) {
        Ok(edits) => Ok(edited(&source.text, &edits)),
        Err(problems) => Err(Diagnostics::of(&problems, &source)),
    }
}

/// The page that explains a code, in Markdown.
///
/// # Errors
/// There is no such code: what may be meant.
pub fn explain(code: &str) -> Result<&'static str, Option<String>> {
    diagnostic::explain(code).ok_or_else(|| {
        let short = |c: &'static str| c.strip_prefix("mech::").unwrap_or(c);
        let near = diagnostic::did_you_mean(code, diagnostic::CODES.iter().map(|c| short(c.code)));
        near.first().map(|near| format!("mech::{near}"))
    })
}
