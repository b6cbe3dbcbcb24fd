//! The polygon of forces in the textbook's order.

use super::actions::{Force, FreeBody};
use super::{Part, names};
use crate::figures::FORCE;
use crate::inset::flipped;
use crate::paper::{Paper, Scaled};
use crate::scene::Scene;
use crate::symbol::mass;
use assur_drawing::{Drawing, Label, Level, Rect, Scale, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::PairKind;
use assur_text::diagnostic::Diagnosis;

const POINT: f64 = 3.8;
const VECTOR: f64 = 4.0;
/// Vectors shorter than this have no head.
const SHORT: f64 = 0.3;
/// Vectors shorter than this are not drawn.
const NOTHING: f64 = 0.005;
/// A part less than this of a force is rounding.
const ROUNDING: f64 = 1e-9;
/// What names take, mm.
const AROUND: Vec2 = Vec2::new(30.0, 26.0);

/// A side of the polygon.
struct Side {
    name: Text,
    force: Vec2,
    style: Style,
}

/// The sides in order, and for every split reaction its name with the first and the last vertex.
struct Sides {
    sides: Vec<Side>,
    resultants: Vec<(Text, usize, usize)>,
}

/// The polygon of a part; none where it has one force alone, or two and nothing else.
///
/// # Errors
/// A scale is wanted that does not fit.
pub fn draw(
    scene: &Scene<'_>,
    part: &Part,
    free: &FreeBody,
    paper: &Paper,
) -> Result<Option<Drawing>, Diagnosis> {
    let Sides { sides, resultants } = sides(scene, part, free);
    // two forces are opposite on one line: they close without a picture
    if sides.len() < 2 || sides.len() == 2 && part.links.len() == 1 && free.couples.is_empty() {
        return Ok(None);
    }
    let mut corners = vec![Vec2::zero()];
    for side in &sides {
        corners.push(corners[corners.len() - 1] + side.force);
    }
    let mut bounds = Rect::NOTHING;
    corners.iter().for_each(|c| bounds.add(*c));
    let Some(scale) = paper.frame(Scaled::Force, &bounds, AROUND)?.scale else { return Ok(None) };
    let on_paper = |v: Vec2| flipped(v) / scale.factor();
    let links = names(scene, part);
    let said: Vec<String> = sides
        .iter()
        .map(|s| format!("{} {} N", s.name.plain(), scene.figure(s.force.norm(), FORCE)))
        .collect();
    let title = format!(
        "{}: polygon of forces of links {links}{}",
        crate::words::title(scene),
        crate::words::at_position(scene)
    );
    let description =
        format!("Sides in order: {}. The polygon closes. Scale {} N per mm.", said.join(", "), scale.text());
    let id = format!("{}-{}", crate::words::id(scene, "polygon"), links.replace(", ", "-"));
    let mut drawing = Drawing::new(&id, title, description);
    for (i, side) in sides.iter().enumerate() {
        let (a, b) = (on_paper(corners[i]), on_paper(corners[i + 1]));
        arrow(&mut drawing, side.style, a, b, side.name.clone());
    }
    for (name, first, last) in resultants {
        arrow(&mut drawing, Style::Unknown, on_paper(corners[first]), on_paper(corners[last]), name);
    }
    let last = corners.len() - 1;
    // the last corner is the first
    vertices(&mut drawing, &corners[..last].iter().map(|c| on_paper(*c)).collect::<Vec<_>>());
    captions(scene, &mut drawing, &sides, &scale);
    Ok(Some(drawing))
}

fn arrow(drawing: &mut Drawing, style: Style, a: Vec2, b: Vec2, name: Text) {
    if (b - a).norm() < NOTHING {
        return;
    }
    drawing.begin("vector", &name.plain());
    if (b - a).norm() < SHORT {
        drawing.line(style, a, b);
        drawing.end();
        return;
    }
    drawing.mark(style, Shape::Arrow(a, b));
    drawing.label(Label::along(name, VECTOR, a, b).coloured(style.text_role()).ranked(2));
    drawing.end();
}

/// Corners as points with small letters; corners that coincide share one.
fn vertices(drawing: &mut Drawing, corners: &[Vec2]) {
    let middle = corners.iter().fold(Vec2::zero(), |sum, c| sum + *c) / corners.len() as f64;
    let mut done: Vec<Vec2> = Vec::new();
    for corner in corners {
        if done.iter().any(|d| (*d - *corner).norm() < SHORT) {
            continue;
        }
        done.push(*corner);
        mass::point(drawing, *corner);
        let name: String = corners
            .iter()
            .enumerate()
            .filter(|(_, c)| (**c - *corner).norm() < SHORT)
            .map(|(i, _)| letter(i))
            .collect::<Vec<_>>()
            .join(" = ");
        drawing.label(
            Label::at(Text::italic(&name), POINT, *corner, mass::POINT).towards(*corner - middle).ranked(1),
        );
    }
}

/// a, b, … z, a1, …
fn letter(i: usize) -> String {
    let first = char::from(b'a' + u8::try_from(i % 26).unwrap_or(0));
    if i < 26 { first.to_string() } else { format!("{first}{}", i / 26) }
}

fn captions(scene: &Scene<'_>, drawing: &mut Drawing, sides: &[Side], scale: &Scale) {
    let text = Text::italic("μ").lowered("F").and(&format!(" = {} N/mm", scale.text()), false, Level::Base);
    drawing.caption(text);
    for (row, line) in sides.chunks(4).enumerate() {
        let mut text = Text::default();
        for (i, side) in line.iter().enumerate() {
            let at = 4 * row + i;
            let to = if at + 1 == sides.len() { 0 } else { at + 1 };
            let lead = if i > 0 { ",  " } else { "" };
            text = text.and(lead, false, Level::Base).and(
                &format!("{}{}", letter(at), letter(to)),
                true,
                Level::Base,
            );
            text = text.and(" = ", false, Level::Base);
            text.runs.extend(side.name.runs.iter().cloned());
            text = text.and(&format!(" = {} N", scene.figure(side.force.norm(), FORCE)), false, Level::Base);
        }
        drawing.caption(text);
    }
}

/// The sides: what moments give first, then loads link by link, then the two unknown lines, which close it.
fn sides(scene: &Scene<'_>, part: &Part, free: &FreeBody) -> Sides {
    let known = |f: &&Force| !f.sought;
    let style = |f: &Force| if f.sought { Style::Unknown } else { Style::Force };
    let whole = |f: &Force| Side { name: f.name.clone(), force: f.force, style: style(f) };
    let mut found = Sides { sides: Vec::new(), resultants: Vec::new() };
    let of = |i: usize| free.forces.iter().filter(move |f| Some(&f.on) == part.links.get(i));
    let split = |f: &Force| split(scene, part, f);
    let unknown = |i: usize| of(i).find(|f| !known(f));
    if part.links.len() != 2
        || part.links.iter().enumerate().any(|(i, _)| of(i).filter(|f| !known(f)).count() != 1)
    {
        let (first, last): (Vec<&Force>, Vec<&Force>) = free.forces.iter().partition(known);
        found.sides = first.into_iter().chain(last).map(whole).collect();
        return found;
    }
    // R₁₂ᵗ, loads of 2, loads of 3, R₆₃ᵗ, R₆₃ⁿ, R₁₂ⁿ: the resultants go from corner to corner
    let (Some(first), Some(second)) = (unknown(0), unknown(1)) else { return found };
    let (first_parts, second_parts) = (split(first), split(second));
    if let Some([_, tangential]) = &first_parts {
        found.sides.push(part_of(first, "t", *tangential));
    }
    let loaded = found.sides.len();
    found.sides.extend(of(0).chain(of(1)).filter(known).map(whole));
    let before = found.sides.len();
    match &second_parts {
        Some([normal, tangential]) => {
            found.sides.push(part_of(second, "t", *tangential));
            found.sides.push(part_of(second, "n", *normal));
            found.resultants.push((second.name.clone(), before, before + 2));
        }
        None => found.sides.push(whole(second)),
    }
    let closing = found.sides.len();
    match &first_parts {
        Some([normal, _]) => {
            found.sides.push(part_of(first, "n", *normal));
            found.resultants.push((first.name.clone(), closing, loaded));
        }
        None => found.sides.push(whole(first)),
    }
    found
}

fn part_of(force: &Force, kind: &str, value: Vec2) -> Side {
    let mut name = force.name.clone();
    let index = name.runs.pop();
    name = name.raised(kind);
    name.runs.extend(index);
    Side { name, force: value, style: Style::UnknownPart }
}

/// The parts of an unknown reaction of a dyad along and across: of a hinge the line to the inner hinge, or across the inner
/// guide. None where its direction is known.
pub fn split(scene: &Scene<'_>, part: &Part, force: &Force) -> Option<[Vec2; 2]> {
    let pair = force.pair.filter(|_| force.sought)?;
    let mechanism = scene.mechanism();
    if !matches!(mechanism.pair(pair).kind, PairKind::Revolute(_)) {
        return None;
    }
    let along = match &mechanism.pair(part.inner?).kind {
        PairKind::Revolute(pins) => {
            let pin = pins.iter().find(|p| p.link == force.on)?;
            (scene.at(pin.link, pin.at) - force.at).unit()?
        }
        PairKind::Prismatic(g) => g.along.turned(scene.body(g.guide).u),
        _ => return None,
    };
    let normal = along * force.force.dot(along);
    let tangential = force.force - normal;
    // of a link that two forces hold rounding is left across it
    let whole =
        tangential.norm() <= ROUNDING * force.force.norm() || normal.norm() <= ROUNDING * force.force.norm();
    (!whole).then_some([normal, tangential])
}
