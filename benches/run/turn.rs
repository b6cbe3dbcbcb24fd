//! From the angles of a drive to an array of what a text asks for: the sine and the cosine of every angle are computed, and
//! every answer is stored.

use super::{Run, SideBySide};
use assur::internals::math::{Lanes, Scalar, Vec2};
use assur::internals::plan::{Level, Plan};
use assur::internals::solve::{BodyState, DriveInput, State, WIDTH};

/// The angles of the drive, and arrays for the answers.
pub struct Turn {
    /// Speed and acceleration of the drive.
    rates: DriveInput,
    angles: Vec<f64>,
    /// Of positions one by one.
    answers: Vec<f64>,
    /// Of rows of positions side by side.
    rows: Vec<Lanes<WIDTH>>,
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
        let rows = vec![Lanes::default(); width * angles.len().div_ceil(WIDTH)];
        let answers = vec![0.0; width * angles.len()];
        Self { rates: run.inputs[0], angles, answers, rows, width }
    }

    /// One position after the other.
    pub fn one_by_one(&mut self, run: &mut Run) -> f64 {
        run.state.motion.inputs[0] = self.rates;
        for (angle, out) in self.angles.iter().zip(self.answers.chunks_exact_mut(self.width)) {
            let input = &mut run.state.motion.inputs[0];
            (input.value, input.place) = (*angle, Vec2::direction(*angle));
            run.state.run(&run.compiled.plan);
            store(&run.compiled.plan, &run.state, out);
        }
        self.answers[0]
    }

    /// Several at a time.
    pub fn side_by_side(&mut self, plan: &Plan, positions: &mut SideBySide) -> f64 {
        for (input, angles) in positions.inputs.iter_mut().zip(self.angles.chunks(WIDTH)) {
            input.value.0[..angles.len()].copy_from_slice(angles);
        }
        let Self { rows, width, .. } = self;
        positions.all(plan, &[0], |i, state| store(plan, state, &mut rows[i * *width..][..*width]));
        self.rows[0].0[0]
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
fn store<S: Scalar>(plan: &Plan, state: &State<S>, out: &mut [S]) {
    if plan.effects.forces {
        let (reactions, efforts) = out.split_at_mut(3 * plan.reactions.len());
        for (reaction, out) in state.forces.reactions.iter().zip(reactions.as_chunks_mut().0) {
            *out = [reaction.force.x, reaction.force.y, reaction.couple];
        }
        efforts.copy_from_slice(&state.forces.efforts);
        return;
    }
    let bodies = &state.motion.bodies[1..];
    match plan.effects.level {
        Level::Positions => of_bodies(bodies, out, |b| [b.p.x, b.p.y, b.u.x, b.u.y]),
        Level::Velocities => of_bodies(bodies, out, |b| [b.v.x, b.v.y, b.omega]),
        Level::Accelerations => of_bodies(bodies, out, |b| [b.a.x, b.a.y, b.alpha]),
    }
}

#[inline(always)]
fn of_bodies<S: Scalar, const N: usize>(
    bodies: &[BodyState<S>],
    out: &mut [S],
    numbers: impl Fn(&BodyState<S>) -> [S; N],
) {
    bodies.iter().zip(out.as_chunks_mut::<N>().0).for_each(|(body, out)| *out = numbers(body));
}
