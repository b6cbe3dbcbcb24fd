//! Trains as they are drawn in books: ropes hang beside their wheels, nuts are on their spindles, worms on their shafts.

use crate::drawn::{sheets, solved};
use assur::internals::drawing::{Mark, Shape, Sheet, Style};
use assur::internals::math::Vec2;
use assur::internals::picture::Kind;

fn train(text: &str) -> Sheet {
    let (source, solved) = solved("train.mech", &format!("mech 1\n{text}\n")).expect("a solution");
    let mut all = sheets(&source, &solved, Kind::Train);
    assert_eq!(all.len(), 1);
    all.remove(0)
}

/// The marks of a group.
fn of<'a>(sheet: &'a Sheet, class: &'a str, name: &'a str) -> Vec<&'a Mark> {
    let groups = &sheet.drawing.groups;
    let own = |m: &&Mark| groups[m.group].class == class && groups[m.group].name == name;
    sheet.drawing.marks.iter().filter(own).collect()
}

fn lines<'a>(marks: &'a [&Mark]) -> impl Iterator<Item = (Vec2, Vec2)> + 'a {
    marks.iter().filter(|m| m.style == Style::Medium).filter_map(|m| match m.shape {
        Shape::Line(a, b) => Some((a, b)),
        _ => None,
    })
}

fn circles(marks: &[&Mark]) -> Vec<(Vec2, f64)> {
    let circles = marks.iter().filter_map(|m| match m.shape {
        Shape::Circle { centre, radius } => Some((centre, radius)),
        _ => None,
    });
    circles.collect()
}

/// Where the block of a slider is.
fn block(sheet: &Sheet, name: &str) -> Vec2 {
    let marks = of(sheet, "link", name);
    let corners = marks.iter().find_map(|m| match &m.shape {
        Shape::Lines { points, .. } if m.style == Style::Block => Some(points.clone()),
        _ => None,
    });
    let corners = corners.expect("a block");
    corners.iter().fold(Vec2::zero(), |a, b| a + *b) * (1.0 / corners.len() as f64)
}

/// The way of the arrow of a group.
fn arrow(sheet: &Sheet, class: &str, name: &str) -> Vec2 {
    let marks = of(sheet, class, name);
    let way = marks.iter().find_map(|m| match m.shape {
        Shape::Arrow(a, b) => Some(b - a),
        _ => None,
    });
    way.expect("an arrow")
}

const SHEAVE: &str =
    "shaft S { wheel w radius 1 m }\nslider cage\nslider counter\nrope a: cage - w - counter";

#[test]
fn ropes_hang_from_both_sides_of_a_sheave() {
    let sheet = train(&format!("{SHEAVE}\ndrive S at 2 rad/s"));
    let (centre, radius) = circles(&of(&sheet, "wheel", "w"))[0];
    let rope = of(&sheet, "pair", "a");
    let parts: Vec<(Vec2, Vec2)> = lines(&rope).collect();
    assert_eq!(parts.len(), 2);
    for (a, b) in parts {
        assert!((a.x - b.x).abs() < 1e-9, "upright: {a:?} {b:?}");
        assert!(((a.x - centre.x).abs() - radius).abs() < 1e-9, "beside the wheel");
    }
    // a wheel that turns counter-clockwise pays out on its left
    assert!(block(&sheet, "cage").x < centre.x && block(&sheet, "counter").x > centre.x);
}

#[test]
fn what_a_rope_pays_out_goes_down() {
    for (speed, down) in [("2 m/s", true), ("-2 m/s", false)] {
        let sheet = train(&format!("{SHEAVE}\ndrive cage at {speed}"));
        assert_eq!(arrow(&sheet, "drive", "cage").y > 0.0, down, "y of paper is down");
    }
    let hoist =
        "shaft I { wheel w radius 0.2 m }\nslider A { mass 10 kg }\nrope a: A - w\ndrive I at 1 rad/s";
    let sheet = train(&format!("{hoist}\nforce W on A = 98.1 N"));
    assert!(arrow(&sheet, "load", "W").y > 0.0, "a weight pulls down");
}

#[test]
fn the_pulley_of_a_differential_hoist_is_as_wide_as_its_ropes_are_apart() {
    let text = "shaft I { wheel big radius 150 mm; wheel small radius 140 mm }\nslider P\n\
                rope a: big - under(P) - small\ndrive I at 10 rad/s";
    let sheet = train(text);
    let (centre, big) = circles(&of(&sheet, "wheel", "big"))[0];
    let (_, small) = circles(&of(&sheet, "wheel", "small"))[0];
    let rope = of(&sheet, "pair", "a");
    let pulley = circles(&rope).into_iter().map(|c| c.1).fold(0.0, f64::max);
    assert!((pulley - (big + small) / 2.0).abs() < 1e-9, "{pulley} of {big} and {small}");
    let mut xs: Vec<f64> = lines(&rope).map(|(a, b)| (a.x + b.x) / 2.0 - centre.x).collect();
    xs.sort_by(f64::total_cmp);
    // turned counter-clockwise, the big one pays out on its left
    assert!((xs[0] + big).abs() < 1e-9 && (xs[1] - small).abs() < 1e-9, "{xs:?}");
}

