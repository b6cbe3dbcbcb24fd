//! Animations without a script.

use crate::drawn::{moving_picture, solved};
use crate::every_example::examples;
use assur::internals::math::Vec2;

#[test]
fn pictures_that_move_are_well_formed() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for (name, text) in examples() {
        let Some((source, solved)) = solved(&name, &text) else { continue };
        let Some(picture) = moving_picture(&source, &solved) else { continue };
        count += 1;
        if let Err(fault) = crate::xml::check(&picture) {
            wrong.push(format!("{name}: {fault}"));
        }
        if ["<script", "href", "NaN", "inf;"].iter().any(|forbidden| picture.contains(forbidden)) {
            wrong.push(format!("{name}: no picture alone"));
        }
        if picture.len() > 1_200_000 {
            wrong.push(format!("{name}: {} bytes", picture.len()));
        }
    }
    assert!(count > 80, "animations are drawn: {count}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// What stands between two texts.
fn between<'t>(text: &'t str, before: &str, after: &str) -> &'t str {
    let rest = text.split_once(before).map_or("", |(_, rest)| rest);
    rest.split_once(after).map_or("", |(inner, _)| inner)
}

/// The numbers in a text.
fn numbers(text: &str) -> Vec<f64> {
    text.split([' ', ';']).filter_map(|x| x.parse().ok()).collect()
}

/// The places of the first hinge of a pair in all frames, mm.
fn places(picture: &str, pair: &str) -> Vec<(f64, f64)> {
    let group = between(picture, &format!("<g class=\"pair\" data-name=\"{pair}\">"), "</g>\n</g>");
    let circle = between(group, "<circle", "/>");
    let at = |name: &str| between(circle, &format!("{name}=\""), "\"").parse::<f64>().expect("a place");
    let (x, y) = (at("cx"), at("cy"));
    let shifts = numbers(between(between(group, "type=\"translate\"", "/>"), "values=\"", "\""));
    let turns = numbers(between(between(group, "type=\"rotate\"", "/>"), "values=\"", "\""));
    let place = |(i, shift): (usize, &[f64])| {
        let turned =
            Vec2::new(x, y).turned(Vec2::direction(turns.get(i).copied().unwrap_or(0.0).to_radians()));
        (shift[0] + turned.x, shift[1] + turned.y)
    };
    shifts.chunks(2).enumerate().map(place).collect()
}

/// The crank is 100 mm and the rod 350 mm, at 4 mm per millimetre of paper.
#[test]
fn hinges_keep_their_distances() {
    let text = include_str!("../../examples/crank-slider.mech");
    let Some((source, solved)) = solved("crank-slider.mech", text) else { panic!("it is solved") };
    let picture = moving_picture(&source, &solved).expect("a picture");
    let support = between(&picture, "<g class=\"pair\" data-name=\"A\">", "</g>");
    let circle = between(support, "<circle", "/>");
    let at = |name: &str| between(circle, &format!("{name}=\""), "\"").parse::<f64>().expect("a place");
    let fixed = (at("cx"), at("cy"));
    let (pin, piston) = (places(&picture, "B"), places(&picture, "C"));
    assert!(pin.len() > 80 && pin.len() == piston.len(), "{} and {}", pin.len(), piston.len());
    let far = |a: (f64, f64), b: (f64, f64)| (a.0 - b.0).hypot(a.1 - b.1);
    for (b, c) in pin.into_iter().zip(piston) {
        assert!((far(fixed, b) - 25.0).abs() < 0.03, "the pin is {} mm from its support", far(fixed, b));
        assert!((far(b, c) - 87.5).abs() < 0.04, "the rod is {} mm long", far(b, c));
        assert!((c.1 - fixed.1).abs() < 0.02, "the piston is off its guide");
    }
}
