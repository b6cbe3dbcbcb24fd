//! Texts with blanks, comments, line ends and tokens thrown in, taken out and moved. `MUTANTS=10000` tries more.

use crate::texts::{all, check, reads};
use assur_syntax::parse_with_tokens;
use assur_text::source::{Edit, Source, Span, edited};
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};
use std::cell::Cell;

/// What is thrown in.
const THROWN: [&str; 16] = [
    " ",
    "   ",
    "\t",
    "\n",
    "\r\n",
    "\n\n\n",
    "  \n",
    "\n  \t",
    " // why\n",
    "//why\n",
    " //  \n",
    ";",
    "\u{A0}",
    "//\n",
    "( ",
    "- ",
];

/// A change at a token, by its number as a part of all.
#[derive(Clone, Debug)]
enum Change {
    Before(f64, usize),
    Joined(f64),
    Twice(f64),
    Gone(f64),
}

fn change() -> impl Strategy<Value = Change> {
    prop_oneof![
        6 => (0.0..1.0, 0..THROWN.len()).prop_map(|(at, what)| Change::Before(at, what)),
        3 => (0.0..1.0).prop_map(Change::Joined),
        1 => (0.0..1.0).prop_map(Change::Twice),
        1 => (0.0..1.0).prop_map(Change::Gone),
    ]
}

/// A text with one change.
fn changed(text: &str, change: &Change) -> String {
    let (_, tokens, _) = parse_with_tokens(&Source::new("text.mech", text));
    let (Change::Before(at, _) | Change::Joined(at) | Change::Twice(at) | Change::Gone(at)) = change;
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss)]
    let i = (at * tokens.len() as f64) as usize;
    let Some(token) = tokens.get(i) else { return text.to_owned() };
    let before = i.checked_sub(1).map_or(0, |i| tokens[i].span.end);
    let start = Span::new(token.span.start, token.span.start);
    let edit = match change {
        Change::Before(_, what) => Edit::new(start, THROWN[*what]),
        Change::Joined(_) => Edit::new(Span::new(before, token.span.start), ""),
        Change::Twice(_) => Edit::new(start, format!("{} ", token.text(text))),
        Change::Gone(_) => Edit::new(token.span, ""),
    };
    edited(text, &[edit])
}

#[test]
fn only_blanks_of_mutants_change() {
    let texts = all();
    let wanted = std::env::var("MUTANTS")
        .ok()
        .and_then(|n| n.parse().ok())
        .unwrap_or_else(|| crate::share::part(2000));
    let mut runner = TestRunner::new(Config { failure_persistence: None, ..Config::with_cases(wanted) });
    let read = Cell::new(0_u32);
    let strategy = (0..texts.len(), prop::collection::vec(change(), 1..12));
    let result = runner.run(&strategy, |(which, changes)| {
        // a change after which the text does not read is not made
        let text = changes.iter().fold(texts[which].1.clone(), |text, change| {
            let after = changed(&text, change);
            if reads(&after) { after } else { text }
        });
        read.set(read.get() + u32::from(text != texts[which].1));
        check(&texts[which].0, &text);
        Ok(())
    });
    result.unwrap_or_else(|error| panic!("{error}"));
    assert!(read.get() > wanted * 4 / 5, "{} of {wanted} texts are changed", read.get());
}
