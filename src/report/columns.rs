//! The quantities of a report, with their values at every pose.

use super::answers::{Answers, NONE};
use crate::exercise::why_undefined;
use assur_model::model::{self, Display, Expr, Find, FindKind, Query, TableEntry, Value};
use assur_model::structure::{EffortKind, EffortSource};
use assur_solve::solve::{Model, Pose, PoseAnswers, Solved, State};
use assur_text::units::Dimension;

/// A quantity and its values.
#[derive(Clone, Debug)]
pub(super) struct Quantity {
    /// Its name, or its own text.
    pub name: String,
    /// How it is printed.
    pub display: Display,
    /// Values in SI, one per pose. `None` where the pose has no solution or the value does not exist.
    pub values: Vec<Option<Value>>,
    /// The text for a missing value.
    pub missing: &'static str,
}

#[derive(Clone, Debug)]
pub(super) struct EffortEntry {
    /// The balance's name, or `effort(crank)`.
    pub name: String,
    /// The latter as the file says it, where one statement drives two coordinates.
    pub written: String,
    /// It is a drive's own: no balance is declared.
    pub of_drive: bool,
    /// How it is printed.
    pub display: Display,
    slot: usize,
}

impl EffortEntry {
    /// Whether a quantity of this name has it.
    pub fn is_named(&self, name: &str) -> bool {
        name == self.name || name == self.written
    }

    /// Its value, N m or N.
    pub fn value(&self, answers: &Answers<'_>, solved: &Solved) -> Option<f64> {
        let value = answers.solution.view(&answers.model, solved).effort(self.slot);
        Some(value).filter(|x| x.is_finite())
    }
}

impl<'a> Answers<'a> {
    /// Items of `find` with one value per pose, then those efforts that nobody asked for by name: the drives' own where
    /// no balance is declared, and all of them where all reactions are asked for.
    pub(super) fn quantities(&self, poses: &[&Pose]) -> Vec<Quantity> {
        let mut quantities: Vec<Quantity> = self
            .finds(false)
            .map(|(find, expr, display)| Quantity {
                name: find.name.clone(),
                display: display.clone(),
                values: poses.iter().map(|pose| self.value(expr, pose)).collect(),
                missing: missing(&self.model, expr),
            })
            .collect();
        for effort in self.efforts() {
            let wanted = effort.of_drive || self.wants_reactions();
            if !wanted || quantities.iter().any(|q| effort.is_named(&q.name)) {
                continue;
            }
            let value =
                |p: &&Pose| p.outcome.as_ref().ok().and_then(|s| effort.value(self, s)).map(Value::Scalar);
            quantities.push(Quantity {
                values: poses.iter().map(value).collect(),
                name: effort.name,
                display: effort.display,
                missing: NONE,
            });
        }
        quantities
    }

    /// Items of `find` that need no pose: each with its one value.
    pub(super) fn quantities_without_pose(&self) -> Vec<Quantity> {
        self.without_pose(|view| self.values_without_pose(view))
    }

    /// Items of `find` at these poses and those that need none, in the order of the file.
    pub(super) fn all_quantities(&self, poses: &[&Pose]) -> Vec<Quantity> {
        let mut all = self.quantities(poses);
        all.extend(self.quantities_without_pose());
        let finds = &self.model.mechanism.finds;
        all.sort_by_key(|q| finds.iter().position(|find| find.name == q.name).unwrap_or(finds.len()));
        all
    }

    /// The tables that are asked for, with their names: one, or one per position.
    pub(super) fn tables(&self) -> Vec<(String, &'a model::Table, Option<&'a Pose>)> {
        let mut tables = Vec::new();
        let poses: Vec<&Pose> = self.poses().collect();
        for find in &self.model.mechanism.finds {
            let FindKind::Table(table) = &find.kind else { continue };
            match &poses[..] {
                _ if !table.is_of_pose() => tables.push((find.name.clone(), table, None)),
                [pose] => tables.push((find.name.clone(), table, Some(*pose))),
                several => {
                    tables.extend(several.iter().map(|pose| {
                        (format!("{} {}", find.name, self.at_pose(&pose.name)), table, Some(*pose))
                    }))
                }
            }
        }
        tables
    }

    /// The numbers of a kind in a table, SI; not a number where there is none.
    pub(super) fn entry(&self, entry: &TableEntry, pose: Option<&Pose>) -> Vec<f64> {
        if entry.found.is_empty() {
            return entry.values.clone();
        }
        let number = |value: Value| if let Value::Scalar(x) = value { x } else { f64::NAN };
        if let Some(pose) = pose {
            return entry.found.iter().map(|expr| self.value(expr, pose).map_or(f64::NAN, number)).collect();
        }
        self.without_pose(|view| entry.found.iter().map(|expr| number(view.value(expr))).collect())
    }

