//! Flywheels: the torque over the turn against its mean, the work, its located extremes, and what follows.

use super::page::{Page, given};
use crate::document::{Line, text};
use crate::words::DesignMessage as Message;
use assur_formula::{Expr, Name, Unit, with_digits};
use assur_model::model::{Flywheel, FlywheelPart, Query, Value};
use assur_solve::answer::FlywheelAnswer;
use assur_solve::solve::{DriveValue, Model, Solution};

/// The most rows of a table.
const ROWS: usize = 37;

impl Page {
    pub(super) fn flywheels(&mut self, model: &Model<'_>, solution: &Solution) {
        let mechanism = model.mechanism;
        for (i, wheel) in mechanism.flywheels.iter().enumerate() {
            let Some(found) = solution.statics.flywheels.get(i).filter(|f| f.fluctuation > 0.0) else {
                continue;
            };
            let on = mechanism.link(wheel.on);
            self.heading(Message::FlywheelOf, &[vec![text(wheel.name.clone())], vec![text(on.name.clone())]]);
            let several = if mechanism.flywheels.len() > 1 { wheel.name.clone() } else { String::new() };
            self.work_table(model, solution, i, found);
            self.size(wheel, found, &several);
        }
    }

    /// Every position: torque on the shaft, its difference to the mean, the work; then the extremes.
    fn work_table(&mut self, model: &Model<'_>, solution: &Solution, which: usize, found: &FlywheelAnswer) {
        self.reduced.push((self.blocks.len(), which));
        self.say(Message::FlywheelTable, &[figure(found.mean_torque, "N·m")]);
        let drive = model.mechanism.drives.first().map_or("φ", |d| &d.name);
        let headers = vec![
            vec![text(format!("{drive}, °"))],
            vec![text("M_r, N·m")],
            vec![text("M_r − M_m, N·m")],
            vec![text("W, J")],
        ];
        let solved: Vec<_> = solution
            .poses
            .iter()
            .filter_map(|pose| match (pose.drives.first(), pose.outcome.as_ref().ok()) {
                (Some(DriveValue::Scalar(x)), Some(solved)) => Some((*x, solved)),
                _ => None,
            })
            .collect();
        let step = solved.len().div_ceil(ROWS).max(1);
        let mut rows = Vec::new();
        for (value, pose) in solved.into_iter().step_by(step) {
            let view = pose.view(model, &solution.statics);
            let Value::Scalar(torque) = view.query(&Query::Flywheel(which, FlywheelPart::Torque)) else {
                continue;
            };
            let cells = [value.to_degrees(), torque, torque - found.mean_torque, found.work(value)];
            rows.push(cells.iter().map(|x| vec![text(with_digits(clear(*x, found), 5).text())]).collect());
        }
        self.table(headers, rows);
    }

    /// [W], J, and the rim.
    fn size(&mut self, wheel: &Flywheel, found: &FlywheelAnswer, several: &str) {
        let name = |letter: &str, sub: &str| {
            let sub = if several.is_empty() { sub.to_owned() } else { format!("{sub},{several}") };
            Name::new(letter, sub.trim_start_matches(','))
        };
        let [least, greatest] = found.extremes;
        let at = |value: f64| -> Line { vec![text(with_digits(value.to_degrees(), 6).text())] };
        self.say(Message::FlywheelExtremes, &[at(least), at(greatest)]);
        let low = self.stated(name("W", "min"), found.work(least), Unit::Work);
        let high = self.stated(name("W", "max"), found.work(greatest), Unit::Work);
        let swing = self.equate(name("ΔW", "max"), found.fluctuation, Unit::Work, high - low);
        self.say(Message::FlywheelInertia, &[]);
        let speed = match wheel.speed {
            Some(speed) => given(name("ω", "m"), speed, Unit::AngularVelocity),
            None => self.stated(name("ω", "m"), found.speed, Unit::AngularVelocity),
        };
        let delta = given(name("δ", ""), wheel.fluctuation, Unit::One);
        let mut right = swing / (speed.squared() * delta);
        if wheel.with_links {
            let links = self.stated(name("J", "r"), found.links[0], Unit::Inertia);
            right = right - links;
        }
        if right.value() <= 0.0 {
            return;
        }
        let inertia = self.equate(name("J", ""), found.inertia, Unit::Inertia, right);
        let Some(rim) = wheel.rim else { return };
        self.say(Message::FlywheelRim, &[]);
        let diameter = given(name("D", ""), rim.diameter, Unit::Length);
        let density = given(name("ρ", ""), rim.density, Unit::Density);
        let shape = given(name("c", ""), rim.height_to_width, Unit::One);
        let right = Expr::Int(4) * inertia.clone() / diameter.clone().squared();
        let mass = right.value();
        self.equate(name("m", ""), mass, Unit::Mass, right);
        let right = (Expr::Int(4) * inertia / (shape.clone() * Expr::Pi * density * diameter.cubed())).root();
        let width = self.named(name("b", ""), Unit::Length, right);
        let right = shape * width;
        self.named(name("h", ""), Unit::Length, right);
    }
}

fn figure(x: f64, unit: &str) -> Line {
    vec![text(format!("{} {unit}", with_digits(x, 5).text()))]
}

/// Without what is rounding against the torque.
fn clear(x: f64, found: &FlywheelAnswer) -> f64 {
    if x.abs() <= 1e-10 * found.fluctuation { 0.0 } else { x }
}
