//! The time of what an editor asks, for a text of 1,000 lines: from a key to the diagnostics, a completion, a hover; the answers of a
//! sweep of 72 positions; 10,000 lines in the one style. The least of several rounds, in milliseconds, against what they may take.
//!
//! `cargo bench --bench editor`

use assur::internals::editor::Analysis;
use assur::internals::source::Source;
use std::fmt::Write as _;
use std::hint::black_box;
use std::time::Instant;

/// How often each is asked.
const ROUNDS: usize = 21;
/// Dyads of the long text, eight lines each.
const DYADS: usize = 124;

/// Rockers in a row, each driven by the one before.
fn rockers(dyads: usize, drive: &str) -> String {
    let mut text = String::from("mech 1\nmechanism \"Rockers in a row\"\nground {\n");
    for i in 0..=dyads {
        _ = writeln!(text, "  O{i} ({} mm, 0)", 100 * i);
    }
    _ = writeln!(text, "}}\nlink r0 O0-T0 50 mm\nrevolute O0: ground - r0\ndrive r0 = {drive}");
    for i in 1..=dyads {
        let b = i - 1;
        _ = writeln!(text, "given l{i} = 100 mm\nlink k{i} T{b}-T{i} l{i}\nrevolute T{b}: r{b} - k{i}");
        _ = writeln!(text, "link r{i} O{i}-T{i} l{i}/2 {{ mass 1 kg at T{i}; inertia 0.1 kg*m^2 }}");
        _ = writeln!(text, "revolute O{i}: ground - r{i}\nassemble U{i} left of T{b}-O{i}");
        _ = writeln!(text, "revolute U{i}: k{i}.T{i} - r{i}.T{i}");
    }
    _ = writeln!(text, "torque M on r{dyads} = 1 N*m cw\nbalance torque Mb on r0\nfind reactions, Mb");
    text
}

fn look(text: &str) -> Analysis {
    Analysis::of(Source::new("rockers.mech", text))
}

fn row(what: &str, most: f64, mut work: impl FnMut()) {
    let round = |work: &mut dyn FnMut()| {
        let begun = Instant::now();
        work();
        begun.elapsed().as_secs_f64() * 1e3
    };
    let least = (0..ROUNDS).map(|_| round(&mut work)).fold(f64::INFINITY, f64::min);
    println!("{what:<44} {least:>9.2} {most:>7}");
}

fn main() {
    let long = rockers(DYADS, "60 deg at 60 rpm");
    println!("{:<44} {:>9} {:>7}", format!("{} lines", long.lines().count()), "ms", "may");
    row("from a key to the diagnostics", 10.0, || _ = black_box(look(&long)));
    let analysis = look(&long);
    assert!(!analysis.problems.has_errors(), "the text is right");
    let place = long.rfind("k70\n").unwrap_or_default();
    row("completion", 10.0, || _ = black_box(analysis.complete(place, None)));
    let results = analysis.solve(&|| true);
    row("hover", 10.0, || _ = black_box(analysis.hover(place, results.as_ref())));
    let sweep = look(&rockers(3, "0 deg .. 355 deg in 71 steps at 60 rpm"));
    let tenfold = look(&rockers(10 * DYADS, "60 deg at 60 rpm").replace(" = ", "="));
    let edits = tenfold.formatting(None).len();
    row(&format!("formatting 10,000 lines, {edits} edits"), 20.0, || _ = black_box(tenfold.formatting(None)));
    row("answers of 72 positions", 50.0, || _ = black_box(sweep.solve(&|| true)));
}
