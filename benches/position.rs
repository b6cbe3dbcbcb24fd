//! The time per position of `.mech` files, from their texts, on one thread: the plan of each is run over the file's
//! positions, and the least of many rounds is printed as JSON.
//!
//! `cargo bench --features lanes --bench position -- FILE…`; with `--rounds N` the plan is run so often without looking at a clock, for a
//! count of instructions: see `benches/instructions.sh`.

mod run;

use run::{Run, side_by_side};
use std::hint::black_box;
use std::time::Instant;

fn main() {
    let mut files = Vec::new();
    let mut rounds = None;
    let mut args = std::env::args().skip(1);
    while let Some(arg) = args.next() {
        match arg.as_str() {
            // what cargo puts behind the files
            "--bench" => {}
            "--rounds" => rounds = args.next().and_then(|n| n.parse::<usize>().ok()),
            _ => files.push(arg),
        }
    }
    for file in files {
        let mut run = Run::of(&std::fs::read_to_string(&file).expect("a file"));
        match rounds {
            Some(rounds) => {
                for _ in 0..rounds {
                    black_box(run.one_by_one());
                }
                println!("{}", run.positions());
            }
            None => measure(&file, &mut run),
        }
    }
}

fn measure(file: &str, run: &mut Run) {
    let positions = run.positions();
    let alone = least(|| run.one_by_one()) / positions as f64;
    let forces = run.compiled.plan.effects.forces;
    let [together, laned] = [false, true].map(|in_lanes| {
        let (mut side, inputs) = run.together(in_lanes);
        least(|| side_by_side(&mut side, &inputs, forces)) / positions as f64
    });
    let effects = run.compiled.plan.effects.computed().join(", ");
    println!(
        r#"{{"file": "{file}", "positions": {positions}, "effects": "{effects}", "us": {:.5}, "us_together": {:.5}, "us_in_lanes": {:.5}}}"#,
        alone * 1e6,
        together * 1e6,
        laned * 1e6
    );
}

/// The least time of a round, s.
fn least(mut round: impl FnMut() -> f64) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..2000 {
        let start = Instant::now();
        black_box(round());
        least = least.min(start.elapsed().as_secs_f64());
    }
    least
}
