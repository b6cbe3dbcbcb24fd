//! Paths of points over the way of the drive, and the mechanism at other poses.

use super::{LinkId, Scheme, Sketch};
use crate::error;
use crate::hodograph::asked as asked_queries;
use crate::scene::Scene;
use assur_drawing::{Drawing, Label, Rect, Role, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{DriveTarget, PairKind, PointRef, Query};
use assur_solve::solve::{Pose, State};
use assur_text::diagnostic::Diagnosis;

/// Radius of a hinge at another pose, and of the point of the crank.
const HINGE: f64 = 0.7;
const POINT: f64 = 0.55;
/// Size of the numbers of poses.
const NUMBER: f64 = 3.1;

/// How far from a line a path is that bends, as a part of its length.
const STRAIGHT: f64 = 1e-3;

/// A point whose path is drawn.
pub struct Traced {
    link: LinkId,
    at: Vec2,
    name: String,
    /// The path ends where it begins, and its last position is left out.
    pub closed: bool,
}

/// The points that are named, as `coupler.S2`; with other poses also the end of the driven link.
///
/// # Errors
/// There is no such point; the drive has no way.
pub fn traced(scene: &Scene<'_>, wanted: &Scheme) -> Result<Vec<Traced>, Diagnosis> {
    let mut traced = Vec::new();
    for name in &wanted.paths {
        traced.push(named(scene, name).ok_or_else(|| error::no_point(scene, name))?);
    }
    if wanted.ghosts > 0
        && let Some((link, at)) = crank_end(scene)
    {
        traced.push(Traced { link, at, name: scene.mechanism().link(link).name.clone(), closed: false });
    }
    if (!traced.is_empty() || wanted.ghosts > 0) && scene.turn.is_empty() {
        return Err(error::no_way(scene));
    }
    Ok(traced)
}

/// The points whose positions, velocities or accelerations the file asks for, each once, where their paths bend.
pub fn asked(scene: &Scene<'_>) -> Vec<Traced> {
    let mechanism = scene.mechanism();
    let mut traced: Vec<Traced> = Vec::new();
    asked_queries(mechanism, &mut |query, name| {
        let (Query::Position(point) | Query::Velocity(point) | Query::Acceleration(point)) = query else {
            return;
        };
        let PointRef::Fixed(link, at) = *point else { return };
        let again = traced.iter().any(|own| own.link == link && own.at == at);
        if link == LinkId::GROUND || !scene.is_placed(link) || again {
            return;
        }
        let own = mechanism.link(link).points.iter().find(|p| p.at == at);
        let name =
            own.map_or_else(|| name.to_owned(), |p| format!("{}.{}", mechanism.link(link).name, p.name));
        let point = Traced { link, at, name, closed: false };
        let places: Vec<Vec2> = path(scene, &point).flatten().collect();
        if bends(&places) {
            traced.push(point);
        }
    });
    traced
}

/// Whether places are not on one line.
fn bends(places: &[Vec2]) -> bool {
    let Some(first) = places.first() else { return false };
    let far = places.iter().map(|at| *at - *first).max_by(|a, b| a.norm().total_cmp(&b.norm()));
    let Some(far) = far.filter(|far| far.norm() > 0.0) else { return false };
    places.iter().any(|at| (*at - *first).cross(far).abs() > STRAIGHT * far.norm() * far.norm())
}

fn named(scene: &Scene<'_>, name: &str) -> Option<Traced> {
    let (link, point) = name.split_once('.')?;
    let mechanism = scene.mechanism();
    let index = mechanism.links.iter().position(|l| l.name == link || l.number.as_deref() == Some(link))?;
    let at = mechanism.links[index].points.iter().find(|p| p.name == point)?.at;
    Some(Traced { link: LinkId::at(index), at, name: name.to_owned(), closed: false })
}

/// The joint of the driven link that is farthest from its hinge.
fn crank_end(scene: &Scene<'_>) -> Option<(LinkId, Vec2)> {
    let mechanism = scene.mechanism();
    let link = mechanism.drives.iter().find_map(|d| match d.target {
        DriveTarget::Link(link) => Some(link),
        DriveTarget::Pair(pair) => match &mechanism.pair(pair).kind {
            PairKind::Revolute(pins) => pins.iter().map(|p| p.link).find(|l| *l != LinkId::GROUND),
            _ => None,
        },
        DriveTarget::Point(..) | DriveTarget::Place(..) => None,
    })?;
    let pins = mechanism.pairs.iter().filter_map(|p| match &p.kind {
        PairKind::Revolute(pins) => pins.iter().find(|pin| pin.link == link).map(|pin| pin.at),
        PairKind::Slot(g) if g.slider == link => Some(g.point),
        _ => None,
    });
    let pins: Vec<Vec2> = pins.collect();
    let pivot = *pins.first()?;
    let far = pins.iter().copied().max_by(|a, b| (*a - pivot).norm().total_cmp(&(*b - pivot).norm()))?;
    ((far - pivot).norm() > 0.0).then_some((link, far))
}

/// Positions of a path in the ground's axes, over the way of the drive or of all positions; `None` where the mechanism does not close.
fn path<'p>(scene: &Scene<'p>, traced: &'p Traced) -> impl Iterator<Item = Option<Vec2>> + use<'p> {
    let place = |state: &State, traced: &Traced| state.motion.bodies[traced.link.index()].position(traced.at);
    let poses = if scene.turn.is_empty() { &scene.solution.poses } else { scene.turn };
    poses.iter().map(move |pose| pose.outcome.as_ref().ok().map(|s| place(&s.state, traced)))
}

/// What paths and other poses take, m.
pub fn extent(scene: &Scene<'_>, wanted: &Scheme, traced: &[Traced], bounds: &mut Rect) {
    for point in traced {
        path(scene, point).flatten().for_each(|at| bounds.add(at));
    }
    for pose in ghosts(scene, wanted.ghosts) {
        let Ok(solved) = &pose.outcome else { continue };
        for pair in &scene.mechanism().pairs {
            if let PairKind::Revolute(pins) = &pair.kind {
                for pin in pins.iter().filter(|p| p.link != LinkId::GROUND && scene.is_placed(p.link)) {
                    bounds.add(solved.state.motion.bodies[pin.link.index()].position(pin.at));
                }
            }
        }
    }
}

/// Other poses: those of the file, evenly, and those of its events; else of the whole turn.
fn ghosts<'p>(scene: &Scene<'p>, count: usize) -> Vec<&'p Pose> {
    let solved = |p: &&'p Pose| p.outcome.is_ok();
    let mut own: Vec<&Pose> =
        scene.solution.poses.iter().take(scene.solution.positions).filter(solved).collect();
    if let [first, .., last] = own.as_slice()
        && comes_again(first, last)
    {
        own.pop();
    }
    let all = if own.len() > 1 { own } else { scene.turn.iter().filter(solved).collect() };
    let count = count.min(all.len());
    let evenly = (0..count).map(|i| i * all.len() / count);
    let chosen: Vec<usize> =
        evenly.chain((0..all.len()).filter(|i| count > 0 && !events(scene, all[*i]).is_empty())).collect();
    let chosen = all.iter().enumerate().filter(|(i, _)| chosen.contains(i)).map(|(_, pose)| *pose);
    chosen.filter(|p| !std::ptr::eq(*p, scene.pose)).collect()
}

