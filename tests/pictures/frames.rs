//! Animations of many frames, of which some are drawn: between them everything is where it is when all are drawn.

use crate::drawn::solved;
use crate::every_example::examples;
use assur::internals::Solved;
use assur::internals::drawing::Theme;
use assur::internals::math::Vec2;
use assur::internals::picture::{Options, Scene, animation};
use assur::internals::pipeline::turn_in;
use assur::internals::solve::Pose;
use assur::internals::source::Source;
use assur::internals::worked::Language;
use std::collections::BTreeMap;

/// More than are drawn.
const FRAMES: usize = 501;
/// What a hinge may be off, mm: it goes with marks within 0.02 mm, and their turns are rounded to a hundredth of a degree.
const OFF: f64 = 0.08;

pub fn page(source: &Source, solved: &Solved, turn: &[Pose]) -> Option<String> {
    let file = (source.name.as_str(), source.text.as_str());
    let scene = Scene::of(solved.compiled.model(), &solved.solution, file, None).ok()?;
    let options = Options { frames: Some(turn.len()), ..Options::default() };
    animation(&Scene { turn, ..scene }, &options, Theme::Auto, &Language::English).ok()
}

/// The numbers of a series: steps in digits of base 64, five bits each, the least first, the first of all the sign.
pub fn series(text: &str) -> Vec<f64> {
    const DIGITS: &str = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let (mut all, mut sum, mut step, mut place) = (Vec::new(), 0_i64, 0_i64, 0);
    for digit in text.chars().filter_map(|c| DIGITS.find(c)) {
        step |= (digit as i64 & 31) << place;
        place += 5;
        if digit < 32 {
            sum += if step & 1 == 1 { -(step >> 1) } else { step >> 1 };
            all.push(sum as f64);
            (step, place) = (0, 0);
        }
    }
    all
}

pub fn between<'t>(text: &'t str, before: &str, after: &str) -> &'t str {
    let rest = text.split_once(before).map_or("", |(_, rest)| rest);
    rest.split_once(after).map_or("", |(inner, _)| inner)
}

/// The data of the player.
pub fn motion(page: &str) -> serde_json::Value {
    serde_json::from_str(between(page, "\nconst motion = ", ";\n")).expect("data")
}

/// The series of a list.
pub fn all_series(list: &serde_json::Value) -> Vec<Vec<f64>> {
    list.as_array().expect("a list").iter().map(|text| series(text.as_str().expect("a series"))).collect()
}

/// The numbers of a list of lists.
pub fn lists(list: &serde_json::Value) -> Vec<Vec<f64>> {
    serde_json::from_value(list.clone()).expect("numbers")
}

/// The first number below the picture, of every frame: where the drive is.
pub fn values(page: &str) -> Vec<f64> {
    series(motion(page)["values"][0][3].as_str().unwrap_or_default())
}

/// The places of the hinges in all frames, mm.
fn hinges(page: &str) -> BTreeMap<&str, Vec<Vec2>> {
    let motion = motion(page);
    let (all, bodies) = (all_series(&motion["series"]), lists(&motion["bodies"]));
    let mut found = BTreeMap::new();
    for group in page.split("<g class=\"pair\" data-name=\"").skip(1) {
        let (name, group) = group.split_once('"').expect("a name");
        let Some((before, circle)) = group.split_once("<circle class=\"h\"") else { continue };
        let Some((_, class)) = before.rsplit_once("<g class=\"m").filter(|(_, rest)| rest.ends_with("\">"))
        else {
            continue;
        };
        let body = &bodies[class.trim_end_matches("\">").parse::<usize>().expect("a number")];
        let at = |key: &str| between(circle, key, "\"").parse::<f64>().expect("a place");
        let from = Vec2::new(at(" cx=\"") - body[0], at(" cy=\"") - body[1]);
        let column = |i: usize, frame: usize| body.get(i).map_or(0.0, |k| all[*k as usize][frame] / 100.0);
        let place = |frame: usize| {
            let turned = from.turned(Vec2::direction(column(4, frame).to_radians()));
            turned + Vec2::new(column(2, frame) + body[0], column(3, frame) + body[1])
        };
        found.entry(name).or_insert_with(|| (0..all[body[2] as usize].len()).map(place).collect());
    }
    found
}

#[test]
fn frames_that_are_not_drawn_are_where_they_are_when_drawn() {
    let (mut wrong, mut count, mut hinges_compared) = (Vec::new(), 0, 0);
    for (name, text) in examples() {
        let Some((source, solved)) = solved(&name, &text) else { continue };
        if solved.compiled.mechanism.simulation.is_some() {
            continue;
        }
        let mut turn = turn_in(&solved.compiled, &solved.solution, FRAMES);
        turn.retain(|pose| pose.outcome.is_ok());
        let Some(many) = page(&source, &solved, &turn) else { continue };
        let others: Vec<Pose> = turn.into_iter().skip(1).step_by(2).collect();
        let Some(few) = page(&source, &solved, &others) else { continue };
        let scale = |page: &str| between(page, "Length scale ", " ").to_owned();
        if scale(&many) != scale(&few) {
            continue;
        }
        count += 1;
        let all = values(&many);
        // the first frames of a way back are a turn apart
        let frames: Vec<(usize, usize)> = values(&few)
            .iter()
            .enumerate()
            .filter_map(|(i, value)| Some((all.iter().position(|other| other == value)?, i)))
            .collect();
        let (many, few) = (hinges(&many), hinges(&few));
        // the paper may begin elsewhere
        let first = few.iter().find_map(|(name, places)| {
            let (i, j) = frames.first()?;
            Some(many.get(name)?.get(*i).copied()? - places[*j])
        });
        for (hinge, places) in &few {
            let Some(all) = many.get(hinge) else { continue };
            hinges_compared += 1;
            let shift = first.unwrap_or_else(Vec2::zero);
            let off = frames.iter().map(|(i, j)| (all[*i] - places[*j] - shift).norm());
            let most = off.fold(0.0, f64::max);
            if most > OFF {
                wrong.push(format!("{name}: {hinge} is {most:.3} mm off"));
            }
        }
    }
    assert!(count > 80 && hinges_compared > 200, "{hinges_compared} hinges of {count} animations");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
