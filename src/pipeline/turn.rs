//! The way of a mechanism between and around the positions of its file, for paths of points and other poses in a picture.

use super::compile::Compiled;
use assur_math::math::Vec2;
use assur_model::model::{DriveTarget, Expr, LinkId, Mechanism, PairKind, Positions, Value};
use assur_position::plan::{Effects, plan, plan_with};
use assur_solve::solve::{DriveValue, Model, Pose, Solution, extent, solve};
use std::f64::consts::TAU;

/// Steps of the way, at least.
const STEPS: usize = 180;

/// Positions in small steps: over the way that the file gives its drive, or a whole turn from its first value. None where
/// there are several drives, or the only one does not turn and has no way.
#[must_use]
pub fn turn(compiled: &Compiled, solution: &Solution) -> Vec<Pose> {
    along(compiled, solution, None, None)
}

/// As [`turn`], in a number of positions that is wanted, two or more.
#[must_use]
pub fn turn_in(compiled: &Compiled, solution: &Solution, count: usize) -> Vec<Pose> {
    along(compiled, solution, Some(count), None)
}

/// The frames of an animation with arrows, and whether they have all effects of the plan: positions alone where more of these are
/// found.
#[must_use]
pub fn turn_with_effects(
    compiled: &Compiled,
    solution: &Solution,
    count: Option<usize>,
) -> (Vec<Pose>, bool) {
    let found = |poses: &[Pose]| poses.iter().filter(|pose| pose.outcome.is_ok()).count();
    let whole = along(compiled, solution, count, Some(compiled.plan.effects));
    if found(&whole) == whole.len() && !whole.is_empty() {
        return (whole, true);
    }
    let alone = along(compiled, solution, count, None);
    if found(&alone) > found(&whole) { (alone, false) } else { (whole, true) }
}

/// Positions along the way, with these effects or as few as the way needs.
fn along(
    compiled: &Compiled,
    solution: &Solution,
    count: Option<usize>,
    effects: Option<Effects>,
) -> Vec<Pose> {
    if compiled.mechanism.simulation.is_some() {
        return in_time(compiled, count.map_or(STEPS + 1, |count| count.max(2)), effects);
    }
    let Some(way) = Way::of(&compiled.mechanism, solution) else { return Vec::new() };
    let solved = |steps| way.solved(compiled, steps, effects);
    let Some(count) = count else { return solved(way.steps * STEPS.div_ceil(way.steps)) };
    let each = |parts: usize| {
        let every = STEPS.div_ceil(parts);
        let poses = solved(parts * every);
        let is_closed = poses.len() == parts * every;
        (poses.into_iter().step_by(every).collect::<Vec<_>>(), is_closed)
    };
    // over whole turns the last position is the first and left out
    let (poses, is_closed) = each(count.max(2));
    if is_closed { poses } else { each(count.max(2) - 1).0 }
}

/// A motion under loads at instants that are equally far apart.
fn in_time(compiled: &Compiled, count: usize, effects: Option<Effects>) -> Vec<Pose> {
    let mut mechanism = compiled.mechanism.clone();
    if let Some(simulation) = &mut mechanism.simulation {
        simulation.steps = Some(count - 1);
    }
    // what starts with a speed alone turns from zero on in the picture
    let zero = Value::Scalar(0.0);
    for drive in mechanism.drives.iter_mut().filter(|drive| matches!(drive.positions, Positions::None)) {
        drive.positions = Positions::List(vec![Expr::Constant(zero)]);
    }
    without_questions(&mut mechanism);
    let plan = match effects {
        Some(effects) => plan_with(&mechanism, &compiled.structure, effects),
        None => plan(&mechanism, &compiled.structure),
    };
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
            DriveTarget::Point(..) | DriveTarget::Place(..) => false,
        };
        let first = solution.poses.first()?.drives.first()?;
        let (true, DriveValue::Scalar(first)) = (turns, first) else { return None };
        let end = |angle: f64| Expr::Constant(Value::Scalar(angle));
        Some(Self { from: end(*first), to: end(first + TAU), steps: STEPS })
    }

    fn solved(&self, compiled: &Compiled, steps: usize, effects: Option<Effects>) -> Vec<Pose> {
        let mut mechanism = compiled.mechanism.clone();
        if let [drive] = mechanism.drives.as_mut_slice() {
            drive.positions = Positions::Range { from: self.from.clone(), to: self.to.clone(), steps };
        }
        let Effects { moving, timed, .. } = compiled.plan.effects;
        match effects {
            Some(_) => without_questions(&mut mechanism),
            None => only_positions(&mut mechanism),
        }
        let effects = effects.unwrap_or(Effects { moving, timed, ..Effects::default() });
        let plan = plan_with(&mechanism, &compiled.structure, effects);
        let model = Model { mechanism: &mechanism, structure: &compiled.structure, plan: &plan };
        solve(&model).map(|solution| solution.poses).unwrap_or_default()
    }
}

