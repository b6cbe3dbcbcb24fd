//! Events of a run, and functions over it.

use super::equations::Equations;
use super::records::within_step;
use crate::math::chebyshev::{NODES, Nodes};
use crate::math::ode::Integrator;
use crate::math::ode::event::{Crossing, first_crossing};
use crate::model::{Cycle, CycleFunction, Event, Expr, Level, Mechanism, PairKind, Query};

/// Events nearer to each other than this part of the run happen at once.
pub(super) const AT_ONCE: f64 = 1e-12;

/// What is looked at within every step.
pub(super) struct Watch<'m> {
    events: &'m [Event],
    functions: Vec<Function<'m>>,
    /// Something looked at depends on accelerations or forces.
    deep: bool,
    /// Something looked at may come again with the turns of a body, however smooth its speed is.
    pub comes_again: bool,
    nodes: Nodes,
    /// Instants of every event, s.
    pub times: Vec<Vec<f64>>,
    /// The way in which an event was passed where the present step begins.
    passed: Vec<Option<bool>>,
    y: Vec<f64>,
    /// The length of the run, s.
    length: f64,
    begin: f64,
}

/// A function over the run as far as it is known.
struct Function<'m> {
    cycle: &'m Cycle,
    /// Integral, or the extreme.
    value: f64,
    /// Where the extreme is, s.
    at: f64,
    greatest: f64,
}

/// What ends a step early.
pub(super) struct Happened {
    /// The instant, s.
    pub time: f64,
    /// The events that happen there.
    events: Vec<(usize, bool)>,
}

impl<'m> Watch<'m> {
    pub fn new(mechanism: &'m Mechanism, unknowns: usize, (begin, end): (f64, f64)) -> Self {
        let asked = mechanism.cycles.iter().map(|cycle| Function {
            cycle,
            value: match cycle.how {
                CycleFunction::Max | CycleFunction::Argmax => f64::NEG_INFINITY,
                CycleFunction::Min => f64::INFINITY,
                CycleFunction::Mean | CycleFunction::Integral => 0.0,
            },
            at: f64::NAN,
            greatest: 0.0,
        });
        let functions: Vec<Function<'m>> = asked.collect();
        let events = mechanism.events.iter().map(|event| &event.value);
        let all = events.chain(functions.iter().map(|f| &f.cycle.expr));
        let all: Vec<&Expr> = all.collect();
        let deep = all.iter().any(|expr| is_deep(mechanism, expr));
        let comes_again =
            (!all.is_empty() && is_linkage(mechanism)) || all.iter().any(|expr| comes_again(mechanism, expr));
        let count = mechanism.events.len();
        Self {
            events: &mechanism.events,
            functions,
            deep,
            comes_again,
            nodes: Nodes::new(),
            times: vec![Vec::new(); count],
            passed: vec![None; count],
            y: vec![0.0; unknowns],
            length: end - begin,
            begin,
        }
    }

