#![no_main]
//! No text makes solving or the rendering of diagnostics panic: `cargo fuzz run solve`.

use assur::source::Source;

libfuzzer_sys::fuzz_target!(|text: &str| {
    let _ = assur::diagnose(&Source::new("fuzz.mech", text));
});
