//! A sweep that closes over a part only.

use super::format::{drive_text, rounded, short};
use super::speeds::rates;
use crate::model::{Expr, Positions, Value};
use crate::position::{DriveValue, Model, turns};
use crate::solve::{Closing, Gap};
use assur_text::diagnostic::Diagnosis;

/// Over which ranges a sweep does not close.
pub(super) fn partial_sweep(
    model: &Model<'_>,
    closing: Closing,
    gaps: &[Gap],
    more: usize,
) -> Option<Diagnosis> {
    let Closing { swept: total, open, .. } = closing;
    let closed = total - open;
    let text = |values: &[DriveValue]| drive_text(model, &rounded(model, values, 100.0));
    let ranges = gaps.iter().map(|gap| match (&gap.from, &gap.to) {
        (Some(from), Some(to)) => format!("from {} to {}", text(from), text(to)),
        (Some(from), None) => format!("beyond {}", text(from)),
        (None, Some(to)) => format!("before {}", text(to)),
        (None, None) => "anywhere".to_owned(),
    });
    let drive = model.mechanism.drives.first()?;
    let (positions, listed) = if closed == total {
        let positions = "the positions close, but not the motion between them".to_owned();
        (positions, "check the motion: every group keeps its side across the gap")
    } else {
        (
            format!("{closed} of {total} positions close"),
            "check the range of the drive: positions that do not close are left out of the answers",
        )
    };
    let help = match closing_range(model, gaps) {
        Some(line) => format!("{listed}; for the part that closes write\n  {line}"),
        None => listed.to_owned(),
    };
    let mut ranges = ranges.collect::<Vec<_>>().join(", nor ");
    if more > 0 {
        ranges += &format!(", nor in {more} other ranges");
    }
    Some(
        Diagnosis::warning(
            "mech::assembly::partial_sweep",
            format!("{positions}: the mechanism does not close {ranges}"),
        )
        .label(drive.span, "this sweep")
        .help(help),
    )
}

/// The sweep of a single drive that turns, cut to what closes.
fn closing_range(model: &Model<'_>, gaps: &[Gap]) -> Option<String> {
    let ([drive], [gap]) = (model.mechanism.drives.as_slice(), gaps) else { return None };
    let Positions::Range { from, to, steps } = &drive.positions else { return None };
    let (Expr::Constant(Value::Scalar(first)), Expr::Constant(Value::Scalar(last))) = (from, to) else {
        return None;
    };
    if !turns(model, drive) {
        return None;
    }
    let degrees = |values: &Option<Vec<DriveValue>>| match values.as_deref() {
        Some([DriveValue::Scalar(x)]) => Some(x.to_degrees()),
        _ => None,
    };
    let (first, last) = (first.to_degrees(), last.to_degrees());
    let way = (last - first).signum();
    // rounded to the side that closes
    let inwards = |x: f64, sense: f64| (x * 100.0 * sense * way).floor() / 100.0 * sense * way;
    let (begin, end) = match (degrees(&gap.from), degrees(&gap.to)) {
        (Some(a), Some(b)) if ((last - first).abs() - 360.0).abs() < 1e-9 => {
            (inwards(b - 360.0 * way, -1.0), inwards(a, 1.0))
        }
        (Some(a), _) => (first, inwards(a, 1.0)),
        (None, Some(b)) => (inwards(b, -1.0), last),
        (None, None) => return None,
    };
    let rates = rates(model.mechanism, drive);
    Some(format!("drive {} = {} deg .. {} deg in {steps} steps{rates}", drive.name, short(begin), short(end)))
}
