//! Vectors over the sweep by the curve of their ends: the hodograph of a point's velocity, the polar diagram of a reaction.

use crate::diagram::{PARTS, drive_axis, printed, thinned};
use crate::figures::{FORCE, VELOCITY, cleared, rounding};
use crate::paper::{Frame, Paper, Scaled};
use crate::scene::Scene;
use crate::symbol::mass;
use crate::{error, no_diagram, words};
use assur_drawing::{Drawing, Label, Level, Rect, Role, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{Axis, Expr, FindKind, LinkId, Mechanism, PairId, PairKind, PointRef, Query, Value};
use assur_solve::solve::{Course, CourseSet, Pose, PoseOrigin, courses};
use assur_text::diagnostic::Diagnosis;

/// The most vectors at poses.
const MOST: usize = 12;
/// From vector to vector of a drive that turns, from number to number, and a turn, degrees.
const STEP: f64 = 10.0;
const NUMBERED: f64 = 30.0;
const TURN: f64 = 360.0;
/// Axes beyond the curve, mm.
const BEYOND: f64 = 6.0;
/// Sizes of numbers of poses and of names.
const NUMBERS: f64 = 3.1;
const NAMES: f64 = 4.2;
/// Radius of the pole.
const POLE: f64 = 0.9;
/// An arrow on the curve is so long, mm.
const ALONG: f64 = 4.0;

#[derive(Clone, Copy, PartialEq, Eq)]
enum Of {
    Velocity,
    Reaction,
}

/// A vector over the sweep.
pub struct Swept {
    query: Query,
    /// As written: `ram.F`, `B on coupler`.
    plain: String,
    letter: Text,
}

/// Hodographs: of a point of a name, or of all whose velocity the file asks for.
///
/// # Errors
/// No speed, no sweep, no such point.
pub fn hodographs(scene: &Scene<'_>, name: &str, paper: &Paper) -> Result<Vec<Drawing>, Diagnosis> {
    let mut all = points_asked(scene)?;
    if name.is_empty() {
        if all.is_empty() {
            let known = points(scene.mechanism());
            let why = "the file asks for no velocity of a point".to_owned();
            return Err(no_diagram::no_velocity(why, no_diagram::first_item(scene), &known));
        }
    } else {
        let Some(point) = point(scene.mechanism(), name) else {
            let known = points(scene.mechanism());
            let why = format!("no point of a link is named `{name}`");
            return Err(no_diagram::no_velocity(why, no_diagram::link_of(scene, name), &known));
        };
        all = vec![velocity(scene.mechanism(), point, name)];
    }
    drawn(scene, Of::Velocity, &all, paper)
}

/// Polar diagrams of reactions: of a pair of a name, or of all whose reaction the file asks for.
///
/// # Errors
/// No forces, no sweep, no such pair.
pub fn polars(scene: &Scene<'_>, name: &str, paper: &Paper) -> Result<Vec<Drawing>, Diagnosis> {
    let mut all = reactions_asked(scene)?;
    let mechanism = scene.mechanism();
    let known: Vec<String> = reacting(mechanism).map(|id| mechanism.pair(id).name.clone()).collect();
    if name.is_empty() {
        if all.is_empty() {
            let why = "the file asks for no reaction".to_owned();
            return Err(no_diagram::no_reaction(why, no_diagram::first_item(scene), &known));
        }
    } else {
        let Some(id) = reacting(mechanism).find(|id| mechanism.pair(*id).name == name) else {
            let why = format!("no pair is named `{name}`");
            return Err(no_diagram::no_reaction(why, (None, ""), &known));
        };
        all = vec![reaction(scene, id, on(mechanism, id))];
    }
    drawn(scene, Of::Reaction, &all, paper)
}

/// The points whose velocity the file asks for.
///
/// # Errors
/// No speed.
pub fn points_asked(scene: &Scene<'_>) -> Result<Vec<Swept>, Diagnosis> {
    if !scene.model.plan.effects.moving {
        return Err(error::no_speed(scene, "velocities"));
    }
    let mut all = Vec::new();
    asked(scene.mechanism(), &mut |query, text| {
        if let Query::Velocity(point) = query {
            all.push(velocity(scene.mechanism(), *point, text));
        }
    });
    Ok(all)
}

/// The pairs whose reaction it asks for.
///
/// # Errors
/// No forces.
pub fn reactions_asked(scene: &Scene<'_>) -> Result<Vec<Swept>, Diagnosis> {
    crate::forces::loaded(scene)?;
    let (mechanism, mut all) = (scene.mechanism(), Vec::new());
    asked(mechanism, &mut |query, _| {
        if let Query::Reaction(pair, link) = query {
            all.push(reaction(scene, *pair, *link));
        }
    });
    if mechanism.finds.iter().any(|f| matches!(f.kind, FindKind::Reactions)) {
        all.extend(reacting(mechanism).map(|id| reaction(scene, id, on(mechanism, id))));
    }
    Ok(all)
}

/// The questions in the items of `find`, each once, with the name of the item.
pub fn asked(mechanism: &Mechanism, visit: &mut impl FnMut(&Query, &str)) {
    let mut done: Vec<Query> = Vec::new();
    for find in &mechanism.finds {
        let FindKind::Value { expr, .. } = &find.kind else { continue };
        expr.queries(&mut |query| {
            if !done.contains(query) {
                done.push(*query);
                visit(query, &find.name);
            }
        });
    }
}

/// A point by its name, `ram.F` or, where one link alone has it, `F`.
fn point(mechanism: &Mechanism, name: &str) -> Option<PointRef> {
    let (link, point) = name.split_once('.').map_or((None, name), |(link, point)| (Some(link), point));
    let fits = |i: &usize| {
        let own = &mechanism.links[*i];
        link.is_none_or(|link| own.name == link || own.number.as_deref() == Some(link))
    };
    let links = (1..mechanism.links.len()).filter(fits);
    links
        .filter_map(|i| {
            let found = mechanism.links[i].points.iter().find(|p| p.name == point)?;
            Some(PointRef::Fixed(LinkId::at(i), found.at))
        })
        .next()
}

fn points(mechanism: &Mechanism) -> Vec<String> {
    let links = mechanism.links.iter().skip(1);
    links.flat_map(|link| link.points.iter().map(|p| format!("{}.{}", link.name, p.name))).collect()
}

fn velocity(mechanism: &Mechanism, point: PointRef, written: &str) -> Swept {
    let (link, name) = match point {
        PointRef::Fixed(link, at) => {
            let own = mechanism.link(link);
            (link, own.points.iter().find(|p| p.at == at).map(|p| p.name.clone()))
        }
        PointRef::Under(link, _) => (link, None),
    };
    let plain = name
        .as_ref()
        .map_or_else(|| written.to_owned(), |name| format!("{}.{name}", mechanism.link(link).name));
    let letter = Text::italic("v").lowered(name.as_deref().unwrap_or_default());
    Swept { query: Query::Velocity(point), plain, letter }
}

fn reaction(scene: &Scene<'_>, pair: PairId, link: LinkId) -> Swept {
    let mechanism = scene.mechanism();
    let plain = format!("{} on {}", mechanism.pair(pair).name, mechanism.link(link).name);
    let from = mechanism.pair(pair).kind.links().into_iter().find(|l| *l != link).unwrap_or(link);
    Swept { query: Query::Reaction(pair, link), plain, letter: scene.reaction_name(pair, from, link) }
}

/// Pairs with a force.
fn reacting(mechanism: &Mechanism) -> impl Iterator<Item = PairId> {
    let placed = |pair: &assur_model::model::Pair| {
        pair.bearing.is_none() && !matches!(pair.kind, PairKind::Transmission(_))
    };
    mechanism.pairs.iter().enumerate().filter(move |(_, p)| placed(p)).map(|(i, _)| PairId::at(i))
}

/// The link on which the force of a pair is shown: the last that moves.
fn on(mechanism: &Mechanism, pair: PairId) -> LinkId {
    let links = mechanism.pair(pair).kind.links();
    links.into_iter().rfind(|l| *l != LinkId::GROUND).unwrap_or(LinkId::GROUND)
}

fn drawn(scene: &Scene<'_>, of: Of, all: &[Swept], paper: &Paper) -> Result<Vec<Drawing>, Diagnosis> {
    let dimension = if of == Of::Velocity { VELOCITY } else { FORCE };
    let rounding = rounding(scene.greatest.in_si(dimension));
    let set = |swept: &Swept| CourseSet { exprs: components(&swept.query), rounding };
    let sets: Vec<CourseSet> = all.iter().map(set).collect();
    let what = if of == Of::Velocity { "hodograph" } else { "polar diagram" };
    let found = courses(&scene.model, scene.solution, &sets)
        .map_err(|cause| no_diagram::no_sweep(scene, what, &cause))?;
    let mut drawings = Vec::new();
    for (swept, found) in all.iter().zip(found.sets) {
        let lines = joined(&found);
        if !lines.is_empty() {
            let rays = by_degrees(scene, &lines).unwrap_or_else(|| by_poses(scene, &swept.query));
            let ends: Vec<Vec<Vec2>> =
                lines.iter().map(|line| line.iter().map(|point| point.1).collect()).collect();
            drawings.push(picture(scene, of, swept, (&ends, &rays), paper)?);
        }
    }
    if drawings.is_empty() {
        return Err(no_diagram::no_quantity(scene, "nothing that is asked for has a value over the sweep"));
    }
    Ok(drawings)
}

fn components(query: &Query) -> Vec<Expr> {
    let of = |axis| Expr::Component(Box::new(Expr::Query(*query)), axis);
    vec![of(Axis::X), of(Axis::Y)]
}

/// The poses of the sweep.
fn poses<'a>(scene: &Scene<'a>) -> impl Iterator<Item = &'a Pose> {
    scene.solution.poses.iter().filter(|p| matches!(p.origin, PoseOrigin::Sweep(_)))
}

