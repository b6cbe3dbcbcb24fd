//! What can be done with a text: shown above its title and its table, done by name.

use super::{Analysis, Results};
use crate::exercise::Outcome;
use crate::pipeline::{FileVariants, test_text};
use crate::report::text::Look;
use crate::report::{AccuracyShown, Page, PrintedDigits, of_answers};
use assur_check::Overrides;
use assur_syntax::document::Statement;
use assur_text::diagnostic::Problems;
use assur_text::source::Span;

/// What a lens does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    Solve,
    /// Compares the answers with the expectations, of all rows where there is a table.
    Test,
    Preview,
}

/// An action at a place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Lens {
    pub at: Span,
    pub title: String,
    pub action: Action,
}

impl Analysis {
    /// The actions of a text that compiles; `tested` is what the last test of its rows came to.
    #[must_use]
    pub fn lenses(&self, results: Option<&Results>, tested: Option<&str>) -> Vec<Lens> {
        let mut found = Vec::new();
        if self.compiled.is_none() {
            return found;
        }
        for statement in &self.document.statements {
            let at = statement.span;
            match &statement.node {
                Statement::Title(_) => {
                    found.push(Lens { at, title: "solve".to_owned(), action: Action::Solve });
                    let title = results.map_or_else(|| "test".to_owned(), Results::outcomes_in_words);
                    found.push(Lens { at, title, action: Action::Test });
                    found.push(Lens { at, title: "picture".to_owned(), action: Action::Preview });
                }
                Statement::Variants(table) => {
                    let title = || format!("test {} rows", table.rows.len());
                    let title = tested.map_or_else(title, str::to_owned);
                    found.push(Lens { at, title, action: Action::Test });
                }
                _ => {}
            }
        }
        found
    }

    /// The answers as a page, or why there are none.
    #[must_use]
    pub fn solved_page(&self, results: Option<&Results>) -> String {
        let solved_now = if results.is_some() { None } else { self.solve(&|| true) };
        match results.or(solved_now.as_ref()).and_then(|results| results.solved.as_ref()) {
            Some(solved) => {
                let answers = solved.answers(PrintedDigits::READABLE);
                let report = of_answers(&self.source.name, &answers, AccuracyShown::Worst);
                Page::Text(Look::PLAIN).render(&report)
            }
            None => "this file has no answers: look at its diagnostics".to_owned(),
        }
    }

    /// `25 rows, 1 fails`; of a text without a table how many expectations are met.
    #[must_use]
    pub fn tested_page(&self) -> String {
        match FileVariants::of(&self.document, &Overrides::none()) {
            Some(Ok(rows)) => {
                let failed = rows.solve(true).map(|row| row.problems.has_errors()).collect::<Vec<_>>();
                let wrong = failed.iter().filter(|failed| **failed).count();
                let fails =
                    if wrong == 0 { "all expectations met".to_owned() } else { format!("{wrong} fail") };
                format!("{} rows, {fails}", failed.len())
            }
            Some(Err(_)) => "the table of variants has errors".to_owned(),
            None => {
                let none = Overrides::none();
                let (solved, _) = test_text(&self.source, &self.document, Problems::new(), &none);
                solved.map_or_else(|| "no solution".to_owned(), |solved| in_words(&solved.outcomes))
            }
        }
    }
}

/// `3 of 3 expectations met`
pub(super) fn in_words(outcomes: &[Outcome]) -> String {
    let failed = outcomes.iter().filter(|o| !o.passed).count();
    match (outcomes.len(), failed) {
        (0, _) => "no expectations".to_owned(),
        (all, 0) => format!("{all} of {all} expectations met"),
        (all, failed) => format!("{failed} of {all} expectations fail"),
    }
}
