//! Steps within which no function over the run has its extreme. What a step has of itself shows that, though it is less accurate than
//! what answers are taken from: for that the method takes evaluations, which such a step does not ask for.

use super::equations::Equations;
use super::functions::{Memory, SURPASSED, most_possible};
use super::records::within_step;
use super::watch::Watch;
use crate::math::lobatto::PLACES;
use crate::math::ode::Integrator;

/// One of so many places is looked at, both ends and the middle among them.
const APART: usize = 4;
const LAST: usize = PLACES - 1;
const MIDDLE: usize = LAST / 2;

impl Watch<'_> {
    /// Takes all functions over the last step, where none has an extreme within it; else `false`, and nothing is taken.
    pub(super) fn only_ends<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        memory: &mut Memory,
    ) -> bool {
        let step = (method.previous_t(), method.t());
        if self.drawn || !method.sketch(step.1, &mut self.y) {
            return false;
        }
        self.ask(step, memory);
        for place in [0, LAST] {
            let t = self.places.at(step.0, step.1, place);
            within_step(equations, method, t, &mut self.y);
            self.note(equations, (t, place), memory);
        }
        // one that goes beyond its best so far goes on to an extreme, or has come from there
        if !self.ends_below(memory) {
            return false;
        }
        for place in (APART..LAST).step_by(APART) {
            let t = self.places.at(step.0, step.1, place);
            method.sketch(t, &mut self.y);
            self.note(equations, (t, place), memory);
        }
        memory.series.clear();
        memory
            .series
            .extend(memory.values.iter().map(|values| self.places.series(step.0, step.1, values, APART)));
        // what the cubic through both ends has there differs by more than the sketch is off
        let middle = self.places.at(step.0, step.1, MIDDLE);
        method.dense(middle, &mut self.y);
        self.note(equations, (middle, MIDDLE), memory);
        let Memory { asked, set_of, values, series, .. } = memory;
        let each = || asked.iter().zip(&*set_of).map(|(&f, &set)| (f, &series[set], &values[set]));
        let stays = each().all(|(f, series, values)| {
            let function = &self.functions[f];
            let off = (series.value(middle) - values[MIDDLE]).abs() + SURPASSED * series.tail();
            function.sign().is_some_and(|sign| most_possible(sign, series) + off < sign * function.value)
        });
        if stays {
            each().for_each(|(f, _, values)| self.functions[f].pass(step, values));
        }
        stays
    }

    /// Whether no function that counts goes beyond its best so far at an end of the step; not where one is no extreme.
    fn ends_below(&self, memory: &Memory) -> bool {
        memory.asked.iter().zip(&memory.set_of).all(|(&f, &set)| {
            let (function, values) = (&self.functions[f], &memory.values[set]);
            function.sign().is_some_and(|sign| {
                [values[0], values[LAST]].iter().all(|x| sign * x <= sign * function.value)
            })
        })
    }
}
