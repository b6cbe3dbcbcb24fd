//! Compiled → solved, compared with its answer key.

use super::compile::{Compiled, compile_document};
use super::followed::{Followed, Sink, followed};
use crate::exercise::{self, Outcome};
use crate::report;
use assur_check::Overrides;
use assur_picture::Kind;
use assur_position::plan::{Effects, plan_with};
use assur_solve::measure::accuracy::{self, AchievedAccuracy};
use assur_solve::solve::{IntegrationOptions, Solution};
use assur_syntax as syntax;
use assur_syntax::document::Document;
use assur_text::diagnostic::Problems;
use assur_text::source::Source;
use std::sync::Arc;

/// A compiled mechanism, solved, with the outcomes of its expectations.
#[derive(Debug)]
pub struct Solved {
    pub compiled: Compiled,
    pub solution: Solution,
    /// Its expectations, one per pose.
    pub outcomes: Vec<Outcome>,
    /// The accuracy wanted and reached, if one was.
    pub reached: Option<AchievedAccuracy>,
}

impl Solved {
    /// As a report sees it.
    #[must_use]
    pub fn answers(&self, precision: report::PrintedDigits) -> report::Answers<'_> {
        let model = self.compiled.model();
        let reached = self.reached.as_ref();
        report::Answers { model, solution: &self.solution, outcomes: &self.outcomes, reached, precision }
    }
}

/// Solves a compiled file and compares it with its answer key. A failed expectation is an outcome, not a problem; one
/// that cannot be evaluated is a problem, and so are more positions than can be kept: see [`solve_each`].
pub fn solve(compiled: Compiled) -> (Result<Solved, Compiled>, Problems) {
    solve_so(compiled, &IntegrationOptions::default())
}

fn solve_so(compiled: Compiled, conduct: &IntegrationOptions<'_>) -> (Result<Solved, Compiled>, Problems) {
    let found = followed(&compiled.model(), compiled.origin.as_ref(), None, conduct);
    evaluated(compiled, found)
}

/// As [`solve()`], however many positions there are: each is handed out, with the answers to what needs none, and of many
/// those alone are kept that an expectation names. There is no result and no message if `sink` stops it.
pub fn solve_each(compiled: Compiled, sink: &mut dyn Sink) -> (Result<Solved, Compiled>, Problems) {
    let found =
        followed(&compiled.model(), compiled.origin.as_ref(), Some(sink), &IntegrationOptions::default());
    evaluated(compiled, found)
}

/// Compares a solution with its answer key.
fn evaluated(compiled: Compiled, found: Followed) -> (Result<Solved, Compiled>, Problems) {
    match found {
        Err(problems) => (Err(compiled), problems),
        Ok(None) => (Err(compiled), Problems::new()),
        Ok(Some((solution, mut problems))) => {
            let outcomes = exercise::evaluate(&compiled.model(), &solution, &mut problems);
            (Ok(Solved { compiled, solution, outcomes, reached: None }), problems)
        }
    }
}

/// As [`solve()`], with the fastest settings that reach a wanted accuracy, see [`accuracy::candidates`]. If none
/// does, the result is the most accurate answer with an error.
pub fn solve_within(compiled: Compiled, within: Option<f64>) -> (Result<Solved, Compiled>, Problems) {
    solve_conducted(compiled, within, &IntegrationOptions::default())
}