    /// What is known without a pose.
    fn without_pose<T>(&self, of: impl FnOnce(&PoseAnswers<'_>) -> T) -> T {
        let plan = self.model.plan;
        let state = State::new(plan);
        let angles = vec![0.0; plan.bodies];
        let view = PoseAnswers::new(&self.model, &state, &angles, &self.solution.statics);
        let quantities = view.all_quantities();
        of(&PoseAnswers { quantities: &quantities, ..view })
    }

    fn values_without_pose(&self, view: &PoseAnswers<'_>) -> Vec<Quantity> {
        let quantity = |(find, expr, display): (&'a Find, &'a Expr, &'a Display)| Quantity {
            name: find.name.clone(),
            display: display.clone(),
            values: vec![Some(view.value(expr)).filter(Value::is_defined)],
            missing: missing(&self.model, expr),
        };
        self.finds(true).map(quantity).collect()
    }

    /// Items of `find` that are values.
    pub(super) fn finds(
        &self,
        without_pose: bool,
    ) -> impl Iterator<Item = (&'a Find, &'a Expr, &'a Display)> + use<'a> {
        self.model.mechanism.finds.iter().filter_map(move |find| match &find.kind {
            FindKind::Value { expr, display, poseless } if *poseless == without_pose => {
                Some((find, expr, display))
            }
            FindKind::Value { .. } | FindKind::Reactions | FindKind::Table(_) => None,
        })
    }

    /// Value of an expression at a pose, SI.
    pub(super) fn value(&self, expr: &Expr, pose: &Pose) -> Option<Value> {
        let solved = pose.outcome.as_ref().ok()?;
        let value = self.solution.view(&self.model, solved).value(expr);
        Some(value).filter(Value::is_defined)
    }

    /// The slots of the unknown efforts that are reported.
    pub(super) fn effort_slots(&self) -> impl Iterator<Item = usize> {
        self.efforts().into_iter().map(|effort| effort.slot)
    }

    /// The unknown efforts; none where forces are not solved.
    pub(super) fn efforts(&self) -> Vec<EffortEntry> {
        let mechanism = self.model.mechanism;
        if self.model.plan.forces.is_empty() {
            return Vec::new();
        }
        let entry = |(slot, effort): (usize, &assur_model::structure::Effort)| {
            let of = |name: &str| format!("effort({name})");
            let (name, written, of_drive) = match effort.source {
                EffortSource::Balance(id) => {
                    (mechanism.balances[id.index()].name.clone(), String::new(), false)
                }
                EffortSource::Drive(id) => {
                    let drive = &mechanism.drives[id.index()];
                    (of(&drive.name), of(drive.written_name()), true)
                }
            };
            let dimension = match effort.kind {
                EffortKind::Angle(_) | EffortKind::RelativeAngle { .. } => Dimension::TORQUE,
                _ => Dimension::FORCE,
            };
            EffortEntry { name, written, of_drive, display: mechanism.display_of(dimension), slot }
        };
        let all = self.model.structure.efforts.iter().enumerate();
        let of_start = |effort: &assur_model::structure::Effort| match effort.source {
            EffortSource::Drive(id) => mechanism.drives[id.index()].is_unaided(),
            EffortSource::Balance(_) => false,
        };
        // an effort that depends on sizes left open has no value
        all.filter(|(_, effort)| !of_start(effort))
            .filter(|(slot, _)| !self.solution.open.efforts.contains(slot))
            .map(entry)
            .collect()
    }
}

/// One column of numbers in the author's unit: a quantity, or a component of a vector.
#[derive(Clone, Debug)]
pub(super) struct Part {
    /// The quantity's name, with `.x` or `.y` for a component.
    pub name: String,
    /// One cell per pose.
    pub cells: Vec<Cell>,
}

/// The value of a quantity at one pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Cell {
    /// A number in the author's unit.
    Number(f64),
    Bool(bool),
    /// It has no value here.
    None,
}

impl Part {
    /// The greatest magnitude of its numbers.
    pub fn greatest(&self) -> f64 {
        let number = |c: &Cell| if let Cell::Number(x) = c { x.abs() } else { 0.0 };
        self.cells.iter().map(number).fold(0.0, f64::max)
    }
}

impl Quantity {
    /// Its columns: two for a vector.
    pub fn parts(&self) -> Vec<Part> {
        let component = |value: &Option<Value>, y: bool| match value {
            Some(Value::Scalar(x)) if !y => Cell::Number(self.display.of_si(*x)),
            Some(Value::Vector(v)) => Cell::Number(self.display.of_si(if y { v.y } else { v.x })),
            Some(Value::Bool(truth)) => Cell::Bool(*truth),
            _ => Cell::None,
        };
        let part = |name: String, y: bool| Part {
            name,
            cells: self.values.iter().map(|v| component(v, y)).collect(),
        };
        if self.values.iter().any(|v| matches!(v, Some(Value::Vector(_)))) {
            ["x", "y"].map(|c| part(format!("{}.{c}", self.name), c == "y")).to_vec()
        } else {
            vec![part(self.name.clone(), false)]
        }
    }
}

/// The text for a value that does not exist.
fn missing(model: &Model<'_>, expr: &Expr) -> &'static str {
    match expr {
        Expr::Quantity(id) => {
            model.mechanism.quantities.get(id.index()).map_or(NONE, |q| missing(model, &q.expr))
        }
        Expr::Query(Query::Critical(_)) => "none in reach",
        _ if why_undefined(model, expr).is_some() => "not determined",
        _ => NONE,
    }
}
