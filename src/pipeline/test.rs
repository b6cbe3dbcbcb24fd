//! A file compared with its own answer key.

use super::compile::compile_document;
use super::file_variants::FileVariants;
use super::followed::Sink;
use super::other_assembly::in_other_assembly;
use super::solved::{Solved, solve_each};
use crate::exercise;
use crate::report::Answers;
use assur_check::Overrides;
use assur_solve::solve::{Conduct, Pose};
use assur_syntax as syntax;
use assur_syntax::document::Document;
use assur_text::diagnostic::{self, Problems};
use assur_text::source::Source;
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
        return test_document(source, document, found, overrides, &Conduct::default());
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
    conduct: &Conduct<'_>,
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
struct Compared<'c>(&'c Conduct<'c>);

impl Sink for Compared<'_> {
    fn add(&mut self, _: &Answers<'_>, _: &Pose) -> bool {
        true
    }

    fn conduct(&self) -> Conduct<'_> {
        *self.0
    }
}

/// The diagnostics of a text, failed expectations included, without colour, 100 columns wide; empty where there are none.
#[must_use]
pub fn diagnose(source: &Source) -> String {
    let (_, problems) = test_source(source, &Overrides::none());
    diagnostic::render(&problems, source, diagnostic::Style::PLAIN)
}
