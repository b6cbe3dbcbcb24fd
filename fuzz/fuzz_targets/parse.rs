#![no_main]
//! No text makes parsing or checking panic: `cargo fuzz run parse`.

use assur::check::Overrides;
use assur::source::Source;

libfuzzer_sys::fuzz_target!(|text: &str| {
    let _ = assur::check_source(&Source::new("fuzz.mech", text), &Overrides::none());
});
