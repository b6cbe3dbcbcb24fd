//! Whether the answer key belongs to another assembly of the mechanism.

use super::solved::{Solved, solve_source};
use crate::exercise::ExpectError;
use assur_check::Overrides;
use assur_solve::message::clause;
use assur_solve::solve;
use assur_syntax::document::{Document, Statement};
use assur_text::source::{Source, Span};

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
