//! The choice of the free coordinates: those of the starts, until a group comes near a dead position of them.

use super::change::{CLOSE, FOUND};
use super::chart::{Chart, standing};
use super::equations::Equations;
use super::sliding_sense::Held;
use super::starting;
use crate::answer::{PoseAnswers, WholeCycle};
use crate::model::{Axis, DriveTarget, LinkId, PairId, PairKind};
use crate::position::{Model, Reduced, State, extent, turns};
use std::rc::Rc;

/// Below this |σ| of a group other coordinates are looked for.
pub(super) const CAREFUL: f64 = 0.3;
/// They are taken where bodies move so much less for a unit of them.
const BETTER: f64 = 2.0;
/// Groups without a closed form take so much longer that they count for less.
const ITERATED: f64 = 0.5;
/// So good is good enough.
const GOOD: f64 = 0.5;
/// Choices that are made at once, at most.
const MOST: usize = 24;

/// The choices made so far in all runs of a motion.
pub(super) struct Charts<'w> {
    written: &'w Model<'w>,
    statics: &'w WholeCycle,
    /// Targets of all drives, with the mechanism in these coordinates where they determine it.
    made: Vec<(Vec<DriveTarget>, Option<Rc<Chart>>)>,
}

/// From where a run goes on, in which coordinates.
#[derive(Clone)]
pub(super) struct Change {
    /// None where they are those of the starts.
    pub chart: Option<Rc<Chart>>,
    pub t: f64,
    pub y: Vec<f64>,
    pub state: State,
    pub angles: Vec<f64>,
    /// Stops that are closed.
    pub closed: Vec<usize>,
    /// What friction holds, where every pair that rubs moves in a way of its own.
    pub held: Option<Held>,
    /// The greatest speed of a body for a unit rate of a coordinate.
    speed: f64,
}

impl<'w> Charts<'w> {
    pub const fn new(written: &'w Model<'w>, statics: &'w WholeCycle) -> Self {
        Self { written, statics, made: Vec::new() }
    }

    /// Better coordinates for the place where the last step ended, if there are any.
    pub fn better(&mut self, equations: &Equations<'_, '_>, y: &[f64]) -> Option<Change> {
        let now: Vec<DriveTarget> = equations.model.mechanism.drives.iter().map(|d| d.target).collect();
        let least = 1.0 / speed(equations.model, &equations.reduced);
        let mut best: Option<(f64, Change)> = None;
        let mut fresh = 0;
        for targets in self.choices(equations, &now) {
            let known = self.made.iter().position(|(made, _)| *made == targets);
            fresh += usize::from(known.is_none());
            if fresh > MOST {
                break;
            }
            let chart = self.chart(known, &targets);
            let written = chart.is_none() && self.is_written(&targets);
            if chart.is_none() && !written {
                continue;
            }
            let Some(change) = self.change(equations, y, chart) else { continue };
            let closed = change.chart.as_ref().is_none_or(|chart| chart.is_closed());
            let worth = if closed { 1.0 } else { ITERATED } / change.speed;
            if worth > best.as_ref().map_or(BETTER * least, |best| best.0) {
                best = Some((worth, change));
            }
            if best.as_ref().is_some_and(|best| best.0 >= GOOD) {
                break;
            }
        }
        best.map(|(_, change)| change)
    }

    fn is_written(&self, targets: &[DriveTarget]) -> bool {
        self.written.mechanism.drives.iter().zip(targets).all(|(drive, target)| drive.target == *target)
    }

    fn chart(&mut self, known: Option<usize>, targets: &[DriveTarget]) -> Option<Rc<Chart>> {
        if let Some(known) = known {
            return self.made[known].1.clone();
        }
        let chart =
            if self.is_written(targets) { None } else { Chart::of(self.written, targets).map(Rc::new) };
        self.made.push((targets.to_vec(), chart.clone()));
        chart
    }

    /// What could be driven instead: one of the free coordinates is another that moves more than a unit for a unit of it, those
    /// first that move most.
    fn choices(&self, equations: &Equations<'_, '_>, now: &[DriveTarget]) -> Vec<Vec<DriveTarget>> {
        let mechanism = self.written.mechanism;
        let links = (1..mechanism.links.len()).map(LinkId::at).map(DriveTarget::Link);
        let pairs = (0..mechanism.pairs.len()).map(PairId::at).map(DriveTarget::Pair);
        let places = mechanism.drives.iter().flat_map(|drive| match drive.target {
            DriveTarget::Place(link, at, _) => {
                Axis::BOTH.map(|axis| DriveTarget::Place(link, at, axis)).to_vec()
            }
            _ => Vec::new(),
        });
        let mut others = Vec::new();
        let extent = extent(self.written);
        for target in links.chain(pairs).chain(places).filter(|target| !now.contains(target)) {
            for (coordinate, &drive) in equations.reduced.free().iter().enumerate() {
                let moves = self.moves(equations, coordinate, target);
                let moves = moves / unit(target, extent) * unit(now[drive], extent);
                // what divides by nothing is the greatest there is
                if moves.is_nan() || moves > BETTER {
                    others.push((if moves.is_nan() { f64::INFINITY } else { moves }, drive, target));
                }
            }
        }
        others.sort_by(|a, b| b.0.total_cmp(&a.0));
        let home: Vec<DriveTarget> = mechanism.drives.iter().map(|d| d.target).collect();
        let other = others.into_iter().map(|(_, drive, target)| {
            let mut targets = now.to_vec();
            targets[drive] = target;
            targets
        });
        std::iter::once(home).chain(other).filter(|targets| targets != now).collect()
    }

