//! The solution that is reached from the system without weights when they grow from zero.

use super::Magnitudes;

/// The least step of the part that the weights have reached.
const SHORTEST: f64 = 1e-5;
/// No part may change by more than this share of the greatest in one step.
const CHANGE: f64 = 0.2;

impl Magnitudes {
    /// Follows the solution of `at(0)`, whose weights or slopes are zero, to that of `at(1)`. `None` where it ends on the way:
    /// it grows beyond all bounds, or turns back. `at` may leave out single parts of the way.
    #[must_use]
    pub fn follow(at: impl Fn(f64) -> Option<Self>) -> Option<Vec<f64>> {
        let start = at(0.0)?;
        let mut x = start.newton(&vec![0.0; start.len()])?.x;
        let mut parts: Vec<_> = start.parts.iter().map(|p| p.at(&x)).collect();
        let (mut reached, mut step) = (0.0, 0.25);
        while reached < 1.0 {
            let next: f64 = f64::min(1.0, reached + step);
            let taken = at(next).and_then(|system| {
                let found =
                    system.newton(&x).filter(|f| f.sign * system.orientation * start.orientation > 0.0)?;
                let now: Vec<_> = system.parts.iter().map(|p| p.at(&found.x)).collect();
                let most = parts.iter().chain(&now).map(|v| v.norm()).fold(0.0, f64::max);
                let change = now.iter().zip(&parts).map(|(a, b)| (*a - *b).norm()).fold(0.0, f64::max);
                (change <= CHANGE * most).then_some((found.x, now))
            });
            if let Some((found, now)) = taken {
                (x, parts, reached) = (found, now, next);
                step *= 2.0;
            } else {
                step *= 0.5;
                if step < SHORTEST {
                    return None;
                }
            }
        }
        Some(x)
    }
}
