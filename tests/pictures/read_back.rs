//! DXF and TikZ have every mark of the sheet, where it is.

use crate::drawn::{Shown, solved};
use crate::every_example::examples;
use assur::internals::drawing::{Mark, Shape, Sheet, Theme, on_circle};
use assur::internals::math::Vec2;
use assur::internals::picture::{KINDS, Scene, Scheme, true_size};
use std::collections::BTreeSet;

/// How far a point of DXF may be off, mm.
const OFF: f64 = 1e-6;

/// An entity: its kind, and its pairs.
type Entity = (String, Vec<(u16, String)>);

/// The names of layers, and the entities, of a text in pairs of code and value.
fn read(dxf: &str) -> (Vec<String>, Vec<Entity>) {
    let lines: Vec<&str> = dxf.split_terminator("\r\n").collect();
    assert!(lines.len().is_multiple_of(2) && dxf.is_ascii(), "pairs of ASCII");
    let mut all: Vec<Entity> = Vec::new();
    for pair in lines.chunks(2) {
        let code = pair[0].trim().parse().expect("a code");
        match (code, all.last_mut()) {
            (0, _) => all.push((pair[1].to_owned(), Vec::new())),
            (_, Some((_, pairs))) => pairs.push((code, pair[1].to_owned())),
            (_, None) => panic!("a value before the first entity"),
        }
    }
    let entities = all.iter().position(|(kind, p)| kind == "SECTION" && p == &[(2, "ENTITIES".to_owned())]);
    let entities = all.split_off(entities.expect("a section") + 1);
    let layers = all.iter().filter(|(kind, _)| kind == "LAYER").map(|entity| text(entity, 2)).collect();
    (layers, entities)
}

fn text((_, pairs): &Entity, code: u16) -> String {
    pairs.iter().find(|(own, _)| *own == code).map(|(_, value)| value.clone()).unwrap_or_default()
}

fn number(entity: &Entity, code: u16) -> f64 {
    text(entity, code).parse().unwrap_or(f64::NAN)
}

/// A point of an entity, y down as on the sheet.
fn point(entity: &Entity, n: u16) -> Vec2 {
    Vec2::new(number(entity, 10 + n), -number(entity, 20 + n))
}

/// The points of an entity; of what is round also the radius, as a point.
fn points(entity: &Entity) -> Vec<Vec2> {
    let round = Vec2::new(number(entity, 40), 0.0);
    match entity.0.as_str() {
        "LINE" => vec![point(entity, 0), point(entity, 1)],
        "SOLID" => (0..3).map(|n| point(entity, n)).collect(),
        "CIRCLE" => vec![point(entity, 0), round],
        "ARC" => {
            let at = |code| on_circle(point(entity, 0), round.x, -number(entity, code).to_radians());
            vec![point(entity, 0), round, at(50), at(51)]
        }
        _ => vec![point(entity, 0)],
    }
}

/// The entities of a mark with their points; ends of arcs in the sense of the format.
fn expected(mark: &Mark) -> Vec<(&'static str, Vec<Vec2>)> {
    let arc = |centre: Vec2, radius: f64, from: f64, sweep: f64| {
        let ends =
            [from + sweep.max(0.0), from + sweep.min(0.0)].map(|angle| on_circle(centre, radius, angle));
        ("ARC", vec![centre, Vec2::new(radius, 0.0), ends[0], ends[1]])
    };
    let head = || ("SOLID", mark.shape.own_head().expect("a head")[..3].to_vec());
    match &mark.shape {
        Shape::Line(a, b) => vec![("LINE", vec![*a, *b])],
        Shape::Lines { points, .. } => {
            let corners = points.iter().map(|p| ("VERTEX", vec![*p]));
            let begin = std::iter::once(("POLYLINE", vec![Vec2::zero()]));
            begin.chain(corners).chain([("SEQEND", Vec::new())]).collect()
        }
        Shape::Strokes(lines) => lines.iter().map(|(a, b)| ("LINE", vec![*a, *b])).collect(),
        Shape::Circle { centre, radius } if *radius == 0.0 => vec![("POINT", vec![*centre])],
        Shape::Circle { centre, radius } => vec![("CIRCLE", vec![*centre, Vec2::new(*radius, 0.0)])],
        Shape::Arc { centre, radius, from, sweep } => vec![arc(*centre, *radius, *from, *sweep)],
        Shape::Sector { centre, radius, from, sweep } => {
            let end = |angle| on_circle(*centre, *radius, angle);
            let sides = [vec![*centre, end(*from)], vec![end(from + sweep), *centre]];
            let [first, last] = sides.map(|side| ("LINE", side));
            vec![first, arc(*centre, *radius, *from, *sweep), last]
        }
        Shape::Arrow(a, _) => {
            let base = mark.shape.own_head().expect("a head")[3];
            vec![("LINE", vec![*a, base]), head()]
        }
        Shape::ArcArrow { centre, radius, from, sweep } => {
            vec![arc(*centre, *radius, *from, Shape::shaft_sweep(*radius, *sweep)), head()]
        }
    }
}