    /// The first events within the last step.
    pub fn first<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
    ) -> Option<Happened> {
        let mut found: Vec<(usize, Crossing<f64>)> = Vec::new();
        for index in 0..self.events.len() {
            let (value, way) = (&self.events[index].value, self.events[index].rising);
            let step = (method.previous_t(), method.t());
            let passed = self.passed[index];
            let crossing = self.crossing(equations, method, value, step, passed);
            // the other way does not count, but what follows it in the same step may
            let counted = crossing.and_then(|crossing| {
                if way.is_none_or(|rising| rising == crossing.rising) {
                    return Some(crossing);
                }
                let rest = (crossing.t, step.1);
                self.crossing(equations, method, value, rest, Some(crossing.rising))
            });
            found.extend(counted.map(|crossing| (index, crossing)));
        }
        let time = found.iter().map(|(_, crossing)| crossing.t).fold(f64::INFINITY, f64::min);
        let at_once = |crossing: &Crossing<f64>| crossing.t - time <= AT_ONCE * self.length;
        let events = found.iter().filter(|(_, c)| at_once(c)).map(|(i, c)| (*i, c.rising)).collect();
        time.is_finite().then_some(Happened { time, events })
    }

    fn crossing<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        value: &Expr,
        step: (f64, f64),
        passed: Option<bool>,
    ) -> Option<Crossing<f64>> {
        first_crossing(step, passed, |t| self.value(equations, method, t, value))
    }

    fn value<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        t: f64,
        expr: &Expr,
    ) -> f64 {
        let known =
            within_step(equations, method, t, &mut self.y) && equations.observe(t, &self.y, self.deep);
        if known { equations.value(expr) } else { f64::NAN }
    }

    /// From here nothing moves: what is zero stays so and was not passed.
    pub fn rests(&mut self) {
        self.passed.fill(None);
    }

    /// How often every event has happened.
    pub fn counts(&self) -> Vec<usize> {
        self.times.iter().map(Vec::len).collect()
    }

    /// A step has ended, at events or not. Returns the event that ends the run.
    pub fn look<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        happened: Option<Happened>,
    ) -> Option<usize> {
        self.functions_in(equations, method);
        self.passed.fill(None);
        let mut ends = None;
        for (index, rising) in happened.into_iter().flat_map(|h| h.events) {
            // at rest a value stays where it is
            self.passed[index] = Some(rising);
            self.times[index].push(method.t());
            if self.events[index].ends {
                ends = ends.or(Some(index));
            }
        }
        ends
    }

    fn functions_in<M: Integrator<f64>>(&mut self, equations: &mut Equations<'_, '_>, method: &mut M) {
        if self.functions.is_empty() {
            return;
        }
        let (from, to) = (method.previous_t(), method.t());
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
        for ((function, values), ends) in self.functions.iter_mut().zip(&values).zip(&ends) {
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
    }

    /// The functions over the run up to its end, each with the greatest magnitude in play.
    pub fn functions(&self, end: f64) -> Vec<(f64, f64)> {
        let value = |f: &Function<'_>| match f.cycle.how {
            CycleFunction::Mean => f.value / (end - self.begin),
            CycleFunction::Argmax => f.at,
            CycleFunction::Max | CycleFunction::Min | CycleFunction::Integral => f.value,
        };
        let scale = |f: &Function<'_>| match f.cycle.how {
            CycleFunction::Argmax => end - self.begin,
            CycleFunction::Integral => f.greatest * (end - self.begin),
            CycleFunction::Max | CycleFunction::Min | CycleFunction::Mean => f.greatest,
        };
        self.functions.iter().map(|f| (value(f), scale(f))).collect()
    }
}

/// Whether links join moving links: then rates go with angles.
fn is_linkage(mechanism: &Mechanism) -> bool {
    let mut joined = vec![false; mechanism.links.len()];
    let pairs = mechanism.pairs.iter().filter(|pair| !matches!(pair.kind, PairKind::Transmission(_)));
    let mut links = pairs.flat_map(|pair| pair.kind.links()).filter(|link| link.index() > 0);
    links.any(|link| std::mem::replace(&mut joined[link.index()], true))
}

/// Whether a value is of anything but speeds, angles and their sums and products.
fn comes_again(mechanism: &Mechanism, expr: &Expr) -> bool {
    let mut again = false;
    expr.parts(&mut |part| match part {
        Expr::Query(query) => {
            again |= !matches!(
                query,
                Query::Omega(_)
                    | Query::Alpha(_)
                    | Query::Angle(_)
                    | Query::Time
                    | Query::KineticEnergy
                    | Query::LoadPower(_)
            );
        }
        Expr::Quantity(id) => again |= comes_again(mechanism, &mechanism.quantities[id.index()].expr),
        Expr::Call(..) | Expr::Curve(..) => again = true,
        _ => {}
    });
    again
}

/// Whether a value depends on accelerations or forces.
fn is_deep(mechanism: &Mechanism, expr: &Expr) -> bool {
    let mut deep = false;
    expr.parts(&mut |part| match part {
        Expr::Query(query) => {
            let facts = query.facts();
            deep |= facts.forces || facts.level > Level::Velocities;
        }
        Expr::Quantity(id) => deep |= is_deep(mechanism, &mechanism.quantities[id.index()].expr),
        _ => {}
    });
    deep
}