/// The vector at a pose.
fn at(scene: &Scene<'_>, pose: &Pose, query: &Query) -> Option<Vec2> {
    let solved = pose.outcome.as_ref().ok()?;
    match scene.solution.view(&scene.model, solved).query(query) {
        Value::Vector(v) if v.x.is_finite() && v.y.is_finite() => Some(v),
        _ => None,
    }
}

/// A vector over the sweep, with the values of the drive.
type Ends = Vec<(f64, Vec2)>;

/// The lines of a vector from those of its components, which have the same places; apart where it leaves what is shown of it.
fn joined(components: &[Course]) -> Vec<Ends> {
    let [x, y] = components else { return Vec::new() };
    let is_shown = |v: &Vec2| {
        let within =
            |of: &Course, y: f64| of.poles().next().is_none() || (of.window.0..=of.window.1).contains(&y);
        within(x, v.x) && within(y, v.y)
    };
    let mut all: Vec<Ends> = Vec::new();
    for (x, y) in x.lines(PARTS).into_iter().zip(y.lines(PARTS)) {
        let ends: Ends = x.into_iter().zip(y).map(|(x, y)| (x.0, Vec2::new(x.1, y.1))).collect();
        all.extend(ends.split(|point| !is_shown(&point.1)).map(<[_]>::to_vec));
    }
    all.retain(|line| line.len() > 1);
    all
}