/// Nothing is asked.
fn without_questions(mechanism: &mut Mechanism) {
    mechanism.finds.clear();
    mechanism.expects.clear();
    mechanism.cycles.clear();
    mechanism.criticals.clear();
    mechanism.powers = None;
}

/// Nothing but positions is asked.
pub(super) fn only_positions(mechanism: &mut Mechanism) {
    without_questions(mechanism);
    mechanism.quantities.clear();
    mechanism.poses.clear();
    mechanism.loads.clear();
    mechanism.flywheels.clear();
}

// A position away from those of a file, for the scheme of an exercise that asks for positions.

/// Positions of a way that may be taken.
const OTHERS: usize = 12;
/// How far drives are moved from their values: parts of a radian, and of the size of the mechanism.
const SHARES: [f64; 8] = [0.5, -0.5, 0.25, -0.25, 0.1, -0.1, 0.05, -0.05];

/// A position that is not the one at `pose`: a quarter of its way further, or with the drives moved a little where there is no way. None
/// where the mechanism has no other position.
#[must_use]
pub fn elsewhere(compiled: &Compiled, solution: &Solution, pose: &Pose) -> Option<Pose> {
    let way = turn_in(compiled, solution, OTHERS).into_iter().skip(OTHERS / 4);
    let mut way = way.filter(|other| is_apart(compiled, pose, other));
    way.next().or_else(|| SHARES.into_iter().find_map(|share| moved(compiled, pose, share)))
}

/// The position with all drives moved.
fn moved(compiled: &Compiled, pose: &Pose, share: f64) -> Option<Pose> {
    let mut mechanism = compiled.mechanism.clone();
    only_positions(&mut mechanism);
    let size = extent(&compiled.model());
    for (i, (drive, value)) in mechanism.drives.iter_mut().zip(&pose.drives).enumerate() {
        let turns = matches!(compiled.mechanism.drive_display(drive.target).dimension, [0, 0, 0, _]);
        // drives that move alike would carry the whole mechanism along
        let by = share * if turns { 1.0 } else { size / 3.0 } / (1.0 + i as f64);
        let value = match value {
            DriveValue::Scalar(x) => Value::Scalar(x + by),
            DriveValue::Point(at) => Value::Vector(*at + Vec2::new(by, by / 2.0)),
            DriveValue::None => continue,
        };
        drive.positions = Positions::List(vec![Expr::Constant(value)]);
    }
    let plan = plan_with(&mechanism, &compiled.structure, Effects::default());
    let model = Model { mechanism: &mechanism, structure: &compiled.structure, plan: &plan };
    let found = solve(&model).ok()?.poses.into_iter().next()?;
    is_apart(compiled, pose, &found).then_some(found)
}

/// Whether a link is seen to be elsewhere.
fn is_apart(compiled: &Compiled, one: &Pose, other: &Pose) -> bool {
    let (Ok(one), Ok(other)) = (&one.outcome, &other.outcome) else { return false };
    let size = extent(&compiled.model());
    let apart = |link: LinkId| {
        let [a, b] = [one, other].map(|solved| &solved.state.motion.bodies[link.index()]);
        (a.u - b.u).norm() > 0.02
            || (a.position(Vec2::zero()) - b.position(Vec2::zero())).norm() > 0.02 * size
    };
    (1..compiled.mechanism.links.len()).any(|i| apart(LinkId::at(i)))
}
