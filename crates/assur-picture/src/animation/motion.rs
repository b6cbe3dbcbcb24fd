//! How the parts of a picture move, as data for the player: whole numbers of all frames as text.

use super::arrows::{ArrowKind, Arrows, arrows};
use super::moved::{Body, Redrawn};
use super::values::{Column, columns, said};
use super::{Animated, Stage};
use crate::kind::Options;
use crate::plot::{Curves, plot};
use crate::scene::Scene;
use crate::wording::Wording;
use assur_drawing::{Theme, escaped, number};
use assur_math::math::Vec2;
use assur_text::diagnostic::Diagnosis;
use serde::Serialize;
use std::fmt::Write;

/// Steps of a millimetre and of a radian.
const STEPS: (f64, f64) = (100.0, 18_000.0 / std::f64::consts::PI);

/// A picture that the player moves: `player.js` says what each part is.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Moving {
    pub title: String,
    /// The picture, the bar, the values and the plot, as HTML.
    pub markup: String,
    /// Nothing where it stands still.
    pub motion: Option<Motion>,
}

/// How it moves.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Motion {
    frames: usize,
    decimal: char,
    series: Vec<String>,
    bodies: Vec<Vec<f64>>,
    followers: Vec<(f64, f64, usize)>,
    redrawn: Vec<(Vec<String>, String)>,
    faded: Vec<String>,
    values: Vec<(String, String, u8, String)>,
    along: Option<String>,
    arrows: Vec<Arrows>,
    shown: Option<&'static str>,
}

/// The mechanism in motion.
///
/// # Errors
/// There is no way to go.
pub fn motion(
    scene: &Scene<'_>,
    options: &Options,
    theme: Theme,
    wording: &dyn Wording,
) -> Result<Moving, Diagnosis> {
    let ways = scene.all_ways();
    let scene = &Scene { ways: &ways, ..*scene };
    let stage = Stage::of(scene, options)?;
    let animated = Animated::of(scene, &stage, options, wording)?;
    let diagram = plot(scene, &[]).ok();
    let columns = columns(&animated.frames, diagram.as_ref().map(|(_, curves)| curves));
    let arrows = match &animated.paper {
        Some(paper) if options.arrows => arrows(&animated.frames, paper, wording.decimal()),
        _ => Vec::new(),
    };
    if let Some(kind) = options.shown.filter(|kind| !arrows.iter().any(|one| one.kind == kind.name())) {
        return Err(kind.missing(scene));
    }
    let mut markup = String::from("<div class=\"motion\"><div class=\"motion-parts\"><div>\n");
    markup.push_str(&animated.sheet.svg(theme));
    markup.push_str(&bar(&animated, &arrows, wording));
    let first = escaped(&said(&columns, 0, wording.decimal()));
    let _ = writeln!(markup, "<output class=\"motion-values\">{first}</output></div>");
    let mut along = None;
    if let Some((drawing, curves)) = diagram {
        let sheet = wording.drawing(scene.mechanism(), drawing).placed();
        let top = number(sheet.bounds.min.y);
        let cursor = format!(
            "<path class=\"motion-cursor\" fill=\"none\" stroke=\"#b84a00\" stroke-width=\".35\" visibility=\"hidden\" d=\"M0 {top}V{}\"/>\n</svg>",
            number(sheet.bounds.max.y)
        );
        let _ = writeln!(
            markup,
            "<div class=\"motion-plot\">\n{}</div>",
            sheet.svg(theme).replacen("</svg>", &cursor, 1)
        );
        along = Some(places(&animated.frames, &curves));
    }
    markup.push_str("</div></div>\n");
    let moved = &animated.moved;
    let mut all = Distinct::default();
    let bodies = moved.bodies.iter().map(|b| body(b, &mut all)).collect();
    let hidden = |frames: &[bool]| series(frames.iter().map(|hidden| Some(i64::from(*hidden))));
    let motion = Motion {
        frames: animated.frames.len(),
        decimal: wording.decimal(),
        series: all.texts,
        bodies,
        followers: moved.followers.iter().map(|f| (short(f.at.x), short(f.at.y), f.body)).collect(),
        redrawn: moved.redrawn.iter().map(redrawn).collect(),
        faded: animated.faded.iter().map(|label| hidden(&label.frames)).collect(),
        values: columns.into_iter().map(column).collect(),
        along,
        shown: options.shown.map(ArrowKind::name),
        arrows,
    };
    Ok(Moving { title: animated.title, markup, motion: Some(motion) })
}

