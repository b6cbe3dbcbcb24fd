//! Positions of groups that are solved as a whole: the steps of Newton's method as the solver took them.

use crate::course::Derivation;
use crate::document::{Inline, Line, Table, text};
use crate::system::matrix;
use crate::words::Message;
use assur_formula::{Expr, Name, Quantity, Unit, name_node, quantity, with_digits};
use assur_math::group::NewtonStep;
use assur_math::group::general::Pose;
use assur_position::plan::MotionStep;
use assur_solve::solve::{Begun, Iteration, iteration};
use std::sync::Arc;

/// A correction below this part of the mechanism, or of a radian, is rounding.
const ROUNDING: f64 = 1e-13;
/// A correction below this part is none.
const NOTHING: f64 = 1e-18;
/// Digits of the unknowns before every step.
const VALUES: usize = 7;
/// How far a step may be from the solution of its equations.
const WHOLE: f64 = 1e-6;
/// A derivative below this part of the largest of its equation is none.
const NOISE: f64 = 1e-13;

/// The letters of a body's unknowns: x, y and its direction.
pub(super) type Unknowns = [Name; 3];

/// A row of the closure of a group: its name, its unit, what is left of it with the values found.
pub(super) type Row = (Name, Unit, Expr);

impl Derivation<'_> {
    /// The positions of a group that the solver finds by iteration. Whether its steps are shown.
    pub(super) fn whole(&mut self, index: usize, step: &MotionStep) -> bool {
        let scene = self.scene;
        let Some(found) = iteration(&scene.model, scene.solution, (scene.pose, scene.solved), index) else {
            return false;
        };
        match step {
            MotionStep::Triad { triad, .. } => self.on_three_legs(triad, &found),
            MotionStep::General { branch, problem } => {
                self.general_group(*branch, &scene.model.plan.general[*problem], &found, index)
            }
            _ => false,
        }
    }

    /// Where the iteration begins, its steps, the equations of the last one and their solution; the unknowns as they are found.
    pub(super) fn newton(
        &mut self,
        found: &Iteration,
        unknowns: &[Unknowns],
        rows: &[Name],
        end: &[Pose],
    ) -> Vec<[Expr; 3]> {
        match &found.begun {
            Begun::Searched => self.say(Message::NewtonSearched, &[]),
            Begun::Followed(values) => {
                let words = self.drive_words(values).join(", ");
                self.say(Message::NewtonFollowed, &[vec![text(words)]]);
            }
        }
        self.table(self.table_of_newton(&found.steps, end, unknowns));
        let before = self.last_of_weight(&found.steps, end);
        let Some(last) = found.steps.get(before) else { return Vec::new() };
        if let [first, second, ..] = found.steps.as_slice()
            && before > 0
            && let Some(share) = share_of(first, &second.poses)
        {
            self.say(Message::NewtonFirst, &[]);
            self.table(equations_of(first, unknowns, rows));
            let share = share.map(|share| quantity(Name::new("σ", ""), share, Unit::One));
            self.say(if share.is_some() { Message::NewtonPart } else { Message::NewtonStarts }, &[]);
            let poses = first.poses.iter().zip(&second.poses).zip(unknowns);
            for ((from, to), names) in poses {
                self.corrected(names, (0, Some(1)), share.as_ref(), (from, to));
            }
        }
        self.say(Message::NewtonMatrix, &[vec![text((before + 1).to_string())]]);
        self.table(equations_of(last, unknowns, rows));
        self.say(Message::NewtonSolution, &[vec![text(before.to_string())]]);
        let poses = last.poses.iter().zip(end).zip(unknowns);
        poses.map(|((from, to), names)| self.corrected(names, (before, None), None, (from, to))).collect()
    }

    /// The last step that changes more than rounding does; the last of all where none does.
    fn last_of_weight(&self, steps: &[NewtonStep], end: &[Pose]) -> usize {
        let extent = self.tiny / 1e-9;
        let heavy = |step: &NewtonStep| {
            step.poses
                .iter()
                .zip(end)
                .any(|(a, b)| (b.p - a.p).norm() > ROUNDING * extent || (b.u - a.u).norm() > ROUNDING)
        };
        steps.iter().rposition(heavy).unwrap_or_else(|| steps.len().saturating_sub(1))
    }

    /// The unknowns of a body: as the steps before have them, and the correction; after the last step they have no number.
    fn corrected(
        &mut self,
        names: &Unknowns,
        (before, after): (usize, Option<usize>),
        share: Option<&Expr>,
        (from, to): (&Pose, &Pose),
    ) -> [Expr; 3] {
        let turn = to.u.turned_back(from.u).angle().to_degrees();
        let angle = libm::atan2(to.u.y, to.u.x).to_degrees();
        let extent = self.tiny / 1e-9;
        let values = [
            (from.p.x, to.p.x, Unit::Length, extent),
            (from.p.y, to.p.y, Unit::Length, extent),
            (angle - turn, angle, Unit::Angle, 180.0),
        ];
        let mut each = names.iter().zip(values).map(|(name, (old, new, unit, large))| {
            let own = Quantity {
                name: numbered(name, before),
                value: old,
                unit,
                scale: old.abs().max(large),
                given: false,
                rounding: 0.0,
            };
            let shift = if unit == Unit::Angle { turn } else { new - old };
            let shift = if shift.abs() <= NOTHING * large { 0.0 } else { shift };
            let part = |share: &Expr| share.clone() * quantity(correction(name), shift / share.value(), unit);
            let shift = share.map_or_else(|| quantity(correction(name), shift, unit), part);
            let right = Expr::Leaf(Arc::new(own)) + shift;
            let found = after.map_or_else(|| name.clone(), |after| numbered(name, after));
            if after.is_some() {
                self.asked.insert(found.clone());
            }
            self.equate(found, new, unit, right)
        });
        let mut next = || each.next().unwrap_or(Expr::ZERO);
        [next(), next(), next()]
    }

    /// The unknowns before every step and after the last, and what is left of the equations with them.
    fn table_of_newton(&self, steps: &[NewtonStep], end: &[Pose], unknowns: &[Unknowns]) -> Table {
        let headed = |name: &Name| {
            let unit = if name.letter == "φ" { ", °" } else { ", m" };
            vec![Inline::Math(name_node(name)), text(unit)]
        };
        let messages = [Message::Step, Message::NewtonLeft].map(|m| vec![text(self.words(m))]);
        let headers: Vec<Line> = messages.into_iter().chain(unknowns.iter().flatten().map(headed)).collect();
        let figure = |x: f64, digits| vec![text(with_digits(x, digits).text())];
        let row = |k: usize, poses: &[Pose], left: Option<f64>| {
            let left = left.map_or_else(|| vec![text("–")], |left| figure(left, 3));
            let values =
                poses.iter().flat_map(|at| [at.p.x, at.p.y, libm::atan2(at.u.y, at.u.x).to_degrees()]);
            let values = values.map(|x| figure(x, VALUES));
            [vec![text(k.to_string())], left].into_iter().chain(values).collect()
        };
        let greatest = |step: &NewtonStep| step.residuals.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let before = steps.iter().enumerate().map(|(k, step)| row(k, &step.poses, Some(greatest(step))));
        let rows: Vec<Vec<Line>> = before.chain([row(steps.len(), end, None)]).collect();
        let numbers = (0..headers.len()).collect();
        Table { headers, rows, numbers }
    }

    /// What is left of every equation with the values found. Whether that is nothing but rounding.
    pub(super) fn left_with(&mut self, rows: Vec<Row>) -> bool {
        self.say(Message::Closes, &[]);
        let mut closes = true;
        for (name, unit, left) in rows.into_iter().filter(|row| !row.2.is_zero()) {
            let misses = left.value().abs() > 1e-6 * left.scale();
            closes &= !misses;
            self.confirm(name, 0.0, unit, left);
        }
        closes
    }
}

