//! Text → Solution: the whole way, with what a reader sees at its end.
//!
//! `fuzz/run.sh 10000000 86400 solve`

#![no_main]

use assur::internals::check::Overrides;
use assur::internals::diagnostic::{Style, render};
use assur::internals::source::Source;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    let source = Source::new("fuzz.mech", text);
    let (_, problems) = assur::internals::solve_source(&source, &Overrides::none());
    let _ = render(&problems, &source, Style::PLAIN);
    let _ = problems.views(&source);
});
