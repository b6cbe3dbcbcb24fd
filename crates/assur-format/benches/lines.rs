//! The time of formatting 10,000 lines: reading them, and laying them out.
//!
//! `cargo bench -p assur-format`

use assur_syntax::parse_with_tokens;
use assur_text::source::{Source, edited};
use divan::{Bencher, black_box};
use std::fmt::Write;

fn main() {
    divan::main();
}

/// Dyads, one after another, in five lines each.
fn dyads(lines: usize) -> Source {
    let mut text = String::from("mech 1\nground { A0 (0, 0) }\n");
    for i in 0..lines / 5 {
        let j = i + 1;
        let _ = write!(
            text,
            "given l{i} = {}mm // bar {i}\nlink a{i} A{i}-B{i} 2*l{i}*cos(30 deg) {{ S (l{i}/2,0);mass 2 kg at S }}\n\
             link b{i} B{i}-A{j} 300 mm\nrevolute B{i}: a{i} - b{i} {{ friction 0.1 }}\nfind velocity(B{i}).x + 2 m/s\n",
            100 + i % 70
        );
    }
    Source::new("dyads.mech", text)
}

#[divan::bench]
fn read(bencher: Bencher<'_, '_>) {
    let source = dyads(10_000);
    bencher.bench(|| parse_with_tokens(black_box(&source)));
}

#[divan::bench]
fn lay_out(bencher: Bencher<'_, '_>) {
    let source = dyads(10_000);
    let (document, tokens, problems) = parse_with_tokens(&source);
    assert!(!problems.has_errors());
    bencher.bench(|| {
        let edits = assur_format::edits_of(&source.text, black_box(&tokens), &document);
        edited(&source.text, &edits)
    });
}
