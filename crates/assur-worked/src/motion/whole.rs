//! Positions of groups that are solved as a whole: the steps of Newton's method as the solver took them.

use crate::course::Derivation;
use crate::document::{Table, text};
use crate::system::matrix;
use crate::words::Message;
use assur_formula::{Expr, Name, Quantity, Unit, quantity, with_digits};
use assur_math::group::NewtonStep;
use assur_math::group::general::Pose;
use assur_position::plan::MotionStep;
use assur_solve::solve::{Begun, Iteration, iteration};
use std::sync::Arc;

/// A correction below this part of the mechanism, or of a radian, is rounding.
const ROUNDING: f64 = 1e-13;
/// A correction below this part is none.
const NOTHING: f64 = 1e-18;
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
        self.table(self.table_of_newton(&found.steps, end));
        let before = self.last_of_weight(&found.steps, end);
        let Some(last) = found.steps.get(before) else { return Vec::new() };
        self.say(Message::NewtonMatrix, &[vec![text((before + 1).to_string())]]);
        let columns: Vec<Name> = unknowns.iter().flatten().map(correction).collect();
        let lines = rows.iter().zip(&last.jacobian).zip(&last.residuals);
        let lines: Vec<_> = lines.map(|((name, line), x)| (name.clone(), without_noise(line), -x)).collect();
        self.table(matrix(&columns, &lines));
        self.say(Message::NewtonSolution, &[vec![text(before.to_string())]]);
        let poses = last.poses.iter().zip(end).zip(unknowns);
        poses.map(|((from, to), names)| self.corrected(names, before, from, to)).collect()
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

    /// The unknowns of a body: as the steps before have them, and the last correction.
    fn corrected(&mut self, names: &Unknowns, before: usize, from: &Pose, to: &Pose) -> [Expr; 3] {
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
                name: Name::new(&name.letter, &format!("{},{before}", name.sub)),
                value: old,
                unit,
                scale: old.abs().max(large),
                given: false,
                rounding: 0.0,
            };
            let shift = if unit == Unit::Angle { turn } else { new - old };
            let shift = if shift.abs() <= NOTHING * large { 0.0 } else { shift };
            let right = Expr::Leaf(Arc::new(own)) + quantity(correction(name), shift, unit);
            self.equate(name.clone(), new, unit, right)
        });
        let mut next = || each.next().unwrap_or(Expr::ZERO);
        [next(), next(), next()]
    }

    /// The steps: what is left of the equations where each begins, and how far it goes.
    fn table_of_newton(&self, steps: &[NewtonStep], end: &[Pose]) -> Table {
        let messages = [Message::Step, Message::NewtonLeft, Message::NewtonShift, Message::NewtonTurn];
        let headers = messages.map(|m| vec![text(self.words(m))]).to_vec();
        let figure = |x: f64| vec![text(with_digits(x, 3).text())];
        let rows = steps.iter().enumerate().map(|(k, step)| {
            let next = steps.get(k + 1).map_or(end, |next| &next.poses);
            let left = step.residuals.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            let moved = || step.poses.iter().zip(next);
            let shift = moved().map(|(a, b)| (b.p - a.p).norm()).fold(0.0, f64::max);
            let turn = moved().map(|(a, b)| b.u.turned_back(a.u).angle().abs()).fold(0.0, f64::max);
            vec![vec![text((k + 1).to_string())], figure(left), figure(shift), figure(turn.to_degrees())]
        });
        Table { headers, rows: rows.collect(), numbers: (0..4).collect() }
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

/// The letters of the correction of an unknown.
fn correction(name: &Name) -> Name {
    Name { letter: format!("δ{}", name.letter), ..name.clone() }
}

fn without_noise(line: &[f64]) -> Vec<f64> {
    let large = line.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    line.iter().map(|x| if x.abs() <= NOISE * large { 0.0 } else { *x }).collect()
}
