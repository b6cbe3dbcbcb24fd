//! Functions over a run: extremes, means and integrals, from series over its steps.

use super::equations::Equations;
use super::part::{is_known, part};
use super::records::within_step;
use super::watch::{AT_ONCE, Watch};
use crate::math::chebyshev::{NODES, tail};
use crate::math::ode::Integrator;
use crate::model::{Bound, Cycle, CycleFunction, Part};

/// What the series of a function leaves off is less than this part of its greatest value, or its part of a step is halved, so often at most.
const SMOOTH: f64 = 1e-11;
const HALVED: u32 = 2;

/// A function over the run as far as it is known.
pub(super) struct Function<'m> {
    pub(super) cycle: &'m Cycle,
    /// Integral, or the extreme.
    value: f64,
    /// Where the extreme is, s.
    at: f64,
    greatest: f64,
    /// How long it was taken, s.
    lasted: f64,
}

impl<'m> Function<'m> {
    pub fn new(cycle: &'m Cycle) -> Self {
        Self {
            cycle,
            value: match cycle.how {
                CycleFunction::Max | CycleFunction::Argmax => f64::NEG_INFINITY,
                CycleFunction::Min => f64::INFINITY,
                CycleFunction::Mean | CycleFunction::Integral => 0.0,
            },
            at: f64::NAN,
            greatest: 0.0,
            lasted: 0.0,
        }
    }
}

impl Watch<'_> {
    /// Takes all functions over the last step.
    pub(super) fn functions_in<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
    ) {
        if self.functions.is_empty() {
            return;
        }
        let mut parts = vec![(method.previous_t(), method.t(), HALVED)];
        while let Some((from, to, left)) = parts.pop() {
            let known = self.functions_between(equations, method, (from, to), left == 0);
            if !known {
                let middle = 0.5 * (from + to);
                parts.extend([(middle, to, left - 1), (from, middle, left - 1)]);
            }
        }
    }

    /// Takes all functions over a part of the last step; `false`, and nothing is taken, where it is too long for their series. With
    /// `anyway` it is taken however long it is.
    fn functions_between<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        (from, to): (f64, f64),
        anyway: bool,
    ) -> bool {
        let mut values = vec![[0.0; NODES]; self.functions.len()];
        let mut ends = vec![[0.0; 2]; self.functions.len()];
        let places = (0..NODES).map(|node| (self.nodes.at(from, to, node), Some(node), 0));
        let places: Vec<_> = places.chain([(from, None, 0), (to, None, 1)]).collect();
        for (t, node, end) in places {
            if !within_step(equations, method, t, &mut self.y) || !equations.observe(t, &self.y, self.deep) {
                continue;
            }
            for ((function, values), ends) in self.functions.iter().zip(&mut values).zip(&mut ends) {
                let value = equations.value(&function.cycle.expr);
                match node {
                    Some(node) => values[node] = value,
                    None => ends[end] = value,
                }
            }
        }
        let smooth = |values: &[f64; NODES]| {
            let greatest = values.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            tail(&self.nodes.coefficients(values)) <= SMOOTH * greatest
        };
        if !anyway && !values.iter().all(smooth) {
            return false;
        }
        let near = AT_ONCE * self.length;
        for ((function, values), ends) in self.functions.iter_mut().zip(&values).zip(&ends) {
            let (after, before) = part(function.cycle, &self.times);
            if from < after - near || to > before + near {
                continue;
            }
            function.lasted += to - from;
            let series = self.nodes.series(from, to, values);
            let greatest = values.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            function.greatest = function.greatest.max(greatest);
            match function.cycle.how {
                CycleFunction::Mean | CycleFunction::Integral => function.value += series.integral(),
                how => {
                    let inner = series.derivative().roots();
                    let places = inner.into_iter().map(|t| (t, series.value(t)));
                    for (t, x) in places.chain([(from, ends[0]), (to, ends[1])]) {
                        let better =
                            if how == CycleFunction::Min { x < function.value } else { x > function.value };
                        if better {
                            (function.value, function.at) = (x, t);
                        }
                    }
                }
            }
        }
        true
    }

    /// The first instant within a step at which the part of a function begins or ends.
    pub fn bound(&self, (from, to): (f64, f64)) -> Option<f64> {
        let near = AT_ONCE * self.length;
        let bounds = self.functions.iter().flat_map(|f| [f.cycle.part.after, f.cycle.part.before]);
        let instants = bounds.flatten().filter_map(|bound| match bound {
            Bound::At(t) => Some(t),
            Bound::Event(..) => None,
        });
        instants.filter(|t| from + near < *t && *t < to - near).min_by(f64::total_cmp)
    }

    /// The functions over the run up to its end, each with the greatest magnitude in play.
    pub fn functions(&self, end: f64) -> Vec<(f64, f64)> {
        let whole = |f: &Function<'_>| f.cycle.part == Part::default();
        let length = |f: &Function<'_>| if whole(f) { end - self.begin } else { f.lasted };
        let value = |f: &Function<'_>| match f.cycle.how {
            _ if !whole(f) && !is_known(f.cycle, &self.times) => f64::NAN,
            CycleFunction::Mean => f.value / length(f),
            CycleFunction::Argmax => f.at,
            CycleFunction::Max | CycleFunction::Min | CycleFunction::Integral => f.value,
        };
        let scale = |f: &Function<'_>| match f.cycle.how {
            CycleFunction::Argmax => end - self.begin,
            CycleFunction::Integral => f.greatest * length(f),
            CycleFunction::Max | CycleFunction::Min | CycleFunction::Mean => f.greatest,
        };
        self.functions.iter().map(|f| (value(f), scale(f))).collect()
    }
}
