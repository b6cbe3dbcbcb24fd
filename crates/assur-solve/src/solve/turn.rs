//! One turn of the drive: where the coordinates of pairs turn back.

use super::assemble::assemble;
use super::failure::Cause;
use super::gap::TurnGap;
use super::inputs::Rates;
use super::track::Tracker;
use crate::answer::{Extremes, PoseAnswers, WholeCycle};
use crate::math::ROUNDING;
use crate::model::PairId;
use crate::position::{BodyState, Branch, DriveValue, Model, State};
use std::f64::consts::TAU;

/// Why there is no turn.
pub(super) enum NoTurn {
    /// The first position has several assemblies, or none that is as the hints say.
    NotAssembled(Box<Cause>),
    /// Over the turn.
    Open {
        /// The ends of a range of drive values that close, where one does.
        limit: Option<[f64; 2]>,
        /// Where it is farthest from closing.
        gap: Option<TurnGap>,
    },
}

/// One turn of the drive, sampled with unit speed.
pub(super) struct Turn {
    pairs: Vec<PairId>,
    samples: Vec<Sample>,
    /// A state of the mechanism, to go on from.
    state: State,
}

struct Sample {
    at: f64,
    branches: Vec<Branch>,
    bodies: Vec<BodyState>,
    angles: Vec<f64>,
    /// Coordinate of each pair and its derivative with respect to the drive.
    seen: Vec<(f64, f64)>,
}

/// Samples per turn: no coordinate of a common mechanism turns back twice within two degrees.
const SAMPLES: usize = 180;

impl Turn {
    /// Follows the drive over a turn and looks at the coordinates of these pairs.
    pub(crate) fn new(model: &Model<'_>, pairs: &[PairId]) -> Result<Self, NoTurn> {
        let rates = Rates::unit(model);
        let mut start = State::new(model.plan);
        let values = [DriveValue::Scalar(0.0)];
        rates.at(&values, &mut start.motion.inputs);
        let mut state = assemble(model, start).map_err(|cause| match cause.is_open() {
            true => NoTurn::Open { limit: range(model, &rates), gap: widest(model, &rates) },
            false => NoTurn::NotAssembled(Box::new(cause)),
        })?;
        let first = Tracker::new(model, state.clone(), &values);
        let mut tracker = Tracker::new(model, state.clone(), &values);
        let mut samples = Vec::with_capacity(SAMPLES + 1);
        for i in 0..=SAMPLES {
            #[allow(clippy::cast_precision_loss)] // at most 180
            let at = TAU * i as f64 / SAMPLES as f64;
            let target = [DriveValue::Scalar(at)];
            if i > 0 && tracker.advance_to(model, &rates, &target).is_err() {
                let limit = Some(ends(model, &rates, &first, 0.0));
                return Err(NoTurn::Open { limit, gap: widest(model, &rates) });
            }
            state.start_from(&tracker.state);
            rates.at(&target, &mut state.motion.inputs);
            state.run_motion::<1>(model.plan);
            let angles = tracker.angles.clone();
            let seen = pairs.iter().map(|pair| seen(model, &state, &angles, *pair)).collect();
            let (branches, bodies) = (state.branches.clone(), state.motion.bodies.clone());
            samples.push(Sample { at, branches, bodies, angles, seen });
        }
        Ok(Self { pairs: pairs.to_vec(), samples, state })
    }

    /// Extremes of the coordinate of a pair, by its number; `None` where it does not go to and fro.
    pub(super) fn extremes(&self, model: &Model<'_>, pair: usize) -> Option<Extremes> {
        let fastest = self.samples.iter().map(|sample| sample.seen[pair].1.abs()).fold(0.0, f64::max);
        let is_zero = |rate: f64| rate.abs() <= ROUNDING * fastest;
        let mut found: Vec<(f64, f64)> = Vec::new();
        for two in self.samples.windows(2) {
            let [a, b] = two else { continue };
            let (coordinate, rate_a) = a.seen[pair];
            let (_, rate_b) = b.seen[pair];
            if is_zero(rate_a) {
                found.push((a.at, coordinate));
            } else if rate_a * rate_b < 0.0 && !is_zero(rate_b) {
                found.push(self.refine(model, a, b.at, [rate_a, rate_b], self.pairs[pair]));
            }
        }
        let least = found.iter().copied().min_by(|x, y| x.1.total_cmp(&y.1))?;
        let greatest = found.iter().copied().max_by(|x, y| x.1.total_cmp(&y.1))?;
        if greatest.1 <= least.1 {
            return None;
        }
        Some(Extremes {
            least: least.1,
            greatest: greatest.1,
            at_least: least.0.rem_euclid(TAU),
            at_greatest: greatest.0.rem_euclid(TAU),
        })
    }

