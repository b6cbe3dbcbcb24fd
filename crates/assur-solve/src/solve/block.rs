//! Positions of a sweep side by side, where none depends on the one before.
//!
//! A closed form finds a position from the drives and from the assembly alone. Where every group stays far from its change points
//! at all positions, the motion keeps the assembly: such a sweep is solved in lanes from its start to its end. Any other is followed.

use super::again::PoseOutputs;
use super::inputs::Rates;
use super::lost::{MEETS, MODERATE};
use super::positions::Sweep;
use super::regular::NO_NOTE;
use super::solution::{Pose, Solved};
use super::steps::StepLimit;
use super::track::CAREFUL;
use super::whole_turns::Turns;
use crate::answer::{PoseAnswers, WholeCycle};
use crate::math::{Lanes, Vec2};
use crate::model::PairKind;
use crate::plan::{MotionStep, Precision};
use crate::position::{
    BodyState, Branch, Checked, DriveInput, DriveValue, F64x8, LaneSolver, Model, PoseOrigin, State, WIDTH,
};

/// The most positions of a block.
pub const BLOCK: usize = 64;

/// Whether positions of a mechanism can depend on the drives and the assembly alone, with nothing to be said about them.
pub(super) fn is_free(model: &Model<'_>) -> bool {
    let plan = model.plan;
    let contact = |pair: &crate::model::Pair| matches!(pair.kind, PairKind::Contact { .. });
    plan.is_batchable()
        && plan.settings.scalar == Precision::F64
        && !plan.effects.loses()
        && !model.mechanism.has_curves
        && !model.mechanism.pairs.iter().any(contact)
}

/// The positions of a sweep behind its first, of which none depends on the one before.
#[derive(Clone, Copy, Debug)]
pub struct FreeSweep<'f> {
    pub(super) model: &'f Model<'f>,
    pub(super) rates: &'f Rates,
    pub(super) statics: &'f WholeCycle,
    pub(super) sweep: &'f Sweep,
    pub(super) pace: &'f StepLimit,
    pub(super) branches: &'f [Branch],
    pub(super) turns: &'f Turns,
    /// The index of the first of them in the sweep.
    pub(super) first: usize,
    pub(super) reads: PoseOutputs,
}

/// Positions side by side, with the memory for them.
#[derive(Debug, Default)]
pub struct Block {
    /// The index of the first position in the sweep.
    first: usize,
    len: usize,
    /// Rows of lanes; those of the last that are left over repeat the last position.
    rows: Vec<State<F64x8>>,
    checked: Vec<Checked>,
    solver: LaneSolver,
    /// The values of the drives, position by position.
    values: Vec<DriveValue>,
    drives: usize,
    /// What the rows have of the drives besides their values.
    rates: Rates,
    /// The drives that an angle or a coordinate places.
    turned: Vec<usize>,
    poses: Vec<Pose>,
}

impl FreeSweep<'_> {
    /// How many positions there are.
    #[must_use]
    pub const fn count(&self) -> usize {
        self.sweep.len() - self.first
    }

    /// How many blocks these are.
    #[must_use]
    pub const fn blocks(&self) -> usize {
        self.count().div_ceil(BLOCK)
    }

    /// Solves the positions of a block.
    pub fn solve(&self, number: usize, block: &mut Block) {
        self.place(block, self.first + number * BLOCK, self.count() - number * BLOCK);
        while block.poses.len() < block.len {
            let outcome = Ok(Solved { state: State::closed(self.model.plan), ..Solved::default() });
            let (name, origin, drives) = (String::new(), PoseOrigin::Sweep(0), Vec::new());
            block.poses.push(Pose { name, origin, drives, outcome });
        }
        let Block { first, len, rows, checked, values, drives, poses, .. } = block;
        for (i, pose) in poses.iter_mut().enumerate().take(*len) {
            let (position, row, lane) = (*first + i, i / WIDTH, i % WIDTH);
            let Ok(solved) = &mut pose.outcome else { continue };
            pose.name.clear();
            pose.name.push_str(itoa::Buffer::new().format(position + 1));
            pose.origin = PoseOrigin::Sweep(position);
            pose.drives.clear();
            pose.drives.extend_from_slice(&values[i * *drives..(i + 1) * *drives]);
            rows[row].write_lane(lane, &mut solved.state);
            solved.residuals = checked[row].residuals(self.model.plan, lane, self.reads.residuals);
            solved.condition = checked[row].condition.0[lane];
            solved.angles.clear();
            if self.reads.angles {
                let bodies = solved.state.motion.bodies.iter().enumerate();
                let angle = |(body, b): (usize, &BodyState)| b.u.angle() + self.turns.of(body, position);
                solved.angles.extend(bodies.map(angle));
                solved.angles.extend_from_slice(&self.turns.pairs);
            } else {
                let count = solved.state.motion.bodies.len() + self.turns.pairs.len();
                solved.angles.resize(count, f64::NAN);
            }
            let quantities = std::mem::take(&mut solved.quantities);
            let view = PoseAnswers::new(self.model, &solved.state, &solved.angles, self.statics);
            solved.quantities = view.all_quantities_in(quantities);
        }
    }

    /// Solves positions from one of the sweep on, a block of them at the most.
    pub(super) fn place(&self, block: &mut Block, first: usize, most: usize) {
        block.begin(self, first, most.min(BLOCK));
        let Block { rows, turned, checked, .. } = block;
        block.solver.run(self.model.plan, (rows, turned), checked, self.reads.residuals);
    }
}

