//! From the angles of a drive to an array of what a text asks for: the sine and the cosine of every angle are computed, and
//! every answer is stored.

use super::Run;
use assur::internals::math::Vec2;
use assur::internals::plan::{Level, Plan};
use assur::internals::solve::{Batch, DriveColumns, DriveInput, Place};

/// The angles of the drive, and an array for the answers.
pub struct Turn {
    /// Speed and acceleration of the drive.
    rates: DriveInput,
    angles: Vec<f64>,
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
        Self { rates: run.inputs[0], answers: vec![0.0; width * angles.len()], angles, width }
    }

    fn input(rates: DriveInput, angle: f64) -> DriveInput {
        DriveInput { value: angle, place: Vec2::direction(angle), ..rates }
    }

    /// One position after the other.
    pub fn one_by_one(&mut self, run: &mut Run) -> &[f64] {
        for (angle, out) in self.angles.iter().zip(self.answers.chunks_exact_mut(self.width)) {
            run.at(&[Self::input(self.rates, *angle)]);
            store(&run.compiled.plan, Place::Alone(&run.state), out);
        }
        &self.answers
    }

    /// Several at a time.
    pub fn side_by_side(&mut self, plan: &Plan, batch: &mut Batch<'_>) -> &[f64] {
        let inputs: Vec<DriveInput> = self.angles.iter().map(|a| Self::input(self.rates, *a)).collect();
        let (answers, width) = (&mut self.answers, self.width);
        batch.run(&DriveColumns::of(&inputs, 1), |i, place| {
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
        for (slot, out) in reactions.chunks_exact_mut(3).enumerate() {
            let reaction = place.reaction(slot);
            out.copy_from_slice(&[reaction.force.x, reaction.force.y, reaction.couple]);
        }
        efforts.iter_mut().enumerate().for_each(|(slot, out)| *out = place.effort(slot));
        return;
    }
    let level = plan.effects.level;
    for (i, out) in out.chunks_exact_mut(if level == Level::Positions { 4 } else { 3 }).enumerate() {
        let body = place.body(i + 1);
        match level {
            Level::Positions => out.copy_from_slice(&[body.p.x, body.p.y, body.u.x, body.u.y]),
            Level::Velocities => out.copy_from_slice(&[body.v.x, body.v.y, body.omega]),
            Level::Accelerations => out.copy_from_slice(&[body.a.x, body.a.y, body.alpha]),
        }
    }
}
