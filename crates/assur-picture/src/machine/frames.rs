//! The frames of an animation: the positions of the way that closes, there and back where it is not a turn, or even steps of time where
//! the speeds are all that is known.

use super::{has_shafts_alone, moved_link};
use crate::error;
use crate::inset::wrapped;
use crate::kind::Options;
use crate::no_diagram;
use crate::scene::Scene;
use assur_math::math::Vec2;
use assur_model::model::{DriveTarget, PairKind, Positions};
use assur_solve::answer::NoSweep;
use assur_solve::solve::{Cause, DriveValue, Pose};
use assur_text::diagnostic::Diagnosis;
use std::f64::consts::TAU;

/// The most frames that are shown where their number is not asked for.
const MOST: usize = 400;
/// Frames where the speeds are constant: as many as the fastest wheel needs, which turns by at most this much from one to the next.
const LEAST: usize = 48;
const MOST_STEADY: usize = 360;
const STEP: f64 = 0.2;
/// The most turns of the fastest wheel, and of the slowest until all are where they were.
const TURNS: f64 = 10.0;
const PERIODS: u8 = 6;
/// How far a slider goes in that time, in parts of the radius of the largest wheel.
const TRAVEL: f64 = 2.5;
/// What turns or goes less than this does not move: rad, and parts of the size of all.
const STILL: f64 = 1e-4;

/// Positions in their order.
pub struct Frames {
    pub poses: Vec<Pose>,
    /// By how much the value of the first drive is more than that of its position: whole turns, or what it has gone since.
    pub carried: Vec<f64>,
    /// The position after the last is the first.
    pub closed: bool,
}

/// The frames of a mechanism.
///
/// # Errors
/// There is no way to go, or nothing moves on it.
pub fn frames(scene: &Scene<'_>, options: &Options) -> Result<Frames, Diagnosis> {
    let way = along(scene, options);
    let comes_back = way.as_ref().is_some_and(|frames| !frames.closed || ends_as_it_began(scene, frames));
    let swept = scene.mechanism().drives.iter().any(|d| matches!(d.positions, Positions::Range { .. }));
    let frames = match way {
        Some(frames) if swept || comes_back || scene.mechanism().simulation.is_some() => Some(frames),
        way => steady(scene, options).or(way),
    };
    let cause = Cause::NoSweep(NoSweep::OnePosition);
    let frames = frames.ok_or_else(|| no_diagram::no_sweep(scene, "animation", &cause))?;
    if moves(&frames.poses) { Ok(frames) } else { Err(error::nothing_moves(scene)) }
}

/// The positions of the way of the drive.
fn along(scene: &Scene<'_>, options: &Options) -> Option<Frames> {
    let all = if scene.turn.is_empty() { &scene.solution.poses } else { scene.turn };
    let solved = |pose: &Pose| pose.outcome.is_ok();
    let (places, closed) = if scene.mechanism().simulation.is_some() {
        ((0..all.len()).filter(|i| solved(&all[*i])).map(|i| i as isize).collect(), false)
    } else {
        order(scene, all)
    };
    let most = options.frames.map_or(MOST, |_| usize::MAX);
    let step = places.len().div_ceil(most).max(1);
    let places: Vec<isize> = places.into_iter().step_by(step).collect();
    let count = all.len() as isize;
    let pose = |place: &isize| all[place.rem_euclid(count) as usize].clone();
    let carried = |place: &isize| place.div_euclid(count) as f64 * TAU;
    let (poses, carried) = (places.iter().map(pose).collect(), places.iter().map(carried).collect());
    (places.len() > 1).then_some(Frames { poses, carried, closed })
}

