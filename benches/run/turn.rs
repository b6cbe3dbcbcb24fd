//! From the angles of a drive to an array of what a text asks for: the sine and the cosine of every angle are computed, and
//! every answer is stored.

use super::Run;
use assur::internals::math::Vec2;
use assur::internals::plan::{Level, Plan};
use assur::internals::solve::{Batch, BodyState, DriveColumns, DriveInput, Place};

/// The angles of the drive, and an array for the answers.
pub struct Turn {
    /// Speed and acceleration of the drive.
    rates: DriveInput,
    angles: Vec<f64>,
    columns: DriveColumns,
    answers: Vec<f64>,
    /// Numbers of one position.
    width: usize,
}

impl Turn {
    /// The turn of a text with one driven angle.
    pub fn of(run: &Run) -> Self {
        let plan = &run.compiled.plan;
        assert_eq!(plan.drives, 1, "one angle is driven");
        let angles: Vec<f64> = run.inputs.iter().map(|input| input.value).collect();
        let width = width(plan);
        let (columns, answers) = (DriveColumns::of(&run.inputs, 1), vec![0.0; width * angles.len()]);
        Self { rates: run.inputs[0], angles, columns, answers, width }
    }

    /// One position after the other.
    pub fn one_by_one(&mut self, run: &mut Run) -> &[f64] {
        for (angle, out) in self.angles.iter().zip(self.answers.chunks_exact_mut(self.width)) {
            run.at(&[DriveInput { value: *angle, place: Vec2::direction(*angle), ..self.rates }]);
            store(&run.compiled.plan, Place::Alone(&run.state), out);
        }
        &self.answers
    }

    /// Several at a time.
    pub fn side_by_side(&mut self, plan: &Plan, batch: &mut Batch<'_>) -> &[f64] {
        self.columns.set_angles(0, &self.angles);
        let (answers, width) = (&mut self.answers, self.width);
        batch.run(&self.columns, |i, place| {
            store(plan, place, &mut answers[i * width..][..width]);
        });
        &self.answers
    }
}

/// How many numbers [`store`] writes.
fn width(plan: &Plan) -> usize {
    if plan.effects.forces {
        return 3 * plan.reactions.len() + plan.efforts;
    }
    let of_a_body = if plan.effects.level == Level::Positions { 4 } else { 3 };
    of_a_body * (plan.bodies - 1)
}

/// All reactions and efforts; without forces the places, the velocities or the accelerations of all bodies.
#[inline(always)]
fn store(plan: &Plan, place: Place<'_>, out: &mut [f64]) {
    if plan.effects.forces {
        let (reactions, efforts) = out.split_at_mut(3 * plan.reactions.len());
        for (slot, out) in reactions.as_chunks_mut().0.iter_mut().enumerate() {
            let reaction = place.reaction(slot);
            *out = [reaction.force.x, reaction.force.y, reaction.couple];
        }
        efforts.iter_mut().enumerate().for_each(|(slot, out)| *out = place.effort(slot));
        return;
    }
    match plan.effects.level {
        Level::Positions => of_bodies(place, out, |b| [b.p.x, b.p.y, b.u.x, b.u.y]),
        Level::Velocities => of_bodies(place, out, |b| [b.v.x, b.v.y, b.omega]),
        Level::Accelerations => of_bodies(place, out, |b| [b.a.x, b.a.y, b.alpha]),
    }
}

#[inline(always)]
fn of_bodies<const N: usize>(place: Place<'_>, out: &mut [f64], numbers: impl Fn(BodyState) -> [f64; N]) {
    let (bodies, _) = out.as_chunks_mut::<N>();
    bodies.iter_mut().enumerate().for_each(|(i, out)| *out = numbers(place.body(i + 1)));
}
