//! A part of the mechanism freed from the rest, with all that acts on it, and the arms of forces about the inner hinge.

use super::actions::{Couple, FreeBody};
use super::polygon::split;
use super::{Part, names};
use crate::figures::{FORCE, MOMENT};
use crate::inset::flipped;
use crate::paper::{Frame, Paper, Scaled};
use crate::scene::Scene;
use crate::scheme::{Freed, length_scale};
use crate::shape::LinkShape;
use crate::symbol::arrow;
use assur_drawing::{Drawing, Label, Level, Rect, Role, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::PairKind;
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
    let freed = Freed(&part.links);
    freed.extent(scene, all, &mut bounds);
    free.forces.iter().for_each(|f| bounds.add(f.at));
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
    freed.draw(scene, all, &frame, &mut drawing);
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
