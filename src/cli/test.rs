//! `assur test`

use super::args::Problem;
use super::reply::{Reply, Status, for_each_file};
use super::screen::Screen;
use crate::exercise::Outcome;

/// Holds solutions against their answer keys: one line per file, and a diagnostic per expectation that fails.
pub fn run(args: &Problem, screen: &Screen) -> Status {
    let overrides = args.overrides();
    for_each_file(&args.files, screen, "", |source| {
        let (solved, problems) = crate::test_source(source, &overrides);
        let outcomes = solved.as_ref().map_or(&[][..], |s| &s.outcomes);
        let errors = problems.errors() - outcomes.iter().filter(|o| !o.passed).count();
        let line = format!("{}: {}\n", source.name, summary(solved.is_some(), errors, outcomes));
        Reply::new(line, &problems, source, screen)
    })
}

fn summary(solved: bool, errors: usize, outcomes: &[Outcome]) -> String {
    let failed = outcomes.iter().filter(|o| !o.passed).count();
    let plural = |n: usize, what: &str| format!("{n} {what}{}", if n == 1 { "" } else { "s" });
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