fn picture(
    scene: &Scene<'_>,
    of: Of,
    swept: &Swept,
    (lines, rays): (&[Vec<Vec2>], &[Ray]),
    paper: &Paper,
) -> Result<Drawing, Diagnosis> {
    let (what, kind, unit, dimension) = match of {
        Of::Velocity => ("hodograph of the velocity of", "hodograph", "m/s", VELOCITY),
        Of::Reaction => ("polar diagram of the reaction in", "polar", "N", FORCE),
    };
    let title = format!("{}: {what} {}", words::title(scene), swept.plain);
    let most = lines.iter().flatten().map(|v| v.norm()).fold(0.0, f64::max);
    let unit_said = if scene.model.plan.effects.timed || of == Of::Reaction {
        ""
    } else {
        " for a unit speed of the drive"
    };
    let over = if scene.mechanism().simulation.is_some() { "motion" } else { "sweep" };
    let said = format!(
        "Ends of the vectors over the {over}{unit_said}; the greatest is {} {unit}.",
        scene.figure(most, dimension)
    );
    let id = format!("{}-{}", words::id(scene, kind), swept.plain);
    let mut drawing = Drawing::new(&id, title, said);
    let mut bounds = Rect::NOTHING;
    bounds.add(Vec2::zero());
    if cleared(most, scene.greatest.in_si(dimension)) > 0.0 {
        lines.iter().flatten().for_each(|v| bounds.add(*v));
    }
    let scaled = if of == Of::Velocity { Scaled::Velocity } else { Scaled::Force };
    let frame = paper.plan(scaled, &bounds, paper.size * 0.2)?;
    axes(&mut drawing, &frame, &bounds);
    let (thick, role) = match of {
        Of::Velocity => (Style::Velocity, Role::Blue),
        Of::Reaction => (Style::Unknown, Role::Green),
    };
    vectors(&mut drawing, &frame, role, (swept, rays));
    drawing.begin("curve", &swept.plain);
    for line in lines {
        let points = thinned(&line.iter().map(|v| frame.point(*v)).collect::<Vec<_>>());
        if points.len() > 1 {
            sense(&mut drawing, thick, &points);
            drawing.mark(thick, Shape::Lines { points, closed: false });
        }
    }
    drawing.end();
    let origin = frame.point(Vec2::zero());
    drawing.mark(Style::Hinge, Shape::Circle { centre: origin, radius: POLE });
    if let Some(scale) = frame.scale {
        let symbol = if of == Of::Velocity { "v" } else { "F" };
        let text = Text::italic("μ").and(symbol, true, Level::Sub);
        let unit = if unit.contains('/') { format!("({unit})") } else { unit.to_owned() };
        drawing.caption(text.and(&format!(" = {} {unit}/mm", scale.text()), false, Level::Base));
        drawing.description += &format!(" Scale {} {unit} per mm.", scale.text());
    } else {
        drawing.caption(Text::upright("The vector is zero over the whole sweep."));
    }
    Ok(drawing)
}

