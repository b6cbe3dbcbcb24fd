//! The collection of problems and how they are shown.

use assur_text::diagnostic::{Problem, Problems, Style, did_you_mean, place, render};
use assur_text::source::{Source, Span};
use miette::Diagnostic;
use thiserror::Error;

#[derive(Debug, Diagnostic, Error)]
enum Sample {
    #[error("first")]
    #[diagnostic(code(mech::test::first), help("do this"))]
    Error {
        #[label("here")]
        at: Span,
    },
    #[error("second")]
    #[diagnostic(code(mech::test::second), severity(Warning))]
    Warning {
        #[label("there")]
        at: Span,
    },
}

impl Problem for Sample {}

#[test]
fn sorted_by_place_errors_first() {
    let mut problems = Problems::new();
    problems.push(Sample::Warning { at: Span::new(4, 5) });
    problems.push(Sample::Error { at: Span::new(4, 5) });
    problems.push(Sample::Warning { at: Span::new(0, 1) });
    let order = problems.sorted().iter().map(ToString::to_string).collect::<Vec<_>>();
    assert_eq!(order, ["second", "first", "second"]);
    assert_eq!((problems.errors(), problems.warnings()), (1, 2));
}

#[test]
fn views_hold_line_column_and_byte() {
    let source = Source::new("a.mech", "φ\nab\n");
    let mut problems = Problems::new();
    problems.push(Sample::Error { at: Span::new(4, 5) });
    let json = serde_json::to_value(problems.views(&source)).expect("JSON");
    let expected = serde_json::json!([{
        "code": "mech::test::first", "severity": "error", "message": "first", "help": "do this",
        "spans": [{
            "file": "a.mech", "label": "here",
            "start": { "line": 2, "column": 2, "byte": 4 },
            "end": { "line": 2, "column": 3, "byte": 5 },
        }],
    }]);
    assert_eq!(json, expected);
    assert_eq!(place("φ", 1).byte, 0);
    assert_eq!(place("φ", 99).column, 2);
}

#[test]
fn styles() {
    let source = Source::new("a.mech", "given r = 1\n");
    let mut problems = Problems::new();
    problems.push(Sample::Error { at: Span::new(6, 7) });
    let coloured = render(&problems, &source, Style::Graphical { colour: true, width: 80 });
    assert!(coloured.contains('\u{1b}'));
    let plain = render(&problems, &source, Style::PLAIN);
    assert!(!plain.contains('\u{1b}') && plain.contains("a.mech:1:7"));
    assert!(render(&problems, &source, Style::Narrated).contains("Diagnostic severity: error"));
}

#[test]
fn places_outside_the_text_do_no_harm() {
    let source = Source::new("a.mech", "");
    let mut problems = Problems::new();
    problems.push(Sample::Error { at: Span::new(6, 7) });
    assert!(render(&problems, &source, Style::PLAIN).contains("first"));
    assert_eq!(problems.views(&source).len(), 1);
}

#[test]
fn what_was_meant() {
    let words = ["crank", "rod", "piston", "Rod2"];
    assert_eq!(did_you_mean("crnak", words), ["crank"]);
    assert_eq!(did_you_mean("ROD", words).first(), Some(&"rod"));
    assert_eq!(did_you_mean("pist", words), ["piston"]);
    assert!(did_you_mean("wheel", words).is_empty());
    assert!(did_you_mean("x", ["y"]).is_empty());
    assert!(did_you_mean("", words).is_empty());
}
