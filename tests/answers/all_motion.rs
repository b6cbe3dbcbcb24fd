//! `find positions, velocities, accelerations` on every example: an answer or a message, and no number that is none.

#![allow(clippy::unwrap_used)] // a test that cannot read its files has failed

use crate::share::{least, spread};
use assur::internals::check::Overrides;
use assur::internals::diagnostic::{Style, render};
use assur::internals::report::{AccuracyShown, Page, PrintedDigits, json, of_answers, text::Look};
use assur::internals::source::Source;
use std::path::Path;

/// What is printed of a text, and what is said of it; printed is nothing where it has errors.
fn solved(source: &Source) -> (Option<String>, String) {
    let (solved, problems) = assur::internals::solve_source(source, &Overrides::none());
    let printed = solved.map(|solved| {
        let answers = solved.answers(PrintedDigits::READABLE);
        let page = Page::Text(Look::PLAIN).render(&of_answers("a.mech", &answers, AccuracyShown::Worst));
        page + &json::render("a.mech", Some(&answers.model), Some(&answers), &[])
    });
    (printed, render(&problems, source, Style::PLAIN))
}

#[test]
fn every_example_answers_with_all_motion() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let (mut answered, mut refused) = (0, 0);
    for path in spread(crate::folder::files(&root, "mech")) {
        let name = path.display().to_string();
        let text = std::fs::read_to_string(&path).unwrap();
        let (before, _) = solved(&Source::new(&name, &text));
        let Some(before) = before else { continue };
        let source = Source::new(&name, format!("{text}\nfind positions, velocities, accelerations\n"));
        let (printed, said) = solved(&source);
        match printed {
            Some(printed) => {
                let words = printed.split(|c: char| !c.is_ascii_alphanumeric());
                for word in words.map(str::to_lowercase) {
                    assert!(!["nan", "inf", "null"].contains(&word.as_str()), "{name}: {word} in {printed}");
                }
                let missing = |page: &str| page.matches(" —").count();
                assert_eq!(missing(&before), missing(&printed), "{name}: no value in {printed}\n{said}");
                answered += 1;
            }
            None => {
                assert!(said.contains("  help: "), "{name}: {said}");
                refused += 1;
                println!("{name}\n{said}");
            }
        }
    }
    println!("{answered} answered, {refused} refused");
    assert!(answered > least(100), "{answered} answered, {refused} refused");
}