/// The axes of the ground through the pole.
fn axes(drawing: &mut Drawing, frame: &Frame, bounds: &Rect) {
    let (low, high) = (frame.point(bounds.min), frame.point(bounds.max));
    drawing.begin("axes", "");
    let right = Vec2::new(low.x.max(high.x) + BEYOND, 0.0);
    let up = Vec2::new(0.0, low.y.min(high.y) - BEYOND);
    drawing.line(Style::Axis, Vec2::new(low.x.min(high.x) - BEYOND, 0.0), right);
    drawing.line(Style::Axis, Vec2::new(0.0, low.y.max(high.y) + BEYOND), up);
    for (end, name) in [(right, "x"), (up, "y")] {
        drawing.label(Label::at(Text::italic(name), NAMES, end, 0.4).towards(end).ranked(4));
    }
    drawing.end();
}

/// A vector that is drawn, with what is at its end.
struct Ray {
    at: Vec2,
    words: String,
}

/// Vectors every ten degrees of a drive that turns, with numbers every thirty, or twice that over two turns; none where it
/// does not turn so far.
fn by_degrees(scene: &Scene<'_>, lines: &[Ends]) -> Option<Vec<Ray>> {
    let along = drive_axis(scene);
    let (first, last) = (lines.first()?.first()?, lines.last()?.last()?);
    let [from, to] = [first, last].map(|point| printed(&along, point.0));
    let (from, wide) = (from.min(to), (to - from).abs());
    let turns = (wide / TURN - 1e-9).ceil();
    if along.unit != "deg" || wide < NUMBERED || turns > 2.0 {
        return None;
    }
    let begin = (from / (STEP * turns) - 1e-9).ceil();
    // the last is the first of the next turn
    let whole = (wide / TURN - turns).abs() < 1e-9;
    let end = ((from + wide) / (STEP * turns) + 1e-9).floor() - if whole { 1.0 } else { 0.0 };
    let mut rays = Vec::new();
    let mut i = begin;
    while i <= end {
        let degrees = i * STEP * turns + 0.0;
        let found = lines.iter().find_map(|line| between(line, |drive| printed(&along, drive), degrees));
        let named = (i * STEP / NUMBERED - (i * STEP / NUMBERED).round()).abs() < 1e-9;
        let words = if named { format!("{degrees:.0}°").replace('-', "−") } else { String::new() };
        rays.extend(found.map(|at| Ray { at, words }));
        i += 1.0;
    }
    Some(rays)
}

