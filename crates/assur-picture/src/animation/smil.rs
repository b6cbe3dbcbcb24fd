//! The mechanism in motion as one picture without a script: every part that moves carries its own `animateTransform`.

use super::moved::{Body, Redrawn};
use super::{Animated, Stage};
use crate::kind::Options;
use crate::scene::Scene;
use crate::wording::Wording;
use assur_drawing::{Theme, number};
use assur_math::math::Vec2;
use assur_text::diagnostic::Diagnosis;
use std::fmt::Write;

/// How long the way takes.
const TIME: &str = "dur=\"6s\" repeatCount=\"indefinite\"";
/// The most frames, where no number is wanted: between them the reader of the picture goes on evenly.
const MOST: usize = 120;

/// The picture, in which the first frame stands where nothing can move.
///
/// # Errors
/// There is no way to go.
pub fn moving(
    scene: &Scene<'_>,
    options: &Options,
    theme: Theme,
    wording: &dyn Wording,
) -> Result<String, Diagnosis> {
    let ways = scene.all_ways();
    let scene = &Scene { ways: &ways, ..*scene };
    let stage = Stage::of(scene, options)?;
    let animated = Animated::of(scene, &stage, options, wording)?;
    let count = animated.frames.len();
    let every = if options.frames.is_some() { 1 } else { count.div_ceil(MOST) };
    let mut out = animated.sheet.svg(theme);
    for (i, body) in animated.moved.bodies.iter().enumerate() {
        let open = format!("<g class=\"m{i}\">");
        out = out.replace(&open, &(open.clone() + &transforms(body, every)));
    }
    for (i, follower) in animated.moved.followers.iter().enumerate() {
        let (open, body) = (format!("<g class=\"f{i}\">"), &animated.moved.bodies[follower.body]);
        let shifts = (0..body.poses.len()).step_by(every).map(|k| body.carried(k, follower.at) - follower.at);
        out = out.replace(&open, &(open.clone() + &shifted(shifts)));
    }
    for (i, label) in animated.faded.iter().enumerate() {
        let shown = label.frames.iter().step_by(every).map(|hidden| if *hidden { "0" } else { "1" });
        let values = shown.collect::<Vec<_>>().join(";");
        let open = format!("<g class=\"v{i}\">");
        let fades =
            format!("<animate attributeName=\"opacity\" calcMode=\"discrete\" {TIME} values=\"{values}\"/>");
        out = out.replace(&open, &(open.clone() + &fades));
    }
    for (i, texts) in animated.moved.redrawn.iter().enumerate() {
        out = shown_in_turn(&out, &format!("<g class=\"r{i}\">"), texts, every);
    }
    Ok(out)
}

/// A turn about the origin of the paper, and then a shift.
fn transforms(body: &Body, every: usize) -> String {
    let poses = || body.poses.iter().step_by(every);
    let mut out = shifted(poses().map(|(at, angle)| *at - body.centre.turned(Vec2::direction(*angle))));
    if body.turns {
        let mut turns = String::new();
        for (_, angle) in poses() {
            let _ = write!(turns, "{};", number(angle.to_degrees()));
        }
        let _ = write!(
            out,
            "<animateTransform attributeName=\"transform\" type=\"rotate\" additive=\"sum\" {TIME} values=\"{}\"/>",
            turns.trim_end_matches(';')
        );
    }
    out
}

fn shifted(shifts: impl Iterator<Item = Vec2>) -> String {
    let mut values = String::new();
    for shift in shifts {
        let _ = write!(values, "{} {};", number(shift.x), number(shift.y));
    }
    let values = values.trim_end_matches(';');
    format!("<animateTransform attributeName=\"transform\" type=\"translate\" {TIME} values=\"{values}\"/>")
}

/// What changes its shape is there once per shape, and each is visible in its frames.
fn shown_in_turn(picture: &str, open: &str, texts: &Redrawn, every: usize) -> String {
    let Some((before, rest)) = picture.split_once(open) else { return picture.to_owned() };
    let Some((_, after)) = rest.split_once("</g>") else { return picture.to_owned() };
    let (known, which) = texts.distinct(every);
    let mut shapes = String::new();
    for (i, text) in known.into_iter().enumerate() {
        let first = if i == 0 { "visible" } else { "hidden" };
        let (mut values, mut times) = (String::new(), String::new());
        let mut shown = None;
        for (frame, index) in which.iter().enumerate() {
            let is_shown = *index == i;
            if shown != Some(is_shown) {
                shown = Some(is_shown);
                let time = frame as f64 / which.len() as f64;
                let _ = write!(values, "{};", if is_shown { "visible" } else { "hidden" });
                let _ = write!(times, "{time:.4};");
            }
        }
        let (values, times) = (values.trim_end_matches(';'), times.trim_end_matches(';'));
        let _ = write!(
            shapes,
            "<g visibility=\"{first}\"><animate attributeName=\"visibility\" calcMode=\"discrete\" {TIME} values=\"{values}\" \
             keyTimes=\"{times}\"/>{text}</g>"
        );
    }
    format!("{before}{open}{shapes}</g>{after}")
}
