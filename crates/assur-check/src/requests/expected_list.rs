//! A list of expected values that is longer or shorter than the sweep.

use crate::expr::context::Context;
use assur_model::model::{Drive, Expr, Positions, Value};
use assur_text::source::Span;

/// Most poses that are listed one by one.
const LISTED: usize = 6;

/// How many values there should be, and for which poses of the sweep at this place.
pub(crate) fn help(cx: &Context<'_>, count: usize, values: usize, sweep: Span) -> String {
    let drive = cx.builder.mech.drives.iter().find(|d| d.span == sweep);
    let poses =
        drive.and_then(|d| in_words(cx, d, count)).map(|poses| format!(": {poses}")).unwrap_or_default();
    let change = match (values > count, values.abs_diff(count)) {
        (true, 1) => "leave one out".to_owned(),
        (true, n) => format!("leave {n} out"),
        (false, 1) => "add one".to_owned(),
        (false, n) => format!("add {n}"),
    };
    let turn = match drive.map(|d| &d.positions) {
        Some(Positions::Range { steps, .. }) if *steps == count => {
            "; over a whole turn the last pose is the first again and has no value"
        }
        _ => "",
    };
    let named = if cx.names.poses.is_empty() { "" } else { "; a named pose has an `expect` of its own" };
    format!("{change}: there is one value for each of the {count} poses{poses}{turn}{named}")
}

/// The poses of a drive: `I = 0 deg, 30 deg, 60 deg, 90 deg`
fn in_words(cx: &Context<'_>, drive: &Drive, count: usize) -> Option<String> {
    let number = |e: &Expr| if let Expr::Constant(Value::Scalar(x)) = e { Some(*x) } else { None };
    #[allow(clippy::cast_precision_loss)] // few poses
    let values = match &drive.positions {
        Positions::List(list) => list.iter().map(number).collect::<Option<Vec<_>>>()?,
        Positions::Numbers(list) => list.to_vec(),
        Positions::Range { from, to, steps } => {
            let (from, to) = (number(from)?, number(to)?);
            let step = (to - from) / *steps as f64;
            (0..count.min(*steps + 1)).map(|i| step.mul_add(i as f64, from)).collect()
        }
        Positions::None => return None,
    };
    let display = cx.values.display(crate::motion::drive::moves(cx, drive.target).dimension(0));
    let texts = values.iter().map(|x| display.text(Value::Scalar(*x), 6)).collect::<Vec<_>>();
    let name = &drive.name;
    Some(match texts.as_slice() {
        [first, second, .., last] if texts.len() > LISTED => format!("{name} = {first}, {second}, … {last}"),
        _ => format!("{name} = {}", texts.join(", ")),
    })
}
