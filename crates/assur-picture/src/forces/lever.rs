//! Zhukovsky's lever: the plan of velocities turned by 90°, with the forces at the images of their points. The moments of
//! all forces about the pole add up to nothing, which is the balance of powers.

use super::actions::Force;
use super::is_loaded;
use super::powers::{self, Term};
use crate::error;
use crate::figures::{cleared, plain};
use crate::inset::{flipped, freest};
use crate::motion::{Nodes, joined, other_image, velocity_at};
use crate::paper::{Frame, Paper, Scaled};
use crate::scene::Scene;
use crate::symbol::{arrow, hinge, mass};
use assur_drawing::{Drawing, Label, Level, Rect, Segment, Shape, Style, Text};
use assur_math::math::{ROUNDING, Vec2};
use assur_model::model::{DriveTarget, LinkId, PairKind};
use assur_text::diagnostic::Diagnosis;

/// Lengths of arrows, mm: the least, and what the greatest force adds.
const ARROW: (f64, f64) = (8.0, 12.0);
/// What arrows and names take, mm.
const AROUND: Vec2 = Vec2::new(60.0, 50.0);
const POINT: f64 = 4.2;
const LETTERS: f64 = 4.0;
/// Images that are one, mm.
const SAME: f64 = 0.06;
/// Forces that have room on a usual sheet, and from one image to the nearest for half of them where there are more, mm.
const USUAL: usize = 8;
const BETWEEN: f64 = 16.0;
/// The most forces of which a plan can be read.
const READABLE: usize = 60;
/// The largest sheet without the lines below it, mm.
const MOST: Vec2 = Vec2::new(227.0, 166.0);
/// What is nearer to a bar lies on it, mm.
const ON_BAR: f64 = 0.3;
/// Powers less than this part of the greatest there could be are none.
const DEAD: f64 = 1e-12;

/// The images of a file that has a lever.
///
/// # Errors
/// There are no velocities, no forces, or no link has a place.
pub fn levered(scene: &Scene<'_>) -> Result<(Nodes, Vec<Term>), Diagnosis> {
    if !scene.model.plan.effects.moving {
        return Err(error::no_speed(scene, "velocities"));
    }
    super::determined(scene)?;
    if !is_loaded(&scene.model) {
        return Err(super::nothing_loads());
    }
    if scene.mechanism().drives.iter().any(|d| matches!(d.target, DriveTarget::Point(..))) {
        let help = "the lever needs the whole machine; `forces` draws the group";
        return Err(error::no_forces_by_drive(
            scene,
            "a driven point replaces the rest of the machine",
            "a driven point",
            help,
        ));
    }
    let nodes = Nodes::of(scene, false);
    if nodes.nodes.is_empty() {
        return Err(error::nothing_placed(scene, "the lever is a plan of velocities"));
    }
    let terms = powers::terms(scene);
    let fastest = greatest(scene)[1];
    let turns = |f: &Force| image(scene, f.on, f.at).norm() > ROUNDING * fastest;
    if !terms.iter().flat_map(|term| &term.forces).any(turns) {
        let help = "draw another position, or `forces`";
        return Err(error::no_forces("on a lever they have no arm: each acts at a point at rest", help));
    }
    Ok((nodes, terms))
}

/// The lever at a position.
///
/// # Errors
/// It has none, or too many forces to be read.
pub fn lever(scene: &Scene<'_>, paper: &Paper) -> Result<Drawing, Diagnosis> {
    let (nodes, terms) = levered(scene)?;
    let mut forces: Vec<&Force> = terms.iter().flat_map(|term| &term.forces).collect();
    let most = forces.iter().map(|f| f.force.norm()).fold(0.0, f64::max);
    forces.retain(|f| f.force.norm() > ROUNDING * most);
    if forces.len() > READABLE {
        return Err(crowded(forces.len()));
    }
    let mut bounds = Rect::NOTHING;
    bounds.add(Vec2::zero());
    nodes.nodes.iter().for_each(|n| bounds.add(turned(scene, n.velocity(scene))));
    forces.iter().for_each(|f| bounds.add(image(scene, f.on, f.at)));
    nodes.others(scene).for_each(|(link, _, at)| bounds.add(image(scene, link, at)));
    let arms = || terms.iter().flat_map(|term| &term.arms);
    arms().for_each(|(link, arm)| arm.iter().for_each(|at| bounds.add(image(scene, *link, *at))));
    let frame = roomy(scene, &forces, &bounds, paper)?;
    let largest = terms.iter().map(|t| t.power.abs()).fold(0.0, f64::max);
    let sum: f64 = terms.iter().map(|t| t.power).sum();
    // where nothing does work, at a dead position, all terms are rounding
    let [most, speed] = greatest(scene);
    let scale = if largest > DEAD * most * speed { largest } else { most * speed };
    let share = if scale > 0.0 { sum.abs() / scale } else { 0.0 };
    let powers: Vec<(Text, f64)> = terms
        .iter()
        .filter(|t| t.power.abs() > ROUNDING * largest)
        .map(|t| (t.name.clone(), cleared(t.power, scale)))
        .collect();
    let said: Vec<String> =
        powers.iter().map(|(name, p)| format!("{} {}", name.plain(), plain(*p))).collect();
    let acting: Vec<String> =
        forces.iter().map(|f| format!("{} {} N", f.name.plain(), plain(f.force.norm()))).collect();
    let title =
        format!("{}: Zhukovsky’s lever{}", crate::words::title(scene), crate::words::at_position(scene));
    let description = format!(
        "The plan of velocities turned by 90 degrees, with the forces. Forces: {}. Moments about the pole, W: {}. Their sum is {share:.0e} of the largest.",
        acting.join(", "),
        said.join(", ")
    );
    let mut drawing = Drawing::new(&crate::words::id(scene, "lever"), title, description);
    plan(scene, &nodes, &frame, &mut drawing);
    for (link, arm) in arms() {
        let [a, b] = arm.map(|at| frame.point(image(scene, *link, at)));
        drawing.line(Style::Thin, a, b);
    }
    arrows(scene, &frame, &forces, &mut drawing);
    captions(&mut drawing, &frame, nodes.pole(scene), &powers);
    let open = terms.iter().filter(|t| t.open && t.power.abs() > ROUNDING * largest);
    without_arrows(&mut drawing, open.map(|t| &t.name));
    Ok(drawing)
}