/// The places of positions in the order in which they are shown, beyond the last and before the first where they go on a turn further.
/// Where some do not close: from the position of the scene to the last that does, back to the first, and again.
fn order(scene: &Scene<'_>, all: &[Pose]) -> (Vec<isize>, bool) {
    let count = all.len() as isize;
    let is_turn = is_turn(all);
    let closes = |place: isize| {
        let inside = is_turn || (0..count).contains(&place);
        inside && all[place.rem_euclid(count) as usize].outcome.is_ok()
    };
    let goes_back = goes_back(scene, all);
    if (0..count).all(closes) {
        let way = (0..count).map(|i| match (goes_back, is_turn) {
            (false, _) => i,
            // from the same position where it comes back to it
            (true, true) => -i,
            (true, false) => count - 1 - i,
        });
        return (way.collect(), is_turn);
    }
    let here =
        |i: &isize| value(&all[*i as usize]).zip(value(scene.pose)).map_or(f64::MAX, |(a, b)| (a - b).abs());
    let starts = (0..count).filter(|i| closes(*i)).min_by(|a, b| here(a).total_cmp(&here(b)));
    let Some(start) = starts else { return (Vec::new(), false) };
    let sense = if goes_back { -1 } else { 1 };
    let last = |sense: isize| {
        (0..count).map(|i| start + sense * i).take_while(|i| closes(*i)).last().unwrap_or(start)
    };
    let (there, back) = (last(sense), last(-sense));
    let between = |from: isize, to: isize| {
        let step = if to < from { -1 } else { 1 };
        (0..(to - from).abs()).map(move |i| from + step * i)
    };
    (between(start, there).chain(between(there, back)).chain(between(back, start)).collect(), false)
}

/// The value of the first drive.
fn value(pose: &Pose) -> Option<f64> {
    match pose.drives.first() {
        Some(DriveValue::Scalar(x)) => Some(*x),
        _ => None,
    }
}

/// Whether the drive moves against the order of the positions.
fn goes_back(scene: &Scene<'_>, all: &[Pose]) -> bool {
    let (Some(first), Some(second)) = (all.first(), all.get(1)) else { return false };
    let senses = scene.mechanism().drives.iter().enumerate().filter_map(|(i, drive)| {
        let value = |pose: &Pose| match pose.drives.get(i) {
            Some(DriveValue::Scalar(x)) => Some(*x),
            _ => None,
        };
        let way = value(second)? - value(first)?;
        let speed = drive.speed.as_ref().map(|e| scene.view().scalar(e)).or(drive.sense)?;
        Some(way * speed).filter(|sense| *sense != 0.0)
    });
    senses.into_iter().next().is_some_and(|sense| sense < 0.0)
}

/// Whether the position after the last is the first again.
fn is_turn(all: &[Pose]) -> bool {
    let along = |i: usize| all.get(i).and_then(value);
    let (Some(a), Some(b), Some(last)) = (along(0), along(1), along(all.len() - 1)) else { return false };
    let (step, left) = (b - a, wrapped(a - last));
    wrapped(step - left).abs() < 0.5 * step.abs()
}

/// Whether all bodies are after the last frame where they were in the first, as far as the step before shows.
fn ends_as_it_began(scene: &Scene<'_>, frames: &Frames) -> bool {
    let at = |i: usize| frames.poses.get(i).and_then(|pose| pose.outcome.as_ref().ok());
    let (Some(a), Some(b), Some(last)) = (at(0), at(1), at(frames.poses.len() - 1)) else { return false };
    (1..scene.mechanism().links.len()).all(|i| {
        let [a, b, last] = [a, b, last].map(|solved| &solved.state.motion.bodies[i]);
        let turn = |from: Vec2, to: Vec2| libm::atan2(from.cross(to), from.dot(to)).abs();
        let gap = |from: Vec2, to: Vec2| (to - from).norm();
        turn(last.u, a.u) <= 2.0 * turn(a.u, b.u) + STILL && gap(last.p, a.p) <= 2.0 * gap(a.p, b.p) + 1e-9
    })
}

