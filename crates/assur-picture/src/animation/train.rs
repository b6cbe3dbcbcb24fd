//! Trains that turn: their front view at each frame of their motion, or at even steps of time where the speeds are all that is known.

use crate::kind::Options;
use crate::scene::Scene;
use crate::train::FrontView;
use assur_drawing::Drawing;
use assur_model::model::LinkId;
use std::f64::consts::TAU;

/// Frames where the speeds are constant: as many as the fastest wheel needs, which turns by at most this much from one to the next.
const LEAST: usize = 48;
const MOST: usize = 360;
const STEP: f64 = 0.2;
/// The most turns of the fastest wheel, and of the slowest until all are where they were.
const TURNS: f64 = 10.0;
const PERIODS: u8 = 6;

/// The frames of a train without places and what each shows; none where its front view does not show all of it.
pub fn turning<'a>(scene: &Scene<'a>, options: &Options) -> Option<(Vec<Scene<'a>>, Vec<Drawing>)> {
    let count = scene.mechanism().links.len();
    if (1..count).any(|i| scene.is_placed(LinkId::at(i))) {
        return None;
    }
    let view = FrontView::of(scene)?;
    if let Ok(frames) = super::frames(scene, options) {
        let angles = |frame: &Scene<'_>| (0..count).map(|i| frame.body(LinkId::at(i)).u.angle()).collect();
        let schemes = frames.iter().map(|frame| view.turned(scene, angles(frame))).collect();
        return Some((frames, schemes));
    }
    let omega: Vec<f64> = (0..count).map(|i| scene.body(LinkId::at(i)).omega).collect();
    let time = period(&omega)?;
    let fastest = omega.iter().map(|omega| omega.abs()).fold(0.0, f64::max);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // bounded
    let needed = (fastest * time / STEP).min(MOST as f64) as usize;
    let frames = options.frames.unwrap_or(needed.max(LEAST)).max(2);
    let schemes = (0..frames).map(|i| {
        let part = time * i as f64 / frames as f64;
        view.turned(scene, omega.iter().map(|omega| omega * part).collect())
    });
    Some((vec![*scene; frames], schemes.collect()))
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
