//! Arrows on what moves: against the motion that the frames show, and against forces found elsewhere.

use crate::every_example::examples;
use crate::frames::{motion, series};
use assur::internals::Solved;
use assur::internals::check::Overrides;
use assur::internals::drawing::Theme;
use assur::internals::math::Vec2;
use assur::internals::picture::{ArrowKind, Kind, Options, Scene, animation};
use assur::internals::pipeline::{solve_document_drawn, turn_with_effects};
use assur::internals::source::Source;
use assur::internals::syntax::parse;
use assur::internals::worked::Language;
use std::sync::Arc;

fn solved(name: &str, text: &str, kind: Kind) -> Option<(Source, Solved)> {
    let source = Source::new(name, text.to_owned());
    let (document, found) = parse(&source);
    let (solved, _) = solve_document_drawn(&source, &Arc::new(document), found, &Overrides::none(), &[kind]);
    Some((source, solved?))
}

/// A page with arrows of a kind; none where there are none.
fn page(name: &str, text: &str, kind: ArrowKind) -> Option<String> {
    let (source, solved) = solved(name, text, kind.kind())?;
    let file = (source.name.as_str(), source.text.as_str());
    let scene = Scene::of(solved.compiled.model(), &solved.solution, file, None).ok()?;
    let (turn, arrows) = turn_with_effects(&solved.compiled, &solved.solution, None);
    let options = Options { arrows, shown: Some(kind), ..Options::default() };
    animation(&Scene { turn: &turn, ..scene }, &options, Theme::Auto, &Language::English).ok()
}

/// Tails and arrows, mm.
type Places = Vec<(Vec2, Vec2)>;

/// Tails and arrows of all frames by name, mm, and the scale.
fn arrows(page: &str, kind: ArrowKind) -> (Vec<(String, Places)>, f64) {
    let motion = motion(page);
    let all = motion["arrows"].as_array().expect("arrows");
    let found = all.iter().find(|one| one["kind"] == kind.name()).expect("its kind");
    let scale = found["scale"].as_str().and_then(|s| s.split(' ').nth(3)?.parse().ok()).unwrap_or(f64::NAN);
    let of = |one: &serde_json::Value| {
        let columns: Vec<Vec<f64>> = (1..5).map(|i| series(one[i].as_str().expect("a series"))).collect();
        let at = |k: usize| {
            let [x, y, dx, dy] = [0, 1, 2, 3].map(|i| columns[i][k] / 10.0);
            (Vec2::new(x, y), Vec2::new(dx, dy))
        };
        let count = columns.iter().map(Vec::len).min().unwrap_or(0);
        (one[0].as_str().expect("a name").to_owned(), (0..count).map(at).collect())
    };
    (found["all"].as_array().expect("arrows").iter().map(of).collect(), scale)
}

/// A velocity points along the way of its point from the frame before to the frame after.
#[test]
fn velocities_go_along_the_ways_of_their_points() {
    let (mut wrong, mut compared, mut files) = (Vec::new(), 0, 0);
    for (name, text) in examples() {
        // frames of a motion under loads have events between them
        if text.contains("\nsimulate") {
            continue;
        }
        let Some(page) = page(&name, &text, ArrowKind::Velocities) else { continue };
        files += 1;
        for (point, all) in arrows(&page, ArrowKind::Velocities).0 {
            let (mut off, mut seen) = (0, 0);
            for part in all.windows(3) {
                let way = part[2].0 - part[0].0;
                let v = part[1].1;
                let turning = (part[2].1 - part[0].1).norm();
                // tenths of a millimetre say no direction, and where the velocity turns a chord is no tangent
                if way.norm() < 2.0 || v.norm() < 3.0 || turning > 0.3 * v.norm() {
                    continue;
                }
                seen += 1;
                off += usize::from(way.cross(v).abs() > 0.12 * way.norm() * v.norm());
            }
            compared += seen;
            if seen > 4 && off * 50 > seen {
                wrong.push(format!("{name}: {point} goes elsewhere in {off} of {seen} frames"));
            }
        }
    }
    println!("{compared} velocities of {files} files");
    assert!(files > 60 && compared > 5_000, "{compared} velocities of {files} files");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The crank press of README: `assur solve` gives 3.15318 kN in B, and the tie of the arrows is on B and C.
#[test]
fn reactions_and_loads_are_those_of_the_answers() {
    let text = include_str!("../../examples/press.mech");
    let found = page("press.mech", text, ArrowKind::Reactions).expect("arrows");
    let (all, scale) = arrows(&found, ArrowKind::Reactions);
    let at = |name: &str| {
        let one = all.iter().find(|one| one.0.ends_with(&format!("({name})"))).expect("the pair");
        one.1[0].1.norm() * scale
    };
    for (pair, force) in [("A", 3153.18), ("B", 3153.18), ("D", 677.113)] {
        assert!((at(pair) - force).abs() < 0.08 * scale, "{pair}: {} N, {force} N", at(pair));
    }
    let (all, scale) = arrows(&found, ArrowKind::Loads);
    let (name, load) = &all[0];
    assert_eq!((name.as_str(), all.len()), ("P", 1));
    assert!((load[0].1 - Vec2::new(-3000.0 / scale, 0.0)).norm() < 0.1, "{:?}", load[0]);
}