fn crowded(count: usize) -> Diagnosis {
    let message = format!("{count} forces act at once: of more than {READABLE} a lever cannot be read");
    Diagnosis::error("mech::picture::crowded", message)
        .help("draw `forces`, each body alone; `find powers` lists the power of every load")
}

/// The frame of the plan, larger where many forces act at images that are close together.
fn roomy(scene: &Scene<'_>, forces: &[&Force], bounds: &Rect, paper: &Paper) -> Result<Frame, Diagnosis> {
    let frame = paper.plan(Scaled::Velocity, bounds, AROUND)?;
    let mut images: Vec<Vec2> = Vec::new();
    for force in forces {
        let at = frame.point(image(scene, force.on, force.at));
        if images.iter().all(|other| (*other - at).norm() > SAME) {
            images.push(at);
        }
    }
    let nearest = |at: &Vec2| {
        let apart = images.iter().map(|other| (*other - *at).norm()).filter(|apart| *apart > 0.0);
        apart.fold(f64::INFINITY, f64::min)
    };
    let mut apart: Vec<f64> = images.iter().map(nearest).collect();
    apart.sort_by(f64::total_cmp);
    let half = apart.get(apart.len() / 2).copied().unwrap_or(BETWEEN);
    if !paper.grows || forces.len() <= USUAL || half >= BETWEEN {
        return Ok(frame);
    }
    let plan = (paper.size - AROUND) * (BETWEEN / half) + AROUND;
    let size = Vec2::new(plan.x.min(MOST.x), plan.y.min(MOST.y));
    Paper { size, ..*paper }.plan(Scaled::Velocity, bounds, AROUND)
}

/// The greatest force and the greatest moment, and the greatest speeds, as a force and a velocity.
fn greatest(scene: &Scene<'_>) -> [f64; 2] {
    let state = &scene.solved.state;
    let (mut force, mut moment, mut v, mut omega) = (0.0_f64, 0.0_f64, 0.0_f64, 0.0_f64);
    for wrench in &state.forces.applied {
        (force, moment) = (force.max(wrench.force.norm()), moment.max(wrench.moment.abs()));
    }
    for body in &state.motion.bodies {
        (v, omega) = (v.max(body.v.norm()), omega.max(body.omega.abs()));
    }
    let extent = assur_solve::solve::extent(&scene.model);
    [force + moment / extent, v + omega * extent]
}

/// A velocity turned by 90° against the first link that turns, so that the image of a crank lies as the crank.
fn turned(scene: &Scene<'_>, v: Vec2) -> Vec2 {
    let turning = scene.solved.state.motion.bodies.iter().map(|b| b.omega).find(|omega| *omega != 0.0);
    if turning.unwrap_or(1.0) > 0.0 { -v.perp() } else { v.perp() }
}

/// The image of a point of a link, turned.
fn image(scene: &Scene<'_>, link: LinkId, at: Vec2) -> Vec2 {
    turned(scene, velocity_at(scene.body(link), at))
}