#[test]
fn an_idler_is_above_and_turns_the_rope() {
    let text = "shaft I { wheel w radius 0.2 m }\nslider A\nrope a: A - over(C) - w\ndrive A at 1 m/s";
    let sheet = train(text);
    let (centre, radius) = circles(&of(&sheet, "wheel", "w"))[0];
    let rope = of(&sheet, "pair", "a");
    let idler = circles(&rope).into_iter().find(|c| c.1 > 2.0).expect("an idler");
    assert!(idler.0.y < centre.y - radius, "above");
    // the rope leaves upwards where a counter-clockwise wheel moves up: on the right
    let part = lines(&rope).find(|(a, b)| a.y.min(b.y) < centre.y && a.y.max(b.y) <= centre.y + 1e-9);
    let part = part.expect("a part from the wheel to the idler");
    assert!((part.0.x - centre.x - radius).abs() < 1e-9);
}

#[test]
fn a_nut_is_on_its_spindle_and_a_worm_on_its_shaft() {
    let screw = "shaft spindle\nslider nut\nscrew n: spindle - nut { lead 6 mm }\ndrive spindle at 3 rad/s";
    let sheet = train(screw);
    let thread = of(&sheet, "pair", "n");
    let bounds =
        thread.iter().map(|m| m.shape.bounds()).reduce(|mut a, b| (a.join(&b), a).1).expect("a thread");
    let nut = block(&sheet, "nut");
    assert!(bounds.min.x < nut.x - 5.0 && nut.x + 5.0 < bounds.max.x, "the spindle goes through the nut");
    assert!(((bounds.min.y + bounds.max.y) / 2.0 - nut.y).abs() < 1e-9);
    let worm = "shaft motor\nshaft drum { wheel z teeth 40 module 2 mm }\nworm s: motor - z { starts 1 }\ndrive motor at 3 rad/s";
    let sheet = train(worm);
    let wheel = of(&sheet, "wheel", "z");
    let (centre, radius) = circles(&wheel)[0];
    let shaft = of(&sheet, "link", "motor");
    let line = shaft.iter().find_map(|m| match m.shape {
        Shape::Line(a, b) if m.style == Style::Link => Some((a, b)),
        _ => None,
    });
    let (a, b) = line.expect("a shaft");
    assert!(a.x < centre.x && centre.x < b.x, "across the wheel");
    assert!(
        a.y == b.y && centre.y - a.y > radius && centre.y - a.y < radius + 5.0,
        "beside its pitch circle"
    );
}

#[test]
fn no_wheel_crosses_the_shaft_within_a_hollow_one() {
    let text = "shaft S { wheel sun teeth 20 }\nshaft R { wheel ring teeth 70 }\nshaft H\n\
                shaft P on H { wheel p teeth 25 }\nmesh sp: sun - p\nmesh pr: p - ring { internal }\n\
                drive S at 3 rad/s\ndrive R at 2 rad/s";
    let sheet = train(text);
    let shaft = |name: &'static str| {
        let marks = of(&sheet, "link", name);
        let lines = marks.iter().filter(|m| m.style == Style::Link).filter_map(|m| match m.shape {
            Shape::Line(a, b) if a.y == b.y => Some((a, b)),
            _ => None,
        });
        lines.collect::<Vec<_>>()
    };
    let (outer, inner) = (shaft("R"), shaft("H"));
    assert_eq!(outer.len(), 2, "a hollow shaft has two lines");
    let axis = inner[0].0.y;
    assert!(outer[0].0.y < axis && axis < outer[1].0.y);
    assert!(inner[0].1.x > outer[0].1.x, "the inner one ends beyond");
    for mark in of(&sheet, "wheel", "ring") {
        if let Shape::Line(a, b) = mark.shape
            && a.x == b.x
        {
            assert!(a.y.max(b.y) < axis, "the bell ends at its own shaft");
        }
    }
}

#[test]
fn a_rope_hangs_from_its_idler_without_any_wheel() {
    let sheet = train("slider A\nslider B\nrope a: A - over(C) - B\ndrive A at 1 m/s");
    let rope = of(&sheet, "pair", "a");
    let (centre, radius) = circles(&rope)[0];
    for (name, side) in [("A", -1.0), ("B", 1.0)] {
        let at = block(&sheet, name);
        assert!(
            ((at.x - centre.x) * side - radius).abs() < 1e-9 && at.y > centre.y + radius,
            "{name}: {at:?}"
        );
    }
    assert!(arrow(&sheet, "drive", "A").y > 0.0, "y of paper is down");
}

#[test]
fn a_rope_between_two_wheels_touches_both() {
    let sheet = train(
        "shaft I { wheel w1 radius 0.2 m }\nshaft II { wheel w2 radius 0.1 m }\nrope a: w1 - w2\ndrive I at 2 rad/s",
    );
    let rope = of(&sheet, "pair", "a");
    let parts: Vec<(Vec2, Vec2)> = lines(&rope).collect();
    assert_eq!(parts.len(), 1);
    let (from, to) = parts[0];
    for (name, end) in [("w1", from), ("w2", to)] {
        let (centre, radius) = circles(&of(&sheet, "wheel", name))[0];
        assert!(((end - centre).norm() - radius).abs() < 1e-9, "{name}: {end:?}");
        assert!((end - centre).dot(to - from).abs() < 1e-9, "{name}: a tangent");
        assert!(end.y < centre.y, "both turn in one sense: above both");
    }
}
