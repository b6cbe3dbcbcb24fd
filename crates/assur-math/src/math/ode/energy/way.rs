//! Mass and force over an interval of the coordinate, by their Chebyshev series; the kinetic energy from the force.

use super::super::Undefined;
use crate::math::chebyshev::{NODES, Nodes, derive, integrate, least, sum, sums, tail};
use crate::math::root::root;
use std::ops::Range;

/// Places and weights of Gauss's rule for eight places on [0, 1], exact for polynomials up to degree 15.
const GAUSS: [(f64, f64); 8] = [
    (0.019_855_071_751_231_884, 0.050_614_268_145_188_13),
    (0.101_666_761_293_186_63, 0.111_190_517_226_687_24),
    (0.237_233_795_041_835_5, 0.156_853_322_938_943_64),
    (0.408_282_678_752_175_1, 0.181_341_891_689_181),
    (0.591_717_321_247_825, 0.181_341_891_689_181),
    (0.762_766_204_958_164_5, 0.156_853_322_938_943_64),
    (0.898_333_238_706_813_4, 0.111_190_517_226_687_24),
    (0.980_144_928_248_768_1, 0.050_614_268_145_188_13),
];
/// A place of rest may lie so far outside, parts of the interval: the series still say where.
const OUTSIDE: f64 = 0.1;
/// Places of rest are looked for in steps of at most this part of the interval, that grow so from the present place.
const SCAN: f64 = 1.0 / 24.0;
const GROWTH: f64 = 1.4;
const LEAST: f64 = 1e-7;
/// So many of them side by side.
const SIDE_BY_SIDE: usize = 4;
/// What the series of a watched value may leave off, in multiples of its last terms.
const UNSEEN: f64 = 10.0;
/// Rounding of sums, parts of the greatest coefficient.
const ROUNDING: f64 = 1e-12;

/// An interval of the coordinate.
#[derive(Clone, Debug)]
pub(super) struct Way {
    pub low: f64,
    pub high: f64,
    mass: [f64; NODES],
    force: [f64; NODES],
    force_slope: [f64; NODES],
    energy: [f64; NODES + 1],
    /// What the series of mass and force leave off.
    pub left_off: f64,
    /// What else adds up along it.
    works: Vec<[f64; NODES + 1]>,
    /// What is watched along it, each with a bound of its slope in an interval of length 2, and with what its series leaves off.
    watched: Vec<([f64; NODES], f64, f64)>,
}

/// The greatest slope that a series on [−1, 1] may have: of T_k it is at most k².
#[allow(clippy::cast_precision_loss)] // far below 2^52
fn steepest(series: &[f64; NODES]) -> f64 {
    series.iter().enumerate().map(|(k, c)| (k * k) as f64 * c.abs()).sum()
}

/// Values at the nodes, by quantity: mass, force, what else adds up, and what is watched.
pub(super) type Values = Vec<[f64; NODES]>;

impl Way {
    /// With room for the rates of works and for watched values.
    pub fn new(works: usize, watched: usize) -> Self {
        let none = [0.0; NODES];
        Self {
            low: 0.0,
            high: 0.0,
            mass: none,
            force: none,
            force_slope: none,
            energy: [0.0; NODES + 1],
            left_off: 0.0,
            works: vec![[0.0; NODES + 1]; works],
            watched: vec![(none, 0.0, 0.0); watched],
        }
    }

    /// Takes an interval with its values at the nodes, and the kinetic energy at a place of it.
    ///
    /// # Errors
    /// There is no mass somewhere.
    pub fn set(
        &mut self,
        Range { start, end }: Range<f64>,
        (nodes, values): (&Nodes, &Values),
        (q, kinetic): (f64, f64),
    ) -> Result<(), Undefined> {
        (self.low, self.high) = (start, end);
        let [mass, force, further @ ..] = values.as_slice() else { return Err(Undefined) };
        let (works, watched) = further.split_at(self.works.len());
        if !mass.iter().all(|m| *m > 0.0) {
            return Err(Undefined);
        }
        (self.mass, self.force) = (nodes.coefficients(mass), nodes.coefficients(force));
        derive(&self.force, &mut self.force_slope);
        let half = 0.5 * (end - start);
        integrate(&self.force, half, 0.0, &mut self.energy);
        self.energy[0] += kinetic - self.energy(q);
        for (out, values) in self.works.iter_mut().zip(works) {
            integrate(&nodes.coefficients(values), half, 0.0, out);
        }
        for (out, values) in self.watched.iter_mut().zip(watched) {
            let series = nodes.coefficients(values);
            *out = (series, steepest(&series), UNSEEN * tail(&series));
        }
        Ok(())
    }

    pub fn length(&self) -> f64 {
        self.high - self.low
    }

    /// What the kinetic energy is a sum of.
    pub fn energies_at_most(&self) -> f64 {
        self.energy.iter().map(|c| c.abs()).sum()
    }

    fn x(&self, q: f64) -> f64 {
        ((q - self.low) + (q - self.high)) / self.length()
    }

    pub fn mass(&self, q: f64) -> f64 {
        sum(&self.mass, self.x(q))
    }

    /// Masses at several places.
    pub fn masses<const N: usize>(&self, q: &[f64; N]) -> [f64; N] {
        sums(&self.mass, &q.map(|q| self.x(q)))
    }

