//! From drive values to what the steps of motion read: directions, coordinates, rates.

use crate::answer::{WholeCycle, constant};
use crate::math::Vec2;
use crate::model::{Drive, Expr, Value};
use crate::position::{DriveInput, DriveValue, Model};

/// Rates of the drives: the same at every position.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Rates(Vec<DriveInput>);

impl Rates {
    /// The speeds of the file. A drive with a sense and no speed moves by one unit, so that velocities are ratios.
    pub(crate) fn of(model: &Model<'_>, statics: &WholeCycle) -> Self {
        Self(model.mechanism.drives.iter().map(|d| rates(model, statics, d)).collect())
    }

    /// The same of a mechanism that differs in numbers alone, where these are known before anything is solved.
    pub(super) fn refresh(&mut self, model: &Model<'_>) {
        for (rates, drive) in self.0.iter_mut().zip(&model.mechanism.drives) {
            *rates = rates_by(model, drive, &|expr| known_value(expr).unwrap_or(Value::Scalar(f64::NAN)));
        }
    }

    /// Unit speed of every drive along the way from one set of values to another; nothing accelerates.
    pub(super) fn unit(model: &Model<'_>) -> Self {
        Self(
            model
                .mechanism
                .drives
                .iter()
                .map(|_| DriveInput { rate: 1.0, ..DriveInput::default() })
                .collect(),
        )
    }

    /// The inputs at one position. The only place where an angle becomes a direction.
    pub(crate) fn at(&self, values: &[DriveValue], inputs: &mut [DriveInput]) {
        for (drive, (value, input)) in values.iter().zip(inputs).enumerate() {
            *input = self.input(drive, *value);
        }
    }

    /// The input of one drive.
    pub(super) fn input(&self, drive: usize, value: DriveValue) -> DriveInput {
        let mut input = self.0[drive];
        match value {
            DriveValue::Scalar(x) => {
                input.value = x;
                input.place = Vec2::direction(x);
            }
            DriveValue::Point(p) => input.place = p,
            // rates only: what is asked does not depend on the position
            DriveValue::None => input.place = Vec2::new(1.0, 0.0),
        }
        input
    }
}

fn rates(model: &Model<'_>, statics: &WholeCycle, drive: &Drive) -> DriveInput {
    rates_by(model, drive, &|expr| constant(model, statics, expr))
}

/// The value of an expression that is one.
pub(super) const fn known_value(expr: &Expr) -> Option<Value> {
    match expr {
        Expr::Constant(value) => Some(*value),
        _ => None,
    }
}

fn rates_by(model: &Model<'_>, drive: &Drive, constant: &dyn Fn(&Expr) -> Value) -> DriveInput {
    let mut input = DriveInput::default();
    match drive.speed.as_ref().map(constant) {
        Some(Value::Scalar(x)) => input.rate = x,
        Some(Value::Vector(v)) => input.velocity = v,
        Some(Value::Bool(_)) => {}
        None => input.rate = drive.sense.unwrap_or(f64::from(u8::from(model.plan.effects.geometric))),
    }
    match drive.acceleration.as_ref().map(constant) {
        Some(Value::Scalar(x)) => input.acceleration = x,
        Some(Value::Vector(v)) => input.point_acceleration = v,
        Some(Value::Bool(_)) | None => {}
    }
    input
}
