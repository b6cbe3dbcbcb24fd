//! Text → solved problem for pictures, which may show more than the file asks for.

use super::compile::{Compiled, compile_document};
use super::solved::{Solved, solve_conducted};
use assur_check::Overrides;
use assur_picture::Kind;
use assur_position::plan::{Effects, plan_with};
use assur_solve::solve::Conduct;
use assur_syntax as syntax;
use assur_syntax::document::Document;
use assur_text::diagnostic::Problems;
use assur_text::source::Source;
use std::sync::Arc;

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
    solve_drawn_conducted(source, document, found, overrides, kinds, &Conduct::default())
}

/// As [`solve_document_drawn()`]; a motion under loads is integrated as `conduct` says.
#[must_use]
pub fn solve_drawn_conducted(
    source: &Source,
    document: &Arc<Document>,
    found: Problems,
    overrides: &Overrides,
    kinds: &[Kind],
    conduct: &Conduct<'_>,
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
    let level = kinds.iter().map(|kind| kind.level()).max().unwrap_or_default();
    let forces = kinds.iter().any(|kind| kind.forces());
    let (mechanism, structure) = (&compiled.mechanism, &compiled.structure);
    let effects = Effects::at_least(mechanism, level, forces && structure.force_defect.is_none());
    if effects != compiled.plan.effects {
        compiled.plan = plan_with(mechanism, structure, effects);
    }
    compiled
}