    pub fn force(&self, q: f64) -> f64 {
        sum(&self.force, self.x(q))
    }

    fn force_slope(&self, q: f64) -> f64 {
        sum(&self.force_slope, self.x(q)) * 2.0 / self.length()
    }

    pub fn energy(&self, q: f64) -> f64 {
        sum(&self.energy, self.x(q))
    }

    /// Energies at several places.
    pub fn energies<const N: usize>(&self, q: &[f64; N]) -> [f64; N] {
        sums(&self.energy, &q.map(|q| self.x(q)))
    }

    /// What adds up between two places, of each further quantity.
    pub fn works(&self, from: f64, to: f64) -> impl Iterator<Item = f64> + '_ {
        let (from, to) = (self.x(from), self.x(to));
        self.works.iter().map(move |work| sum(work, to) - sum(work, from))
    }

    /// Whether a watched value is certain not to be zero between two places: it is too far from it for its slope.
    pub fn keeps_off(&self, watched: usize, (from, to): (f64, f64)) -> bool {
        let (series, steepest, left_off) = &self.watched[watched];
        let [from, to] = [from, to].map(|q| self.x(q));
        let middle = 0.5 * (sum(series, from) + sum(series, to));
        middle.abs() > 0.5 * steepest * (to - from).abs() + left_off
    }

    /// The mean force between two places.
    pub fn mean_force(&self, from: f64, to: f64) -> f64 {
        let forces = sums(&self.force, &GAUSS.map(|(at, _)| self.x(from + at * (to - from))));
        GAUSS.iter().zip(forces).map(|((_, weight), force)| weight * force).sum()
    }

    /// Whether a motion from a place goes on within.
    pub fn leads_on(&self, q: f64, sense: f64) -> bool {
        if sense > 0.0 { self.low <= q && q < self.high } else { self.low < q && q <= self.high }
    }

    /// The places of rest behind a place and ahead of it, as far as the series tell.
    pub fn rests(&self, q: f64, sense: f64, kinetic: f64) -> [Option<f64>; 2] {
        let behind = if kinetic == 0.0 { Some(q) } else { self.rest(q, -sense, kinetic) };
        [behind, self.rest(q, sense, kinetic)]
    }

    /// The nearest place of rest in one sense.
    fn rest(&self, q: f64, sense: f64, kinetic: f64) -> Option<f64> {
        if least(&self.energy, 1.0 + 2.0 * OUTSIDE) > ROUNDING * self.energy[0] {
            return None;
        }
        let length = self.length();
        let last = if sense > 0.0 { self.high + OUTSIDE * length } else { self.low - OUTSIDE * length };
        let (mut step, most) = self.scan(q, kinetic);
        let mut before = q;
        while (last - before) * sense > 0.0 {
            let mut places = [last; SIDE_BY_SIDE];
            let mut from = before;
            for place in &mut places {
                *place = from + sense * step.min((last - from).abs());
                from = *place;
                step = (GROWTH * step).min(most);
            }
            for (next, energy) in places.into_iter().zip(self.energies(&places)) {
                if energy <= 0.0 {
                    // of the motion from rest only the far end is one
                    let start = if before == q && kinetic == 0.0 { None } else { Some(before) };
                    return start.map(|start| self.root(start, next));
                }
                before = next;
            }
        }
        None
    }

    /// The first step in which a place of rest is looked for from a place, and the longest.
    fn scan(&self, q: f64, kinetic: f64) -> (f64, f64) {
        let length = self.length();
        let (force, slope) = (self.force(q), self.force_slope(q));
        let of_motion = if kinetic > 0.0 { kinetic / force } else { f64::INFINITY };
        let near = of_motion.abs().min((force / slope).abs());
        // a place without force has no size of its own
        let near = if near.is_nan() { length } else { near };
        let most = SCAN * length;
        // a shorter one would end where it begins
        let least = (LEAST * length).max(2.0 * f64::EPSILON * self.low.abs().max(self.high.abs())).min(most);
        ((0.25 * near).clamp(least, most), most)
    }

    fn root(&self, from: f64, to: f64) -> f64 {
        // from the near place, so that one close to it keeps its digits
        from + root(0.0, to - from, self.energy(from), self.energy(to), |d| self.energy(from + d))
    }

    /// What the series leave off, relative to the mass and to the greatest kinetic energy between the places of rest.
    pub fn leaves_off(&self, values: &Values, sense: f64, [behind, ahead]: [Option<f64>; 2]) -> f64 {
        let least = values[0].iter().fold(f64::INFINITY, |least, m| m.min(least));
        let within = |q: Option<f64>, other: f64| q.map_or(other, |q| q.clamp(self.low, self.high));
        let (first, last) = if sense > 0.0 { (self.low, self.high) } else { (self.high, self.low) };
        let (from, to) = (within(behind, first), within(ahead, last));
        let energies = (0..=8_u8).map(|i| self.energy(from + (to - from) * f64::from(i) / 8.0));
        let greatest = energies.fold(0.0, f64::max);
        let lost = tail(&self.force) * self.length();
        let of_force = if lost > 0.0 { lost / greatest } else { 0.0 };
        (tail(&self.mass) / least).max(of_force)
    }
}
