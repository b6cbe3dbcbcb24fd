//! The size of a drive's steps: `0 deg .. 360 deg step 30 deg`.

use super::drive::{MOST_STEPS, Moves, difference};
use crate::expr::context::Context;
use crate::expr::positive::Want;
use crate::values::fold;
use crate::values::format_value::{digits, format_value};
use assur_math::math::Vec2;
use assur_model::model::{Expr, Value};
use assur_syntax::document;
use assur_text::diagnostic::Diagnosis;

/// The part of a step by which a range may miss a whole number of steps, per step.
const REST: f64 = 1e-9;

/// The number of steps of this size between two values; reports a size that gives none.
pub(super) fn count(
    cx: &mut Context<'_>,
    (from, to): (&Expr, &Expr),
    each: &document::Expr,
    moves: Moves,
) -> Option<f64> {
    let dimension = moves.dimension(0);
    let size = cx.scalar_constant(each, &Want(dimension), "the size of a step")?;
    let value = |x: f64| format_value(x, dimension);
    let length = length(from, to);
    let fault = match length {
        _ if size < 0.0 => Fault {
            message: format!("the size of a step must be greater than zero; got {}", value(size)),
            help: format!("write `step {}`: the ends of the range give its direction", value(-size)),
            label: "negative",
        },
        _ if size == 0.0 => Fault {
            message: format!("the size of a step must be greater than zero; got {}", value(size)),
            help: "write the size of a step, or the number of steps: `in 12 steps`".into(),
            label: "zero",
        },
        None => Fault {
            message: format!(
                "the number of steps of {} is not known: an end of the range is found only by solving",
                value(size)
            ),
            help: "write the number of steps: `in 12 steps`".into(),
            label: "a size needs a range of known length",
        },
        Some(length) => match whole(length, size) {
            Ok(steps) => return Some(steps),
            Err(steps) => of_length(length, steps, value(size), value),
        },
    };
    let Fault { message, help, label } = fault;
    cx.error(Diagnosis::error("mech::geometry::steps", message).label(each.span, label).help(help));
    None
}

struct Fault {
    message: String,
    help: String,
    label: &'static str,
}

/// Whether a range ends where it begins, but for rounding.
pub(super) fn is_empty(from: &Expr, to: &Expr) -> bool {
    let size = |e: &Expr| match e {
        Expr::Constant(Value::Scalar(x)) => x.abs(),
        _ => fold::vector(e).map_or(0.0, Vec2::norm),
    };
    length(from, to).is_some_and(|length| length <= 4.0 * f64::EPSILON * size(from).max(size(to)))
}

/// The distance between two values where it is known before anything is solved.
fn length(from: &Expr, to: &Expr) -> Option<f64> {
    match (fold::vector(from), fold::vector(to)) {
        (Some(from), Some(to)) => Some((to - from).norm()),
        _ => difference(from, to).map(f64::abs),
    }
}

/// A number of steps that a drive can take; or one that it cannot.
fn whole(length: f64, size: f64) -> Result<f64, f64> {
    let steps = length / size;
    let fits = (steps - steps.round()).abs() <= REST * steps;
    #[allow(clippy::cast_precision_loss)] // a million is exact
    let few = (1.0..=MOST_STEPS as f64).contains(&steps.round());
    if fits && few { Ok(steps.round()) } else { Err(steps) }
}

fn of_length(length: f64, steps: f64, of: String, value: impl Fn(f64) -> String) -> Fault {
    #[allow(clippy::cast_precision_loss)] // a million is exact
    let most = MOST_STEPS as f64;
    let range = value(length);
    if steps.round() > most {
        return Fault {
            message: format!(
                "the range of {range} has {} steps of {of}; at most {MOST_STEPS}",
                digits(steps.round())
            ),
            help: format!("write a step of {} or more, or for example `in 360 steps`", value(length / most)),
            label: "too small",
        };
    }
    Fault {
        message: format!("the range of {range} is not a whole number of steps of {of}"),
        help: format!("write `in {} steps`, or another step", digits(steps.ceil().max(1.0))),
        label: "leaves a rest",
    }
}
