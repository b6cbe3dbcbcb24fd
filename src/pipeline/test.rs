//! A file compared with its own answer key.

use super::compile::compile_document;
use super::file_variants::FileVariants;
use super::followed::Sink;
use super::solved::{Solved, solve_each, solve_source};
use crate::exercise::{self, ExpectError};
use crate::report::Answers;
use assur_check::Overrides;
use assur_solve::message::clause;
use assur_solve::solve::{self, IntegrationOptions, Pose};
use assur_syntax as syntax;
use assur_syntax::document::{Document, Statement};
use assur_text::diagnostic::{self, Problems};
use assur_text::source::{Source, Span};
use std::sync::Arc;

/// Text → [`Solved`], with all that was found on the way, failed expectations among it. A text with variants is tested
/// with every row; the solution is that of the first row that has one.
#[must_use]
pub fn test_source(source: &Source, overrides: &Overrides) -> (Option<Solved>, Problems) {
    let (document, found) = syntax::parse(source);
    test_text(source, &Arc::new(document), found, overrides)
}

/// As [`test_source`], of a document in which `found` was found on reading.
#[must_use]
pub fn test_text(
    source: &Source,
    document: &Arc<Document>,
    mut found: Problems,
    overrides: &Overrides,
) -> (Option<Solved>, Problems) {
    let rows = if found.has_errors() { None } else { FileVariants::of(document, overrides) };
    let Some(rows) = rows else {
        return test_document(source, document, found, overrides, &IntegrationOptions::default());
    };
    let mut first = None;
    match rows {
        Ok(rows) => rows.solve(true).for_each(|row| {
            found.append(row.problems);
            first = first.take().or(row.solved);
        }),
        Err(problems) => found.append(problems),
    }
    (first, found)
}

/// As [`test_source`], of a document without variants in which `found` was found on reading.
#[must_use]
pub fn test_document(
    source: &Source,
    document: &Arc<Document>,
    found: Problems,
    overrides: &Overrides,
    conduct: &IntegrationOptions<'_>,
) -> (Option<Solved>, Problems) {
    let (compiled, mut problems) = compile_document(source, document, found, overrides);
    let Some(compiled) = compiled.filter(|_| !problems.has_errors()) else { return (None, problems) };
    let (solved, found) = solve_each(compiled, &mut Compared(conduct));
    problems.append(found);
    let solved = solved.ok();
    if let Some(solved) = &solved {
        let failed = exercise::mismatches(&solved.outcomes);
        let opens = problems.has("mech::assembly::partial_sweep");
        let failed = if opens { exercise::in_one(failed) } else { failed };
        problems.extend(in_other_assembly(solved, (source, document), overrides, failed));
    }
    (solved, problems)
}

/// Keeps no position but for expectations.
struct Compared<'c>(&'c IntegrationOptions<'c>);

impl Sink for Compared<'_> {
    fn add(&mut self, _: &Answers<'_>, _: &Pose) -> bool {
        true
    }

    fn conduct(&self) -> IntegrationOptions<'_> {
        *self.0
    }
}

/// The diagnostics of a text, failed expectations included, without colour, 100 columns wide; empty where there are none.
#[must_use]
pub fn diagnose(source: &Source) -> String {
    let (_, problems) = test_source(source, &Overrides::none());
    diagnostic::render(&problems, source, diagnostic::Style::PLAIN)
}

// Whether the answer key belongs to another assembly of the mechanism.

/// Most assemblies that are tried.
const TRIES: usize = 8;
/// Most poses of a file that is solved again.
const POSES: usize = 1000;

/// The errors of expectations that are not met; where all are met in another assembly, that is the one error.
#[must_use]
pub fn in_other_assembly(
    solved: &Solved,
    text: (&Source, &Document),
    overrides: &Overrides,
    failed: Vec<ExpectError>,
) -> Vec<ExpectError> {
    if failed.is_empty() || solved.solution.poses.len() > POSES {
        return failed;
    }
    let Some(line) = fitting(solved, text, overrides) else { return failed };
    let more = failed.len() - 1;
    failed.into_iter().take(1).map(|error| error.of_assembly(more, &line)).collect()
}

/// The `assemble` statement with which all expectations are met.
fn fitting(
    solved: &Solved,
    (source, document): (&Source, &Document),
    overrides: &Overrides,
) -> Option<String> {
    let places = places(document);
    if places.is_empty() {
        return None;
    }
    others(solved)?.into_iter().take(TRIES).find(|line| {
        let other = Source::new(source.name.clone(), replaced(&source.text, &places, line));
        let (other, problems) = solve_source(&other, overrides);
        !problems.has_errors() && other.is_some_and(|s| s.outcomes.iter().all(|o| o.passed))
    })
}

/// The places of all `assemble` statements.
fn places(document: &Document) -> Vec<Span> {
    let is_assemble = |s: &&assur_text::source::Spanned<Statement>| matches!(s.node, Statement::Assemble(_));
    document.statements.iter().filter(is_assemble).map(|s| s.span).collect()
}

/// The text with another `assemble` statement in place of all that it has.
fn replaced(text: &str, places: &[Span], line: &str) -> String {
    let mut out = String::new();
    let mut end = 0;
    for (i, place) in places.iter().enumerate() {
        out.push_str(text.get(end..place.start).unwrap_or_default());
        out.push_str(if i == 0 { line } else { "" });
        end = place.end;
    }
    out.push_str(text.get(end..).unwrap_or_default());
    out
}

/// Statements for the other assemblies: those that differ in one group come first.
fn others(solved: &Solved) -> Option<Vec<String>> {
    let model = solved.compiled.model();
    let modes = solve::assemblies(&model).ok()?;
    let mut all: Vec<(usize, Vec<String>)> = vec![(0, Vec::new())];
    for group in modes.groups.iter().filter(|g| g.assemblies.len() > 1) {
        let lines =
            group.assemblies.iter().filter_map(|m| Some((m.chosen, clause(&model, m.clause.as_ref()?))));
        let lines = lines.map(|(chosen, line)| (chosen, line.trim_start_matches("assemble ").to_owned()));
        let lines: Vec<(bool, String)> = lines.collect();
        let with = |(changed, clauses): &(usize, Vec<_>)| {
            let (changed, clauses) = (*changed, clauses.clone());
            lines.clone().into_iter().map(move |(chosen, line)| {
                (changed + usize::from(!chosen), clauses.iter().cloned().chain([line]).collect::<Vec<_>>())
            })
        };
        all = all.iter().flat_map(with).collect();
        all.sort_by_key(|(changed, _)| *changed);
        all.truncate(TRIES + 1);
    }
    all.retain(|(changed, _)| *changed > 0);
    Some(all.into_iter().map(|(_, clauses)| format!("assemble {}", clauses.join(", "))).collect())
}
