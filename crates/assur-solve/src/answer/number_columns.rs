//! Answers at a position as numbers in the author's units, column by column: what stands in a column is found once.

use super::joint_reaction::JointReaction;
use super::pose_answers::PoseAnswers;
use crate::model::{Display, Value};
use crate::position::DriveValue;
use assur_text::units::Conversion;

/// What a column shows, or two for a vector.
#[derive(Clone, Debug)]
pub enum ColumnSource {
    /// The value of a drive.
    Drive(usize),
    /// An item of `find` that is a value.
    Find(usize),
    Effort(usize),
    /// The force on a link in a pair.
    Force(JointReaction),
    /// The couple on a link in a pair.
    Couple(JointReaction),
    /// The same at all positions.
    Known(Option<Value>),
}

#[derive(Clone, Debug, Default)]
pub struct NumberColumns(Vec<Column>);

#[derive(Clone, Debug)]
struct Column {
    shown: ColumnSource,
    vector: bool,
    unit: Conversion,
}

impl NumberColumns {
    /// Adds what is shown, in two columns if it is a vector.
    pub fn push(&mut self, shown: ColumnSource, vector: bool, display: &Display) {
        let unit = Conversion::into_units_of(display.factor);
        self.0.push(Column { shown, vector, unit });
    }

    /// What the columns show, whether they are two for a vector, and their unit.
    pub(super) fn columns(&self) -> impl Iterator<Item = (&ColumnSource, bool, Conversion)> {
        self.0.iter().map(|column| (&column.shown, column.vector, column.unit))
    }

    /// Writes the numbers of a position; NaN where there is none. `false` where one is a condition.
    pub fn read(&self, view: &PoseAnswers<'_>, drives: &[DriveValue], out: &mut Vec<f64>) -> bool {
        out.clear();
        for Column { shown, vector, unit } in &self.0 {
            let value = match shown {
                ColumnSource::Drive(i) => drives.get(*i).and_then(DriveValue::value),
                ColumnSource::Find(index) => view.found(*index),
                ColumnSource::Effort(slot) => {
                    view.state.forces.efforts.get(*slot).copied().map(Value::Scalar)
                }
                ColumnSource::Force(joints) => Some(Value::Vector(joints.force(view.state))),
                ColumnSource::Couple(joints) => Some(Value::Scalar(joints.couple(view.state))),
                ColumnSource::Known(value) => *value,
            };
            match (value, vector) {
                (Some(Value::Vector(v)), true) => out.extend([unit.of(v.x), unit.of(v.y)]),
                (Some(Value::Scalar(x)), false) => out.push(unit.of(x)),
                (Some(Value::Bool(_)), false) => return false,
                (_, true) => out.extend([f64::NAN; 2]),
                (_, false) => out.push(f64::NAN),
            }
        }
        true
    }
}