/// The events of a sweep at a pose.
fn events<'p>(scene: &Scene<'p>, pose: &Pose) -> Vec<&'p str> {
    let swept = scene.solution.statics.swept.as_ref();
    swept.map_or_else(Vec::new, |_| scene.solution.events_at(scene.model.mechanism, pose))
}

/// The last pose of a whole turn is the first.
fn comes_again(first: &Pose, last: &Pose) -> bool {
    let (Ok(a), Ok(b)) = (&first.outcome, &last.outcome) else { return false };
    let bodies = a.state.motion.bodies.iter().zip(&b.state.motion.bodies);
    let size = a.state.motion.bodies.iter().map(|b| b.p.norm()).fold(0.0, f64::max);
    bodies.into_iter().all(|(a, b)| (a.p - b.p).norm() <= 1e-9 * size && (a.u - b.u).norm() < 1e-9)
}

impl Sketch<'_, '_> {
    /// Paths, dashed.
    pub(super) fn paths(&mut self, drawing: &mut Drawing, traced: &[Traced]) {
        for point in traced {
            drawing.begin("path", &point.name);
            let mut line: Vec<Vec2> = Vec::new();
            let closed = point.closed && path(self.scene, point).all(|at| at.is_some());
            for at in path(self.scene, point).chain([None]) {
                match at {
                    Some(at) => line.push(self.frame.point(at)),
                    None if line.len() > 1 => {
                        let points = std::mem::take(&mut line);
                        drawing.mark(Style::Way, Shape::Lines { points, closed });
                    }
                    None => line.clear(),
                }
            }
            drawing.end();
            self.say(&format!("Path of {}", point.name));
        }
    }

