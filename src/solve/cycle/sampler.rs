//! Solves the mechanism anywhere on the sweep.

use super::super::assemble::assemble;
use super::super::error::SolveError;
use super::super::extremes::Statics;
use super::super::inputs::Rates;
use super::super::pose::{DEAD, balanced};
use super::super::solution::Scene;
use super::super::state::{BodyState, Branch, State};
use super::super::track::{Tracker, continued, extent, steps};
use super::super::view::View;
use super::answer::Undefined;
use super::hangs_on_forces;
use super::way::Way;
use crate::model::{Expr, LoadId, Query, Value};
use crate::plan::Level;

/// The fewest intervals between places where the mechanism is known beforehand.
const FEWEST: f64 = 64.0;

/// A place where the mechanism is known: its assemblies, its bodies and their angles.
struct Anchor {
    branches: Vec<Branch>,
    bodies: Vec<BodyState>,
    angles: Vec<f64>,
}

/// Solves the mechanism at places of the sweep.
pub(super) struct Sampler<'a> {
    scene: Scene<'a>,
    /// The sweep.
    pub way: &'a Way,
    rates: Rates,
    anchors: Vec<Anchor>,
    /// Intervals between the anchors of the whole sweep.
    intervals: f64,
    state: State,
    angles: Vec<f64>,
    evaluated: Vec<(LoadId, Value)>,
    quantities: Vec<Value>,
    ideal: Option<(State, Vec<Value>)>,
    forces: bool,
    with_ideal: bool,
    with_quantities: bool,
    /// Beyond this place the mechanism does not close.
    open: Option<f64>,
    last: Option<f64>,
    /// Positions solved since `begin`.
    pub samples: usize,
}

impl<'a> Sampler<'a> {
    /// Follows the sweep once, in small steps.
    pub(super) fn new(scene: &Scene<'a>, statics: &Statics, way: &'a Way) -> Result<Self, SolveError> {
        let rates = Rates::of(scene, statics);
        let mut state = State::new(scene.plan);
        rates.at(&way.from, &mut state.inputs);
        let state = assemble(scene, state)?;
        let mut tracker = Tracker::new(scene, state.clone(), &way.from);
        let count = steps(scene, extent(scene), &way.from, &way.to).max(FEWEST);
        let anchor = |tracker: &Tracker| Anchor {
            branches: tracker.state.branches.clone(),
            bodies: tracker.state.bodies.clone(),
            angles: tracker.angles.clone(),
        };
        let mut anchors = vec![anchor(&tracker)];
        let mut open = None;
        let mut done = 0.0;
        while done < count {
            done += 1.0;
            if tracker.go(scene, &rates, &way.values(done / count)).is_err() {
                open = Some(done / count);
                break;
            }
            anchors.push(anchor(&tracker));
        }
        Ok(Self {
            scene: *scene,
            way,
            rates,
            anchors,
            intervals: count,
            angles: tracker.angles,
            state,
            evaluated: Vec::new(),
            quantities: Vec::new(),
            ideal: None,
            forces: false,
            with_ideal: false,
            with_quantities: false,
            open,
            last: None,
            samples: 0,
        })
    }

    /// Whether the bodies stand at the sweep's end as at its beginning.
    pub(super) fn comes_again(&self) -> bool {
        let (Some(first), Some(last)) = (self.anchors.first(), self.anchors.last()) else { return false };
        let near = 1e-9 * extent(&self.scene);
        let mut bodies = first.bodies.iter().zip(&last.bodies);
        bodies.all(|(a, b)| (a.p - b.p).norm() <= near && (a.u - b.u).norm() <= 1e-9)
    }

    /// Intervals between equally spaced places where the mechanism is known beforehand.
    pub(super) fn intervals(&self) -> f64 {
        self.intervals
    }

    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // from 0 to 20,000
    fn nearest(&self, s: f64) -> usize {
        let index = (s * self.intervals).round().max(0.0) as usize;
        index.min(self.anchors.len() - 1)
    }

