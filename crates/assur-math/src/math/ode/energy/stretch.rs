//! Time along a part of a way.
//!
//! dt = dq √(J/2T). Towards a place of rest r the kinetic energy vanishes as |q − r|: there q = r ± v² is taken, so that
//! dt = 2 dv √(J/2F), F the mean force between r and q, is smooth.

use super::way::Way;
use crate::math::chebyshev::{NODES, Nodes, integrate, sum, tail};

/// Newton's iterations for the place at an instant: it doubles its digits each time.
const MOST: usize = 60;
/// So many nodes side by side.
const SIDE_BY_SIDE: usize = 8;

/// A part of a way that is gone in one sense.
#[derive(Clone, Debug)]
pub(super) struct Stretch {
    from: f64,
    to: f64,
    /// The place of rest that is near.
    rest: Option<f64>,
    /// √|q − r| at both ends.
    roots: [f64; 2],
    /// The derivative of time, on [−1, 1], and time.
    rate: [f64; NODES],
    time: [f64; NODES + 1],
    /// The least kinetic energy on it; towards a place of rest that at its far end, by the least force.
    pub slowest: f64,
}

impl Stretch {
    pub fn new(nodes: &Nodes, way: &Way, (from, to): (f64, f64), rest: Option<f64>) -> Self {
        let roots = rest.map_or([0.0; 2], |r| [(from - r).abs().sqrt(), (to - r).abs().sqrt()]);
        let none = ([0.0; NODES], [0.0; NODES + 1]);
        let mut stretch = Self { from, to, rest, roots, rate: none.0, time: none.1, slowest: f64::INFINITY };
        let change = if rest.is_some() { (roots[1] - roots[0]).abs() } else { 0.5 * (to - from).abs() };
        let mut rates = [0.0; NODES];
        for (part, rates) in rates.as_chunks_mut::<SIDE_BY_SIDE>().0.iter_mut().enumerate() {
            let q: [f64; SIDE_BY_SIDE] =
                std::array::from_fn(|i| stretch.place(nodes.at(-1.0, 1.0, part * SIDE_BY_SIDE + i)));
            let of_motion = rest.map_or_else(|| way.energies(&q), |r| q.map(|q| way.mean_force(r, q).abs()));
            let masses = way.masses(&q);
            stretch.slowest = of_motion.iter().fold(stretch.slowest, |least, x| least.min(*x));
            *rates = std::array::from_fn(|i| change * (masses[i] / (2.0 * of_motion[i])).sqrt());
        }
        if rest.is_some() {
            stretch.slowest *= roots[0].max(roots[1]) * roots[0].max(roots[1]);
        }
        stretch.rate = nodes.coefficients(&rates);
        integrate(&stretch.rate, 1.0, 0.0, &mut stretch.time);
        stretch
    }

    /// What the series of time leaves off, relative to time.
    pub fn left_off(&self) -> f64 {
        tail(&self.rate) / self.rate[0]
    }

    /// The sense in which it is gone.
    pub fn sense(&self) -> f64 {
        (self.to - self.from).signum()
    }

    pub fn duration(&self) -> f64 {
        sum(&self.time, 1.0)
    }

    /// The coordinate at a place of [−1, 1].
    pub fn place(&self, z: f64) -> f64 {
        let part = 0.5 * (1.0 + z);
        let Some(rest) = self.rest else { return self.from + (self.to - self.from) * part };
        if z == 1.0 {
            return self.to;
        }
        let v = self.roots[0] + (self.roots[1] - self.roots[0]) * part;
        let side = if self.roots[1] > self.roots[0] { self.to - rest } else { self.from - rest };
        rest + (v * v).copysign(side)
    }

    /// The coordinate so long after its begin.
    pub fn place_after(&self, duration: f64) -> f64 {
        let whole = self.duration();
        if duration >= whole {
            return self.to;
        }
        let (mut low, mut high) = (-1.0_f64, 1.0_f64);
        let mut z = 2.0 * duration / whole - 1.0;
        for _ in 0..MOST {
            let miss = sum(&self.time, z) - duration;
            if miss > 0.0 {
                high = z;
            } else {
                low = z;
            }
            let next = z - miss / sum(&self.rate, z);
            let next = if low < next && next < high { next } else { 0.5 * (low + high) };
            if (next - z).abs() <= 2.0 * f64::EPSILON {
                return self.place(next);
            }
            z = next;
        }
        self.place(z)
    }

    /// The kinetic energy at a place.
    pub fn energy(&self, way: &Way, q: f64) -> f64 {
        self.rest.map_or_else(|| way.energy(q), |r| (q - r).abs() * way.mean_force(r, q).abs())
    }
}