    /// The moving links at other poses, pale, with the number of the pose at the end of the driven link.
    pub(super) fn ghosts(&mut self, drawing: &mut Drawing, count: usize) {
        let crank = crank_end(self.scene);
        let poses = ghosts(self.scene, count);
        for pose in &poses {
            let Ok(solved) = &pose.outcome else { continue };
            drawing.begin("ghost", &pose.name);
            for (i, shape) in self.shapes.iter().enumerate().skip(1) {
                let link = LinkId::at(i);
                let driven = crank.is_some_and(|(l, _)| l == link);
                if driven || !self.scene.is_placed(link) || self.scene.is_in_cylinder(link) {
                    continue;
                }
                let body = &solved.state.motion.bodies[i];
                let outline = shape.outline(self.frame, &|at| body.position(at));
                outline.bars.iter().for_each(|(a, b)| drawing.line(Style::Ghost, *a, *b));
                for plate in outline.plates {
                    drawing.mark(Style::Ghost, Shape::polygon(plate));
                }
            }
            self.ghost_hinges(drawing, &solved.state);
            if let Some((link, at)) = crank {
                let end = self.frame.point(solved.state.motion.bodies[link.index()].position(at));
                drawing.mark(Style::Solid, Shape::Circle { centre: end, radius: POINT });
                if self.is_of_the_file(pose) {
                    let pivot = self.pivot(link).unwrap_or(end);
                    let events = events(self.scene, pose);
                    let name = if events.is_empty() { pose.name.clone() } else { events.join(", ") };
                    let label = Label::at(Text::upright(&name), NUMBER, end, POINT).towards(end - pivot);
                    drawing.label(label.coloured(Role::Grey).ranked(5));
                }
            }
            drawing.end();
        }
        if !poses.is_empty() {
            self.say(&format!("Other poses drawn pale: {}", poses.len()));
        }
    }

    fn is_of_the_file(&self, pose: &Pose) -> bool {
        self.scene.solution.poses.iter().any(|p| std::ptr::eq(p, pose))
    }

    /// Hinges at the ends of sliders.
    fn ghost_hinges(&self, drawing: &mut Drawing, state: &State) {
        for pair in &self.scene.mechanism().pairs {
            if let PairKind::Prismatic(g) = &pair.kind
                && g.guide == LinkId::GROUND
                && self.scene.is_placed(g.slider)
            {
                let centre = self.frame.point(state.motion.bodies[g.slider.index()].position(g.point));
                drawing.mark(Style::Ghost, Shape::Circle { centre, radius: HINGE });
            }
        }
    }
}
