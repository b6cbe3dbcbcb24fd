//! The answers do not depend on blanks: every example as it is, with other blanks, and formatted again.

#![allow(clippy::unwrap_used)] // a test that cannot read its files has failed

use crate::folder::files;
use crate::share::spread;
use assur::internals::check::Overrides;
use assur::internals::diagnostic::Problems;
use assur::internals::report::{PrintedDigits, json};
use assur::internals::source::{Edit, Source, Span, edited};
use assur::internals::syntax::{TokenKind, parse_with_tokens};
use std::path::Path;

/// The answers of a text, and the codes of what is said of it.
fn answers(text: &str) -> (Option<String>, Vec<Option<String>>) {
    let source = Source::new("a.mech", text);
    let (solved, problems) = assur::internals::solve_source(&source, &Overrides::none());
    let printed = solved.map(|solved| {
        let answers = solved.answers(PrintedDigits::READABLE);
        json::render("a.mech", Some(&answers.model), Some(&answers), &[])
    });
    (printed, codes(&problems, &source))
}

fn codes(problems: &Problems, source: &Source) -> Vec<Option<String>> {
    problems.views(source).into_iter().map(|view| view.code).collect()
}

/// A text with more blanks where there are some, and none around commas and signs that are not those of products.
fn with_other_blanks(text: &str) -> String {
    let (_, tokens, _) = parse_with_tokens(&Source::new("a.mech", text));
    let free =
        |kind| matches!(kind, TokenKind::Comma | TokenKind::Infix | TokenKind::Semicolon | TokenKind::Brace);
    let gaps = tokens.windows(2).filter(|pair| pair[0].kind != TokenKind::Newline);
    let edits = gaps.filter_map(|pair| {
        let gap = Span::new(pair[0].span.end, pair[1].span.start);
        // a point before dots is that of a number
        let is_free = (free(pair[0].kind) || free(pair[1].kind)) && !pair[0].text(text).starts_with('.');
        let with = if is_free && pair[1].text(text) != ".." { "" } else { "   " };
        (gap.start < gap.end).then(|| Edit::new(gap, with))
    });
    edited(text, &edits.collect::<Vec<_>>())
}

#[test]
fn answers_do_not_depend_on_blanks() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    for path in spread(files(&root, "mech")) {
        let text = std::fs::read_to_string(&path).unwrap();
        let wanted = answers(&text);
        let other = with_other_blanks(&text);
        assert_ne!(other, text);
        assert!(answers(&other) == wanted, "{} with other blanks:\n{other}", path.display());
        let edits = assur::internals::format::edits(&Source::new("a.mech", &*other)).unwrap();
        let formatted = edited(&other, &edits);
        assert!(answers(&formatted) == wanted, "{} formatted:\n{formatted}", path.display());
    }
}