/// The turned plan: the pole on its support, images of the links as bars.
fn plan(scene: &Scene<'_>, nodes: &Nodes, frame: &Frame, drawing: &mut Drawing) {
    let paper = |v: Vec2| frame.point(turned(scene, v));
    let mut bars: Vec<Segment> = Vec::new();
    for i in 1..scene.mechanism().links.len() {
        let link = LinkId::at(i);
        let ends: Vec<Vec2> = nodes.on(link).iter().map(|n| paper(n.velocity(scene))).collect();
        let Some((first, others)) = ends.split_first() else { continue };
        drawing.begin("link", &scene.mechanism().link(link).name);
        for other in others {
            if (*other - *first).norm() > 0.1 {
                drawing.line(Style::Medium, *first, *other);
                bars.push(Segment { a: *first, b: *other });
            }
        }
        drawing.end();
    }
    hinge::support(drawing, Vec2::zero());
    let mut done: Vec<Vec2> = Vec::new();
    let mut names: Vec<(Vec2, Vec<Text>)> = Vec::new();
    for node in nodes.nodes.iter().filter(|n| !n.fixed) {
        let at = paper(node.velocity(scene));
        // what slides on the ground is carried by the pole
        if node.links.iter().any(|l| slides(scene, *l)) && at.norm() > 0.1 {
            drawing.line(Style::Medium, Vec2::zero(), at);
            bars.push(Segment { a: Vec2::zero(), b: at });
        }
        match names.iter_mut().find(|(p, _)| (*p - at).norm() < SAME) {
            Some((_, images)) => images.push(node.image()),
            None => names.push((at, vec![node.image()])),
        }
    }
    for (link, name, at) in nodes.others(scene) {
        let at = frame.point(image(scene, link, at));
        if names.iter().all(|(p, _)| (*p - at).norm() > SAME) {
            names.push((at, vec![other_image(scene, link, name)]));
            // its velocity, where no bar shows it
            if bars.iter().all(|bar| bar.distance(at * 0.5) > ON_BAR) {
                drawing.line(Style::Thin, Vec2::zero(), at);
            }
        }
    }
    for (at, images) in names {
        drawing.begin("point", &images.iter().map(Text::plain).collect::<Vec<_>>().join(" = "));
        let name = joined(images);
        if at.norm() > hinge::RADIUS && done.iter().all(|d| (*d - at).norm() > SAME) {
            mass::point(drawing, at);
        }
        done.push(at);
        drawing.label(Label::at(name, POINT, at, mass::POINT).towards(at).ranked(1));
        drawing.end();
    }
    hinge::moving(drawing, Vec2::zero());
    let away = freest(&done).map_or(Vec2::new(-1.0, 0.0), |d| d);
    drawing.label(
        Label::at(Text::italic(nodes.pole(scene)), POINT, Vec2::zero(), hinge::RADIUS)
            .towards(away)
            .ranked(1),
    );
}

/// Whether a link has a guide on the ground.
fn slides(scene: &Scene<'_>, link: LinkId) -> bool {
    let on_ground = |kind: &PairKind| matches!(kind, PairKind::Prismatic(g) if g.slider == link && g.guide == LinkId::GROUND);
    scene.mechanism().pairs.iter().any(|p| on_ground(&p.kind))
}

fn arrows(scene: &Scene<'_>, frame: &Frame, forces: &[&Force], drawing: &mut Drawing) {
    let largest = forces.iter().map(|f| f.force.norm()).fold(0.0, f64::max);
    let mut lines = arrow::OnLines::default();
    for force in forces {
        let Some(along) = flipped(force.force).unit() else { continue };
        let length = ARROW.0 + ARROW.1 * force.force.norm() / largest;
        let from = lines.begin(frame.point(image(scene, force.on, force.at)), along, length);
        let style = if force.sought { Style::Unknown } else { Style::Force };
        drawing.begin("vector", &force.name.plain());
        drawing.mark(style, Shape::Arrow(from, from + along * length));
        let label = Label::along(
            force.name.clone(),
            LETTERS,
            from + along * (0.5 * length),
            from + along * (length + 2.0),
        );
        drawing.label(label.coloured(style.text_role()).ranked(2));
        drawing.end();
    }
}

/// Terms of links that have no place.
fn without_arrows<'t>(drawing: &mut Drawing, terms: impl Iterator<Item = &'t Text>) {
    let names: Vec<String> = terms.map(Text::plain).collect();
    if !names.is_empty() {
        drawing.caption(Text::upright("Without arrows, of links that have no place:"));
        drawing.caption(Text::upright(&names.join(", ")));
    }
}

fn captions(drawing: &mut Drawing, frame: &Frame, pole: &str, terms: &[(Text, f64)]) {
    if let Some(scale) = frame.scale {
        let text = Text::italic("μ").and("v", true, Level::Sub);
        drawing.caption(text.and(&format!(" = {} (m/s)/mm", scale.text()), false, Level::Base));
    }
    if terms.is_empty() {
        return;
    }
    let sum = Text::upright("Σ").and("M", true, Level::Base).and(pole, true, Level::Sub);
    let mut text = sum.and(" = 0 (W):  ", false, Level::Base);
    for (i, (name, power)) in terms.iter().enumerate() {
        let lead = if i > 0 { ",  " } else { "" };
        text = text.and(lead, false, Level::Base);
        text.runs.extend(name.runs.iter().cloned());
        text = text.and(&format!(": {}", plain(*power)), false, Level::Base);
    }
    drawing.caption(text);
}