/// The linear equations of a step.
fn equations_of(step: &NewtonStep, unknowns: &[Unknowns], rows: &[Name]) -> Table {
    let columns: Vec<Name> = unknowns.iter().flatten().map(correction).collect();
    let lines = rows.iter().zip(&step.jacobian);
    let left = without_noise(&step.residuals);
    let lines = lines.zip(left).map(|((name, line), x)| (name.clone(), without_noise(line), -x));
    let lines: Vec<_> = lines.collect();
    matrix(&columns, &lines)
}

/// Which part of the solution of its equations a step goes, where that is not all; none where it goes another way.
fn share_of(step: &NewtonStep, next: &[Pose]) -> Option<Option<f64>> {
    let moved = step.poses.iter().zip(next).flat_map(|(a, b)| {
        let shift = b.p - a.p;
        // a step δ turns by 2 arctan(δ/2), see `Pose::moved`
        [shift.x, shift.y, 2.0 * libm::tan(0.5 * b.u.turned_back(a.u).angle())]
    });
    let moved: Vec<f64> = moved.collect();
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let reached: Vec<f64> = step.jacobian.iter().map(|line| -dot(line, &moved)).collect();
    let share = dot(&reached, &step.residuals) / dot(&step.residuals, &step.residuals);
    let large = step.residuals.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let pairs = reached.iter().zip(&step.residuals);
    let follows = pairs.into_iter().all(|(own, left)| (own - share * left).abs() <= WHOLE * large);
    follows.then_some((share < 1.0 - WHOLE).then_some(share))
}

/// The letters of an unknown after a step.
fn numbered(name: &Name, step: usize) -> Name {
    Name { sub: format!("{},{step}", name.sub), ..name.clone() }
}

/// The letters of the correction of an unknown.
fn correction(name: &Name) -> Name {
    Name { letter: format!("δ{}", name.letter), ..name.clone() }
}

fn without_noise(line: &[f64]) -> Vec<f64> {
    let large = line.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    line.iter().map(|x| if x.abs() <= NOISE * large { 0.0 } else { *x }).collect()
}
