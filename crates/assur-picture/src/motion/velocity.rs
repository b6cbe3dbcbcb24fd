//! The plan of velocities.

use super::nodes::{Node, Nodes, velocity};
use super::{NOTHING_MOVES, PlanOf, magnitudes, natural, title};
use crate::error;
use crate::figures::VELOCITY;
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
pub fn with_velocities(scene: &Scene<'_>) -> Result<Nodes, Diagnosis> {
    if !scene.model.plan.effects.moving {
        return Err(error::no_speed(scene, "velocities"));
    }
    let nodes = Nodes::of(scene, true);
    if nodes.nodes.is_empty() {
        return Err(error::nothing_placed(scene, "a plan shows velocities of points"));
    }
    Ok(nodes)
}

/// The plan of velocities at a position.
///
/// # Errors
/// No drive has a speed; no link has a place.
pub fn velocities(scene: &Scene<'_>, paper: &Paper) -> Result<Drawing, Diagnosis> {
    let nodes = with_velocities(scene)?;
    let all: Vec<Vec2> = nodes.nodes.iter().map(|n| n.velocity(scene)).collect();
    let ratios = if scene.model.plan.effects.timed { "" } else { " for a unit speed of the drive" };
    let pole = nodes.pole(scene);
    let description = match magnitudes(scene, &nodes, ("v", "m/s", VELOCITY), velocity) {
        Some(said) => format!("Velocities from the pole {pole}{ratios}: {said}."),
        None => NOTHING_MOVES.to_owned(),
    };
    let id = crate::words::id(scene, "velocities");
    let drawing = Drawing::new(&id, title(scene, "velocity plan"), description);
    let mut room = Nodes::extent(scene, velocity);
    room.extend(&all);
    let natural = natural(scene).0;
    let mut plan = PlanOf::new(drawing, (Scaled::Velocity, natural), &room, &all, paper)?;
    plan.pole(Text::italic(pole));
    let is_of = |n: &Node| !n.fixed;
    for (node, v) in nodes.nodes.iter().zip(&all).filter(|(n, _)| is_of(n)) {
        plan.absolute(Style::Velocity, *v, Text::italic("v").lowered(&node.index()));
    }
    relative(scene, &nodes, &mut plan);
    for (node, v) in nodes.nodes.iter().zip(&all).filter(|(n, _)| is_of(n)) {
        plan.dot(*v, node.image());
    }
    images(scene, &nodes, &mut plan, velocity);
    if !scene.model.plan.effects.timed {
        plan.drawing.caption(Text::upright("For a unit speed of the drive: the file gives its sense alone."));
    }
    Ok(plan.finish("v", Role::Blue))
}

/// Velocities of points of one link against each other, and of sliding.
fn relative(scene: &Scene<'_>, nodes: &Nodes, plan: &mut PlanOf) {
    for link in 1..scene.mechanism().links.len() {
        let on = nodes.on(LinkId::at(link));
        let Some((base, others)) = on.split_first() else { continue };
        if on.iter().any(|n| n.fixed) {
            continue;
        }
        for other in others {
            let ends = (base.velocity(scene), other.velocity(scene));
            let name = Text::italic("v").lowered(&format!("{}{}", other.index(), base.index()));
            plan.vector(Style::VelocityPart, ends, name, (ends.1 - ends.0).norm());
        }
    }
    for (first, second) in &nodes.centres {
        let (a, b) = (&nodes.nodes[*first.min(second)], &nodes.nodes[*first.max(second)]);
        if !a.fixed && !b.fixed {
            let ends = (a.velocity(scene), b.velocity(scene));
            let name = Text::italic("v").lowered(&format!("{}{}", b.index(), a.index()));
            plan.vector(Style::VelocityPart, ends, name, (ends.1 - ends.0).norm());
        }
    }
    for sliding in &nodes.sliding {
        let (slider, guide) = (&nodes.nodes[sliding.slider], &nodes.nodes[sliding.guide]);
        // from the one that is known first
        let later = super::nodes::rank(scene, slider.link) > super::nodes::rank(scene, guide.link);
        let (known, found) = if later { (guide, slider) } else { (slider, guide) };
        let ends = (known.velocity(scene), found.velocity(scene));
        let name = Text::italic("v").lowered(&format!("{}{}", found.index(), known.index()));
        plan.vector(Style::VelocityPart, ends, name, (ends.1 - ends.0).norm());
    }
}

/// Images of further points of links, by similarity.
pub fn images(
    scene: &Scene<'_>,
    nodes: &Nodes,
    plan: &mut PlanOf,
    of: fn(&assur_solve::solve::BodyState, Vec2) -> Vec2,
) {
    let near = 1e-7 * assur_solve::solve::extent(&scene.model);
    for (i, link) in scene.mechanism().links.iter().enumerate().skip(1) {
        let id = LinkId::at(i);
        if !scene.is_placed(id) || scene.is_in_cylinder(id) {
            continue;
        }
        let on = nodes.on(id);
        for point in &link.points {
            let at = scene.at(id, point.at);
            if on.iter().any(|n| (n.at - at).norm() <= near) {
                continue;
            }
            let v = of(scene.body(id), at);
            // the image of the link, as far as the point is not on it
            for node in on.iter().take(2) {
                let from = of(scene.body(id), node.at);
                let (a, b) = (plan.end(from), plan.end(v));
                if (b - a).norm() > 1.0 && !plan.is_covered(a, b) {
                    plan.drawing.line(Style::Ghost, a, b);
                }
            }
            plan.dot(v, super::other_image(scene, id, &point.name));
        }
    }
}
