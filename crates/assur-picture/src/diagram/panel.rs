//! A panel: two axes with ticks and grid, and what is drawn in it.

use super::axis::Axis;
use crate::figures::unit_text;
use crate::scene::Scene;
use assur_drawing::{Drawing, Label, Level, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{Display, DriveTarget, PairKind};
use assur_text::units::Dimension;

/// Size of the numbers at ticks.
const NUMBERS: f64 = 3.0;
/// Size of names and marked values.
pub const LETTERS: f64 = 3.6;
/// Half a tick, mm.
const TICK: f64 = 0.8;
/// Half a stroke across an axis that is cut, mm.
const CUT: f64 = 1.2;
/// How far the axes go beyond the panel, mm.
const BEYOND: f64 = 4.5;
/// How near to the line between its neighbours a point is left out, mm.
const STRAIGHT: f64 = 0.012;

/// A panel on paper.
#[derive(Clone, Copy, Debug)]
pub struct Panel {
    /// Its upper edge; its left one is at null.
    pub top: f64,
    /// Its width and height, mm.
    pub size: Vec2,
    /// Values of the drive, as printed.
    pub x: Axis,
    /// The numbers, as printed.
    pub y: Axis,
}

impl Panel {
    /// A point on paper.
    #[must_use]
    pub fn at(&self, x: f64, y: f64) -> Vec2 {
        let up = self.y.share(y);
        Vec2::new(self.x.share(x) * self.size.x, self.top + (1.0 - up) * self.size.y)
    }

    #[must_use]
    pub fn bottom(&self) -> f64 {
        self.top + self.size.y
    }

    /// Grid, axes, ticks; numbers below where it is the lowest of several.
    pub fn draw(&self, drawing: &mut Drawing, title: Text, below: Option<Text>) {
        drawing.begin("axes", "");
        for (y, _) in self.y.ticks() {
            drawing.line(Style::Grid, self.at(self.x.from, y), self.at(self.x.to, y));
        }
        let zero = 0.0_f64.clamp(self.y.from, self.y.to);
        let right = self.at(self.x.to, zero);
        drawing.mark(Style::Medium, Shape::Arrow(self.at(self.x.from, zero), right + Vec2::new(BEYOND, 0.0)));
        let tip = Vec2::new(0.0, self.top - BEYOND);
        drawing.mark(Style::Medium, Shape::Arrow(Vec2::new(0.0, self.bottom()), tip));
        let across =
            |x: f64| (self.at(x, zero) - Vec2::new(0.0, TICK), self.at(x, zero) + Vec2::new(0.0, TICK));
        let level = |y: f64| (self.at(self.x.from, y) - Vec2::new(TICK, 0.0), self.at(self.x.from, y));
        let ticks: Vec<_> =
            self.x.ticks().map(|t| across(t.0)).chain(self.y.ticks().map(|t| level(t.0))).collect();
        drawing.mark(Style::Medium, Shape::Strokes(ticks));
        for (y, written) in self.y.ticks() {
            let at = self.at(self.x.from, y);
            drawing.label(number(written, at, TICK + 0.3, Vec2::new(-1.0, 0.0)));
        }
        drawing.label(Label::at(title, LETTERS, tip, 0.6).towards(Vec2::new(1.0, 0.15)).ranked(1));
        if let Some(name) = below {
            for (x, written) in self.x.ticks() {
                let at = Vec2::new(self.at(x, zero).x, self.bottom());
                drawing.label(number(written, at, TICK + 0.4, Vec2::new(0.0, 1.0)));
            }
            let end = right + Vec2::new(BEYOND, 0.0);
            drawing.label(Label::at(name, LETTERS, end, 0.4).towards(Vec2::new(1.0, 0.3)).ranked(1));
        }
        drawing.end();
    }

    /// A curve: its lines in the units of the axes.
    pub fn curve(&self, drawing: &mut Drawing, style: Style, lines: &[Line]) {
        for line in lines {
            let points = thinned(&line.iter().map(|(x, y)| self.at(*x, *y)).collect::<Vec<_>>());
            if points.len() > 1 {
                drawing.mark(style, Shape::Lines { points, closed: false });
            }
        }
    }

    /// Marks that an axis goes on beyond what is shown of it: above, or below.
    pub fn cut(&self, drawing: &mut Drawing, above: bool) {
        let y = if above { self.top - CUT } else { self.bottom() - 1.5 * CUT };
        let strokes = [-0.4, 0.4].map(|i| {
            let at = Vec2::new(0.0, y + i * CUT);
            (at + Vec2::new(-CUT, 0.4 * CUT), at + Vec2::new(CUT, -0.4 * CUT))
        });
        drawing.mark(Style::Medium, Shape::Strokes(strokes.to_vec()));
    }

    pub fn dot(&self, drawing: &mut Drawing, x: f64, y: f64) -> Vec2 {
        let at = self.at(x, y);
        drawing.mark(Style::Solid, Shape::Circle { centre: at, radius: 0.7 });
        at
    }
}

fn number(written: String, at: Vec2, radius: f64, towards: Vec2) -> Label {
    Label::at(Text::upright(&written), NUMBERS, at, radius).towards(towards).ranked(0)
}

/// The points without those that lie on the line between two that stay.
#[must_use]
pub fn thinned(points: &[Vec2]) -> Vec<Vec2> {
    let Some(last) = points.len().checked_sub(1) else { return Vec::new() };
    let mut stays = vec![false; points.len()];
    (stays[0], stays[last]) = (true, true);
    let mut open = vec![(0, last)];
    while let Some((from, to)) = open.pop() {
        let (a, b) = (points[from], points[to]);
        let along = (b - a).unit();
        let away = |p: Vec2| along.map_or((p - a).norm(), |u| (p - a).cross(u).abs());
        let far = (from + 1..to).map(|i| (i, away(points[i])));
        let farthest = far.fold((from, STRAIGHT), |most, here| if here.1 > most.1 { here } else { most });
        if farthest.0 != from {
            stays[farthest.0] = true;
            open.extend([(from, farthest.0), (farthest.0, to)]);
        }
    }
    points.iter().zip(stays).filter(|(_, stays)| *stays).map(|(p, _)| *p).collect()
}

/// Points of a number over the sweep, before those are left out that lie on lines between others.
pub const PARTS: f64 = 480.0;

/// Points that are joined: values of the drive and of the number.
pub type Line = Vec<(f64, f64)>;

/// What of lines lies between two numbers; they end on them.
#[must_use]
pub fn clipped(lines: &[Line], (low, high): (f64, f64)) -> Vec<Line> {
    let mut all: Vec<Line> = Vec::new();
    for line in lines {
        let mut part = Line::new();
        for pair in line.windows(2) {
            let ((x_1, y_1), (x_2, y_2)) = (pair[0], pair[1]);
            let at = |y: f64| if y_1 == y_2 { 0.0 } else { ((y - y_1) / (y_2 - y_1)).clamp(0.0, 1.0) };
            let (from, to) = if y_1 <= y_2 { (at(low), at(high)) } else { (at(high), at(low)) };
            let middle = y_1 + (y_2 - y_1) * (0.5 * (from + to));
            if (from >= to && y_1 != y_2) || middle < low || middle > high {
                all.push(std::mem::take(&mut part));
                continue;
            }
            let to = if y_1 == y_2 { 1.0 } else { to };
            let point = |share: f64| match share {
                0.0 => (x_1, y_1),
                1.0 => (x_2, y_2),
                _ => (x_1 + (x_2 - x_1) * share, y_1 + (y_2 - y_1) * share),
            };
            if from > 0.0 {
                all.push(std::mem::take(&mut part));
            }
            if part.is_empty() {
                part.push(point(from));
            }
            part.push(point(to));
        }
        all.push(part);
    }
    all.retain(|line| line.len() > 1);
    all
}

// Numbers, units and the drive's name as they stand in a diagram.

/// The letter of what the numbers run over: t of a motion under loads; of a sweep φ of a link or a hinge, s of a slider; the share of the sweep where the drive moves a
/// point.
#[must_use]
pub fn drive_label(scene: &Scene<'_>) -> Text {
    let mechanism = scene.mechanism();
    if mechanism.simulation.is_some() {
        return Text::italic("t");
    }
    match mechanism.drives.first().map(|d| d.target) {
        Some(DriveTarget::Link(link)) => scene.indexed("φ", link),
        Some(DriveTarget::Pair(pair)) => {
            let pair = mechanism.pair(pair);
            let turns = matches!(pair.kind, PairKind::Revolute(_));
            Text::italic(if turns { "φ" } else { "s" }).lowered(&pair.name)
        }
        _ => Text::upright("share of the sweep"),
    }
}

/// How the drive's value, or the instant, is printed.
#[must_use]
pub fn drive_axis(scene: &Scene<'_>) -> Display {
    let mechanism = scene.mechanism();
    if mechanism.simulation.is_some() {
        return mechanism.display_of(Dimension::TIME);
    }
    let drive = mechanism.drives.first().filter(|d| !matches!(d.target, DriveTarget::Point(..)));
    drive.map_or_else(Display::default, |drive| mechanism.drive_display(drive.target))
}

/// A name, a comma and a unit.
#[must_use]
pub fn with_unit(name: Text, power: &str, unit: &str) -> Text {
    let unit = format!("{power}{}", unit_text(unit));
    if unit.is_empty() { name } else { name.and(&format!(", {unit}"), false, Level::Base) }
}

/// An SI number in the unit of a display.
#[must_use]
pub fn printed(display: &Display, si: f64) -> f64 {
    display.of_si(si)
}

/// A line in the units of its axes.
#[must_use]
pub fn scaled(line: &Line, along: &Display, display: &Display) -> Line {
    line.iter().map(|(x, y)| (printed(along, *x), printed(display, *y))).collect()
}
