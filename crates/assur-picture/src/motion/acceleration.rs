//! The plan of accelerations: normal, Coriolis, tangential and sliding parts.

use super::nodes::{Node, Nodes, acceleration, rank};
use super::velocity::images;
use super::{NOTHING_MOVES, PlanOf, magnitudes, natural, title};
use crate::error;
use crate::figures::ACCELERATION;
use crate::paper::{Paper, Scaled};
use crate::scene::Scene;
use assur_drawing::{Drawing, Role, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::LinkId;
use assur_text::diagnostic::Diagnosis;

/// The points of a plan.
///
/// # Errors
/// No drive has a speed; no link has a place.
pub fn with_accelerations(scene: &Scene<'_>) -> Result<Nodes, Diagnosis> {
    if !scene.model.plan.effects.timed {
        return Err(error::no_speed(scene, "accelerations"));
    }
    let nodes = Nodes::of(scene, false);
    if nodes.nodes.is_empty() {
        return Err(error::nothing_placed(scene, "a plan shows accelerations of points"));
    }
    Ok(nodes)
}

/// The plan of accelerations at a position.
///
/// # Errors
/// No drive has a speed; no link has a place.
pub fn accelerations(scene: &Scene<'_>, paper: &Paper) -> Result<Drawing, Diagnosis> {
    let nodes = with_accelerations(scene)?;
    let all: Vec<Vec2> = nodes.nodes.iter().map(|n| n.acceleration(scene)).collect();
    let parts = parts(scene, &nodes);
    let mut ends = all.clone();
    ends.extend(parts.iter().flat_map(|p| [p.from, p.to]));
    let pole = nodes.pole(scene);
    let description = match magnitudes(scene, &nodes, ("a", "m/s²", ACCELERATION), acceleration) {
        Some(said) => format!("Accelerations from the pole {pole}′: {said}."),
        None => NOTHING_MOVES.to_owned(),
    };
    let id = crate::words::id(scene, "accelerations");
    let drawing = Drawing::new(&id, title(scene, "acceleration plan"), description);
    ends.extend(Nodes::extent(scene, acceleration));
    let natural = natural(scene).1;
    let mut plan = PlanOf::new(drawing, (Scaled::Acceleration, natural), &ends, &all, paper)?;
    plan.pole(Text::italic(pole).and("′", false, assur_drawing::Level::Base));
    for (node, a) in nodes.nodes.iter().zip(&all).filter(|(n, _)| !n.fixed) {
        plan.absolute(Style::Acceleration, *a, Text::italic("a").lowered(&node.index()));
    }
    for part in parts {
        plan.vector(part.style, (part.from, part.to), part.name, (part.to - part.from).norm());
        if let Some(name) = part.end {
            plan.dot(part.to, name);
        }
    }
    for (node, a) in nodes.nodes.iter().zip(&all).filter(|(n, _)| !n.fixed) {
        plan.dot(*a, node.image());
    }
    images(scene, &nodes, &mut plan, acceleration);
    Ok(plan.finish("a", Role::Vermilion))
}

/// A part of an acceleration, from the pole.
struct Part {
    style: Style,
    from: Vec2,
    to: Vec2,
    name: Text,
    /// The name of its end, where the next part begins.
    end: Option<Text>,
}

fn named(kind: &str, of: &str) -> Text {
    Text::italic("a").raised(kind).lowered(of)
}

/// What is drawn beside the absolute vectors.
fn parts(scene: &Scene<'_>, nodes: &Nodes) -> Vec<Part> {
    let mut parts = Vec::new();
    for link in 1..scene.mechanism().links.len() {
        let id = LinkId::at(link);
        let on = nodes.on(id);
        if let Some((base, other)) = solved_between(scene, id, &on) {
            turning(scene, id, base, other, &mut parts);
        }
    }
    for (first, second) in &nodes.centres {
        replaced(scene, &nodes.nodes[*first.min(second)], &nodes.nodes[*first.max(second)], &mut parts);
    }
    for sliding in &nodes.sliding {
        let (slider, guide) = (&nodes.nodes[sliding.slider], &nodes.nodes[sliding.guide]);
        let later = rank(scene, slider.link) > rank(scene, guide.link);
        let (known, found) = if later { (guide, slider) } else { (slider, guide) };
        let omega = scene.body(guide.link).omega;
        let v = found.velocity(scene) - known.velocity(scene);
        let coriolis = v.perp() * (2.0 * omega);
        let (from, to) = (known.acceleration(scene), found.acceleration(scene));
        let index = format!("{}{}", found.index(), known.index());
        let several = nodes.sliding.len() > 1;
        let k = if several { Text::italic("k").lowered(&found.index()) } else { Text::italic("k") };
        let style = Style::AccelerationPart;
        parts.push(Part { style, from, to: from + coriolis, name: named("k", &index), end: Some(k) });
        let style = Style::AccelerationTangent;
        parts.push(Part { style, from: from + coriolis, to, name: named("r", &index), end: None });
    }
    parts
}

/// Normal and tangential part of the link that replaces a contact: it joins the centres.
fn replaced(scene: &Scene<'_>, base: &Node, other: &Node, parts: &mut Vec<Part>) {
    let r = other.at - base.at;
    let squared = r.dot(r);
    if base.fixed || other.fixed || squared <= 0.0 {
        return;
    }
    let omega = r.cross(other.velocity(scene) - base.velocity(scene)) / squared;
    let (from, to) = (base.acceleration(scene), other.acceleration(scene));
    let normal = from - r * (omega * omega);
    let index = format!("{}{}", other.index(), base.index());
    let n = Text::italic("n").lowered(&index);
    let style = Style::AccelerationPart;
    parts.push(Part { style, from, to: normal, name: named("n", &index), end: Some(n) });
    let style = Style::AccelerationTangent;
    parts.push(Part { style, from: normal, to, name: named("t", &index), end: None });
}

/// The two points of a link between which its rotation shows: the fixed or the first one, and the one by which its group finds
/// it. A driven link that turns uniformly has the normal part alone, which is its absolute acceleration.
fn solved_between<'n>(scene: &Scene<'_>, link: LinkId, on: &[&'n Node]) -> Option<(&'n Node, &'n Node)> {
    let base = on.iter().find(|n| n.fixed).or(on.first())?;
    let others: Vec<&&Node> = on.iter().filter(|n| !std::ptr::eq(**n, *base) && !n.fixed).collect();
    let of_group = |n: &&&&Node| n.links.iter().all(|l| rank(scene, *l) == rank(scene, link));
    let other = others.iter().find(of_group).or(others.first())?;
    let uniform = base.fixed && scene.body(link).alpha == 0.0;
    (!uniform).then_some((*base, **other))
}

/// Normal and tangential part of one point of a link about another.
fn turning(scene: &Scene<'_>, link: LinkId, base: &Node, other: &Node, parts: &mut Vec<Part>) {
    let body = scene.body(link);
    let r = other.at - base.at;
    let from = base.acceleration(scene);
    let normal = from - r * (body.omega * body.omega);
    let to = acceleration(body, other.at);
    let index = if base.fixed { other.index() } else { format!("{}{}", other.index(), base.index()) };
    let n = Text::italic("n").lowered(scene.link_label(link));
    let style = Style::AccelerationPart;
    parts.push(Part { style, from, to: normal, name: named("n", &index), end: Some(n) });
    let style = Style::AccelerationTangent;
    parts.push(Part { style, from: normal, to, name: named("t", &index), end: None });
}
