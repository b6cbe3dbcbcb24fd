//! Text → Document: no text makes the reader panic, and every span lies within it.
//!
//! `fuzz/run.sh 10000000 86400 parse`

#![no_main]

use assur::internals::diagnostic::{Style, render};
use assur::internals::source::Source;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    let source = Source::new("fuzz.mech", text);
    let (document, problems) = assur::internals::syntax::parse(&source);
    for statement in &document.statements {
        assert!(text.get(statement.span.start..statement.span.end).is_some());
    }
    let _ = render(&problems, &source, Style::PLAIN);
});
