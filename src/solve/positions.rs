//! Which positions are asked for: sweeps, named poses, and those an `expect … at` adds.

use super::extremes::Statics;
use super::solution::{DriveValue, PoseOrigin, Scene};
use super::state::State;
use super::view::View;
use crate::model::{At, Drive, DriveId, DriveTarget, Expr, Positions, Value};

/// A position to be solved.
#[derive(Clone, Debug)]
pub(super) struct Wanted {
    pub name: String,
    pub origin: PoseOrigin,
    pub drives: Vec<DriveValue>,
}

/// Evaluates expressions that need no position.
pub(super) fn constant(scene: &Scene<'_>, statics: &Statics, expr: &Expr) -> Value {
    let state = State::new(scene.plan);
    let view = View::new(scene, &state, &[], statics);
    view.value(expr)
}

fn drive_value(value: Value) -> DriveValue {
    match value {
        Value::Scalar(x) => DriveValue::Scalar(x),
        Value::Vector(v) => DriveValue::Point(v),
        Value::Truth(_) => DriveValue::None,
    }
}

/// The values of one drive over its sweep.
fn values(scene: &Scene<'_>, statics: &Statics, drive: &Drive) -> Vec<DriveValue> {
    match &drive.positions {
        Positions::None => vec![DriveValue::None],
        Positions::List(list) => list.iter().map(|e| drive_value(constant(scene, statics, e))).collect(),
        Positions::Range { from, to, steps } => {
            let scalar = |e| match constant(scene, statics, e) {
                Value::Scalar(x) => x,
                _ => f64::NAN,
            };
            range(scalar(from), scalar(to), *steps, turns(scene, drive))
        }
    }
}

/// Equal steps; over whole turns of a drive that turns the last position, the first again, is left out.
fn range(from: f64, to: f64, steps: usize, turning: bool) -> Vec<DriveValue> {
    let turns = (to - from) / std::f64::consts::TAU;
    let whole = turning && turns.round() != 0.0 && (turns - turns.round()).abs() < 1e-12;
    let count = if whole { steps } else { steps + 1 };
    #[allow(clippy::cast_precision_loss)] // steps are far below 2^52
    let at = |i: usize| from + (to - from) * (i as f64 / steps as f64);
    (0..count).map(|i| DriveValue::Scalar(at(i))).collect()
}

/// Whether a drive's value is an angle.
pub(super) fn turns(scene: &Scene<'_>, drive: &Drive) -> bool {
    match drive.target {
        DriveTarget::Link(_) => true,
        DriveTarget::Pair(pair) => {
            matches!(scene.mechanism.pair(pair).kind, crate::model::PairKind::Revolute(_))
        }
        DriveTarget::Point(..) => false,
    }
}

/// All positions of the sweep, in order.
pub(super) fn sweep(scene: &Scene<'_>, statics: &Statics) -> Vec<Wanted> {
    let drives = &scene.mechanism.drives;
    let all: Vec<Vec<DriveValue>> = drives.iter().map(|d| values(scene, statics, d)).collect();
    let length = all.iter().map(Vec::len).max().unwrap_or(1);
    // `check` has seen to it that all are of one length, or single
    (0..length)
        .map(|i| Wanted {
            name: (i + 1).to_string(),
            origin: PoseOrigin::Sweep(i),
            drives: all.iter().map(|v| v.get(i).or(v.last()).copied().unwrap_or(DriveValue::None)).collect(),
        })
        .collect()
}

/// Positions beside the sweep: drives that are not named keep the value of the sweep's first position.
pub(super) fn beside(scene: &Scene<'_>, statics: &Statics, first: &Wanted) -> Vec<Wanted> {
    let at = |list: &[(DriveId, Expr)]| {
        let mut drives = first.drives.clone();
        for (id, expr) in list {
            drives[id.index()] = drive_value(constant(scene, statics, expr));
        }
        drives
    };
    let named = scene.mechanism.poses.iter().enumerate().map(|(i, pose)| Wanted {
        name: pose.name.clone(),
        origin: PoseOrigin::Named(i),
        drives: at(&pose.at),
    });
    let expected = scene.mechanism.expects.iter().enumerate().filter_map(|(i, e)| match &e.at {
        Some(At::Drives(list)) => Some(Wanted {
            name: format!("expect {}", i + 1),
            origin: PoseOrigin::Expected(i),
            drives: at(list),
        }),
        _ => None,
    });
    named.chain(expected).collect()
}
