//! Places within a step where a function over the run is not smooth, and its series are divided: a number under `abs` or a difference
//! under `max` passes zero, the argument of a curve a point of its table.

use super::equations::Equations;
use super::records::within_step;
use crate::answer::{OF_FORCES, OF_MOTION};
use crate::math::ode::Integrator;
use crate::math::ode::event::crossings;
use crate::model::{Axis, BinaryOp, Curve, Cycle, Expr, Function, Mechanism};
use std::convert::Infallible;
use std::ops::ControlFlow;
use std::sync::Arc;

/// Where all are looked at first, parts of the step.
const PLACES: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];
/// A number that stays farther from a value than this part of its variation in the step does not reach it between the places.
const CLEAR: f64 = 0.5;
/// Places nearer to each other than this part of the step are one.
const APART: f64 = 1e-12;

/// A number that turns a function where it passes zero, or a point of a curve.
struct Kink {
    number: Expr,
    curve: Option<Arc<Curve>>,
}

/// The kinks of all functions over a run.
#[derive(Default)]
pub(super) struct Kinks {
    all: Vec<Kink>,
    /// The values of each number at the first places.
    samples: Vec<[f64; PLACES.len()]>,
    /// The values that it passes.
    levels: Vec<f64>,
    /// Where the last step is divided, s, in order.
    pub found: Vec<f64>,
    deep: bool,
    y: Vec<f64>,
}

impl Kinks {
    pub fn of(mechanism: &Mechanism, cycles: &[Cycle], deep: bool, y: Vec<f64>) -> Self {
        let mut kinks = Self { deep, y, ..Self::default() };
        cycles.iter().for_each(|cycle| kinks.expr(mechanism, &cycle.expr));
        kinks.samples = vec![[f64::NAN; PLACES.len()]; kinks.all.len()];
        kinks
    }

    fn add(&mut self, number: Expr, curve: Option<Arc<Curve>>) {
        let is_constant = matches!(number, Expr::Constant(_));
        if !is_constant && !self.all.iter().any(|kink| kink.number == number && kink.curve == curve) {
            self.all.push(Kink { number, curve });
        }
    }

    fn expr(&mut self, mechanism: &Mechanism, expr: &Expr) {
        let mut parts = Vec::new();
        expr.parts(&mut |part| parts.push(part.clone()));
        for part in parts {
            match part {
                Expr::Call(Function::Abs, args) => args.into_iter().for_each(|a| self.add(a, None)),
                Expr::Call(Function::Mag, args) => {
                    for (vector, axis) in args.iter().flat_map(|a| [(a, Axis::X), (a, Axis::Y)]) {
                        self.add(Expr::Component(Box::new(vector.clone()), axis), None);
                    }
                }
                Expr::Call(Function::Max | Function::Min, args) => {
                    for (i, a) in args.iter().enumerate() {
                        for b in &args[..i] {
                            let [a, b] = [a, b].map(|x| Box::new(x.clone()));
                            self.add(Expr::Binary(BinaryOp::Sub, a, b), None);
                        }
                    }
                }
                Expr::Curve(curve, _, x) => self.add(*x, Some(curve)),
                Expr::Quantity(id) => self.expr(mechanism, &mechanism.quantities[id.index()].expr),
                _ => {}
            }
        }
    }

    /// Finds where the last step is divided.
    pub fn find<M: Integrator<f64>>(&mut self, equations: &mut Equations<'_, '_>, method: &mut M) {
        self.found.clear();
        if self.all.is_empty() {
            return;
        }
        let step = (method.previous_t(), method.t());
        self.sample(equations, method, step);
        for index in 0..self.all.len() {
            self.take_levels(equations, index);
            for level in 0..self.levels.len() {
                self.passes(equations, method, (step, index), self.levels[level]);
            }
        }
        let apart = APART * (step.1 - step.0);
        self.found.sort_by(f64::total_cmp);
        self.found.dedup_by(|a, b| *a - *b <= apart);
        self.found.retain(|t| *t > step.0 + apart && *t < step.1 - apart);
    }

    fn sample<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        (from, to): (f64, f64),
    ) {
        for (place, part) in PLACES.into_iter().enumerate() {
            let t = if part < 1.0 { from + part * (to - from) } else { to };
            let known = self.observe(equations, method, t);
            for (samples, kink) in self.samples.iter_mut().zip(&self.all) {
                samples[place] = if known { equations.value(&kink.number) } else { f64::NAN };
            }
        }
    }

    /// The values that a number may pass in the step.
    fn take_levels(&mut self, equations: &mut Equations<'_, '_>, index: usize) {
        self.levels.clear();
        let samples = &self.samples[index];
        let least = samples.iter().copied().fold(f64::INFINITY, f64::min);
        let greatest = samples.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let beyond = CLEAR * (greatest - least);
        let kink = &self.all[index];
        if let Some(curve) = &kink.curve {
            if least < greatest {
                curve.function.points_between(least - beyond, greatest + beyond, |x| self.levels.push(x));
            }
        } else if least - beyond <= 0.0 && greatest + beyond >= 0.0 {
            let grows = if self.deep { OF_FORCES } else { OF_MOTION };
            equations.look_at_sizes();
            // what is zero all the time does not pass it
            if greatest.max(-least) > equations.nothing(&kink.number, grows) {
                self.levels.push(0.0);
            }
        }
    }

    fn passes<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        (step, index): ((f64, f64), usize),
        level: f64,
    ) {
        let mut found = std::mem::take(&mut self.found);
        let value = |t: f64| {
            if self.observe(equations, method, t) {
                equations.value(&self.all[index].number) - level
            } else {
                f64::NAN
            }
        };
        let _: ControlFlow<Infallible> = crossings(step, None, value, |crossing| {
            found.push(crossing.t);
            ControlFlow::Continue(())
        });
        self.found = found;
    }

    fn observe<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        t: f64,
    ) -> bool {
        within_step(equations, method, t, &mut self.y) && equations.observe(t, &self.y, self.deep)
    }
}
