//! Plans of velocities and accelerations: vectors from a pole to the images of points, and between these.

mod acceleration;
mod nodes;
mod velocity;

pub use acceleration::{accelerations, with_accelerations};
pub use nodes::{Nodes, acceleration as acceleration_at, velocity as velocity_at};
pub use velocity::{velocities, with_velocities};

use crate::figures::plain;
use crate::paper::{Frame, Paper, Scaled};
use crate::scene::Scene;
use crate::symbol::mass;
use assur_drawing::{Drawing, Label, Level, Rect, Role, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::LinkId;
use assur_solve::solve::BodyState;
use assur_text::diagnostic::Diagnosis;

/// Sizes of letters at points and at vectors.
const POINT: f64 = 4.4;
const VECTOR: f64 = 4.0;
/// Radius of the circle of the pole, and of a point.
const POLE: f64 = 1.3;
/// Points nearer than this are one, mm.
const SAME: f64 = 0.06;
/// Vectors shorter than this are listed below.
const SHORT: f64 = 0.3;
/// Vectors less than this part of the largest are rounding.
const ROUNDING: f64 = 1e-9;

/// What is said of a plan that has the pole alone.
const NOTHING_MOVES: &str = "No joint and no named point moves: the plan is a point.";

/// Where no vector is more than this part of the natural size, all are rounding.
const NOISE: f64 = 1e-13;

/// A plan that is being drawn.
struct PlanOf {
    drawing: Drawing,
    frame: Frame,
    /// Points that have a dot, with their names.
    dots: Vec<(Vec2, Vec<Text>)>,
    /// Ends of all vectors on paper.
    ends: Vec<Vec2>,
    /// Absolute vectors that are drawn.
    absolute: Vec<Vec2>,
    /// Other vectors that are drawn.
    parts: Vec<Part>,
    largest: f64,
    /// Vectors too short to be drawn, with their values.
    short: Vec<Text>,
    unit: &'static str,
}

/// A vector between the ends of two others: its ends on paper, the number of its label, all names that it has.
struct Part {
    style: Style,
    ends: (Vec2, Vec2),
    label: usize,
    names: Vec<Text>,
}

impl PlanOf {
    /// A plan of vectors that fits into its size; vectors that are rounding beside a natural size are points.
    fn new(
        drawing: Drawing,
        (of, natural): (Scaled, f64),
        room: &[Vec2],
        vectors: &[Vec2],
        paper: &Paper,
    ) -> Result<Self, Diagnosis> {
        let mut bounds = Rect::NOTHING;
        bounds.add(Vec2::zero());
        if room.iter().any(|v| v.norm() > NOISE * natural) {
            room.iter().for_each(|v| bounds.add(*v));
        }
        let frame = paper.plan(of, &bounds, AROUND)?;
        let ends = vectors.iter().map(|v| frame.point(*v)).collect();
        let largest = room.iter().map(|v| v.norm()).fold(0.0, f64::max);
        Ok(Self {
            drawing,
            frame,
            dots: Vec::new(),
            ends,
            absolute: Vec::new(),
            parts: Vec::new(),
            largest,
            short: Vec::new(),
            unit: of.unit(),
        })
    }

    /// The end of a vector from the pole.
    fn end(&self, v: Vec2) -> Vec2 {
        self.frame.point(v)
    }

    fn pole(&mut self, name: Text) {
        self.dots.push((Vec2::zero(), vec![name]));
    }

    /// A point with its name; points that coincide share a dot.
    fn dot(&mut self, v: Vec2, name: Text) {
        let at = self.end(v);
        match self.dots.iter_mut().find(|(p, _)| (*p - at).norm() <= SAME) {
            Some((_, names)) if names.contains(&name) => {}
            Some((_, names)) => names.push(name),
            None => self.dots.push((at, vec![name])),
        }
    }

    /// A vector between the ends of two others, with its name; vectors that coincide share one.
    fn vector(&mut self, style: Style, (from, to): (Vec2, Vec2), name: Text, value: f64) {
        let (a, b) = (self.end(from), self.end(to));
        if (b - a).norm() < SHORT {
            // what rounding leaves is nothing
            if value > ROUNDING * self.largest && self.frame.scale.is_some() {
                let text = format!(" = {} {}", plain(value), self.unit);
                self.short.push(name.and(&text, false, Level::Base));
            }
            return;
        }
        let same = |part: &&mut Part| {
            part.style == style && (part.ends.0 - a).norm() <= SAME && (part.ends.1 - b).norm() <= SAME
        };
        if let Some(part) = self.parts.iter_mut().find(same) {
            part.names.push(name);
            self.drawing.labels[part.label].text = joined(part.names.clone());
            return;
        }
        let label = self.drawing.labels.len();
        self.parts.push(Part { style, ends: (a, b), label, names: vec![name.clone()] });
        self.drawing.begin("vector", &name.plain());
        self.drawing.mark(style, assur_drawing::Shape::Arrow(a, b));
        self.drawing.label(Label::along(name, VECTOR, a, b).coloured(style.text_role()).ranked(2));
        self.drawing.end();
    }

    /// A vector from the pole; one that is there already is not drawn again. Its name is beside the part that no other covers.
    fn absolute(&mut self, style: Style, v: Vec2, name: Text) {
        let end = self.end(v);
        if end.norm() < SHORT || self.absolute.iter().any(|p| (*p - end).norm() <= SAME) {
            return;
        }
        let along = end / end.norm();
        let covered =
            |p: &Vec2| p.cross(along).abs() < 0.5 && p.dot(along) > 0.0 && p.dot(along) < end.norm() - 4.0;
        let from = self.ends.iter().filter(|p| covered(p)).map(|p| p.dot(along)).fold(0.0, f64::max);
        self.drawing.begin("vector", &name.plain());
        self.drawing.mark(style, assur_drawing::Shape::Arrow(Vec2::zero(), end));
        self.drawing
            .label(Label::along(name, VECTOR, along * from, end).coloured(style.text_role()).ranked(2));
        self.drawing.end();
        self.absolute.push(end);
    }

    /// Whether a vector is drawn along a line.
    fn is_covered(&self, a: Vec2, b: Vec2) -> bool {
        self.drawing.marks.iter().any(|mark| match mark.shape {
            assur_drawing::Shape::Arrow(from, to) => {
                let line = assur_drawing::Segment { a: from, b: to };
                line.distance(a) < 0.1 && line.distance(b) < 0.1
            }
            _ => false,
        })
    }

    /// Dots with their names, the pole, the scale.
    fn finish(mut self, symbol: &str, role: Role) -> Drawing {
        let dots = std::mem::take(&mut self.dots);
        let (lengths, points) = (self.lengths(&dots), dots.len());
        for (i, (at, names)) in dots.into_iter().enumerate() {
            self.drawing.begin("point", &names.iter().map(Text::plain).collect::<Vec<_>>().join(" = "));
            if i == 0 {
                self.drawing.mark(Style::Hinge, assur_drawing::Shape::Circle { centre: at, radius: POLE });
            } else {
                mass::point(&mut self.drawing, at);
            }
            let radius = if i == 0 { POLE } else { mass::POINT };
            let label = Label::at(joined(names), POINT, at, radius).ranked(1);
            let label = if i == 0 { self.away_from_vectors(label) } else { label.towards(at) };
            self.drawing.label(label);
            self.drawing.end();
        }
        if let Some(scale) = self.frame.scale {
            let text = Text::italic("μ").and(symbol, true, Level::Sub);
            let text = text.and(&format!(" = {} ({})/mm", scale.text(), self.unit), false, Level::Base);
            self.drawing.caption(text);
            lengths.into_iter().for_each(|line| self.drawing.caption(line));
            self.drawing.description += &format!(" Scale {} {} per mm.", scale.text(), self.unit);
        } else {
            let what = if role == Role::Blue { "velocities" } else { "accelerations" };
            let words = format!("All {what} are zero at this position: the plan is a point.");
            self.drawing.caption(Text::upright(if points == 1 { NOTHING_MOVES } else { &words }));
        }
        for line in self.short.chunks(4) {
            let mut text = Text::upright("Too short to draw: ");
            for (i, short) in line.iter().enumerate() {
                if i > 0 {
                    text = text.and(", ", false, Level::Base);
                }
                text.runs.extend(short.runs.iter().cloned());
            }
            self.drawing.caption(text);
        }
        self.drawing
    }

    /// How long the vectors from the pole are on paper: `pb = 100.0 mm`.
    fn lengths(&self, dots: &[(Vec2, Vec<Text>)]) -> Vec<Text> {
        let Some((_, pole)) = dots.first() else { return Vec::new() };
        let from_pole = |at: &Vec2| self.absolute.iter().any(|end| (*end - *at).norm() <= SAME);
        let ends: Vec<_> = dots[1..].iter().filter(|(at, _)| from_pole(at)).collect();
        let lines = ends.chunks(4).map(|line| {
            let mut text = Text::default();
            for (i, (at, names)) in line.iter().enumerate() {
                text = text.and(if i > 0 { ",  " } else { "" }, false, Level::Base);
                let runs =
                    pole.first().into_iter().chain(names.first()).flat_map(|name| name.runs.iter().cloned());
                text.runs.extend(runs);
                text = text.and(&format!(" = {:.1} mm", at.norm()), false, Level::Base);
            }
            text
        });
        lines.collect()
    }

    /// The pole's name is where no vector goes.
    fn away_from_vectors(&self, label: Label) -> Label {
        match crate::inset::freest(&self.absolute) {
            Some(direction) => label.towards(direction),
            None => label,
        }
    }
}

/// What names of points and vectors take, mm.
const AROUND: Vec2 = Vec2::new(24.0, 20.0);

/// `v_B = 0.15 m/s, v_C = 0.149 m/s` of joints, and of points that the author named where no joint moves; none where there are none.
fn magnitudes(
    scene: &Scene<'_>,
    nodes: &Nodes,
    (letter, unit, dimension): (&str, &str, [i8; 4]),
    of: fn(&BodyState, Vec2) -> Vec2,
) -> Option<String> {
    let said = |name: &str, link: LinkId, at: Vec2| {
        let v = of(scene.body(link), at);
        // squares of great numbers are none
        let value = scene.figure(libm::hypot(v.x, v.y), dimension);
        format!("{letter}_{name} = {value} {unit}")
    };
    let joints = nodes.nodes.iter().filter(|node| !node.fixed);
    let mut all: Vec<String> = joints.map(|node| said(&node.index(), node.link, node.at)).collect();
    if all.is_empty() {
        all.extend(nodes.others(scene).map(|(link, name, at)| said(name, link, at)));
    }
    (!all.is_empty()).then(|| all.join(", "))
}

/// The velocity and the acceleration that the fastest turn gives over the whole mechanism.
fn natural(scene: &Scene<'_>) -> (f64, f64) {
    let extent = assur_solve::solve::extent(&scene.model);
    let bodies = &scene.solved.state.motion.bodies;
    let omega = bodies.iter().map(|b| b.omega.abs()).fold(0.0, f64::max);
    let alpha = bodies.iter().map(|b| b.alpha.abs()).fold(0.0, f64::max);
    (omega * extent, (omega * omega + alpha) * extent)
}

/// `a₂ = a₃`; of many points the first and the last.
pub fn joined(mut names: Vec<Text>) -> Text {
    let mut full = None;
    if names.len() > MOST_NAMES {
        let said: Vec<String> = names.iter().map(Text::plain).collect();
        full = Some(said.join(" = "));
        names.splice(SHOWN_NAMES..names.len() - 1, [Text::upright("…")]);
    }
    let mut all = Text::default();
    for (i, name) in names.into_iter().enumerate() {
        if i > 0 {
            all = all.and(" = ", false, Level::Base);
        }
        all.runs.extend(name.runs);
        all.full = all.full.or(name.full);
    }
    all.full = full.or(all.full);
    all
}

/// The most names of points that coincide in one label, and how many of more are before the last.
const MOST_NAMES: usize = 8;
const SHOWN_NAMES: usize = 3;

/// The name of a point in small letters.
fn small(name: &str, sub: Option<&str>) -> Text {
    let lower: String = name.to_lowercase();
    match sub {
        Some(sub) => Text::name(&lower).lowered(sub),
        None => Text::name(&lower),
    }
}

/// The image of a point of a link which is no joint, with the number of the link where several links have a point of the name.
pub fn other_image(scene: &Scene<'_>, link: LinkId, name: &str) -> Text {
    let links = &scene.mechanism().links;
    let others = links.iter().filter(|other| other.points.iter().any(|point| point.name == name));
    let label = scene.link_label(link);
    let is_clear = others.count() < 2 || name.ends_with(label);
    small(name, (!is_clear).then_some(label))
}

/// The title of a plan.
fn title(scene: &Scene<'_>, what: &str) -> String {
    format!("{}: {what}{}", crate::words::title(scene), crate::words::at_position(scene))
}