/// What is wrong with the DXF of a sheet.
fn dxf_faults(sheet: &Sheet) -> Vec<String> {
    let dxf = sheet.dxf();
    let (layers, entities) = read(&dxf);
    let mut faults = Vec::new();
    let allowed = |c: char| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_' || c == '-';
    let bad = layers.iter().filter(|name| name.is_empty() || name.len() > 31 || !name.chars().all(allowed));
    faults.extend(bad.map(|name| format!("a layer is named {name}")));
    if layers.iter().collect::<BTreeSet<_>>().len() < layers.len() {
        faults.push(format!("layers have one name: {layers:?}"));
    }
    let drawn = entities.iter().filter(|(kind, _)| !matches!(kind.as_str(), "TEXT" | "ENDSEC" | "EOF"));
    faults.extend(
        drawn.clone().filter(|e| !layers.contains(&text(e, 8))).map(|e| format!("no layer of {e:?}")),
    );
    let beside = sheet.labels().into_iter().flat_map(|label| label.marks);
    let marks: Vec<Mark> = sheet.marks().iter().cloned().chain(beside).collect();
    let wanted: Vec<_> = marks.iter().flat_map(expected).collect();
    let own: Vec<_> = drawn.collect();
    if own.len() != wanted.len() {
        faults.push(format!("{} entities for {}", own.len(), wanted.len()));
    }
    for (entity, (kind, places)) in own.iter().zip(&wanted) {
        let off = points(entity).iter().zip(places).map(|(p, q)| (*p - *q).norm()).fold(0.0, f64::max);
        if entity.0 != *kind || off.is_nan() || off > OFF {
            faults.push(format!("{entity:?} for {kind} at {places:?}"));
        }
    }
    let words = sheet.labels().iter().filter(|label| !label.text.plain().trim().is_empty()).count();
    let texts = entities.iter().filter(|(kind, _)| kind == "TEXT").count();
    if words != texts {
        faults.push(format!("{texts} texts for {words}"));
    }
    faults
}

/// What is wrong with the TikZ of a sheet.
fn tikz_faults(sheet: &Sheet) -> Vec<String> {
    let (tikz, tex) = (sheet.tikz(Theme::Auto), sheet.tex(Theme::Auto));
    let mut faults = Vec::new();
    if !tex.is_ascii() || !tex.contains(&tikz) {
        faults.push("it is not ASCII, or not the same in a document".to_owned());
    }
    let count = |sign: char| {
        let lines = tikz.lines().filter(|line| !line.starts_with('%'));
        lines
            .map(|line| line.replace("\\\\", "").replace(&format!("\\{sign}"), "").matches(sign).count())
            .sum()
    };
    let counts: [usize; 3] = ['{', '}', '$'].map(count);
    if counts[0] != counts[1] || !counts[2].is_multiple_of(2) {
        faults.push(format!("brackets and signs of maths: {counts:?}"));
    }
    let beside: usize = sheet.labels().iter().map(|label| label.marks.len()).sum();
    let heads = sheet.marks().iter().filter(|mark| mark.shape.own_head().is_some()).count();
    let paths = tikz.lines().filter(|line| line.starts_with("\\path[")).count();
    if paths != sheet.marks().len() + beside + heads {
        faults.push(format!("{paths} paths for {} marks", sheet.marks().len() + beside + heads));
    }
    for line in tikz.lines().filter(|line| line.starts_with("\\path[")) {
        let style = line.trim_start_matches("\\path[").split(']').next().unwrap_or_default();
        if !tikz.contains(&format!("  {style}/.style=")) {
            faults.push(format!("there is no style {style}"));
        }
    }
    faults
}

#[test]
fn every_mark_is_in_every_format() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for (name, text) in crate::share::spread(examples()) {
        let Some((source, solved)) = solved(&name, &text) else { continue };
        let shown = Shown::of(&source, &solved);
        for kind in KINDS {
            for (_, sheet) in shown.sheets(kind, false) {
                count += 1;
                let faults = dxf_faults(&sheet).into_iter().chain(tikz_faults(&sheet)).take(3);
                wrong.extend(faults.map(|fault| format!("{name}, {kind:?}: {fault}")));
                let again = (sheet.dxf() == sheet.dxf(), sheet.tex(Theme::Mono) == sheet.tex(Theme::Mono));
                assert_eq!(again, (true, true), "{name}, {kind:?}: other bytes");
            }
        }
    }
    assert!(count > 100, "pictures are drawn: {count}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Every point of a link that has a place is where the solution has it, in millimetres.
#[test]
fn true_size_is_that_of_the_mechanism() {
    let mut count = 0;
    for (name, text) in crate::share::spread(examples()) {
        let Some((source, solved)) = solved(&name, &text) else { continue };
        let (file, model) = ((source.name.as_str(), source.text.as_str()), solved.compiled.model());
        let Ok(scene) = Scene::of(model, &solved.solution, file, None) else { continue };
        let Ok(drawing) = true_size(&scene, &Scheme::default()) else { continue };
        let (_, entities) = read(&drawing.placed().dxf());
        let known: Vec<Vec2> = entities.iter().filter(|e| e.0 == "POINT").map(|e| point(e, 0)).collect();
        for (i, link) in scene.mechanism().links.iter().enumerate() {
            let body = &scene.solved.state.motion.bodies[i];
            let places = link.points.iter().map(|at| body.position(at.at) * 1e3);
            for at in places.filter(|_| scene.is_placed(assur::internals::model::LinkId::at(i))) {
                let at = Vec2::new(at.x, -at.y);
                let off = known.iter().map(|p| (*p - at).norm()).fold(f64::MAX, f64::min);
                assert!(off <= OFF, "{name}: {} is {off} mm off", link.name);
                count += 1;
            }
        }
    }
    assert!(count > 200, "points are compared: {count}");
}
