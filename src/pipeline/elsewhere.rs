//! A position away from those of a file, for the scheme of an exercise that asks for positions.

use super::compile::Compiled;
use super::turn::{only_positions, turn_in};
use assur_math::math::Vec2;
use assur_model::model::{Expr, LinkId, Positions, Value};
use assur_position::plan::{Effects, plan_with};
use assur_solve::solve::{DriveValue, Model, Pose, Solution, extent, solve};

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
