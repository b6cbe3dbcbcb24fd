//! Animations as one picture per frame.

use crate::drawn::solved;
use assur::internals::drawing::Theme;
use assur::internals::math::Vec2;
use assur::internals::picture::{Film, Options, Scene, film};
use assur::internals::pipeline::turn_in;
use assur::internals::worked::Language;

const COUNT: usize = 24;

fn film_of(name: &str, text: &str) -> Film {
    let Some((source, solved)) = solved(name, text) else { panic!("{name} is solved") };
    let turn = turn_in(&solved.compiled, &solved.solution, COUNT);
    let scene = Scene::of(solved.compiled.model(), &solved.solution, (name, &source.text), None);
    let Ok(scene) = scene else { panic!("{name} has a position") };
    let options = Options { frames: Some(COUNT), ..Options::default() };
    let drawn = film(&Scene { turn: &turn, ..scene }, &options, Theme::Light, &Language::English);
    drawn.unwrap_or_else(|_| panic!("{name} moves"))
}

/// What stands between two texts.
fn between<'t>(text: &'t str, before: &str, after: &str) -> &'t str {
    let rest = text.split_once(before).map_or("", |(_, rest)| rest);
    rest.split_once(after).map_or("", |(inner, _)| inner)
}

/// The place of the first circle of a pair.
fn place(picture: &str, pair: &str) -> Vec2 {
    let group = between(picture, &format!("<g class=\"pair\" data-name=\"{pair}\">"), "</g>\n</g>");
    let circle = between(group, "<circle", "/>");
    let at = |name: &str| between(circle, &format!("{name}=\""), "\"").parse::<f64>().expect("a place");
    let mut at = Vec2::new(at("cx"), at("cy"));
    let steps = between(between(group, "", "<circle"), "transform=\"", "\"");
    for step in steps.split(')').rev().filter(|step| !step.is_empty()) {
        let (what, numbers) = step.split_once('(').expect("a step");
        let numbers: Vec<f64> = numbers.split(' ').map(|x| x.parse().expect("a number")).collect();
        at = match (what, numbers.as_slice()) {
            ("translate", [x, y]) => at + Vec2::new(*x, *y),
            ("rotate", [angle]) => at.turned(Vec2::direction(angle.to_radians())),
            _ => panic!("{step}"),
        };
    }
    at
}

/// The crank is 100 mm and the rod 350 mm, at 4 mm per millimetre of paper.
#[test]
fn hinges_keep_their_distances_in_every_frame() {
    let film = film_of("crank-slider.mech", include_str!("../../examples/crank-slider.mech"));
    assert_eq!(film.count(), COUNT);
    let first = film.frame(0);
    let fixed = place(&first, "A");
    let mut turned = 0.0;
    let mut before = place(&first, "B") - fixed;
    for k in 0..COUNT {
        let frame = film.frame(k);
        crate::xml::check(&frame).expect("it is well formed");
        assert_eq!(place(&frame, "A"), fixed);
        let (pin, piston) = (place(&frame, "B"), place(&frame, "C"));
        assert!(((pin - fixed).norm() - 25.0).abs() < 0.03, "frame {k}: {}", (pin - fixed).norm());
        assert!(((piston - pin).norm() - 87.5).abs() < 0.04, "frame {k}: {}", (piston - pin).norm());
        turned += libm::atan2(before.cross(pin - fixed), before.dot(pin - fixed)).abs();
        before = pin - fixed;
    }
    let steps = f64::from(u8::try_from(COUNT - 1).expect("few"));
    let turn = std::f64::consts::TAU;
    let near = |whole: f64| (turned - whole).abs() < 0.02;
    assert!(near(turn * steps / (steps + 1.0)) || near(turn), "over the frames it turns by {turned}");
    assert_eq!(film.frame(COUNT), film.frame(COUNT - 1), "there is none behind the last");
}

/// Labels that meet give way, and what changes its shape is drawn anew.
#[test]
fn frames_have_their_own_labels_and_shapes() {
    let film = film_of("six-bar.mech", include_str!("../../examples/kinetostatics/six-bar.mech"));
    let frames: Vec<String> = (0..COUNT).map(|k| film.frame(k)).collect();
    let hidden = |frame: &String| frame.matches("display=\"none\"").count();
    assert!(frames.iter().any(|frame| hidden(frame) > 0));
    assert!(frames.iter().any(|frame| hidden(frame) == 0));
    let arc = |frame: &String| between(frame, "<g class=\"r1\">", "</g>").to_owned();
    let arcs: std::collections::BTreeSet<String> = frames.iter().map(arc).collect();
    // at an angle of zero there is none
    assert!(arcs.len() > COUNT / 2, "{arcs:?}");
    for frame in &frames {
        crate::xml::check(frame).expect("it is well formed");
    }
}
