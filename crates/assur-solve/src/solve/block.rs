//! Positions of a sweep side by side, where none depends on the one before.
//!
//! A closed form finds a position from the drives and from the assembly alone. Where every group stays far from its change points
//! the motion keeps the assembly, which is what following would find: a block of such positions is solved at once, here, in lanes,
//! and then taken over by the one that follows ([`Taking::take`](super::Taking::take)), as far as that holds. Nothing else may
//! come of it than from following: not a bit, not a note. Only where whole positions are asked for, a state is written of each.

use super::inputs::Rates;
use super::lost::{MEETS, MODERATE};
use super::positions::Sweep;
use super::regular::NO_NOTE;
use super::solution::{Pose, Solved};
use super::steps::StepLimit;
use super::taken::{Turns, Uneven, vector};
use super::track::CAREFUL;
use crate::answer::{PoseAnswers, WholeCycle, WideBeside, WideColumns, finite, of_drive, write_row};
use crate::math::Lanes;
use crate::model::PairKind;
use crate::plan::Precision;
use crate::position::{
    Branch, Checked, DriveInput, DriveValue, F64x8, LaneSolver, Model, PoseOrigin, Residuals, State, WIDTH,
    in_avx2,
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

/// What the next positions of a sweep are solved from while the one that follows it looks at others.
#[derive(Clone, Copy, Debug)]
pub struct UpcomingPositions<'f> {
    pub(super) model: &'f Model<'f>,
    pub(super) rates: &'f Rates,
    pub(super) statics: &'f WholeCycle,
    pub(super) sweep: &'f Sweep,
    pub(super) pace: &'f StepLimit,
    pub(super) branches: &'f [Branch],
    pub(super) first: usize,
    pub(super) count: usize,
    /// How many angles there are, of bodies and pairs.
    pub(super) angles: usize,
    /// The balance of forces is checked and its residuals are kept.
    pub(super) residuals: bool,
}

/// Positions side by side, with the memory for them.
#[derive(Debug, Default)]
pub struct Block {
    /// The index of the first position in the sweep.
    first: usize,
    /// Rows of lanes; those of the last that are left over repeat the last position.
    pub(super) rows: Vec<State<F64x8>>,
    checked: Vec<Checked>,
    together: LaneSolver,
    /// The values of the drives, position by position.
    values: Vec<DriveValue>,
    drives: usize,
    /// What the rows have of the drives besides their values.
    rates: Rates,
    /// The drives that an angle or a coordinate places.
    turned: Vec<usize>,
    /// The residuals of the forces are known.
    residuals: bool,
    /// How many were solved.
    solved: usize,
    /// How many positions from the first on are what following would find, as far as it was looked at.
    free: usize,
    /// How many positions from the first on are one step from the one before, the first apart.
    pub(super) in_single_steps: usize,
    /// A bound for the steps between these, in largest ones; not a number where there is none.
    pub(super) longest_step: f64,
    /// Where bodies turn by more than their directions tell.
    pub(super) uneven: Vec<Uneven>,
    pub(super) turns: Turns,
    poses: Vec<Pose>,
}

