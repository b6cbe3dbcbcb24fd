//! The polynomial through values and rates at places of a step (Hermite), by Newton's divided differences with each place
//! twice.

use super::Real;

#[derive(Clone, Debug)]
pub(super) struct Hermite<S> {
    /// Parts of the step.
    pub places: Vec<S>,
    /// Of component i those from i·2·places on.
    differences: Vec<S>,
    /// How many places are of use; none before the polynomial is made.
    pub used: usize,
}

impl<S: Real> Hermite<S> {
    pub(super) fn new(places: usize, n: usize) -> Self {
        // the ends first, then halves, quarters … of a half turn: any number of them lies well, and in a stable sequence
        let angle = |mut i: usize| {
            let (mut part, mut unit) = (0.0, 0.5);
            while i > 0 {
                part += if i % 2 == 1 { unit } else { 0.0 };
                (i, unit) = (i / 2, 0.5 * unit);
            }
            part
        };
        let inner = (1..places - 1).map(|i| 0.5 - 0.5 * libm::cos(std::f64::consts::PI * angle(i)));
        let places: Vec<S> = [0.0, 1.0].into_iter().chain(inner).map(S::of).collect();
        Self { differences: vec![S::zero(); 2 * places.len() * n], places, used: 0 }
    }

    fn rows(&self) -> usize {
        2 * self.places.len()
    }

    /// The value at a place, and the rate times the length of the step.
    pub(super) fn set(&mut self, place: usize, component: usize, value: S, rate: S) {
        let row = component * self.rows() + 2 * place;
        (self.differences[row], self.differences[row + 1]) = (value, rate);
    }

    /// Divided differences, in place of values and rates.
    pub(super) fn divide(&mut self, used: usize) {
        let (rows, places) = (self.rows(), &self.places);
        for c in self.differences.chunks_exact_mut(rows) {
            // the rates are those between a place and itself
            for place in (1..used).rev() {
                c[2 * place] = (c[2 * place] - c[2 * place - 2]) / (places[place] - places[place - 1]);
            }
            for order in 2..2 * used {
                for i in (order..2 * used).rev() {
                    c[i] = (c[i] - c[i - 1]) / (places[i / 2] - places[(i - order) / 2]);
                }
            }
        }
        self.used = used;
    }

    pub(super) fn value(&self, component: usize, s: S) -> S {
        let row = component * self.rows();
        let last = 2 * self.used - 1;
        (0..last).rev().fold(self.differences[row + last], |value, i| {
            self.differences[row + i] + (s - self.places[i / 2]) * value
        })
    }
}
