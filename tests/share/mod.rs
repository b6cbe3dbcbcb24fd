//! How much a run does: a fifth of the random cases and of the sweeps over examples, or all with `ASSUR_TESTS=all`, as `.ci/run` has it.
//! The fifth is the first one, so that a case has the same number in both.

#![allow(dead_code, reason = "each program uses a part")]

use std::ops::{Add, Div, Range};

/// Whether all are run.
pub fn all() -> bool {
    std::env::var_os("ASSUR_TESTS").is_some_and(|value| value == "all")
}

/// A fifth of a number of cases, or all.
pub fn part<N: From<u8> + Add<Output = N> + Div<Output = N>>(cases: N) -> N {
    if all() { cases } else { (cases + N::from(4)) / N::from(5) }
}

/// The first of some seeds.
pub fn first(seeds: Range<u64>) -> Range<u64> {
    seeds.start..seeds.start + part(seeds.end - seeds.start)
}

/// How many of a kind are seen at least: in a fifth of the cases half as often, since chance weighs more.
pub fn least<N: From<u8> + Div<Output = N>>(seen: N) -> N {
    if all() { seen } else { seen / N::from(10) }
}

/// Every fifth, so that all folders have some.
pub fn spread<T>(files: Vec<T>) -> Vec<T> {
    let step = if all() { 1 } else { 5 };
    files.into_iter().step_by(step).collect()
}
