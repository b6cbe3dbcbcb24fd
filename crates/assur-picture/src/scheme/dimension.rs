//! Lengths and offsets that the file gives by name.

use super::{LinkId, Sketch};
use crate::symbol::dimension;
use assur_drawing::{Drawing, Label, Level, Obstacle, Rect, Segment, Text, touches};
use assur_math::math::Vec2;
use assur_model::model::Display;

/// A length of a link that has a name.
#[derive(Clone, Debug, PartialEq)]
pub struct Dimension {
    /// The name of its value.
    pub name: String,
    pub link: LinkId,
    /// What is measured, in the link's axes.
    pub of: Measured,
    /// How the value is printed.
    pub display: Display,
}

/// What a dimension measures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Measured {
    /// From point to point along a direction.
    Length {
        from: Vec2,
        to: Vec2,
        /// The direction, of unit length.
        along: Vec2,
    },
    Radius {
        centre: Vec2,
        /// The radius, m.
        radius: f64,
    },
}

const NAME: f64 = 3.8;
/// The nearest dimension line to what it measures, from line to line, and how many there are.
const NEAREST: f64 = 7.5;
const NEXT: f64 = 5.0;
const LEVELS: u8 = 9;
/// Less than this on paper is listed below.
const LEAST: f64 = 1.2;
/// Half of the strip that a dimension line takes with its name.
const STRIP: f64 = 2.2;
/// Parts of a line that are looked at.
const PART: f64 = 3.0;
/// What crosses a line that leads to a dimension line costs less than what lies in that.
const CROSSED: f64 = 0.25;

/// Where dimension lines and what else is drawn already lie.
struct Room {
    obstacles: Vec<(Rect, Obstacle)>,
    lines: Vec<Segment>,
}

impl Sketch<'_, '_> {
    /// Dimension lines, each where it hides least.
    pub(super) fn dimensions(&mut self, drawing: &mut Drawing, wanted: &[Dimension]) {
        if wanted.is_empty() {
            return;
        }
        let mut room = Room::of(drawing);
        let (mut said, mut short) = (Vec::new(), Vec::new());
        for dimension in wanted.iter().filter(|d| self.scene.is_placed(d.link)) {
            let value = |length: f64| format!(" = {}", self.scene.value_text(&dimension.display, length));
            drawing.begin("dimension", &dimension.name);
            let (length, is_drawn) = match dimension.of {
                Measured::Length { from, to, along } => {
                    let ends = [from, to].map(|at| self.on_paper(dimension.link, at));
                    let along_paper = self.direction(dimension.link, along);
                    let is_drawn = length(drawing, &mut room, &dimension.name, ends, along_paper);
                    ((to - from).dot(along).abs(), is_drawn)
                }
                Measured::Radius { centre, radius } => {
                    let at = self.on_paper(dimension.link, centre);
                    (radius, round(drawing, &mut room, &dimension.name, at, self.frame.length(radius)))
                }
            };
            drawing.end();
            said.push(format!("{}{}", dimension.name, value(length)));
            if !is_drawn {
                short.push(Text::name(&dimension.name).and(&value(length), false, Level::Base));
            }
        }
        if !said.is_empty() {
            self.say(&format!("Dimensions: {}", said.join(", ")));
        }
        short.into_iter().for_each(|text| drawing.caption(text));
    }
}

/// A length; whether it is long enough to be drawn.
fn length(drawing: &mut Drawing, room: &mut Room, name: &str, [a, b]: [Vec2; 2], along: Vec2) -> bool {
    let span = (b - a).dot(along);
    if span.abs() < LEAST {
        return false;
    }
    let feet = |level: u8, side: Vec2| {
        let far = a.dot(side).max(b.dot(side)) + NEAREST + NEXT * f64::from(level);
        [a, b].map(|end| end + side * (far - end.dot(side)))
    };
    let normal = along.perp();
    let places = (0..LEVELS).flat_map(|level| [normal, -normal].map(|side| (level, feet(level, side))));
    let price = |(level, [p, q]): &(u8, [Vec2; 2])| {
        let leads = room.hits(a, *p) + room.hits(b, *q);
        room.hits(*p, *q) + room.lines_at(*p, *q) + CROSSED * leads + 0.6 * f64::from(*level)
    };
    let priced = places.map(|place| (price(&place), place.1));
    let Some((_, feet)) = priced.min_by(|a, b| a.0.total_cmp(&b.0)) else { return false };
    dimension::between(drawing, [a, b], feet);
    label(drawing, room, name, feet);
    true
}

/// A radius; whether it is long enough to be drawn.
fn round(drawing: &mut Drawing, room: &mut Room, name: &str, centre: Vec2, radius: f64) -> bool {
    if radius < LEAST {
        return false;
    }
    let rims = (0..12)
        .map(|i| centre + Vec2::direction(std::f64::consts::TAU * (f64::from(i) + 0.5) / 12.0) * radius);
    let priced = rims.map(|rim| (room.hits(centre, rim) + room.lines_at(centre, rim), rim));
    let Some((_, rim)) = priced.min_by(|a, b| a.0.total_cmp(&b.0)) else { return false };
    dimension::radius(drawing, centre, rim);
    label(drawing, room, name, [centre, rim]);
    true
}

fn label(drawing: &mut Drawing, room: &mut Room, name: &str, [p, q]: [Vec2; 2]) {
    drawing.label(Label::along(Text::name(name), NAME, p, q).ranked(3));
    room.lines.push(Segment { a: p, b: q });
}

impl Room {
    fn of(drawing: &Drawing) -> Self {
        let solid = drawing.marks.iter().filter(|mark| mark.style.is_solid());
        let all = solid.flat_map(|mark| mark.shape.obstacles(mark.style.half_width()));
        let boxed = |obstacle: Obstacle| (extent(&obstacle), obstacle);
        Self { obstacles: all.map(boxed).collect(), lines: Vec::new() }
    }

    /// How many parts of a line are on what is drawn.
    fn hits(&self, a: Vec2, b: Vec2) -> f64 {
        let reach = Segment { a, b }.bounds().grown(STRIP);
        let near: Vec<&Obstacle> =
            self.obstacles.iter().filter(|(bounds, _)| bounds.overlaps(&reach)).map(|(_, o)| o).collect();
        let hit =
            |at: Vec2| near.iter().any(|o| touches(&Rect::around(at, Vec2::new(STRIP, STRIP)), true, o, 0.0));
        parts(a, b).filter(|at| hit(*at)).count() as f64
    }

    /// The same of dimension lines, which lie on none.
    fn lines_at(&self, a: Vec2, b: Vec2) -> f64 {
        let reach = 2.0 * STRIP;
        let hit = |at: Vec2| self.lines.iter().any(|line| line.distance(at) < reach);
        3.0 * parts(a, b).filter(|at| hit(*at)).count() as f64
    }
}

/// The box of an obstacle.
fn extent(obstacle: &Obstacle) -> Rect {
    match obstacle {
        Obstacle::Stroke(segment, half) => segment.bounds().grown(*half),
        Obstacle::Disc(centre, radius) => Rect::around(*centre, Vec2::new(*radius, *radius)),
    }
}

/// Points along a line.
fn parts(a: Vec2, b: Vec2) -> impl Iterator<Item = Vec2> {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // millimetres of paper
    let count = ((b - a).norm() / PART).ceil().clamp(1.0, 200.0) as u32;
    (0..=count).map(move |i| a + (b - a) * (f64::from(i) / f64::from(count)))
}