    /// The root of the derivative behind a sample: drive value and coordinate.
    fn refine(&self, model: &Model<'_>, a: &Sample, end: f64, ends: [f64; 2], pair: PairId) -> (f64, f64) {
        let rates = Rates::unit(model);
        let mut state = self.state.clone();
        state.branches.clone_from(&a.branches);
        state.motion.bodies.clone_from(&a.bodies);
        let mut at = |x: f64| {
            rates.at(&[DriveValue::Scalar(x)], &mut state.motion.inputs);
            state.run_motion::<1>(model.plan);
            // within two degrees no angle turns by half a turn
            let angles: Vec<f64> = state
                .motion
                .bodies
                .iter()
                .zip(a.bodies.iter().zip(&a.angles))
                .map(|(new, (old, angle))| angle + libm::atan2(old.u.cross(new.u), old.u.dot(new.u)))
                .chain(a.angles[a.bodies.len()..].iter().copied())
                .collect();
            seen(model, &state, &angles, pair)
        };
        let x = crate::math::root(a.at, end, ends[0], ends[1], |x| at(x).1);
        (x, at(x).0)
    }
}

/// Steps of a turn in which a position that closes is sought.
const SOUGHT: i32 = 36;

/// The ends of the first range that closes.
fn range(model: &Model<'_>, rates: &Rates) -> Option<[f64; 2]> {
    (1..SOUGHT).find_map(|i| {
        let at = TAU * f64::from(i) / f64::from(SOUGHT);
        let state = assembled(model, rates, at).ok()?;
        Some(ends(model, rates, &Tracker::new(model, state, &[DriveValue::Scalar(at)]), at))
    })
}

fn assembled(model: &Model<'_>, rates: &Rates, at: f64) -> Result<State, Cause> {
    let mut start = State::new(model.plan);
    rates.at(&[DriveValue::Scalar(at)], &mut start.motion.inputs);
    assemble(model, start)
}

/// Halvings of the step around the widest gap: enough for all digits that the message shows.
const HALVINGS: i32 = 12;

/// Where the first group that stays open over the turn is farthest from closing.
fn widest(model: &Model<'_>, rates: &Rates) -> Option<TurnGap> {
    let open = |at: f64| match assembled(model, rates, at) {
        Err(Cause::DoesNotClose { group, gap }) => gap.missing().map(|far| (far, TurnGap { at, group, gap })),
        _ => None,
    };
    let wider = |a: (f64, TurnGap), b: (f64, TurnGap)| {
        let is_wider = b.1.group < a.1.group || b.1.group == a.1.group && b.0 > a.0;
        if is_wider { b } else { a }
    };
    let mut step = TAU / f64::from(SOUGHT);
    let mut best = (0..SOUGHT).filter_map(|i| open(step * f64::from(i))).reduce(wider)?;
    for _ in 0..HALVINGS {
        step /= 2.0;
        let beside = [best.1.at - step, best.1.at + step];
        best = beside.into_iter().filter_map(open).fold(best, wider);
    }
    Some(best.1)
}

/// How far the mechanism closes on both sides of a position.
fn ends(model: &Model<'_>, rates: &Rates, from: &Tracker, at: f64) -> [f64; 2] {
    [-TAU, TAU].map(|way| {
        let limit = from.clone().limit(model, rates, &[DriveValue::Scalar(at + way)]);
        match limit.first() {
            Some(DriveValue::Scalar(x)) => *x,
            _ => at,
        }
    })
}

/// Coordinate and its derivative with respect to the drive.
fn seen(model: &Model<'_>, state: &State, angles: &[f64], pair: PairId) -> (f64, f64) {
    let statics = WholeCycle::EMPTY;
    let view = PoseAnswers::new(model, state, angles, &statics);
    (view.displacement(pair), view.relative_velocity(pair))
}
