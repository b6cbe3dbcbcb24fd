//! A million positions of the crank-slider with all reactions as columns, by the library alone on one thread: following, residuals and all.
//! Prints the seconds of the processor, the least of some turns. `benches/columns.py` compares the Python package with it.

use assur::{Alone, DrivePositions, Problem};

const COUNT: usize = 1_000_000;
const TURNS: usize = 3;

fn main() {
    let problem = Problem::new("crank-slider.mech", include_str!("../examples/crank-slider.mech"));
    let checked = problem.checked().expect("an example");
    let turn = |i: usize| i as f64 * (std::f64::consts::TAU / COUNT as f64);
    let mut least = f64::INFINITY;
    for _ in 0..TURNS {
        let positions = DrivePositions::Numbers((0..COUNT).map(turn).collect());
        let before = seconds();
        let columns = checked.columns_at(vec![(None, positions)], &Alone).expect("positions that fit");
        least = least.min(seconds() - before);
        assert_eq!(columns.len, COUNT);
    }
    println!("{least}");
}

/// Of the processor: on a shared machine they say more than those of a clock.
fn seconds() -> f64 {
    let stat = std::fs::read_to_string("/proc/self/stat").expect("Linux");
    let after_name = stat.rsplit(')').next().unwrap_or_default();
    // the 14th and the 15th value, in hundredths of a second
    let ticks = after_name.split_whitespace().skip(11).take(2).filter_map(|ticks| ticks.parse::<f64>().ok());
    ticks.sum::<f64>() / 100.0
}
