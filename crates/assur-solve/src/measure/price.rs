//! What work takes, by how much of it there is: measured once for all of its amounts, so that what comes of it grows with the
//! work and does not depend on a moment when the machine was busy.

/// A setting is clearly faster than another one where it takes no more than this part of its time.
pub(super) const CLEARLY: f64 = 0.7;
/// Settings of one method are alike where one takes no more than this times the work of the other.
pub(super) const ALIKE: f64 = 1.05;

/// Microseconds of a run: something once, and the same for each part of the work.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Price {
    /// Whatever is to be done.
    pub once: f64,
    /// Of an evaluation, of a sample.
    pub each: f64,
}

impl Price {
    /// From amounts of work with the microseconds they took: the least squares of the relative differences.
    #[must_use]
    pub fn of(measured: impl Iterator<Item = (usize, f64)>) -> Self {
        let [mut uu, mut uv, mut vv, mut u, mut v] = [0.0; 5];
        for (work, micros) in measured.filter(|(_, micros)| *micros > 0.0) {
            let (one, part) = (1.0 / micros, amount(work) / micros);
            (uu, uv, vv) = (uu + one * one, uv + one * part, vv + part * part);
            (u, v) = (u + one, v + part);
        }
        let determinant = uu * vv - uv * uv;
        let (once, each) = ((u * vv - v * uv) / determinant, (v * uu - u * uv) / determinant);
        // amounts that are all alike tell no part from the other
        let known = determinant > 1e-9 * uu * vv && once >= 0.0 && each > 0.0;
        if known {
            Self { once, each }
        } else {
            Self { once: 0.0, each: if vv > 0.0 { v / vv } else { 0.0 } }
        }
    }

    /// Microseconds of so much work.
    #[must_use]
    pub fn time(&self, work: usize) -> f64 {
        self.once + self.each * amount(work)
    }
}

#[allow(clippy::cast_precision_loss)] // less than a thousand million
const fn amount(work: usize) -> f64 {
    work as f64
}
