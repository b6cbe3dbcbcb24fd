//! A text as the program's JSON, and in the one style.

use super::diagnostics::Diagnostics;
use super::problem::Problem;
use crate::pipeline::{Compiled, compile_document, solve_within};
use crate::report::Precision;
use crate::report::json::render;
use assur_text::diagnostic::{self, Problems};
use assur_text::source::{Source, edited};

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
                let answers = solved.answers(Precision::READABLE);
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
