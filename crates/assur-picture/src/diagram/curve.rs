//! A number over the sweep: from the solver's own series where the sweep is followed whole, else from its positions; over a
//! motion under loads from many instants of it.

use crate::figures::{cleared, unit_text};
use crate::scene::Scene;
use assur_drawing::{Level, Text};
use assur_model::model::{Display, DriveTarget, Expr, PairKind, Value};
use assur_solve::solve::{DriveValue, PoseOrigin, SweepCurve, TimeCourse};
use assur_text::units::Dimension;

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

    /// Over a motion under loads; what is rounding beside what its numbers are large against is 0.
    #[must_use]
    pub fn in_time(mut course: TimeCourse, large: f64) -> Self {
        course.lines.iter_mut().flatten().for_each(|point| point.1 = cleared(point.1, large));
        let known =
            |(x, y): (f64, f64)| Some((x, cleared(y, large))).filter(|_| x.is_finite() && y.is_finite());
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

    #[must_use]
    pub fn changes(&self) -> bool {
        let (least, greatest) = self.range();
        greatest - least > 1e-9 * greatest.abs().max(least.abs())
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
