//! The greatest value of a smooth function of one variable on an interval.

/// Samples of an interval: a law of motion has few waves in each of its parts.
const SAMPLES: usize = 48;
/// Steps of the golden section: each takes 0.618 of the interval before it.
const GOLDEN: usize = 44;
/// Share of the golden section.
const SHARE: f64 = 0.618_033_988_749_894_9;

/// Where `f` is greatest on `[from, to]`, and its value there. Both ends are looked at; inside, the best sample is
/// refined until rounding hides the rest, and its place by a root of the derivative.
pub fn greatest(from: f64, to: f64, f: &impl Fn(f64) -> f64) -> (f64, f64) {
    let width = to - from;
    let at = |i: usize| if i == SAMPLES { to } else { from + width * i as f64 / SAMPLES as f64 };
    let mut best = (from, f(from));
    let mut index = 0;
    for i in 1..=SAMPLES {
        let value = f(at(i));
        if value > best.1 {
            best = (at(i), value);
            index = i;
        }
    }
    let (mut a, mut b) = (at(index.saturating_sub(1)), at((index + 1).min(SAMPLES)));
    let (mut c, mut d) = (b - SHARE * (b - a), a + SHARE * (b - a));
    let (mut f_c, mut f_d) = (f(c), f(d));
    for _ in 0..GOLDEN {
        if f_c > f_d {
            (b, d, f_d) = (d, c, f_c);
            c = b - SHARE * (b - a);
            f_c = f(c);
        } else {
            (a, c, f_c) = (c, d, f_d);
            d = a + SHARE * (b - a);
            f_d = f(d);
        }
    }
    for x in [c, d] {
        let value = f(x);
        if value > best.1 {
            best = (x, value);
        }
    }
    polished(best, from, to, f)
}

/// The place of a smooth greatest value by Newton's method on differences of five values; a section alone leaves it
/// uncertain by the root of the rounding.
fn polished(best: (f64, f64), from: f64, to: f64, f: &impl Fn(f64) -> f64) -> (f64, f64) {
    let h = (to - from) * 1e-3;
    let mut x = best.0;
    for _ in 0..4 {
        if x - 2.0 * h < from || x + 2.0 * h > to {
            return best;
        }
        let [l2, l1, m, r1, r2] = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| f(x + k * h));
        let first = (8.0 * (r1 - l1) - (r2 - l2)) / (12.0 * h);
        let second = (16.0 * (r1 + l1) - (r2 + l2) - 30.0 * m) / (12.0 * h * h);
        let step = first / second;
        if !step.is_finite() || second >= 0.0 || step.abs() > h {
            return best;
        }
        x -= step;
    }
    let value = f(x);
    let noise = 4.0 * f64::EPSILON * best.1.abs();
    if value + noise >= best.1 { (x, value.max(best.1)) } else { best }
}
