//! `assur test`

use super::args::Problem;
use super::reply::{Reply, Status, for_each_file};
use super::screen::Screen;
use crate::exercise::Outcome;
use crate::pipeline::{FileVariants, test_document};
use assur_syntax as syntax;
use assur_text::diagnostic::Problems;
use assur_text::source::{Source, shown_in_line};
use std::sync::Arc;

/// The code of expectations that are not met; they are counted apart.
const MISMATCH: &str = "mech::expect::mismatch";

/// Holds solutions against their answer keys: one line per file, and a diagnostic per `expect` that fails.
pub fn run(args: &Problem, screen: &Screen) -> Status {
    let overrides = args.overrides();
    for_each_file(&args.files, screen, "", |source, _| {
        let (document, found) = syntax::parse(source);
        let document = Arc::new(document);
        if let (false, Some(Ok(rows))) = (found.has_errors(), FileVariants::of(&document, &overrides)) {
            return of_rows(rows, source, found, screen);
        }
        let (solved, problems) = test_document(source, &document, found, &overrides);
        let outcomes = solved.as_ref().map_or(&[][..], |s| &s.outcomes);
        let errors = problems.errors() - problems.errors_of(MISMATCH);
        let line =
            format!("{}: {}\n", shown_in_line(&source.name), summary(solved.is_some(), errors, outcomes));
        Reply::new(line, &problems, source, screen)
    })
}

/// One line for all rows of a table of variants.
fn of_rows(rows: FileVariants<'_>, source: &Source, mut problems: Problems, screen: &Screen) -> Reply {
    let (mut met, mut failed, mut unsolved, mut errors, mut count) = (0, 0, 0, 0, 0);
    for row in rows.solve(true) {
        count += 1;
        unsolved += usize::from(row.solved.is_none());
        let outcomes = row.solved.as_ref().map_or(&[][..], |s| &s.outcomes);
        let passed = outcomes.iter().filter(|o| o.passed).count();
        met += passed;
        failed += outcomes.len() - passed;
        errors += row.problems.errors() - row.problems.errors_of(MISMATCH);
        problems.append(row.problems);
    }
    let none = met + failed + unsolved + errors == 0;
    let mut parts =
        vec![if none { "no expectations".to_owned() } else { format!("{} met", plural(met, "expectation")) }];
    let more = [
        (failed, format!("{failed} failed")),
        (unsolved, format!("{} not solved", plural(unsolved, "row"))),
        (errors, plural(errors, "error")),
    ];
    parts.extend(more.into_iter().filter(|(n, _)| *n > 0).map(|(_, words)| words));
    let line = format!("{}: {} in {}\n", shown_in_line(&source.name), parts.join(", "), plural(count, "row"));
    let mut reply = Reply::new(line, &problems, source, screen);
    if count == 0 {
        reply.status = Status::Wrong;
    }
    reply
}

fn plural(n: usize, what: &str) -> String {
    format!("{n} {what}{}", if n == 1 { "" } else { "s" })
}

fn summary(solved: bool, errors: usize, outcomes: &[Outcome]) -> String {
    let failed = outcomes.iter().filter(|o| !o.passed).count();
    let mut parts = Vec::new();
    if !solved {
        parts.push("not solved".to_owned());
    } else if outcomes.is_empty() && errors == 0 {
        parts.push("solved, no expectations".to_owned());
    } else {
        parts.push(format!("{} met", plural(outcomes.len() - failed, "expectation")));
    }
    if failed > 0 {
        parts.push(format!("{failed} failed"));
    }
    if errors > 0 {
        parts.push(plural(errors, "error"));
    }
    parts.join(", ")
}
