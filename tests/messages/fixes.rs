//! Every fix that a diagnostic of the wrong files offers is applied: what it is about is gone, and no other error is new.

#![allow(clippy::unwrap_used)] // a test that cannot read its files has failed

use assur::internals::check::Overrides;
use assur::internals::diagnostic::{Fix, Problem, Problems};
use assur::internals::editor::Analysis;
use assur::internals::source::Source;
use miette::Severity;
use std::collections::BTreeSet;
use std::path::Path;

/// What is wrong with a text; the files of the stage `syntax` are no whole problems, and are read alone.
fn problems(text: &str, is_whole: bool) -> Problems {
    let source = Source::new("text.mech", text);
    if is_whole {
        assur::internals::check_source(&source, &Overrides::none()).1
    } else {
        assur::internals::syntax::parse(&source).1
    }
}

/// What tells one diagnostic from another, wherever it is.
fn is(problem: &dyn Problem) -> String {
    format!("{} {problem}", problem.code().map(|code| code.to_string()).unwrap_or_default())
}

/// The first byte of what it marks.
fn place(problem: &dyn Problem) -> usize {
    let labels = problem.labels().into_iter().flatten().collect::<Vec<_>>();
    labels.iter().find(|label| label.primary()).or(labels.first()).map_or(0, |label| label.offset())
}

/// Where a byte is after a fix.
fn moved(at: usize, fix: &Fix) -> usize {
    let before = fix.edits.iter().filter(|edit| edit.span.end <= at);
    before.fold(at, |at, edit| at + edit.with.len() - (edit.span.end - edit.span.start))
}

fn is_error(problem: &dyn Problem) -> bool {
    matches!(problem.severity(), None | Some(Severity::Error))
}

#[test]
fn every_fix_fixes() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/errors");
    let (mut fixes, mut helps, mut codes, mut wrong) = (0, 0, BTreeSet::new(), Vec::new());
    for entry in crate::folder::files(&root, "mech") {
        let Ok(text) = std::fs::read_to_string(&entry) else { continue };
        let name = entry.strip_prefix(&root).unwrap().display().to_string();
        let is_whole = !name.starts_with("syntax");
        let before = problems(&text, is_whole);
        let known = before.sorted().into_iter().map(is).collect::<BTreeSet<_>>();
        for problem in before.sorted() {
            let code = problem.code().map(|code| code.to_string()).unwrap_or_default();
            helps += usize::from(!problem.fixes().is_empty());
            for fix in problem.fixes() {
                let after = fix.apply(&text);
                let left = problems(&after, is_whole);
                let same = |other: &&dyn Problem| {
                    is(*other) == is(problem) && place(*other) == moved(place(problem), &fix)
                };
                let gone = !left.sorted().iter().any(same);
                let errors = left.sorted().into_iter().filter(|problem| is_error(*problem));
                let new = errors.map(is).filter(|found| !known.contains(found));
                let new = new.collect::<Vec<_>>();
                if !gone || !new.is_empty() || after == text {
                    wrong
                        .push(format!("{name}: {problem}\n{}\ngone {gone}, new {new:?}\n{after}", fix.title));
                }
                fixes += 1;
                codes.insert(code.clone());
            }
        }
    }
    assert!(wrong.is_empty(), "{} of {fixes}\n{}", wrong.len(), wrong.join("\n----\n"));
    println!("{fixes} fixes of {helps} helps, {} codes", codes.len());
    assert!(helps >= 150 && codes.len() >= 60, "{helps} helps with fixes, {} codes", codes.len());
}

/// Of the files that have no error before they are solved: what is wrong with their answers.
#[test]
fn every_fix_of_answers_fixes() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/errors");
    let solved = |text: &str| {
        let analysis = Analysis::of(Source::new("text.mech", text));
        let results = analysis.solve(&|| true);
        let all = analysis.problems_with(results.as_ref());
        let fixes = results.as_ref().map(|results| results.problems.fixes()).unwrap_or_default();
        (fixes, all.into_iter().filter(|problem| is_error(*problem)).map(is).collect::<BTreeSet<_>>())
    };
    let (mut fixes, mut wrong) = (0, Vec::new());
    for entry in crate::folder::files(&root, "mech") {
        let Ok(text) = std::fs::read_to_string(&entry) else { continue };
        let (offered, before) = solved(&text);
        for fix in offered {
            let after = fix.apply(&text);
            let left = solved(&after).1;
            fixes += 1;
            if !left.is_subset(&before) || left.len() >= before.len() {
                wrong.push(format!("{}\n{}\n{left:#?}", entry.display(), fix.title));
            }
        }
    }
    assert!(wrong.is_empty() && fixes >= 20, "{} of {fixes}\n{}", wrong.len(), wrong.join("\n----\n"));
}