    /// What is computed from now on: as much as these expressions need.
    pub(super) fn begin(&mut self, exprs: &[&Expr]) {
        let (scene, mechanism) = (self.scene, self.scene.mechanism);
        self.forces = exprs.iter().any(|e| hangs_on_forces(mechanism, e));
        self.with_quantities = !mechanism.quantities.is_empty();
        self.with_ideal = self.forces && scene.plan.effects.friction && asks_for_ideal(&scene);
        self.samples = 0;
        self.last = None;
    }

    /// The value of a number at a place of the sweep.
    pub(super) fn sample(&mut self, statics: &Statics, s: f64, expr: &Expr) -> Result<f64, Undefined> {
        match self.value(statics, s, expr)? {
            Value::Scalar(x) if x.is_finite() => Ok(x),
            _ => Err(Undefined::At(s)),
        }
    }

    /// The value of an expression at a place of the sweep.
    pub(super) fn value(&mut self, statics: &Statics, s: f64, expr: &Expr) -> Result<Value, Undefined> {
        if self.last != Some(s) {
            self.last = None;
            self.solve(statics, s)?;
            self.last = Some(s);
        }
        let ideal = self.ideal.as_ref().map(|(state, values)| (state, values.as_slice()));
        let view = View::new(&self.scene, &self.state, &self.angles, statics);
        Ok(View { quantities: &self.quantities, frictionless: ideal, ..view }.value(expr))
    }

    fn solve(&mut self, statics: &Statics, s: f64) -> Result<(), Undefined> {
        if self.open.is_some_and(|open| s >= open) {
            return Err(Undefined::Open(s));
        }
        self.samples += 1;
        let scene = self.scene;
        self.start(s);
        match scene.plan.effects.level {
            Level::Positions => self.state.run_motion::<0>(scene.plan),
            Level::Velocities => self.state.run_motion::<1>(scene.plan),
            Level::Accelerations => self.state.run_motion::<2>(scene.plan),
        }
        if self.state.open.is_some() {
            return Err(Undefined::Open(s));
        }
        let singular = |sines: &[f64]| sines.iter().any(|sine| sine.abs() <= DEAD);
        if scene.plan.effects.level > Level::Positions && singular(&self.state.sines) {
            return Err(Undefined::At(s));
        }
        let known = &self.anchors[self.nearest(s)].bodies;
        for (angle, (body, known)) in self.angles.iter_mut().zip(self.state.bodies.iter().zip(known)) {
            *angle = continued(*angle, known.u, body.u);
        }
        if self.forces {
            balanced(&scene, statics, &mut self.state, &self.angles, &mut self.evaluated);
            if self.state.locked {
                return Err(Undefined::Locked(s));
            }
            if singular(&self.state.force_sines) {
                return Err(Undefined::At(s));
            }
        }
        self.ideal = self.with_ideal.then(|| {
            let mut state = self.state.clone();
            state.wrenches.clone_from(&state.applied);
            state.frictions.fill(0.0);
            state.run_forces_without_friction(scene.plan);
            let values = View::new(&scene, &state, &self.angles, statics).all_quantities();
            (state, values)
        });
        if self.with_quantities {
            let ideal = self.ideal.as_ref().map(|(state, values)| (state, values.as_slice()));
            let view = View::new(&scene, &self.state, &self.angles, statics);
            self.quantities = View { frictionless: ideal, ..view }.all_quantities();
        }
        Ok(())
    }

    /// Puts the state at the nearest place that is known, with the drives where they are asked for.
    fn start(&mut self, s: f64) {
        let anchor = &self.anchors[self.nearest(s)];
        self.state.branches.clone_from_slice(&anchor.branches);
        self.state.bodies.clone_from_slice(&anchor.bodies);
        self.angles.clone_from_slice(&anchor.angles);
        self.state.open = None;
        self.state.locked = false;
        self.rates.at(&self.way.values(s), &mut self.state.inputs);
    }
}

/// Whether the file asks anywhere for what it would be without friction.
fn asks_for_ideal(scene: &Scene<'_>) -> bool {
    let mechanism = scene.mechanism;
    let exprs = mechanism.quantities.iter().map(|q| &q.expr).chain(mechanism.cycles.iter().map(|c| &c.expr));
    let mut asked = false;
    for expr in exprs {
        expr.parts(&mut |part| {
            asked |= matches!(part, Expr::Frictionless(_) | Expr::Query(Query::Efficiency | Query::Locked));
        });
    }
    asked
}