impl UpcomingPositions<'_> {
    /// How many positions can be tried.
    #[must_use]
    pub const fn count(&self) -> usize {
        self.count
    }

    /// Those behind the next `count` of them.
    #[must_use]
    pub const fn behind(self, count: usize) -> Self {
        Self { first: self.first + count, count: self.count.saturating_sub(count), ..self }
    }

    /// The same, with the closure as the only residual: of forces that are neither lost nor out of scale nothing else is reported.
    #[must_use]
    pub const fn without_residuals(self) -> Self {
        Self { residuals: false, ..self }
    }

    /// Solves positions, counted from the first that can be tried.
    pub fn solve(&self, block: &mut Block, from: usize) {
        block.begin(self, from);
        let Block { rows, turned, checked, .. } = block;
        block.together.run(self.model.plan, (rows, turned), checked, self.residuals);
        let regular = || block.rows.iter().zip(&block.checked).map(|(row, c)| regular(self.model, row, c));
        let all = in_avx2(
            #[inline(always)]
            || {
                regular()
                    .fold([u64::MAX; WIDTH], |all, row| std::array::from_fn(|lane| all[lane] & row[lane]))
            },
        );
        block.free = block.solved;
        if all.contains(&0) {
            block.free = regular().flatten().take(block.solved).take_while(|regular| *regular != 0).count();
        }
        let (single, longest) = self.pace.single_steps(&block.values, block.drives);
        (block.in_single_steps, block.longest_step) = (single.min(block.free), longest);
        block.look_at_turns();
    }

    /// Writes the positions, with the quantities; and with the angles if they are asked for, of positions that were taken over.
    pub fn answer(&self, block: &mut Block, angles: bool) {
        block.make_room(self.model);
        let Block { first, rows, checked, values, drives, residuals, free, turns, poses, .. } = block;
        let mut write = |i: usize, known: Option<(&[f64], &[f64])>| {
            let (pose, lane) = (&mut poses[i], i % WIDTH);
            let Ok(solved) = &mut pose.outcome else { return };
            pose.name.clear();
            pose.name.push_str(itoa::Buffer::new().format(*first + i + 1));
            pose.origin = PoseOrigin::Sweep(*first + i);
            pose.drives.clear();
            pose.drives.extend_from_slice(&values[i * *drives..(i + 1) * *drives]);
            rows[i / WIDTH].write_lane(lane, &mut solved.state);
            let checked = &checked[i / WIDTH];
            solved.residuals = checked.residuals(self.model.plan, lane, *residuals);
            solved.condition = checked.condition.0[lane];
            solved.angles.clear();
            if let Some((turns, pairs)) = known {
                let bodies = solved.state.motion.bodies.iter().zip(turns);
                solved.angles.extend(bodies.map(|(b, turns)| b.u.angle() + turns));
                solved.angles.extend_from_slice(pairs);
            } else {
                solved.angles.resize(self.angles, f64::NAN);
            }
            let quantities = std::mem::take(&mut solved.quantities);
            let view = PoseAnswers::new(self.model, &solved.state, &solved.angles, self.statics);
            solved.quantities = view.all_quantities_in(quantities);
        };
        if angles {
            turns.each(*free, |i, turns, pairs| write(i, Some((turns, pairs))));
        } else {
            (0..*free).for_each(|i| write(i, None));
        }
    }
}

impl Block {
    /// The positions, once they were [answered](UpcomingPositions::answer).
    #[must_use]
    pub fn poses(&self) -> &[Pose] {
        &self.poses[..self.free.min(self.poses.len())]
    }

