//! A part of the mechanism freed from the rest, with all that acts on it, and the arms of forces about the inner hinge.

use super::actions::{Couple, FreeBody};
use super::polygon::split;
use super::{Part, names};
use crate::figures::{FORCE, MOMENT};
use crate::inset::{flipped, freest};
use crate::paper::{Frame, Paper, Scaled};
use crate::scene::Scene;
use crate::scheme::{Freed, length_scale};
use crate::shape::{LinkShape, Outline};
use crate::symbol::{arrow, cylinder, guide, hinge, mass};
use assur_drawing::{Drawing, Label, Level, Rect, Role, Segment, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{LinkId, PairId, PairKind, Pin};
use assur_text::diagnostic::Diagnosis;

/// Lengths of arrows, mm: the least, and what the greatest force adds.
const ARROW: (f64, f64) = (9.0, 8.0);
/// Radius and angle of a couple's arrow.
const COUPLE: (f64, f64) = (5.5, 1.75);
/// What is smaller than this part of the mechanism is a point.
const ONE_POINT: f64 = 1e-9;
/// What arrows and names take, mm.
const AROUND: Vec2 = Vec2::new(50.0, 44.0);
const LETTERS: f64 = 4.0;
const POINT: f64 = 4.4;
/// Arms shorter than this are not drawn, mm; the most of them.
const ARM: f64 = 3.0;
const ARMS: usize = 4;

/// The free body.
///
/// # Errors
/// A scale is wanted that does not fit.
pub fn draw(
    (scene, all): (&Scene<'_>, &[LinkShape]),
    part: &Part,
    free: &FreeBody,
    paper: &Paper,
) -> Result<Drawing, Diagnosis> {
    let mut bounds = Rect::NOTHING;
    for link in &part.links {
        all[link.index()].extent(scene, *link, &mut bounds);
    }
    free.forces.iter().for_each(|f| bounds.add(f.at));
    let profiles = Freed(&part.links);
    profiles.extent(scene, &mut bounds);
    if bounds.size().norm() <= ONE_POINT * assur_solve::solve::extent(&scene.model) {
        bounds = Rect::around(bounds.centre(), Vec2::zero());
    }
    let frame = paper.frame(Scaled::Length, &bounds, AROUND)?;
    let links = names(scene, part);
    let arrows = arrows(scene, part, free);
    let words =
        |(name, force): (&Text, Vec2)| format!("{} {} N", name.plain(), scene.figure(force.norm(), FORCE));
    let whole = free.forces.iter().map(|f| (&f.name, f.force));
    // what is drawn in parts is said whole and in its parts
    let parts = arrows.iter().map(|a| (&a.0, a.2)).filter(|a| free.forces.iter().all(|f| f.name != *a.0));
    let said: Vec<String> = whole.chain(parts).map(words).collect();
    let couple = |c: &Couple| format!("{} {} N·m", c.name.plain(), scene.figure(c.moment, MOMENT));
    let couples: Vec<String> = free.couples.iter().map(couple).collect();
    let couples =
        if couples.is_empty() { String::new() } else { format!(" Couples: {}.", couples.join(", ")) };
    let title =
        format!("{}: links {links} freed{}", crate::words::title(scene), crate::words::at_position(scene));
    let id = format!("{}-{}", crate::words::id(scene, "free-body"), links.replace(", ", "-"));
    let description = format!("Forces on links {links}: {}.{couples}", said.join(", "));
    let mut drawing = Drawing::new(&id, title, description);
    let mut outlines = Vec::new();
    for link in &part.links {
        let body = scene.body(*link);
        outlines.push((*link, all[link.index()].outline(&frame, &|at| body.position(at))));
    }
    profiles.draw(scene, all, &frame, &mut drawing);
    bodies(scene, &mut drawing, &frame, &outlines, part);
    vectors(&mut drawing, &frame, &arrows);
    turning(&mut drawing, &frame, free);
    arms(scene, part, free, &frame, &mut drawing);
    if let Some(scale) = frame.scale {
        drawing.captions.push(length_scale(&scale));
    }
    if free.open {
        drawing.caption(Text::upright(
            "Where forces press on guides is not determined: drawn so that they balance.",
        ));
    }
    Ok(drawing)
}

fn bodies(
    scene: &Scene<'_>,
    drawing: &mut Drawing,
    frame: &Frame,
    outlines: &[(LinkId, Outline)],
    part: &Part,
) {
    blocks(scene, drawing, frame, part);
    cylinders(scene, drawing, frame, part);
    for (link, outline) in outlines {
        drawing.begin("link", &scene.mechanism().link(*link).name);
        for plate in &outline.plates {
            drawing.mark(Style::Plate, Shape::polygon(plate.clone()));
        }
        for (a, b) in &outline.arms {
            drawing.line(Style::Medium, *a, *b);
        }
        for (a, b) in &outline.bars {
            drawing.line(Style::Link, *a, *b);
        }
        let longest = outline.bars.iter().max_by(|a, b| (a.1 - a.0).norm().total_cmp(&(b.1 - b.0).norm()));
        if let (Some((a, b)), Some(number)) = (longest, &scene.mechanism().link(*link).number) {
            drawing.label(Label::along(Text::upright(number), 3.7, *a, *b).ringed(2.5).ranked(3));
        }
        drawing.end();
    }
    let mut done: Vec<Vec2> = Vec::new();
    for (name, text, pin) in pins(scene, part) {
        let at = frame.point(scene.at(pin.link, pin.at));
        drawing.begin("pair", name);
        hinge::moving(drawing, at);
        if done.iter().all(|d| (*d - at).norm() > 0.05) {
            let lines: Vec<Vec2> = lines_at(outlines, at);
            let label = Label::at(text, POINT, at, hinge::RADIUS).ranked(1);
            drawing.label(freest(&lines).map_or(label.clone(), |d| label.towards(d)));
        }
        done.push(at);
        drawing.end();
    }
    for link in &part.links {
        let declared = scene.mechanism().link(*link);
        if let Some(at) =
            declared.mass.filter(|m| m.mass > 0.0).map(|m| frame.point(scene.at(*link, m.centre)))
            && done.iter().all(|d| (*d - at).norm() > 0.4)
        {
            mass::centre(drawing, at);
            let near =
                |p: &&assur_model::model::Point| (frame.point(scene.at(*link, p.at)) - at).norm() < 0.4;
            if let Some(point) = declared.points.iter().find(near) {
                drawing.label(Label::at(Text::name(&point.name), POINT, at, mass::RADIUS).ranked(2));
            }
        }
    }
}

/// The hinges of a part with the names of their pairs and their letters: at the end of a cylinder that of the point.
fn pins<'a>(scene: &Scene<'a>, part: &Part) -> Vec<(&'a str, Text, &'a Pin)> {
    let mut found = Vec::new();
    let inside = |pin: &&Pin| part.links.contains(&pin.link);
    for pair in &scene.mechanism().pairs {
        match &pair.kind {
            PairKind::Revolute(pins) => {
                let pin = pins.iter().find(inside);
                found.extend(pin.map(|pin| (pair.name.as_str(), Text::name(&pair.name), pin)));
            }
            PairKind::Cylinder { from, to, .. } => {
                for pin in [from, to].into_iter().filter(inside) {
                    found.push((pair.name.as_str(), Text::name(&pin.name), pin));
                }
            }
            _ => {}
        }
    }
    found
}

fn lines_at(outlines: &[(LinkId, Outline)], at: Vec2) -> Vec<Vec2> {
    let bars = outlines.iter().flat_map(|(_, o)| o.bars.iter());
    let near = bars.filter(|(a, b)| Segment { a: *a, b: *b }.distance(at) < 0.3);
    near.flat_map(|(a, b)| [*a - at, *b - at]).filter(|d| d.norm() > 1.0).collect()
}

fn blocks(scene: &Scene<'_>, drawing: &mut Drawing, frame: &Frame, part: &Part) {
    for pair in &scene.mechanism().pairs {
        let PairKind::Prismatic(g) = &pair.kind else { continue };
        let is_wedge = |link: LinkId| crate::wedge::corners(scene, link).is_some();
        if part.links.contains(&g.slider) && !is_wedge(g.slider) {
            let along = flipped(g.along.turned(scene.body(g.guide).u));
            let at = frame.point(scene.at(g.slider, g.point));
            let half = if g.guide == LinkId::GROUND { guide::BLOCK } else { guide::SLEEVE };
            guide::block(drawing, at, along, (-half.x, half.x), half.y);
        }
    }
}

/// Cylinders between links of the part.
fn cylinders(scene: &Scene<'_>, drawing: &mut Drawing, frame: &Frame, part: &Part) {
    for (i, pair) in scene.mechanism().pairs.iter().enumerate() {
        let PairKind::Cylinder { from, to, .. } = &pair.kind else { continue };
        if [from, to].iter().all(|pin| part.links.contains(&pin.link)) {
            let [a, b] = [from, to].map(|pin| frame.point(scene.at(pin.link, pin.at)));
            drawing.begin("pair", &pair.name);
            cylinder::cylinder(drawing, a, b, frame.length(scene.way(PairId::at(i)).0));
            drawing.end();
        }
    }
}

/// A force with its name and its place; whether its arrow ends there.
type Arrow = (Text, Vec2, Vec2, Style, bool);

/// What is drawn as arrows: unknown reactions of hinges in their two parts.
fn arrows(scene: &Scene<'_>, part: &Part, free: &FreeBody) -> Vec<Arrow> {
    let mut all = Vec::new();
    for force in &free.forces {
        let style = if force.sought { Style::Unknown } else { Style::Force };
        match split(scene, part, force) {
            Some(parts) => {
                for (kind, value) in ["n", "t"].into_iter().zip(parts) {
                    let mut name = force.name.clone();
                    let index = name.runs.pop();
                    name = name.raised(kind);
                    name.runs.extend(index);
                    all.push((name, force.at, value, style, false));
                }
            }
            None => all.push((force.name.clone(), force.at, force.force, style, force.presses)),
        }
    }
    all
}

fn vectors(drawing: &mut Drawing, frame: &Frame, arrows: &[Arrow]) {
    let largest = arrows.iter().map(|a| a.2.norm()).fold(0.0, f64::max);
    let mut lines = arrow::OnLines::default();
    for (name, at, force, style, presses) in arrows {
        let Some(along) = flipped(*force).unit().filter(|_| force.norm() > 1e-9 * largest) else { continue };
        let length = ARROW.0 + ARROW.1 * force.norm() / largest;
        let at = frame.point(*at);
        let from = if *presses { at - along * length } else { lines.begin(at, along, length) };
        drawing.begin("vector", &name.plain());
        drawing.mark(*style, Shape::Arrow(from, from + along * length));
        let label =
            Label::along(name.clone(), LETTERS, from + along * (0.5 * length), from + along * (length + 1.5));
        drawing.label(label.coloured(style.text_role()).ranked(2));
        drawing.end();
    }
}

fn turning(drawing: &mut Drawing, frame: &Frame, free: &FreeBody) {
    for (i, Couple { name, at, moment, sought, .. }) in free.couples.iter().enumerate() {
        let style = if *sought { Style::Unknown } else { Style::Force };
        let at = frame.point(*at);
        let middle = -1.9 + 2.1 * i as f64;
        let radius = COUPLE.0 + 1.2 * (i / 3) as f64;
        drawing.begin("couple", &name.plain());
        arrow::turn(drawing, style, at, radius, (middle, COUPLE.1), *moment > 0.0);
        let tip = arrow::middle(at, radius, middle);
        let label = Label::at(name.clone(), LETTERS, tip, 0.4).towards(tip - at).ranked(2);
        drawing.label(label.coloured(style.text_role()));
        drawing.end();
    }
}

/// The arms of known forces about the inner hinge of a dyad: from the hinge to the foot on the line of the force.
fn arms(scene: &Scene<'_>, part: &Part, free: &FreeBody, frame: &Frame, drawing: &mut Drawing) {
    let Some(inner) = part.inner else { return };
    let PairKind::Revolute(pins) = &scene.mechanism().pair(inner).kind else { return };
    let Some(pin) = pins.iter().find(|p| part.links.contains(&p.link)) else { return };
    let centre = frame.point(scene.at(pin.link, pin.at));
    let mut drawn = 0;
    for force in free.forces.iter().filter(|f| !f.sought) {
        let at = frame.point(force.at);
        let Some(along) = flipped(force.force).unit() else { continue };
        let foot = at + along * (centre - at).dot(along);
        if (foot - centre).norm() < ARM || drawn == ARMS {
            continue;
        }
        drawn += 1;
        drawing.begin("arm", &force.name.plain());
        drawing.line(Style::Dashed, at, foot);
        drawing.line(Style::Thin, centre, foot);
        let lowered = force.name.runs.iter().filter(|r| r.level == Level::Sub);
        let index: String = lowered.map(|r| r.letters.as_str()).collect();
        let index = if index.is_empty() { force.name.plain() } else { index };
        let name = Text::italic("h").lowered(&index);
        drawing.label(Label::along(name, 3.4, centre, foot).coloured(Role::Grey).ranked(5));
        drawing.end();
    }
}
