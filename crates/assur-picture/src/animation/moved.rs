//! How the marks of a drawing move from frame to frame: those that keep their shape are turned and shifted, the others are
//! drawn anew.

use crate::inset::wrapped;
use assur_drawing::{Anchor, Drawing, Label, Later, Mark, Placed, Rect, Shape, mark_svg, on_circle};
use assur_math::math::Vec2;
use std::collections::HashMap;

/// What two places may differ by and are still one, mm; and two angles, rad.
pub const SAME: f64 = 0.02;
pub const SAME_ANGLE: f64 = 2e-4;

/// What turns less does not turn, rad.
const STILL: f64 = 1e-5;

/// Marks that move together.
#[derive(Clone, Debug)]
pub struct Body {
    /// About which they turn, in the first frame.
    pub centre: Vec2,
    pub turns: bool,
    /// Whether a turn would be seen: not of circles.
    pub directed: bool,
    /// Where that place is in each frame, mm, and how far they have turned, rad.
    pub poses: Vec<(Vec2, f64)>,
}

/// What goes with a place of a body without turning: a label.
#[derive(Clone, Copy, Debug)]
pub struct Follower {
    /// The place in the first frame.
    pub at: Vec2,
    pub body: usize,
}

/// By what a mark or a label moves: an index of bodies, followers, marks that are drawn anew.
#[derive(Clone, Copy, Debug)]
pub enum Mover {
    Body(usize),
    Follower(usize),
    Redrawn(usize),
}

impl Mover {
    /// The class of its group in the document.
    pub fn class(self) -> String {
        match self {
            Self::Body(i) => format!("m{i}"),
            Self::Follower(i) => format!("f{i}"),
            Self::Redrawn(i) => format!("r{i}"),
        }
    }

    /// That of the group of a class.
    pub fn of_class(class: &str) -> Option<Self> {
        let index = class.get(1..)?.parse().ok()?;
        match class.get(..1)? {
            "m" => Some(Self::Body(index)),
            "f" => Some(Self::Follower(index)),
            "r" => Some(Self::Redrawn(index)),
            _ => None,
        }
    }
}

/// A mark that changes its shape, as text in each frame.
pub struct Redrawn(Vec<String>);

impl Redrawn {
    /// The text of a frame.
    pub fn text(&self, frame: usize) -> Option<&str> {
        self.0.get(frame).map(String::as_str)
    }

    /// The texts of every so many frames, each once, and which one each of these frames shows.
    pub fn distinct(&self, every: usize) -> (Vec<&str>, Vec<usize>) {
        let (mut known, mut places) = (Vec::new(), HashMap::new());
        let which = self.0.iter().step_by(every).map(|text| {
            *places.entry(text.as_str()).or_insert_with(|| {
                known.push(text.as_str());
                known.len() - 1
            })
        });
        let which = which.collect();
        (known, which)
    }
}

/// What moves in a drawing.
#[derive(Default)]
pub struct Moved {
    pub bodies: Vec<Body>,
    /// What goes with them.
    pub followers: Vec<Follower>,
    /// What is drawn anew.
    pub redrawn: Vec<Redrawn>,
    /// What moves the marks and the labels.
    pub movers: [Vec<Option<Mover>>; 2],
}

impl Body {
    fn moves(&self) -> bool {
        let still = |(at, angle): &(Vec2, f64)| (*at - self.centre).norm() <= SAME && angle.abs() <= STILL;
        !self.poses.iter().all(still)
    }

    /// Where a place of the first frame is in another.
    pub fn carried(&self, frame: usize, at: Vec2) -> Vec2 {
        let (to, angle) = self.poses[frame];
        to + (at - self.centre).turned(Vec2::direction(angle))
    }

    /// Whether another moves with it: a block on its guide does not turn with the rod on its hinge.
    fn takes(&self, other: &Self) -> bool {
        (!other.directed || self.turns == other.turns)
            && other.poses.iter().enumerate().all(|(k, (at, angle))| {
                (self.carried(k, other.centre) - *at).norm() <= SAME
                    && (!other.directed || wrapped(self.poses[k].1 - angle).abs() < SAME_ANGLE)
            })
    }
}

