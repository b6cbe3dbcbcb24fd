//! The way of a mechanism between and around the positions of its file, for paths of points and other poses in a picture.

use super::compile::Compiled;
use assur_model::model::{DriveTarget, Expr, Mechanism, PairKind, Positions, Value};
use assur_position::plan::{Effects, plan, plan_with};
use assur_solve::solve::{DriveValue, Model, Pose, Solution, solve};
use std::f64::consts::TAU;

/// Steps of the way, at least.
const STEPS: usize = 180;

/// Positions in small steps: over the way that the file gives its drive, or a whole turn from its first value. None where
/// there are several drives, or the only one does not turn and has no way.
#[must_use]
pub fn turn(compiled: &Compiled, solution: &Solution) -> Vec<Pose> {
    if compiled.mechanism.simulation.is_some() {
        return in_time(compiled, STEPS + 1);
    }
    let Some(way) = Way::of(&compiled.mechanism, solution) else { return Vec::new() };
    way.solved(compiled, way.steps * STEPS.div_ceil(way.steps))
}

/// As [`turn`], in a number of positions that is wanted, two or more.
#[must_use]
pub fn turn_in(compiled: &Compiled, solution: &Solution, count: usize) -> Vec<Pose> {
    if compiled.mechanism.simulation.is_some() {
        return in_time(compiled, count.max(2));
    }
    let Some(way) = Way::of(&compiled.mechanism, solution) else { return Vec::new() };
    let each = |parts: usize| {
        let every = STEPS.div_ceil(parts);
        let poses = way.solved(compiled, parts * every);
        let is_closed = poses.len() == parts * every;
        (poses.into_iter().step_by(every).collect::<Vec<_>>(), is_closed)
    };
    // over whole turns the last position is the first and left out
    let (poses, is_closed) = each(count.max(2));
    if is_closed { poses } else { each(count.max(2) - 1).0 }
}

/// A motion under loads at instants that are equally far apart.
fn in_time(compiled: &Compiled, count: usize) -> Vec<Pose> {
    let mut mechanism = compiled.mechanism.clone();
    if let Some(simulation) = &mut mechanism.simulation {
        simulation.steps = Some(count - 1);
    }
    mechanism.finds.clear();
    mechanism.expects.clear();
    mechanism.cycles.clear();
    mechanism.criticals.clear();
    mechanism.powers = None;
    let plan = plan(&mechanism, &compiled.structure);
    let model = Model { mechanism: &mechanism, structure: &compiled.structure, plan: &plan };
    solve(&model).map(|solution| solution.poses).unwrap_or_default()
}

/// A way of the only drive.
struct Way {
    from: Expr,
    to: Expr,
    steps: usize,
}

impl Way {
    fn of(mechanism: &Mechanism, solution: &Solution) -> Option<Self> {
        let [drive] = mechanism.drives.as_slice() else { return None };
        if let Positions::Range { from, to, steps } = &drive.positions {
            return Some(Self { from: from.clone(), to: to.clone(), steps: (*steps).max(1) });
        }
        let turns = match drive.target {
            DriveTarget::Link(_) => true,
            DriveTarget::Pair(pair) => matches!(mechanism.pair(pair).kind, PairKind::Revolute(_)),
            DriveTarget::Point(..) => false,
        };
        let first = solution.poses.first()?.drives.first()?;
        let (true, DriveValue::Scalar(first)) = (turns, first) else { return None };
        let end = |angle: f64| Expr::Constant(Value::Scalar(angle));
        Some(Self { from: end(*first), to: end(first + TAU), steps: STEPS })
    }

    fn solved(&self, compiled: &Compiled, steps: usize) -> Vec<Pose> {
        let mut mechanism = compiled.mechanism.clone();
        if let [drive] = mechanism.drives.as_mut_slice() {
            drive.positions = Positions::Range { from: self.from.clone(), to: self.to.clone(), steps };
        }
        only_positions(&mut mechanism);
        let Effects { moving, timed, .. } = compiled.plan.effects;
        let effects = Effects { moving, timed, ..Effects::default() };
        let plan = plan_with(&mechanism, &compiled.structure, effects);
        let model = Model { mechanism: &mechanism, structure: &compiled.structure, plan: &plan };
        solve(&model).map(|solution| solution.poses).unwrap_or_default()
    }
}

/// Nothing but positions is asked.
pub(super) fn only_positions(mechanism: &mut Mechanism) {
    mechanism.finds.clear();
    mechanism.expects.clear();
    mechanism.quantities.clear();
    mechanism.poses.clear();
    mechanism.loads.clear();
    mechanism.cycles.clear();
    mechanism.flywheels.clear();
    mechanism.criticals.clear();
    mechanism.powers = None;
}