/// As [`solve_within()`]; a motion under loads is integrated as `conduct` says.
pub fn solve_conducted(
    mut compiled: Compiled,
    within: Option<f64>,
    conduct: &IntegrationOptions<'_>,
) -> (Result<Solved, Compiled>, Problems) {
    let Some(wanted) = within else { return solve_so(compiled, conduct) };
    if let Some(simulation) = &mut compiled.mechanism.simulation {
        // a run keeps the accuracy that it is asked for by itself
        simulation.within = Some(wanted);
        return solve_so(compiled, conduct);
    }
    let mut candidates = accuracy::candidates(&compiled.model(), wanted);
    candidates.reverse();
    while let Some(settings) = candidates.pop() {
        compiled.plan.settings = settings;
        let is_last = candidates.is_empty();
        let (found, mut problems) = solve(compiled);
        compiled = match found {
            Ok(mut solved) => {
                let reached = accuracy::reached(&solved.compiled.model(), &solved.solution, wanted);
                if reached.is_kept() || is_last {
                    let missed = (!reached.is_kept()).then(|| reached.missed(&solved.compiled.mechanism));
                    problems.extend(missed);
                    solved.reached = Some(reached);
                    return (Ok(solved), problems);
                }
                solved.compiled
            }
            Err(compiled) if is_last => return (Err(compiled), problems),
            Err(compiled) => compiled,
        };
    }
    (Err(compiled), Problems::new())
}

/// Text → [`Solved`], with all problems found. There is a solution even if an expectation cannot be
/// evaluated.
#[must_use]
pub fn solve_source(source: &Source, overrides: &Overrides) -> (Option<Solved>, Problems) {
    solve_source_conducted(source, overrides, &IntegrationOptions::default())
}

/// As [`solve_source()`]; a motion under loads is integrated as `conduct` says.
#[must_use]
pub fn solve_source_conducted(
    source: &Source,
    overrides: &Overrides,
    conduct: &IntegrationOptions<'_>,
) -> (Option<Solved>, Problems) {
    let (document, found) = syntax::parse(source);
    let (compiled, mut problems) = compile_document(source, &Arc::new(document), found, overrides);
    let Some(compiled) = compiled.filter(|_| !problems.has_errors()) else { return (None, problems) };
    let (solved, found) = solve_so(compiled, conduct);
    problems.append(found);
    (solved.ok(), problems)
}

// Text → solved problem for pictures, which may show more than the file asks for.

/// Solves a text with all that pictures of these kinds show, as far as the file declares it.
#[must_use]
pub fn solve_drawn(source: &Source, overrides: &Overrides, kinds: &[Kind]) -> (Option<Solved>, Problems) {
    let (document, found) = syntax::parse(source);
    solve_document_drawn(source, &Arc::new(document), found, overrides, kinds)
}

/// As [`solve_drawn`], of a document in which `found` was found on reading.
#[must_use]
pub fn solve_document_drawn(
    source: &Source,
    document: &Arc<Document>,
    found: Problems,
    overrides: &Overrides,
    kinds: &[Kind],
) -> (Option<Solved>, Problems) {
    solve_drawn_conducted(source, document, found, overrides, kinds, &IntegrationOptions::default())
}

/// As [`solve_document_drawn()`]; a motion under loads is integrated as `conduct` says.
#[must_use]
pub fn solve_drawn_conducted(
    source: &Source,
    document: &Arc<Document>,
    found: Problems,
    overrides: &Overrides,
    kinds: &[Kind],
    conduct: &IntegrationOptions<'_>,
) -> (Option<Solved>, Problems) {
    let (compiled, mut problems) = compile_document(source, document, found, overrides);
    let Some(compiled) = compiled.filter(|_| !problems.has_errors()) else { return (None, problems) };
    let (solved, found) = solve_conducted(planned_to_draw(compiled, kinds), None, conduct);
    problems.append(found);
    (solved.ok().filter(|_| !problems.has_errors()), problems)
}

/// With the plan of all that pictures of these kinds show.
#[must_use]
pub fn planned_to_draw(mut compiled: Compiled, kinds: &[Kind]) -> Compiled {
    let level = kinds.iter().map(|kind| kind.needs().level).max().unwrap_or_default();
    let forces = kinds.iter().any(|kind| kind.needs().forces);
    let (mechanism, structure) = (&compiled.mechanism, &compiled.structure);
    let effects = Effects::at_least(mechanism, level, forces && structure.force_defect.is_none());
    if effects != compiled.plan.effects {
        compiled.plan = plan_with(mechanism, structure, effects);
    }
    compiled
}