    /// How many positions are left.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.free
    }

    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.free == 0
    }

    /// Writes what a position is called.
    pub fn push_name(&self, position: usize, out: &mut Vec<u8>) {
        out.extend_from_slice(itoa::Buffer::new().format(self.first + position + 1).as_bytes());
    }

    /// How many were solved.
    pub(super) const fn solved(&self) -> usize {
        self.solved
    }

    /// Hands the positions over.
    pub(super) fn into_poses(mut self) -> impl Iterator<Item = Pose> {
        self.poses.truncate(self.free);
        self.poses.into_iter()
    }

    /// So many positions are left.
    pub(super) const fn keep(&mut self, count: usize) {
        self.free = count;
    }

    /// The values of the drives at a position.
    pub(super) fn values(&self, position: usize) -> &[DriveValue] {
        &self.values[position * self.drives..(position + 1) * self.drives]
    }

    /// Appends the numbers of the positions that are left, column by column.
    pub fn read(&self, columns: &WideColumns, out: &mut [Vec<f64>]) {
        let at = out.first().map_or(0, Vec::len);
        out.iter_mut().for_each(|column| column.resize(at + self.free, f64::NAN));
        self.write(columns, &mut out.iter_mut().map(|column| &mut column[at..]));
    }

    /// Writes the numbers of the positions that are left, column by column, to places of as many.
    pub fn write(&self, columns: &WideColumns, out: &mut dyn Iterator<Item = &mut [f64]>) {
        let beside = |what, out: &mut [f64]| self.write_beside(what, out);
        columns.write(&self.rows, (&self.values, self.drives), out, beside);
    }

    /// Writes what is known in addition to the states; angles of positions that were taken over.
    fn write_beside(&self, beside: WideBeside, out: &mut [f64]) {
        match beside {
            WideBeside::Angle(link) => {
                let each = self.turns.of(link.index(), out.len());
                for (i, (out, turns)) in out.iter_mut().zip(each).enumerate() {
                    let u = self.rows[i / WIDTH].motion.bodies[link.index()].u;
                    *out = finite(vector(u, i % WIDTH).angle() + turns);
                }
            }
            WideBeside::Equilibrium => self.write_part(out, self.residuals, |c| c.equilibrium),
            WideBeside::Power => self.write_part(out, self.residuals, |c| c.power),
            WideBeside::Condition => self.write_part(out, true, |c| c.condition),
        }
    }

    /// Writes residuals and condition of the positions that are left from a place on; NaN where there are none.
    pub fn write_quality(&self, model: &Model<'_>, at: usize, out: [&mut [f64]; 4]) {
        let known = Checked::default().residuals(model.plan, 0, self.residuals);
        let [closure, equilibrium, power, condition] = out.map(|column| &mut column[at..at + self.free]);
        self.write_part(closure, true, |c| c.closure);
        self.write_part(equilibrium, known.equilibrium.is_some(), |c| c.equilibrium);
        self.write_part(power, known.power.is_some(), |c| c.power);
        self.write_part(condition, true, |c| c.condition);
    }

    /// Writes what is known of the positions from the first on; NaN where it is not.
    fn write_part(&self, out: &mut [f64], known: bool, part: impl Fn(&Checked) -> F64x8) {
        if !known {
            return out.fill(f64::NAN);
        }
        in_avx2(
            #[inline(always)]
            || {
                for (out, checked) in out.chunks_mut(WIDTH).zip(&self.checked) {
                    write_row(out, &part(checked));
                }
            },
        );
    }

    /// Residuals and condition of the positions that are left.
    pub fn quality(&self, model: &Model<'_>) -> impl Iterator<Item = (Residuals, f64)> {
        (0..self.free).map(|i| {
            let checked = &self.checked[i / WIDTH];
            let residuals = checked.residuals(model.plan, i % WIDTH, self.residuals);
            (residuals, checked.condition.0[i % WIDTH])
        })
    }

    /// Sets inputs and assemblies of the positions from one on.
    fn begin(&mut self, ahead: &UpcomingPositions<'_>, from: usize) {
        let plan = ahead.model.plan;
        self.solved = ahead.count.saturating_sub(from).min(BLOCK);
        (self.first, self.residuals, self.drives) = (ahead.first + from, ahead.residuals, plan.drives);
        ahead.sweep.write_values(self.first, &mut self.values, self.solved);
        let count = self.solved.div_ceil(WIDTH);
        let kept = if self.rates == *ahead.rates { self.rows.len() } else { 0 };
        if kept == 0 {
            self.rates.clone_from(ahead.rates);
        }
        self.rows.truncate(count);
        self.rows.resize_with(count, || State::closed(plan));
        self.checked.resize(count, Checked::default());
        self.rows.iter_mut().for_each(|row| row.branches.copy_from_slice(ahead.branches));
        self.turned.clear();
        for drive in 0..self.drives {
            self.place(drive, ahead.rates, kept);
        }
    }

    /// Puts a drive at its values; the first rows have its rates already.
    fn place(&mut self, drive: usize, rates: &Rates, kept: usize) {
        let values = || of_drive(&self.values, self.drives, drive);
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

    fn make_room(&mut self, model: &Model<'_>) {
        while self.poses.len() < self.free {
            let outcome = Ok(Solved { state: State::closed(model.plan), ..Solved::default() });
            let (name, origin, drives) = (String::new(), PoseOrigin::Sweep(0), Vec::new());
            self.poses.push(Pose { name, origin, drives, outcome });
        }
    }
}

/// Which positions are such that following finds them too, if it found the one before: far from change points, and with nothing to
/// be said about them. All bits where a position is, as vectors compare.
#[inline(always)]
fn regular(model: &Model<'_>, row: &State<F64x8>, checked: &Checked) -> [u64; WIDTH] {
    const fn bits(holds: bool) -> u64 {
        if holds { u64::MAX } else { 0 }
    }
    let Checked { closure, equilibrium, power, condition, magnitude } = checked;
    let closes = bits(row.motion.open.is_none());
    let mut regular = std::array::from_fn(|lane| {
        closes
            & bits(condition.0[lane] > NO_NOTE)
            & bits(magnitude.0[lane] < MODERATE)
            & bits(closure.0[lane] <= MEETS)
            & bits(!equilibrium.0[lane].is_nan())
            & bits(!power.0[lane].is_nan())
    });
    for (step, conditions) in model.plan.motion.iter().zip(&row.motion.conditions) {
        if step.has_two_roots() {
            regular
                .iter_mut()
                .zip(conditions.0)
                .for_each(|(regular, c)| *regular &= bits(c.abs() >= CAREFUL));
        }
    }
    regular
}

/// Whether no group is so near to a change point that following tries both its assemblies.
pub(super) fn keeps_its_assembly(model: &Model<'_>, state: &State) -> bool {
    let groups = model.plan.motion.iter().zip(&state.motion.conditions);
    groups.into_iter().all(|(step, c)| c.abs() >= CAREFUL || !step.has_two_roots())
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
