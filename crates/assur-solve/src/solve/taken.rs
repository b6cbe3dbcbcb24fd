//! Positions of a block taken over by the one that follows the motion, as far as following comes to the same.

use super::block::{BLOCK, Block, keeps_its_assembly};
use super::track::{Tracker, continued};
use crate::answer::whole_turns;
use crate::math::{V2, Vec2};
use crate::position::{BodyState, Model, WIDTH, Wide};

/// Whole turns of the bodies over a block, rad: they change at few positions.
#[derive(Debug, Default)]
pub(super) struct Turns {
    /// At the position before.
    before: Vec<f64>,
    /// Position, body, and its whole turns from there on.
    changes: Vec<(usize, usize, f64)>,
    /// The same over all positions, by pair.
    pairs: Vec<f64>,
    now: Vec<f64>,
}

impl Turns {
    /// Calls `look` with the turns of bodies and pairs at every position.
    pub(super) fn each(&mut self, count: usize, mut look: impl FnMut(usize, &[f64], &[f64])) {
        self.now.clone_from(&self.before);
        let mut changes = self.changes.iter().peekable();
        for position in 0..count {
            while let Some(&(_, body, turns)) = changes.next_if(|change| change.0 <= position) {
                self.now[body] = turns;
            }
            look(position, &self.now, &self.pairs);
        }
    }
}

impl Tracker {
    /// Takes over positions of a block as far as following comes to the same, and moves to the last of them. Returns how many
    /// they are.
    pub(super) fn take(&mut self, model: &Model<'_>, block: &mut Block) -> usize {
        if !keeps_its_assembly(model, &self.state) {
            block.keep(0);
            return 0;
        }
        let near = self.in_single_steps(block);
        let taken = block.turn_on(&self.angles, &self.state.motion.bodies, near);
        block.keep(taken);
        let Some(last) = taken.checked_sub(1) else { return 0 };
        self.remember_block(block);
        self.values.clear();
        self.values.extend_from_slice(block.values(last));
        block.rows[last / WIDTH].motion.start_lane(last % WIDTH, &mut self.state.motion);
        let Self { angles, state, .. } = self;
        block.turns.each(taken, |position, turns, _| {
            if position == last {
                let bodies = state.motion.bodies.iter().zip(turns);
                angles.iter_mut().zip(bodies).for_each(|(angle, (b, turns))| *angle = b.u.angle() + turns);
            }
        });
        taken
    }

    /// How many positions are one step from the one before.
    fn in_single_steps(&self, block: &Block) -> usize {
        let before = |i: usize| if i == 0 { self.values.as_slice() } else { block.values(i - 1) };
        (0..block.len()).take_while(|&i| self.pace.is_one_step(before(i), block.values(i))).count()
    }

    /// Keeps the places before each of the positions, as steps one by one do.
    fn remember_block(&mut self, block: &Block) {
        self.remember();
        for position in 0..block.len() - 1 {
            let values = block.values(position);
            if self.history.first().is_some_and(|last| !self.pace.is_apart(&last.values, values)) {
                continue;
            }
            let (row, lane) = (&block.rows[position / WIDTH], position % WIDTH);
            let vector = |v: V2<Wide>| Vec2::new(v.x.0[lane], v.y.0[lane]);
            let poses = row.motion.bodies.iter().map(|b| (vector(b.p), vector(b.u)));
            Self::keep(&mut self.history, values, poses);
        }
    }
}

impl Block {
    /// Carries whole turns of the bodies on over the first positions. Returns how many these are: up to one where a body turns too
    /// far for that.
    fn turn_on(&mut self, angles: &[f64], bodies: &[BodyState], most: usize) -> usize {
        let Turns { before, changes, pairs, .. } = &mut self.turns;
        before.clear();
        before.extend(angles.iter().zip(bodies).map(|(angle, b)| whole_turns(*angle - b.u.angle())));
        pairs.clear();
        pairs.extend_from_slice(&angles[bodies.len()..]);
        changes.clear();
        let (mut taken, mut directions) = (most, [Vec2::zero(); BLOCK + 1]);
        for (body, now) in bodies.iter().enumerate() {
            directions[0] = now.u;
            for (row, directions) in self.rows.iter().zip(directions[1..].chunks_mut(WIDTH)) {
                let u = &row.motion.bodies[body].u;
                directions.iter_mut().zip(u.x.0).zip(u.y.0).for_each(|((d, x), y)| *d = Vec2::new(x, y));
            }
            let mut turns = before[body];
            for (position, two) in directions.windows(2).take(taken).enumerate() {
                let (old, new) = (two[0], two[1]);
                if old.dot(new) <= 0.0 {
                    taken = position;
                    break;
                }
                // only over the negative x axis the angle jumps
                if old.y.is_sign_negative() != new.y.is_sign_negative() && (old.x < 0.0 || new.x < 0.0) {
                    turns = whole_turns(continued(old.angle() + turns, old, new) - new.angle());
                    changes.push((position, body, turns));
                }
            }
        }
        changes.retain(|change| change.0 < taken);
        changes.sort_by_key(|change| change.0);
        taken
    }
}
