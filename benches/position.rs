//! The time per position of `.mech` files, from their texts, on one thread: the plan of each is run over the file's
//! positions, and the least of many rounds is printed as JSON, in microseconds per position. Each figure twice: one
//! position after the other, and in lanes with the closure checked.
//!
//! - `plan`: the plan alone; the sine and the cosine of the drive are given, and nothing is stored;
//! - `array`: from the angle of the drive to an array of what the file asks for;
//! - `text`: `array` for a hundred turns in lanes, and once before them the text is read and compiled, and its turn followed
//!   with all residuals; one figure.
//!
//! `cargo bench --bench position -- FILE…`. With `--rounds N` the plan is run so often without looking at a
//! clock, for a count of instructions: see `benches/instructions.sh`. With `--by-hand` the four-bar by hand is measured, one position
//! after the other and in lanes of AVX2: `plan` stores the reactions here.

mod by_hand;
mod run;

use assur::internals::math::{Lanes, V2, Vec2};
use by_hand::Answer;
use run::Run;
use run::turn::Turn;
use std::hint::black_box;
use std::time::Instant;

/// Of the loop by hand: a vector of AVX2.
const LANES: usize = 4;

fn main() {
    let mut files = Vec::new();
    let mut rounds = None;
    let mut args = std::env::args().skip(1);
    while let Some(arg) = args.next() {
        match arg.as_str() {
            // what cargo puts behind the files
            "--bench" => {}
            "--rounds" => rounds = args.next().and_then(|n| n.parse::<usize>().ok()),
            "--by-hand" => by_hand(),
            _ => files.push(arg),
        }
    }
    for file in files {
        let text = std::fs::read_to_string(&file).expect("a file");
        match rounds {
            Some(rounds) => {
                let mut run = Run::of(&text);
                for _ in 0..rounds {
                    black_box(run.one_by_one());
                }
                println!("{}", run.positions());
            }
            None => measure(&file, &text),
        }
    }
}

fn measure(file: &str, text: &str) {
    let mut run = Run::of(text);
    let mut turn = Turn::of(&run);
    let positions = run.positions();
    let us = |seconds: f64| 1e6 * seconds / positions as f64;
    let mut lanes = run.side_by_side();
    let plan = [us(least(|| run.one_by_one())), us(least(|| lanes.sum(&run.compiled.plan)))];
    let array = [
        us(least(|| turn.one_by_one(&mut run))),
        us(least(|| turn.side_by_side(&run.compiled.plan, &mut lanes))),
    ];
    let effects = run.compiled.plan.effects.computed().join(", ");
    println!(
        r#"{{"file": "{file}", "positions": {positions}, "effects": "{effects}", "plan": {plan:.5?}, "array": {array:.5?}, "text": {:.5}}}"#,
        us(least_of(10, || a_hundred_turns(text))) / 100.0
    );
}

/// From a text to the array.
fn a_hundred_turns(text: &str) -> f64 {
    let run = Run::of(text);
    let mut turn = Turn::of(&run);
    let mut lanes = run.side_by_side();
    (0..100).map(|_| black_box(turn.side_by_side(&run.compiled.plan, &mut lanes))).sum()
}

/// The four-bar written by hand, with the directions of its crank given, and from its angles.
fn by_hand() {
    let angles: Vec<f64> = (0..360).map(|i| f64::from(i).to_radians()).collect();
    let directions: Vec<Vec2> = angles.iter().map(|&a| Vec2::direction(a)).collect();
    let lengths = black_box([0.1, 0.35, 0.3, 0.4]);
    let us = |seconds: f64| 1e6 * seconds / 360.0;
    let mut out = vec![Answer::default(); angles.len()];
    let mut plan = [0.0; 2];
    let mut array = [0.0; 2];
    plan[0] = us(least(|| {
        out.iter_mut().zip(&directions).for_each(|(out, u)| *out = by_hand::four_bar(lengths, 30.0, *u));
        black_box(&out)[0].1
    }));
    array[0] = us(least(|| {
        let each = out.iter_mut().zip(&angles);
        each.for_each(|(out, a)| *out = by_hand::four_bar(lengths, 30.0, Vec2::direction(*a)));
        black_box(&out)[0].1
    }));
    let mut out = vec![Answer::default(); angles.len() / LANES];
    let mut rows: Vec<_> = directions.as_chunks().0.iter().map(row).collect();
    plan[1] = us(least(|| in_lanes(lengths, &rows, &mut out)));
    array[1] = us(least(|| {
        let each = rows.iter_mut().zip(angles.as_chunks().0);
        each.for_each(|(to, angles): (_, &[f64; LANES])| *to = row(&angles.map(Vec2::direction)));
        in_lanes(lengths, &rows, &mut out)
    }));
    println!(r#"{{"plan": {plan:.5?}, "array": {array:.5?}}}"#);
}

/// A row of directions.
fn row(directions: &[Vec2; LANES]) -> V2<Lanes<LANES>> {
    V2::new(Lanes(directions.map(|u| u.x)), Lanes(directions.map(|u| u.y)))
}

/// All rows by hand in AVX2, as far as the machine has it.
fn in_lanes(lengths: [f64; 4], rows: &[V2<Lanes<LANES>>], out: &mut [Answer<Lanes<LANES>>]) -> f64 {
    let all = ByHand { lengths, rows, out: &mut *out };
    #[cfg(target_arch = "x86_64")]
    let all = match pulp::x86::V3::try_new() {
        Some(avx2) => {
            avx2.vectorize(all);
            return black_box(out)[0].1.0[0];
        }
        None => all,
    };
    pulp::NullaryFnOnce::call(all);
    black_box(out)[0].1.0[0]
}

struct ByHand<'a> {
    lengths: [f64; 4],
    rows: &'a [V2<Lanes<LANES>>],
    out: &'a mut [Answer<Lanes<LANES>>],
}

impl pulp::NullaryFnOnce for ByHand<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self { lengths, rows, out } = self;
        out.iter_mut().zip(rows).for_each(|(out, u)| *out = by_hand::four_bar(lengths, 30.0, *u));
    }
}

/// The least time of a round, s.
fn least(round: impl FnMut() -> f64) -> f64 {
    least_of(2000, round)
}

fn least_of(rounds: usize, mut round: impl FnMut() -> f64) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..rounds {
        let start = Instant::now();
        black_box(round());
        least = least.min(start.elapsed().as_secs_f64());
    }
    least
}
