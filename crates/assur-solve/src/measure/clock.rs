//! Times: the least of many repeats, after a warm-up.

/// Seconds since a moment that stays the same. The caller has the clock: not every machine that solves has one.
pub type Clock = fn() -> f64;

/// How long one setting is measured, s.
const BUDGET: f64 = 20e-3;
/// A stretch of repeats that the clock can tell from nothing, s.
const STRETCH: f64 = 200e-6;

/// Microseconds that `work` takes.
pub fn micros(clock: Clock, mut work: impl FnMut()) -> f64 {
    let once = |work: &mut dyn FnMut(), times: u32| {
        let started = clock();
        (0..times).for_each(|_| work());
        clock() - started
    };
    let mut times = 1;
    let mut least = once(&mut work, times);
    while least < STRETCH && times < 1 << 20 {
        times *= 2;
        least = once(&mut work, times);
    }
    let started = clock();
    while clock() - started < BUDGET {
        least = least.min(once(&mut work, times));
    }
    least * 1e6 / f64::from(times)
}