    /// What a link turns, or a sliding pair slides, for a unit rate of a free coordinate; zero of what is no coordinate.
    fn moves(&self, equations: &Equations<'_, '_>, coordinate: usize, target: DriveTarget) -> f64 {
        let unit = |link: LinkId| equations.reduced.unit_motion(coordinate, link.index());
        match target {
            DriveTarget::Link(link) => unit(link).1.abs(),
            DriveTarget::Pair(pair) => {
                let PairKind::Prismatic(guide) = &self.written.mechanism.pair(pair).kind else { return 0.0 };
                let bodies = &equations.here().1.motion.bodies;
                let place = bodies[guide.slider.index()].position(guide.point);
                let at = |link: LinkId| {
                    let (v, omega) = unit(link);
                    v + (place - bodies[link.index()].p).perp() * omega
                };
                let along = guide.along.turned(bodies[guide.guide.index()].u);
                (at(guide.slider) - at(guide.guide)).dot(along).abs()
            }
            DriveTarget::Place(link, at, axis) => {
                let body = &equations.here().1.motion.bodies[link.index()];
                let (v, omega) = unit(link);
                (v + at.turned(body.u).perp() * omega).dot(axis.unit()).abs()
            }
            DriveTarget::Point(..) => 0.0,
        }
    }

    /// The place where the last step ended in other coordinates.
    fn change(&self, equations: &Equations<'_, '_>, y: &[f64], chart: Option<Rc<Chart>>) -> Option<Change> {
        let (t, here, angles) = equations.here();
        let model = chart.as_deref().map_or(*self.written, Chart::model);
        let view = PoseAnswers::new(&model, here, angles, self.statics);
        let free = equations.reduced.free();
        let n = free.len();
        let mut unknowns = y.to_vec();
        let mut inputs = State { motion: here.motion.clone(), ..State::default() };
        equations.inputs_at(t, y, &mut inputs.motion);
        // what the formulas say there of rates is nothing
        let dead = equations.condition() < FOUND;
        let rests = dead || inputs.motion.inputs.iter().all(|input| input.rate == 0.0);
        for (i, &drive) in free.iter().enumerate() {
            let target = model.mechanism.drives[drive].target;
            let (value, rate, _) = measured(&view, target)?;
            unknowns[i] = value;
            unknowns[n + i] = if rests { 0.0 } else { rate };
        }
        if unknowns.iter().any(|x| !x.is_finite()) {
            return None;
        }
        equations.inputs_at(t, &unknowns, &mut inputs.motion);
        let bodies = &here.motion.bodies;
        let mut state = standing(&model, &inputs, bodies)?;
        let mut moved = state.clone();
        let mut reduced = Reduced::new(model.plan, free.to_vec(), !equations.reduced.is_alone());
        reduced.run_motion(model.plan, &mut moved);
        let speed = speed(&model, &reduced);
        // near a change point others are no better
        let least = if dead { FOUND } else { CLOSE };
        let near = equations.condition() < CLOSE;
        if near && moved.motion.conditions.iter().any(|condition| condition.abs() < least) {
            return None;
        }
        if dead {
            let before = &equations.model.mechanism.drives;
            let before: Vec<DriveTarget> = free.iter().map(|&drive| before[drive].target).collect();
            let given = (self.statics, angles);
            let rates = starting::rates(&model, given, (&reduced, moved), (&before, &y[n..2 * n]))?;
            unknowns[n..2 * n].copy_from_slice(&rates);
            equations.inputs_at(t, &unknowns, &mut state.motion);
        }
        let (angles, closed) = (angles.to_vec(), equations.closed.clone());
        let held = equations.slipping.as_ref().map(|slipping| slipping.held_in(equations.model.plan));
        Some(Change { chart, t, y: unknowns, state, angles, closed, held, speed })
    }
}

impl Change {
    pub fn coordinates(&self, written: &Model<'_>) -> Vec<DriveTarget> {
        let model = self.chart.as_deref().map_or(*written, Chart::model);
        model.mechanism.drives.iter().filter(|d| d.free).map(|d| d.target).collect()
    }
}

/// A unit of a coordinate: an angle of 1, or the extent.
pub(super) const fn unit(target: DriveTarget, extent: f64) -> f64 {
    match target {
        DriveTarget::Pair(_) | DriveTarget::Place(..) => extent,
        DriveTarget::Link(_) | DriveTarget::Point(..) => 1.0,
    }
}

/// The greatest speed of a body for a unit rate of a coordinate: near a dead position of the coordinates it grows beyond all
/// bounds.
fn speed(model: &Model<'_>, reduced: &Reduced) -> f64 {
    let extent = extent(model);
    let drives = &model.mechanism.drives;
    let scales = reduced.free().iter().map(|&drive| if turns(model, &drives[drive]) { 1.0 } else { extent });
    reduced.greatest_speed(extent, scales)
}

/// The coordinate that a drive is at, its rate and its acceleration.
pub(super) fn measured(view: &PoseAnswers<'_>, target: DriveTarget) -> Option<(f64, f64, f64)> {
    Some(match target {
        DriveTarget::Link(link) => {
            let body = &view.state.motion.bodies[link.index()];
            (view.angles[link.index()], body.omega, body.alpha)
        }
        DriveTarget::Pair(pair) => {
            (view.displacement(pair), view.relative_velocity(pair), view.relative_acceleration(pair))
        }
        DriveTarget::Place(link, at, axis) => {
            let body = &view.state.motion.bodies[link.index()];
            let place = [body.position(at), body.velocity(at), body.acceleration(at)];
            let [x, v, a] = place.map(|vector| vector.dot(axis.unit()));
            (x, v, a)
        }
        DriveTarget::Point(..) => return None,
    })
}
