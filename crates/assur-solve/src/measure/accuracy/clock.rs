//! Times: the least of many repeats, after a warm-up.

use std::time::{Duration, Instant};

/// How long one setting is measured.
const BUDGET: Duration = Duration::from_millis(20);
/// A stretch of repeats that the clock can tell from nothing.
const STRETCH: Duration = Duration::from_micros(200);

/// Microseconds that `work` takes.
pub fn micros(mut work: impl FnMut()) -> f64 {
    let once = |work: &mut dyn FnMut(), times: u32| {
        let started = Instant::now();
        (0..times).for_each(|_| work());
        started.elapsed()
    };
    let mut times = 1;
    let mut least = once(&mut work, times);
    while least < STRETCH && times < 1 << 20 {
        times *= 2;
        least = once(&mut work, times);
    }
    let started = Instant::now();
    while started.elapsed() < BUDGET {
        least = least.min(once(&mut work, times));
    }
    least.as_secs_f64() * 1e6 / f64::from(times)
}