impl Moved {
    /// Of a drawing and all frames, of which it is the first.
    pub fn of(frames: &[Drawing]) -> Self {
        let mut moved = Self::default();
        let Some(first) = frames.first() else { return moved };
        let found: Vec<Vec<Option<&Mark>>> = frames.iter().map(|frame| matching(first, frame)).collect();
        let bodies: Vec<Option<Body>> = (0..first.marks.len()).map(|i| rigid(&found, i)).collect();
        // those that turn first: circles move with them
        let mut order: Vec<usize> = (0..bodies.len()).collect();
        order.sort_by_key(|i| !bodies[*i].as_ref().is_some_and(|body| body.turns));
        let mut marks = vec![None; first.marks.len()];
        for i in order {
            // the arc of a drive shows its sense and stays with its pivot
            if shows_turn(first, first.marks[i].group) {
                let pivot = pivot(first, &found, first.marks[i].group).filter(Body::moves);
                marks[i] = pivot.map(|body| moved.with(&body));
                continue;
            }
            marks[i] = match &bodies[i] {
                Some(body) if !body.moves() => None,
                Some(body) => Some(moved.with(body)),
                None => {
                    let texts = found.iter().map(|marks| marks[i].map(mark_svg).unwrap_or_default());
                    moved.redrawn.push(Redrawn(texts.collect()));
                    Some(Mover::Redrawn(moved.redrawn.len() - 1))
                }
            };
        }
        let places: Vec<Vec<Option<Vec2>>> = frames.iter().map(|frame| anchors(first, frame)).collect();
        let labels = first.labels.iter().enumerate().map(|(i, label)| {
            if shows_turn(first, label.group) {
                let mut body = pivot(first, &found, label.group).filter(Body::moves)?;
                let beside = anchor(label) - body.centre;
                body.centre += beside;
                body.poses.iter_mut().for_each(|pose| pose.0 += beside);
                return Some(moved.shift_of(body));
            }
            // what has no name in a frame stays where it was
            let mut last = anchor(label);
            let poses = places.iter().map(|anchors| {
                last = anchors[i].unwrap_or(last);
                (last, 0.0)
            });
            let body = Body { centre: anchor(label), turns: false, directed: false, poses: poses.collect() };
            body.moves().then(|| moved.shift_of(body))
        });
        let labels = labels.collect();
        moved.movers = [marks, labels];
        moved
    }

    fn with(&mut self, body: &Body) -> Mover {
        let known = self.bodies.iter().position(|b| b.takes(body));
        Mover::Body(known.unwrap_or_else(|| {
            self.bodies.push(body.clone());
            self.bodies.len() - 1
        }))
    }

    /// Labels are shifted and never turned: they go with a place of a body, else on their own.
    fn shift_of(&mut self, label: Body) -> Mover {
        if let Some(body) = self.bodies.iter().position(|b| b.takes(&label)) {
            self.followers.push(Follower { at: label.centre, body });
            return Mover::Follower(self.followers.len() - 1);
        }
        self.bodies.push(label);
        Mover::Body(self.bodies.len() - 1)
    }

    /// By how much a label is shifted in a frame.
    pub fn shift(&self, label: usize, frame: usize) -> Vec2 {
        let (body, at) = match self.movers[1].get(label).copied().flatten() {
            None | Some(Mover::Redrawn(_)) => return Vec2::zero(),
            Some(Mover::Body(i)) => (&self.bodies[i], self.bodies[i].centre),
            Some(Mover::Follower(i)) => (&self.bodies[self.followers[i].body], self.followers[i].at),
        };
        body.carried(frame, at) - at
    }
}

const fn anchor(label: &Label) -> Vec2 {
    match label.anchor {
        Anchor::Point(at, _) => at,
        Anchor::Line(a, b) => Vec2::new(0.5 * (a.x + b.x), 0.5 * (a.y + b.y)),
    }
}

/// What labels of the first frame meet in another one.
pub fn later(first: &Drawing, frame: &Drawing) -> Later {
    let shifts = first.labels.iter().zip(anchors(first, frame)).map(|(label, there)| {
        let stays = shows_turn(first, label.group);
        there.filter(|_| !stays).map_or(Vec2::zero(), |there| there - anchor(label))
    });
    let moved = frame.marks.iter().filter(|m| !shows_turn(frame, m.group));
    let stay = first.marks.iter().filter(|m| shows_turn(first, m.group));
    Later { marks: moved.chain(stay).cloned().collect(), shifts: shifts.collect() }
}

/// How the pivot moves about which the arc arrow of a group turns.
fn pivot(first: &Drawing, frames: &[Vec<Option<&Mark>>], group: usize) -> Option<Body> {
    let centre = |mark: &Mark| match mark.shape {
        Shape::ArcArrow { centre, .. } => Some(centre),
        _ => None,
    };
    let index = first.marks.iter().position(|mark| mark.group == group && centre(mark).is_some())?;
    let mut last = centre(&first.marks[index])?;
    let poses = frames.iter().map(|marks| {
        last = marks[index].and_then(centre).unwrap_or(last);
        (last, 0.0)
    });
    let poses = poses.collect();
    Some(Body { centre: centre(&first.marks[index])?, turns: false, directed: false, poses })
}

/// Whether a group is the arc arrow of a drive.
fn shows_turn(drawing: &Drawing, group: usize) -> bool {
    let is_arc = |mark: &Mark| mark.group == group && matches!(mark.shape, Shape::ArcArrow { .. });
    drawing.groups.get(group).is_some_and(|g| g.class == "drive") && drawing.marks.iter().any(is_arc)
}

/// The anchors of a frame for each label of the first: of the same group and text.
fn anchors(first: &Drawing, frame: &Drawing) -> Vec<Option<Vec2>> {
    let same =
        |a: &Label, b: &Label| a.text == b.text && first.groups.get(a.group) == frame.groups.get(b.group);
    let mut taken = vec![false; frame.labels.len()];
    let of = first.labels.iter().enumerate().map(|(i, label)| {
        let fits = |j: &usize| !taken[*j] && same(label, &frame.labels[*j]);
        let at = Some(i).filter(|i| *i < frame.labels.len()).filter(fits);
        let at = at.or_else(|| (0..frame.labels.len()).find(fits))?;
        taken[at] = true;
        Some(anchor(&frame.labels[at]))
    });
    of.collect()
}