impl Block {
    /// The positions.
    #[must_use]
    pub fn poses(&self) -> &[Pose] {
        &self.poses[..self.len]
    }

    pub(super) const fn len(&self) -> usize {
        self.len
    }

    /// The values of the drives at a position.
    pub(super) fn values(&self, position: usize) -> &[DriveValue] {
        &self.values[position * self.drives..(position + 1) * self.drives]
    }

    /// The directions of the bodies at a position.
    pub(super) fn directions(&self, position: usize) -> impl Iterator<Item = Vec2> {
        let (row, lane) = (&self.rows[position / WIDTH], position % WIDTH);
        row.motion.bodies.iter().map(move |b| Vec2::new(b.u.x.0[lane], b.u.y.0[lane]))
    }

    /// Whether all positions are such that following finds them too, if it found the one before: far from change points, and with
    /// nothing to be said about them.
    pub(super) fn is_regular(&self, model: &Model<'_>) -> bool {
        self.rows.iter().zip(&self.checked).all(|(row, checked)| is_regular(model, row, checked))
    }

    /// Sets inputs and assemblies of the positions from one on.
    fn begin(&mut self, sweep: &FreeSweep<'_>, first: usize, len: usize) {
        let plan = sweep.model.plan;
        (self.first, self.len, self.drives) = (first, len, plan.drives);
        sweep.sweep.write_values(first, &mut self.values, len);
        let count = len.div_ceil(WIDTH);
        let kept = if self.rates == *sweep.rates { self.rows.len() } else { 0 };
        if kept == 0 {
            self.rates.clone_from(sweep.rates);
        }
        self.rows.truncate(count);
        self.rows.resize_with(count, || State::closed(plan));
        self.checked.resize(count, Checked::default());
        self.rows.iter_mut().for_each(|row| row.branches.copy_from_slice(sweep.branches));
        self.turned.clear();
        for drive in 0..self.drives {
            self.drive(drive, sweep.rates, kept);
        }
    }

    /// Puts a drive at its values; the first rows have its rates already.
    fn drive(&mut self, drive: usize, rates: &Rates, kept: usize) {
        let values = || self.values.iter().skip(drive).step_by(self.drives);
        let Some(last) = values().next_back() else { return };
        let last_and_after = std::iter::repeat(last);
        let mut each = values().chain(last_and_after);
        if values().all(|value| matches!(value, DriveValue::Scalar(_))) {
            self.turned.push(drive);
            for row in self.rows.iter_mut().skip(kept) {
                row.motion.inputs[drive] = rates.wide(drive);
            }
            for row in &mut self.rows {
                let mut value = [0.0; WIDTH];
                value.iter_mut().zip(&mut each).for_each(|(x, value)| {
                    if let DriveValue::Scalar(value) = value {
                        *x = *value;
                    }
                });
                row.motion.inputs[drive].value = Lanes(value);
            }
        } else {
            for row in &mut self.rows {
                for (lane, value) in (0..WIDTH).zip(&mut each) {
                    row.motion.inputs[drive].set_lane(lane, &rates.input(drive, *value));
                }
            }
        }
    }
}

fn is_regular(model: &Model<'_>, row: &State<F64x8>, checked: &Checked) -> bool {
    let Checked { closure, equilibrium, power, condition, magnitude } = checked;
    let far =
        |(step, c): (&MotionStep, &F64x8)| !step.has_two_roots() || c.0.iter().all(|c| c.abs() >= CAREFUL);
    row.motion.open.is_none()
        && condition.0.iter().all(|c| *c > NO_NOTE)
        && magnitude.0.iter().all(|m| *m < MODERATE)
        && closure.0.iter().all(|c| *c <= MEETS)
        && !equilibrium.0.iter().chain(&power.0).any(|x| x.is_nan())
        && model.plan.motion.iter().zip(&row.motion.conditions).all(far)
}

impl Rates {
    /// A drive at rest in its place, at several positions side by side.
    fn wide(&self, drive: usize) -> DriveInput<F64x8> {
        let one = self.input(drive, DriveValue::None);
        let mut wide = DriveInput::default();
        (0..WIDTH).for_each(|lane| wide.set_lane(lane, &one));
        wide
    }
}
