//! The work of a flywheel over the cycle: above the effort with its mean and the areas between them, below the work with the
//! fluctuation [W] between its extremes.

use crate::diagram::{
    Axis, LETTERS, Line, PARTS, Panel, drive_axis, drive_label, hatched, printed, scaled, with_unit,
};
use crate::scene::Scene;
use crate::wittenbauer::{Wittenbauer, links};
use crate::{no_diagram, words};
use assur_drawing::{Drawing, Label, Level, Role, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{
    BalanceKind, BinaryOp, Display, Expr, Flywheel, FlywheelPart, FlywheelTorque, LinkId, Query,
};
use assur_solve::solve::{Course, CourseSet, FlywheelAnswer, courses};
use assur_text::diagnostic::Diagnosis;
use assur_text::units::Dimension;

/// Width of the panels, mm, and their heights.
const WIDTH: f64 = 132.0;
const HEIGHTS: [f64; 2] = [58.0, 56.0];
/// Between the panels, mm.
const BETWEEN: f64 = 16.0;
/// Where [W] stands, right of the panels, mm.
const BESIDE: f64 = 14.0;
/// An area of less than this part of [W] has no number.
const SMALL: f64 = 0.02;

/// A flywheel with what its picture is made of.
struct Sheet<'a> {
    wheel: &'a Flywheel,
    found: &'a FlywheelAnswer,
    torque: Course,
    /// Mean of the torque on the shaft of the drive.
    mean: f64,
    along: Display,
    moment: Display,
    energy: Display,
}

/// Per flywheel its work, and Wittenbauer's diagram where the links count.
///
/// # Errors
/// There is none.
pub fn work(scene: &Scene<'_>) -> Result<Vec<Drawing>, Diagnosis> {
    let wheels = scene.mechanism().flywheels.iter().zip(&scene.solution.statics.flywheels);
    let wheels: Vec<(&Flywheel, &FlywheelAnswer)> = wheels.collect();
    if wheels.is_empty() {
        return Err(no_diagram::no_flywheel(scene));
    }
    let numbers = |(i, (wheel, found)): (usize, &(&Flywheel, &FlywheelAnswer))| {
        let own = Expr::Query(Query::Flywheel(i, FlywheelPart::Torque));
        let torque = Expr::Binary(BinaryOp::Mul, Box::new(own), Box::new(Expr::number(found.ratio)));
        let exprs = std::iter::once(torque).chain(links(scene, i, wheel, found)).collect();
        CourseSet { exprs, rounding: 0.0 }
    };
    let sets: Vec<CourseSet> = wheels.iter().enumerate().map(numbers).collect();
    let all = courses(&scene.model, scene.solution, &sets)
        .map_err(|cause| no_diagram::no_sweep(scene, "work", &cause))?;
    let mut drawings = Vec::new();
    for ((wheel, found), courses) in wheels.into_iter().zip(all.sets) {
        let mut courses = courses.into_iter();
        let Some(torque) = courses.next() else { continue };
        let sheet = Sheet {
            wheel,
            found,
            torque,
            mean: found.mean_torque * found.ratio,
            along: drive_axis(scene),
            moment: scene.mechanism().display_of(Dimension::TORQUE),
            energy: Display { unit: "J".to_owned(), factor: 1.0, ..Display::default() },
        };
        drawings.push(sheet.draw(scene));
        let diagram = courses.next().map(|links| Wittenbauer::of(wheel, found, &links, drive_axis(scene)));
        drawings.extend(diagram.and_then(|diagram| diagram.draw(scene)));
    }
    Ok(drawings)
}

