//! A panel: two axes with ticks and grid, and what is drawn in it.

use super::axis::Axis;
use crate::figures::unit_text;
use crate::scene::Scene;
use assur_drawing::{Drawing, Label, Level, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{Display, DriveTarget, Expr, PairKind, Value};
use assur_solve::solve::{DriveValue, PoseOrigin, SweepCurve, TimeCourse};
use assur_text::units::Dimension;

/// Size of the numbers at ticks.
const NUMBERS: f64 = 3.0;
/// Size of names and marked values.
pub const LETTERS: f64 = 3.6;
/// Half a tick, mm.
const TICK: f64 = 0.8;
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

// A number over the sweep: from the solver's own series where the sweep is followed whole, else from its positions; over a
// motion under loads from many instants of it.

/// Points of a curve over the sweep before those are left out that lie on lines between others.
const PARTS: f64 = 480.0;

/// Points that are joined: values of the drive and of the number.
pub type Line = Vec<(f64, f64)>;

/// A number over the sweep, SI.
#[derive(Clone, Debug, Default)]
pub struct Curve {
    /// Its lines, apart where it has no value.
    pub lines: Vec<Line>,
    /// Where it is least and what it is there; none where it is known at positions alone.
    pub least: Option<(f64, f64)>,
    /// The same where it is greatest.
    pub greatest: Option<(f64, f64)>,
}

impl Curve {
    /// Of the solver's series.
    #[must_use]
    pub fn of(course: &SweepCurve) -> Self {
        let lines = vec![course.points(PARTS)];
        Self { lines, least: Some(course.least), greatest: Some(course.greatest) }
    }

    /// Over a motion under loads.
    #[must_use]
    pub fn in_time(course: TimeCourse) -> Self {
        let known = |(x, y): (f64, f64)| (x.is_finite() && y.is_finite()).then_some((x, y));
        Self { least: known(course.least), greatest: known(course.greatest), lines: course.lines }
    }

    /// The least and the greatest number on it.
    #[must_use]
    pub fn range(&self) -> (f64, f64) {
        let own = [self.least, self.greatest].into_iter().flatten().map(|p| p.1);
        let all = self.lines.iter().flatten().map(|p| p.1).chain(own);
        all.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), y| (least.min(y), most.max(y)))
    }

    /// The number at a value of the drive, between the points.
    #[must_use]
    pub fn at(&self, drive: f64) -> Option<f64> {
        let near = |a: f64, b: f64| (drive - a) * (drive - b) <= 0.0;
        self.lines.iter().flat_map(|line| line.windows(2)).find_map(|pair| {
            let ((x_1, y_1), (x_2, y_2)) = (pair[0], pair[1]);
            let part = if x_1 == x_2 { 0.0 } else { (drive - x_1) / (x_2 - x_1) };
            near(x_1, x_2).then_some(y_1 + (y_2 - y_1) * part)
        })
    }
}

/// A number at the positions of the sweep, joined by lines.
#[must_use]
pub fn over_poses(scene: &Scene<'_>, expr: &Expr) -> Curve {
    let mut lines: Vec<Line> = vec![Vec::new()];
    let poses = &scene.solution.poses;
    let count = poses.len().max(2) - 1;
    for (i, pose) in poses.iter().enumerate().filter(|(_, p)| matches!(p.origin, PoseOrigin::Sweep(_))) {
        let x = match pose.drives.first() {
            Some(DriveValue::Scalar(x)) => *x,
            _ => i as f64 / count as f64,
        };
        let y =
            pose.outcome.as_ref().ok().map(|solved| scene.solution.view(&scene.model, solved).value(expr));
        match y {
            Some(Value::Scalar(y)) if y.is_finite() => {
                lines.last_mut().into_iter().for_each(|l| l.push((x, y)))
            }
            _ => lines.push(Vec::new()),
        }
    }
    lines.retain(|line| line.len() > 1);
    Curve { lines, least: None, greatest: None }
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