/// Even steps of time at constant speeds, of shafts and sliders alone.
fn steady(scene: &Scene<'_>, options: &Options) -> Option<Frames> {
    let mechanism = scene.mechanism();
    let links = 1..mechanism.links.len();
    if mechanism.simulation.is_some() || !has_shafts_alone(mechanism) {
        return None;
    }
    let bodies = &scene.solved.state.motion.bodies;
    let omega: Vec<f64> = links.map(|i| bodies[i].omega).collect();
    let sliders = mechanism.pairs.iter().filter_map(|pair| match &pair.kind {
        PairKind::Prismatic(g) => Some(bodies[g.slider.index()].v.norm()),
        _ => None,
    });
    let fastest_slider = sliders.filter(|v| v.is_finite()).fold(0.0, f64::max);
    let largest = mechanism.wheels.iter().map(|w| w.radius).fold(0.0, f64::max);
    let most =
        if fastest_slider > 0.0 && largest > 0.0 { TRAVEL * largest / fastest_slider } else { f64::INFINITY };
    let (time, closed) = match period(&omega) {
        Some(time) if time <= most => (time, true),
        Some(_) | None if most.is_finite() => (most, false),
        other => (other?, true),
    };
    let fastest = omega.iter().map(|omega| omega.abs()).fold(0.0, f64::max);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // bounded
    let needed = (fastest * time / STEP).min(MOST_STEADY as f64) as usize;
    let count = options.frames.unwrap_or(needed.max(LEAST)).max(2);
    let carries = mechanism.drives.first().map_or(0.0, |drive| match drive.target {
        DriveTarget::Link(link) => scene.body(link).omega,
        DriveTarget::Pair(pair) => match &mechanism.pair(pair).kind {
            PairKind::Prismatic(g) => scene.body(g.slider).v.x,
            kind => scene.body(moved_link(kind)).omega,
        },
        DriveTarget::Point(..) | DriveTarget::Place(..) => 0.0,
    });
    let at = |i: usize| time * i as f64 / count as f64;
    let poses = (0..count).map(|i| moved_by(scene, at(i))).collect();
    Some(Frames { poses, carried: (0..count).map(|i| carries * at(i)).collect(), closed })
}

/// The position of a scene after a time at its speeds, s.
fn moved_by(scene: &Scene<'_>, time: f64) -> Pose {
    let mut pose = scene.pose.clone();
    if let Ok(solved) = &mut pose.outcome {
        for (i, body) in solved.state.motion.bodies.iter_mut().enumerate().skip(1) {
            let angle = body.omega * time;
            if angle.is_finite() {
                body.u = body.u.turned(Vec2::direction(angle));
                body.turned += angle;
                if let Some(own) = solved.angles.get_mut(i) {
                    *own += angle;
                }
            }
        }
        for pair in &scene.mechanism().pairs {
            if let PairKind::Prismatic(g) = &pair.kind {
                let body = &mut solved.state.motion.bodies[g.slider.index()];
                body.p += body.v * time;
            }
        }
    }
    pose
}

/// How long the motion takes that is shown, s: until all wheels are where they were, else a turn of the slowest; none where nothing
/// turns.
fn period(omega: &[f64]) -> Option<f64> {
    let speeds = || omega.iter().map(|omega| omega.abs()).filter(|omega| *omega > 0.0 && omega.is_finite());
    let (slowest, fastest) = (speeds().fold(f64::INFINITY, f64::min), speeds().fold(0.0, f64::max));
    if fastest == 0.0 {
        return None;
    }
    let turn = TAU / slowest;
    let comes_back = |time: &f64| {
        let whole = |omega: f64| (omega * time / TAU - (omega * time / TAU).round()).abs() < 1e-6;
        speeds().all(whole) && fastest * time <= 2.0 * TURNS * TAU
    };
    let periods = (1..=PERIODS).map(|turns| f64::from(turns) * turn);
    Some(periods.into_iter().find(comes_back).unwrap_or_else(|| turn.min(TURNS * TAU / fastest)))
}

/// Whether a body is elsewhere in some frame.
fn moves(poses: &[Pose]) -> bool {
    let bodies = |pose: &Pose| pose.outcome.as_ref().ok().map(|solved| solved.state.motion.bodies.clone());
    let Some(first) = poses.first().and_then(bodies) else { return false };
    let others: Vec<_> = poses.iter().filter_map(bodies).collect();
    let size =
        others.iter().flatten().map(|body| body.p.norm()).filter(|r| r.is_finite()).fold(0.0, f64::max);
    others.iter().any(|frame| {
        let pairs = first.iter().zip(frame);
        pairs.into_iter().any(|(a, b)| {
            (b.u - a.u).norm() > STILL
                || (b.turned - a.turned).abs() > STILL
                || (b.p - a.p).norm() > STILL * size
        })
    })
}
