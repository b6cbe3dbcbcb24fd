//! Insets: a circle beside a place that the scale hides, with the place magnified.

use assur_drawing::{Drawing, Label, Rect, Role, Segment, Shape, Style, Text};
use assur_math::math::Vec2;
use std::f64::consts::{PI, TAU};

/// Radius of an inset, mm.
pub const RADIUS: f64 = 12.0;
/// How many times as large the place is in it; places that are hidden even then are larger.
const TIMES: [f64; 10] = [5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1e3, 2e3, 5e3];
/// Radius of the ring around the place, the least that is seen, mm.
const RING: f64 = 2.4;
/// From an inset to all other marks, mm: labels have room between.
const CLEAR: f64 = 6.0;
/// How far an inset may be from its place, and the steps in which a place for it is looked for, mm.
const FAR: f64 = 80.0;
const STEP: f64 = 4.0;
/// From the drawing to an inset that has no room in it, mm.
const BESIDE: f64 = 20.0;
/// Size of the letters below.
const LETTERS: f64 = 3.6;

/// A place with its magnified picture.
#[derive(Clone, Copy, Debug)]
pub struct Inset {
    at: Vec2,
    centre: Vec2,
    times: f64,
}

impl Inset {
    /// The inset of a place, so large that a length there is at least as long as another; drawn with its ring.
    pub fn of(drawing: &mut Drawing, at: Vec2, (length, least): (f64, f64)) -> Option<Self> {
        let times = TIMES.into_iter().find(|times| times * length >= least)?;
        let centre = spot(drawing, at);
        let ring = (RADIUS / times).max(RING);
        let towards = (centre - at).unit()?;
        drawing.mark(Style::Thin, Shape::Circle { centre: at, radius: ring });
        drawing.line(Style::Thin, at + towards * ring, centre - towards * RADIUS);
        drawing.mark(Style::Inset, Shape::Circle { centre, radius: RADIUS });
        Some(Self { at, centre, times })
    }

    /// Where a point of the drawing is in it.
    pub fn point(&self, p: Vec2) -> Vec2 {
        self.centre + (p - self.at) * self.times
    }

    /// Whether a point of the drawing is in it.
    pub fn shows(&self, p: Vec2) -> bool {
        (p - self.at).norm() * self.times < RADIUS - 2.0
    }

    /// A length of the drawing in it.
    pub fn length(&self, l: f64) -> f64 {
        l * self.times
    }

    /// The part of a line of the drawing that is in it.
    pub fn within(&self, a: Vec2, b: Vec2) -> Option<(Vec2, Vec2)> {
        let (a, b) = (self.point(a) - self.centre, self.point(b) - self.centre);
        let along = (b - a).unit()?;
        let foot = a - along * a.dot(along);
        let half = (RADIUS * RADIUS - foot.dot(foot)).max(0.0).sqrt();
        let (from, to) = (a.dot(along).max(-half), b.dot(along).min(half));
        (from < to).then(|| (self.centre + foot + along * from, self.centre + foot + along * to))
    }

    /// A line of the drawing as far as it is in it.
    pub fn line(&self, drawing: &mut Drawing, style: Style, a: Vec2, b: Vec2) {
        if let Some((a, b)) = self.within(a, b) {
            drawing.line(style, a, b);
        }
    }

    /// What is written below: words, and its scale.
    pub fn caption(&self, drawing: &mut Drawing, words: Text, role: Role) {
        let lead = if words.runs.is_empty() { "" } else { ", " };
        let times = assur_text::units::significant(self.times, 4);
        let text = words.and(&format!("{lead}{times} : 1"), false, assur_drawing::Level::Base);
        let below = self.centre + Vec2::new(0.0, RADIUS);
        let label = Label::at(text, LETTERS, below, 0.3).towards(Vec2::new(0.0, 1.0));
        drawing.label(label.coloured(role).ranked(0));
    }
}

/// A place that is clear of all marks, the nearest; right of the drawing where there is none.
fn spot(drawing: &Drawing, at: Vec2) -> Vec2 {
    let all = drawing.extent();
    let reach = FAR + RADIUS + CLEAR;
    let near = |s: &Segment| s.distance(at) < reach;
    let mut segments: Vec<Segment> = Vec::new();
    for mark in &drawing.marks {
        mark.shape.each_segment(|segment| segments.extend(Some(segment).filter(near)));
    }
    let steps = (FAR / STEP) as i32;
    let offers = (-steps..=steps).flat_map(|i| (-steps..=steps).map(move |j| (i, j)));
    let offers = offers.map(|(i, j)| at + flipped(Vec2::new(f64::from(i), f64::from(j))) * STEP);
    let inside = |c: &Vec2| all.contains(&Rect::around(*c, Vec2::new(RADIUS, RADIUS)));
    let offers = offers.map(|c| ((c - at).norm(), c));
    let mut offers: Vec<(f64, Vec2)> = offers.filter(|(away, c)| *away < FAR && inside(c)).collect();
    offers.sort_by(|a, b| a.0.total_cmp(&b.0));
    let beside = Vec2::new(all.max.x + BESIDE, all.centre().y);
    let clear = offers.into_iter().find(|(_, c)| {
        let first = segments.iter().position(|s| s.distance(*c) < RADIUS + CLEAR);
        // what is in the way of one is in the way of those beside it, too
        first.into_iter().for_each(|i| segments.swap(0, i));
        first.is_none()
    });
    clear.map_or(beside, |(_, c)| c)
}

// Directions on paper, whose y axis points down.

/// A direction of the ground's axes on paper, and back.
pub const fn flipped(v: Vec2) -> Vec2 {
    Vec2::new(v.x, -v.y)
}

/// The direction that leaves the most room between others; none where there are no others.
pub fn freest(directions: &[Vec2]) -> Option<Vec2> {
    let mut angles: Vec<f64> = directions.iter().filter_map(|d| d.unit()).map(Vec2::angle).collect();
    angles.sort_by(f64::total_cmp);
    let first = *angles.first()?;
    angles.push(first + TAU);
    let mut widest: Option<(f64, f64)> = None;
    for pair in angles.windows(2) {
        let gap = pair[1] - pair[0];
        if widest.is_none_or(|(most, _)| gap > most + 1e-6) {
            widest = Some((gap, pair[0] + gap / 2.0));
        }
    }
    widest.map(|(_, middle)| Vec2::direction(middle))
}

/// An angle between −π and π.
pub fn wrapped(angle: f64) -> f64 {
    let turned = angle - TAU * (angle / TAU).round();
    if turned <= -PI { turned + TAU } else { turned }
}