/// The vector at a value of the drive, between two points of its course.
fn between(course: &[(f64, Vec2)], printed: impl Fn(f64) -> f64, at: f64) -> Option<Vec2> {
    let slack = 1e-6;
    course.windows(2).find_map(|pair| {
        let [(a, v), (b, w)] = [pair[0], pair[1]].map(|(drive, v)| (printed(drive), v));
        let inside = at >= a.min(b) - slack && at <= a.max(b) + slack;
        let share = if a == b { 0.0 } else { ((at - a) / (b - a)).clamp(0.0, 1.0) };
        inside.then(|| v + (w - v) * share)
    })
}

/// Vectors at poses, evenly over the sweep, with the names of the poses, or with the instants.
fn by_poses(scene: &Scene<'_>, query: &Query) -> Vec<Ray> {
    let all: Vec<&Pose> = poses(scene).collect();
    let step = all.len().div_ceil(MOST).max(1);
    let ray = |pose: &&Pose| {
        let solved = pose.outcome.as_ref().ok()?;
        let words = match scene.mechanism().simulation {
            Some(_) => scene.place_text(&drive_axis(scene), solved.state.motion.time),
            None => pose.name.clone(),
        };
        Some(Ray { at: at(scene, pose, query)?, words })
    };
    all.into_iter().step_by(step).filter_map(|pose| ray(&pose)).collect()
}

/// Light vectors; the longest with the letter.
fn vectors(drawing: &mut Drawing, frame: &Frame, role: Role, (swept, rays): (&Swept, &[Ray])) {
    let longest = rays.iter().map(|ray| ray.at.norm()).fold(0.0, f64::max);
    let mut named = false;
    let origin = frame.point(Vec2::zero());
    let mut taken: Vec<Vec2> = Vec::new();
    for ray in rays {
        let end = frame.point(ray.at);
        if (end - origin).norm() < 1.0 {
            continue;
        }
        drawing.begin("vector", &format!("{} {}", swept.plain, ray.words));
        drawing.line(Style::Ghost, origin, end);
        // one number where several share a vector
        if !ray.words.is_empty() && taken.iter().all(|other| (*other - end).norm() > 0.8) {
            mass::point(drawing, end);
            let label = Label::at(Text::upright(&ray.words), NUMBERS, end, 0.6).towards(end - origin);
            drawing.label(label.ranked(4));
            taken.push(end);
        }
        if !named && ray.at.norm() >= longest * (1.0 - 1e-9) {
            named = true;
            drawing.mark(Style::Thin, Shape::Arrow(origin, end));
            let label = Label::along(swept.letter.clone(), NAMES, origin, end);
            drawing.label(label.coloured(role).ranked(1));
        }
        drawing.end();
    }
}

/// An arrow's head on the curve, in the sense of the sweep.
fn sense(drawing: &mut Drawing, style: Style, points: &[Vec2]) {
    let lengths = points.windows(2).map(|p| (p[1] - p[0]).norm());
    let total: f64 = lengths.clone().sum();
    let mut left = total / 24.0;
    for (pair, length) in points.windows(2).zip(lengths) {
        if left <= length && total > 4.0 * ALONG {
            let Some(along) = (pair[1] - pair[0]).unit() else { return };
            let at = pair[0] + along * left;
            drawing.mark(style, Shape::Arrow(at - along * (0.5 * ALONG), at + along * (0.5 * ALONG)));
            return;
        }
        left -= length;
    }
}