/// What stands below the picture: buttons, the slider, the kinds of arrows.
fn bar(animated: &Animated<'_>, arrows: &[Arrows], wording: &dyn Wording) -> String {
    let last = animated.frames.len() - 1;
    let word = |english: &str| escaped(&wording.phrase(english));
    let button = |class: &str, says: &str, shows: &str| {
        let says = word(says);
        format!(
            "<button class=\"motion-{class}\" type=\"button\" aria-label=\"{says}\" title=\"{says}\">{shows}</button>"
        )
    };
    let mut out = String::from("<div class=\"motion-bar\">");
    out += &button("back", "play backwards", "◀");
    out += &button("play", "play or pause", "▶");
    let _ = write!(
        out,
        "<input class=\"motion-slider\" type=\"range\" min=\"0\" max=\"{last}\" value=\"0\" aria-label=\"{}\">",
        word("pose")
    );
    out += &button("speed", "speed", "1×");
    // a page alone has only what is in it
    let missing = |is_there: bool| if is_there { "" } else { " data-missing" };
    let _ = write!(
        out,
        "<select class=\"motion-show\"{} aria-label=\"{}\"><option value=\"\">{}</option>",
        missing(!arrows.is_empty()),
        word("arrows"),
        word("no arrows")
    );
    for kind in ArrowKind::ALL {
        let missing = missing(arrows.iter().any(|one| one.kind == kind.name()));
        let _ = write!(out, "<option value=\"{0}\"{missing}>{1}</option>", kind.name(), word(kind.name()));
    }
    out + "</select><span class=\"motion-scale\"></span></div>\n"
}

/// Where the drive, or the instant, is in the plot, in steps of a hundredth of a millimetre.
fn places(frames: &[Scene<'_>], curves: &Curves) -> String {
    series(frames.iter().map(|frame| whole(curves.place(frame.along()?) * STEPS.0)))
}

/// The nearest whole number.
#[allow(clippy::cast_possible_truncation)] // millimetres of paper
pub(super) fn whole(x: f64) -> Option<i64> {
    (x.abs() < 1e15).then(|| x.round() as i64)
}

/// A length of paper as the drawing has it.
fn short(x: f64) -> f64 {
    (x * 100.0).round() / 100.0
}

/// A number of all frames: name, unit, decimals, series.
fn column(column: Column) -> (String, String, u8, String) {
    let Column { name, unit, decimals, numbers } = column;
    (name, unit, decimals, series(numbers.into_iter()))
}

/// The texts of a mark, each once, and which one each frame shows.
fn redrawn(texts: &Redrawn) -> (Vec<String>, String) {
    let (known, which) = texts.distinct(1);
    let which = which.into_iter().map(|i| i64::try_from(i).ok());
    (known.into_iter().map(str::to_owned).collect(), series(which))
}

/// Centre, and the places of the series by which it moves: right, down, turn.
fn body(body: &Body, all: &mut Distinct) -> Vec<f64> {
    let Body { centre, turns, poses, .. } = body;
    let mut column = |part: &dyn Fn(&(Vec2, f64)) -> f64| {
        all.place(series(poses.iter().map(|pose| Some(whole(part(pose)).unwrap_or(0)))))
    };
    let right = column(&|(at, _)| (at.x - centre.x) * STEPS.0);
    let down = column(&|(at, _)| (at.y - centre.y) * STEPS.0);
    let turn = turns.then(|| column(&|(_, angle)| angle * STEPS.1));
    #[allow(clippy::cast_precision_loss)] // few series
    let series = [Some(right), Some(down), turn].into_iter().flatten().map(|place| place as f64);
    [short(centre.x), short(centre.y)].into_iter().chain(series).collect()
}

// Whole numbers of all frames as text: the steps from one to the next, in digits of base 64 as in source maps. Five bits a digit, the
// least first; a digit from 32 on is followed by more, and the first bit is the sign.

/// Digits in their order; none of them ends a text or an element.
pub const DIGITS: &str = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
/// Where there is no number.
const NONE: char = '~';

/// The text of numbers.
pub fn series(numbers: impl Iterator<Item = Option<i64>>) -> String {
    let mut out = String::new();
    let mut before = 0_i64;
    for number in numbers {
        match number {
            Some(number) => {
                digits(&mut out, number.wrapping_sub(before));
                before = number;
            }
            None => out.push(NONE),
        }
    }
    out
}

fn digits(out: &mut String, step: i64) {
    let mut rest = (step.unsigned_abs() << 1) | u64::from(step < 0);
    loop {
        #[allow(clippy::cast_possible_truncation)] // five bits
        let digit = (rest & 31) as usize;
        rest >>= 5;
        let digit = if rest > 0 { digit + 32 } else { digit };
        out.push(char::from(DIGITS.as_bytes()[digit]));
        if rest == 0 {
            return;
        }
    }
}

/// Series of many things, each text once.
#[derive(Default)]
pub struct Distinct {
    pub texts: Vec<String>,
    known: std::collections::HashMap<String, usize>,
}

impl Distinct {
    /// The place of a text.
    pub fn place(&mut self, text: String) -> usize {
        *self.known.entry(text).or_insert_with_key(|text| {
            self.texts.push(text.clone());
            self.texts.len() - 1
        })
    }
}