impl Sheet<'_> {
    fn draw(&self, scene: &Scene<'_>) -> Drawing {
        let title = format!("{}: work of the flywheel {}", words::title(scene), self.wheel.name);
        let id = format!("{}-{}", words::id(scene, "work"), self.wheel.name);
        let mut drawing = Drawing::new(&id, title, self.said(scene));
        let (first, length) = self.torque.interval;
        let (from, to) = (printed(&self.along, first), printed(&self.along, first + length));
        let x = Axis::between(from, to, 13.0, self.along.unit == "deg");
        let upper = self.efforts(scene, &mut drawing, x);
        let lower = self.works(scene, &mut drawing, x, upper.bottom() + BETWEEN);
        drawing.begin("projection", "");
        for at in self.found.extremes {
            let at = printed(&self.along, at);
            drawing.line(
                Style::Dashed,
                upper.at(at, printed(&self.moment, self.mean)),
                lower.at(at, lower.y.from),
            );
        }
        drawing.end();
        drawing
    }

    /// The effort, its mean, the areas.
    fn efforts(&self, scene: &Scene<'_>, drawing: &mut Drawing, x: Axis) -> Panel {
        let (least, greatest) = self.torque.window;
        let [low, high, mean] =
            [least.min(self.mean), greatest.max(self.mean), self.mean].map(|si| printed(&self.moment, si));
        let panel =
            Panel { top: 0.0, size: Vec2::new(WIDTH, HEIGHTS[0]), x, y: Axis::around(low, high, 7.0) };
        let line: Line = scaled(&self.torque.lines(PARTS).concat(), &self.along, &self.moment);
        self.areas(scene, drawing, &panel, &line, mean);
        let name = self.letter(scene);
        panel.draw(drawing, with_unit(name.clone(), &panel.y.power_text(), &self.moment.unit), None);
        drawing.begin("mean", "");
        let (from, to) = (panel.at(x.from, mean), panel.at(x.to, mean));
        drawing.line(Style::Velocity, from, to);
        let text = Text::italic("M").lowered("m").and(
            &format!(" = {}", scene.value_text(&self.moment, self.mean)),
            false,
            Level::Base,
        );
        let label = Label::at(text, LETTERS, to, 0.4).towards(Vec2::new(1.0, -0.4)).ranked(1);
        drawing.label(label.coloured(Role::Blue));
        drawing.begin("curve", &self.wheel.name);
        panel.curve(drawing, Style::Curve1, &[line]);
        drawing.end();
        panel
    }

    /// Where the effort does more work than its mean, hatched, and where it does less, with the work between.
    fn areas(&self, scene: &Scene<'_>, drawing: &mut Drawing, panel: &Panel, line: &Line, mean: f64) {
        let mut ends: Vec<f64> = self.torque.crossings(self.mean);
        let (first, length) = self.torque.interval;
        ends.insert(0, first);
        ends.push(first + length);
        drawing.begin("areas", "");
        for pair in ends.windows(2) {
            let (from, to) = (printed(&self.along, pair[0]), printed(&self.along, pair[1]));
            let inside = line.iter().filter(|(x, _)| (*x > from && *x < to) || (*x < from && *x > to));
            let mut corners = vec![panel.at(from, mean)];
            // at the ends of the sweep and at jumps the curve does not begin on the mean
            let near =
                |x: f64, y: f64| (x - from).abs().min((x - to).abs()) < 1e-9 * (to - from).abs() && y != mean;
            let edges = line.iter().filter(|(x, y)| near(*x, *y));
            let mut all: Vec<(f64, f64)> = inside.chain(edges).copied().collect();
            all.sort_by(|a, b| if length < 0.0 { b.0.total_cmp(&a.0) } else { a.0.total_cmp(&b.0) });
            let above = all.iter().map(|p| p.1 - mean).sum::<f64>() > 0.0;
            all.retain(|p| (p.1 >= mean) == above);
            corners.extend(all.iter().map(|(x, y)| panel.at(*x, *y)));
            corners.push(panel.at(to, mean));
            let work = self.between(pair[0], pair[1]);
            if corners.len() < 4 {
                continue;
            }
            // backwards a torque below the mean gives more than the mean
            if above == (length > 0.0) {
                let lines = hatched(&corners);
                drawing.mark(Style::Surplus, Shape::polygon(corners));
                drawing.mark(Style::Hatch, Shape::Strokes(lines));
            } else {
                drawing.mark(Style::Want, Shape::polygon(corners));
            }
            if work.abs() > SMALL * self.found.fluctuation {
                let most = all.iter().map(|p| p.1).fold(mean, |a, b| if (b > a) == above { b } else { a });
                let middle = panel.at(0.5 * (from + to), mean + 0.45 * (most - mean));
                let text = Text::upright(&scene.value_text(&self.energy, work));
                drawing.label(Label::at(text, 3.0, middle, 0.0).towards(Vec2::new(0.0, -1.0)).ranked(5));
            }
        }
        drawing.end();
    }

    /// The work done between two values of the drive, J; over the ends of the cycle it begins anew.
    fn between(&self, from: f64, to: f64) -> f64 {
        let (first, length) = self.found.interval;
        let at = |x: f64| {
            let share = (x - first) / length;
            if share <= 1e-12 || share >= 1.0 - 1e-12 { 0.0 } else { self.found.work(x) }
        };
        at(to) - at(from)
    }

    /// The work with [W] between its extremes.
    fn works(&self, scene: &Scene<'_>, drawing: &mut Drawing, x: Axis, top: f64) -> Panel {
        let (first, length) = self.found.interval;
        let points = (0..=360).map(|i| first + length * f64::from(i) / 360.0);
        let mut places: Vec<f64> = points.chain(self.found.splits.iter().copied()).collect();
        places.extend(self.found.extremes);
        places.sort_by(|a, b| if length < 0.0 { b.total_cmp(a) } else { a.total_cmp(b) });
        let value = |x: f64| self.between(first, x);
        let line: Line = places.iter().map(|at| (printed(&self.along, *at), value(*at))).collect();
        let [least, greatest] = self.found.extremes.map(value);
        let y = Axis::around(least, greatest, 7.0);
        let panel = Panel { top, size: Vec2::new(WIDTH, HEIGHTS[1]), x, y };
        let below = with_unit(drive_label(scene), "", &self.along.unit);
        panel.draw(drawing, with_unit(Text::italic("W"), &panel.y.power_text(), "J"), Some(below));
        drawing.begin("curve", &format!("work({})", self.wheel.name));
        panel.curve(drawing, Style::Curve1, &[line]);
        drawing.begin("fluctuation", &self.wheel.name);
        let right = WIDTH + BESIDE;
        let level = |y: f64| Vec2::new(right, panel.at(x.from, y).y);
        for ((place, y), (index, side)) in
            self.found.extremes.into_iter().zip([least, greatest]).zip([("min", 1.0), ("max", -1.0)])
        {
            let at = panel.dot(drawing, printed(&self.along, place), y);
            drawing.line(Style::Thin, at, level(y) + Vec2::new(2.0, 0.0));
            let text = Text::italic("φ").lowered(index).and(
                &format!(" = {}", scene.place_text(&self.along, place)),
                false,
                Level::Base,
            );
            drawing.label(Label::at(text, LETTERS, at, 0.9).towards(Vec2::new(0.4, side)).ranked(2));
        }
        let (low, high) = (level(least), level(greatest));
        let middle = (low + high) * 0.5;
        drawing.mark(Style::Acceleration, Shape::Arrow(middle, low));
        drawing.mark(Style::Acceleration, Shape::Arrow(middle, high));
        let text = Text::upright("[").and("W", true, Level::Base).and(
            &format!("] = {}", scene.value_text(&self.energy, self.found.fluctuation)),
            false,
            Level::Base,
        );
        let label = Label::at(text, LETTERS, middle, 0.8).towards(Vec2::new(1.0, 0.0)).ranked(0);
        drawing.label(label.coloured(Role::Vermilion));
        drawing.end();
        panel
    }

    /// The letter of the effort; of one on another shaft, reduced to that of the drive.
    fn letter(&self, scene: &Scene<'_>) -> Text {
        let mechanism = scene.mechanism();
        let balance = |name: &str, on: LinkId| {
            (on == self.wheel.on && (self.found.ratio - 1.0).abs() < 1e-9).then(|| Text::name(name))
        };
        let own = match self.wheel.torque {
            Some(FlywheelTorque::Balance(id)) => {
                mechanism.balances.get(id.index()).and_then(|b| match b.kind {
                    BalanceKind::Torque(on) => balance(&b.name, on),
                    _ => None,
                })
            }
            Some(FlywheelTorque::Load(_)) => None,
            None => match mechanism.balances.as_slice() {
                [b] => match b.kind {
                    BalanceKind::Torque(on) => balance(&b.name, on),
                    _ => None,
                },
                _ => None,
            },
        };
        own.unwrap_or_else(|| Text::italic("M").lowered("red"))
    }

    fn said(&self, scene: &Scene<'_>) -> String {
        let place = |at: f64| scene.place_text(&self.along, at);
        let [least, greatest] = self.found.extremes;
        format!(
            "Above {} over the sweep of {} and its mean {}; below the work between them, least at {}, greatest at {}: its \
             fluctuation is {}.",
            self.letter(scene).plain(),
            drive_label(scene).plain(),
            scene.value_text(&self.moment, self.mean),
            place(least),
            place(greatest),
            scene.value_text(&self.energy, self.found.fluctuation),
        )
    }
}