/// The mark of a frame for each of the first: of the same group, style and place in the group.
fn matching<'d>(first: &Drawing, frame: &'d Drawing) -> Vec<Option<&'d Mark>> {
    let same =
        |a: &Mark, b: &Mark| a.style == b.style && first.groups.get(a.group) == frame.groups.get(b.group);
    if first.marks.len() == frame.marks.len() && first.marks.iter().zip(&frame.marks).all(|(a, b)| same(a, b))
    {
        return frame.marks.iter().map(Some).collect();
    }
    let mut taken = vec![false; frame.marks.len()];
    let mut found = Vec::with_capacity(first.marks.len());
    for mark in &first.marks {
        let at = frame.marks.iter().enumerate().position(|(i, other)| !taken[i] && same(mark, other));
        if let Some(at) = at {
            taken[at] = true;
        }
        found.push(at.map(|at| &frame.marks[at]));
    }
    found
}

/// How a mark moves if it keeps its shape.
fn rigid(frames: &[Vec<Option<&Mark>>], index: usize) -> Option<Body> {
    let first = places(&frames.first()?.get(index).copied().flatten()?.shape);
    let count = first.len() as f64;
    let middle = |points: &[Vec2]| points.iter().fold(Vec2::zero(), |sum, p| sum + *p) / count;
    let centre = middle(&first);
    let has_turn = first.iter().any(|p| (*p - centre).norm() > SAME);
    let mut before = 0.0;
    let mut poses = Vec::with_capacity(frames.len());
    for marks in frames {
        let here = places(&marks[index]?.shape);
        if here.len() != first.len() {
            return None;
        }
        let to = middle(&here);
        let (mut cross, mut dot) = (0.0, 0.0);
        for (a, b) in first.iter().zip(&here) {
            let (a, b) = (*a - centre, *b - to);
            cross += a.cross(b);
            dot += a.dot(b);
        }
        let angle = if has_turn { libm::atan2(cross, dot) } else { 0.0 };
        let u = Vec2::direction(angle);
        let keeps = |(a, b): (&Vec2, &Vec2)| (to + (*a - centre).turned(u) - *b).norm() <= SAME;
        if !first.iter().zip(&here).all(keeps) {
            return None;
        }
        // angles go on without jumps
        before += wrapped(angle - before);
        poses.push((to, before));
    }
    let turns = poses.iter().any(|(_, angle)| angle.abs() > STILL);
    Some(Body { centre, turns, directed: has_turn, poses })
}

/// Places that say where a shape is; one alone of a circle, whose turn is not seen.
fn places(shape: &Shape) -> Vec<Vec2> {
    match shape {
        Shape::Line(a, b) | Shape::Arrow(a, b) => vec![*a, *b],
        Shape::Lines { points, .. } => points.clone(),
        Shape::Strokes(lines) => lines.iter().flat_map(|(a, b)| [*a, *b]).collect(),
        Shape::Circle { centre, .. } => vec![*centre],
        Shape::Arc { centre, radius, from, sweep }
        | Shape::Sector { centre, radius, from, sweep }
        | Shape::ArcArrow { centre, radius, from, sweep } => {
            vec![*centre, on_circle(*centre, *radius, *from), on_circle(*centre, *radius, from + sweep)]
        }
    }
}

// Labels that meet in some frames: the one of lower rank is not shown there.

/// Boxes that share less than this are apart, mm.
const TOUCH: f64 = 0.05;

/// A label that gives way to others.
pub struct Faded {
    pub label: usize,
    pub frames: Vec<bool>,
}

/// The labels that give way in some frame.
pub fn faded(labels: &[Placed], moved: &Moved, frames: usize) -> Vec<Faded> {
    let mut order: Vec<usize> = (0..labels.len()).collect();
    order.sort_by_key(|i| labels[*i].label.rank);
    let mut hidden = vec![Vec::with_capacity(frames); labels.len()];
    let mut shown: Vec<Rect> = Vec::with_capacity(labels.len());
    for frame in 0..frames {
        shown.clear();
        for &i in &order {
            let here = labels[i].bounds.shifted(moved.shift(i, frame));
            let meets = shown.iter().any(|other| meet(&here, other));
            hidden[i].push(meets);
            if !meets {
                shown.push(here);
            }
        }
    }
    let of = hidden.into_iter().enumerate().map(|(label, frames)| Faded { label, frames });
    of.filter(|label| label.frames.contains(&true)).collect()
}

fn meet(a: &Rect, b: &Rect) -> bool {
    let shared = |a: [f64; 2], b: [f64; 2]| a[1].min(b[1]) - a[0].max(b[0]) > TOUCH;
    shared([a.min.x, a.max.x], [b.min.x, b.max.x]) && shared([a.min.y, a.max.y], [b.min.y, b.max.y])
}
