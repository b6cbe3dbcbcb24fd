//! No text makes the reader panic, overflow its stack or take more than linear time.

use crate::busy::Busy;
use assur::internals::diagnostic::Diagnosis;
use assur::internals::source::Source;
use assur::internals::syntax::parse;
use proptest::prelude::*;
use std::time::Duration;

/// Far more than needed in a debug build on a busy machine, far less than quadratic time would take.
const PATIENCE: Duration = Duration::from_secs(20);

/// The number of statements and of errors.
fn read(text: &str) -> (usize, usize) {
    let source = Source::new("text.mech", text);
    let start = Busy::start();
    let (document, problems) = parse(&source);
    let took = start.elapsed();
    let head = text.chars().take(40).collect::<String>();
    assert!(took < PATIENCE, "{took:?} for {} bytes: {head}", text.len());
    for statement in &document.statements {
        assert!(text.get(statement.span.start..statement.span.end).is_some(), "a span is off: {head}");
    }
    (document.statements.len(), problems.errors())
}

#[test]
fn nesting() {
    const N: usize = 100_000;
    for (open, middle, close) in [("(", "1", ")"), ("f(", "1", ")"), ("(1, ", "2", ")"), ("-(", "1", ")")] {
        let (_, errors) = read(&format!("let x = {}{middle}{}\n", open.repeat(N), close.repeat(N)));
        assert!(errors > 0);
        let (_, errors) = read(&format!("let x = {}\n", open.repeat(N)));
        assert!(errors > 0);
        let nested = format!("let x = {}{middle}{}\n", open.repeat(62), close.repeat(62));
        assert_eq!(read(&nested), (1, 0), "{nested}");
    }
    for text in ["{", "}", "link a {\n", "{\n", "(\n", "a {", "link a { b {", "revolute A: b - c { d {\n"] {
        assert!(read(&text.repeat(N / 10)).1 > 0);
    }
    assert_eq!(read(&format!("let x = {}\n", "f(\n".repeat(50) + "1" + &")".repeat(50))), (1, 0));
}

#[test]
fn chains() {
    const N: usize = 20_000;
    for link in ["a + ", "a * ", "a and ", "a < ", "6 mm*r*", "a @ ", "1 + (2) - "] {
        read(&format!("let x = {}1\n", link.repeat(N)));
    }
    for text in ["-", "not ", "2^", "2^-", "a.", "1, ", "\"", "0,5 ", "f( ", ") ", "5 m ", "/ "] {
        read(&format!("let x = {}\n", text.repeat(N)));
    }
    assert_eq!(read(&format!("let x = {}1\n", "a + ".repeat(N))), (1, 0));
}

#[test]
fn ten_thousand_lines() {
    let program = include_str!("../language/18-shaper.mech");
    let body =
        program.split_once("mechanism").map_or("", |(_, rest)| rest.split_once('\n').map_or("", |(_, r)| r));
    let times = 10_000 / body.lines().count() + 1;
    assert_eq!(read(&body.repeat(times)).1, 0);
    let wrong = ["lenk a B-C 5 mm", "given r 5 mm", "drive", "// note", "}", "{", "a = 0,5", "S (1, 2)"];
    let text = (0..10_000).map(|i| wrong[i % wrong.len()]).collect::<Vec<_>>().join("\n");
    assert!(read(&text).1 > 5_000);
}

#[test]
fn one_long_line() {
    let text = "link a A-B 5 mm ".repeat(5_000);
    assert!(read(&text).1 > 0);
    read(&"given ".repeat(20_000));
    read(&"\u{FF08}".repeat(50_000));
    read(&"０，５".repeat(20_000));
    read(&"a\r".repeat(50_000));
}

#[test]
fn a_shared_error_type() {
    fn shared<T: Send + Sync + 'static>() {}
    shared::<Diagnosis>();
}

/// Pieces of the language in any order.
fn soup() -> impl Strategy<Value = String> {
    let piece = prop::sample::select(vec![
        "mech 1",
        "mechanism",
        "\"M\"",
        "given",
        "let",
        "link",
        "ground",
        "{",
        "}",
        "(",
        ")",
        "[",
        "]",
        ",",
        ";",
        "\n",
        "\r\n",
        "\r",
        ":",
        "=",
        "-",
        "..",
        "+",
        "*",
        "/",
        "^",
        "@",
        "<",
        ">=",
        "a",
        "A.B",
        "5 mm",
        "0,5",
        ".5",
        "5.",
        "1e9",
        "°",
        "//",
        "\"",
        "at",
        "along",
        "through",
        "in",
        "steps",
        "of",
        "near",
        "left",
        "cw",
        "revolute",
        "drive",
        "find",
        "expect",
        "variants",
        "cam",
        "rise",
        "line",
        "mass",
        "wheel",
        "not",
        "and",
        "（",
        "“",
        "\0",
        "\u{FEFF}",
        "½",
        "e\u{301}",
        "\u{2028}",
        "\u{85}",
    ]);
    prop::collection::vec((piece, prop::bool::weighted(0.7)), 0..40).prop_map(|pieces| {
        pieces.into_iter().map(|(p, blank)| if blank { format!("{p} ") } else { p.to_owned() }).collect()
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(crate::share::part(400)))]

    #[test]
    fn any_text(text in "\\PC{0,60}(\\n\\PC{0,30}){0,3}") {
        read(&text);
        let _ = assur::internals::diagnose(&Source::new("text.mech", &text));
    }

    #[test]
    fn any_bytes(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let text = String::from_utf8_lossy(&bytes).into_owned();
        let _ = assur::internals::diagnose(&Source::new("text.mech", &text));
        read(&text);
    }

    #[test]
    fn any_words(text in soup()) {
        read(&text);
        let _ = assur::internals::diagnose(&Source::new("text.mech", &text));
    }

    #[test]
    fn a_program_cut_anywhere(at in 0_usize..2_500, length in 0_usize..40) {
        let program = include_str!("../language/18-shaper.mech");
        let start = program.floor_char_boundary(at);
        let end = program.floor_char_boundary(start + length);
        let cut = format!("{}{}", &program[..start], &program[end..]);
        read(&cut);
    }
}
