//! Positions of a block taken over by the one that follows the motion, as far as following comes to the same.

use super::block::{Block, keeps_its_assembly};
use super::track::{KEPT, Tracker, continued};
use crate::answer::whole_turns;
use crate::math::{V2, Vec2};
use crate::position::{BodyState, F64x8, Model, WIDTH, in_avx2};

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
    /// The turns of the bodies at the last position.
    fn last(&mut self) -> &[f64] {
        self.now.clone_from(&self.before);
        self.changes.iter().for_each(|&(_, body, turns)| self.now[body] = turns);
        &self.now
    }

    /// The turns of a body at the first positions.
    pub(super) fn of(&self, body: usize, count: usize) -> impl Iterator<Item = f64> {
        let mut now = self.before.get(body).copied().unwrap_or(f64::NAN);
        let mut changes = self.changes.iter().filter(move |change| change.1 == body).peekable();
        (0..count).map(move |position| {
            while let Some(&(_, _, turns)) = changes.next_if(|change| change.0 <= position) {
                now = turns;
            }
            now
        })
    }

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
        let bodies = self.state.motion.bodies.iter().zip(block.turns.last());
        self.angles.iter_mut().zip(bodies).for_each(|(angle, (b, turns))| *angle = b.u.angle() + turns);
        taken
    }

    /// How many positions are one step from the one before.
    fn in_single_steps(&self, block: &Block) -> usize {
        let first = !block.is_empty() && self.pace.is_one_step(&self.values, block.values(0));
        if first { block.in_single_steps } else { 0 }
    }

    /// Keeps the places before each of the positions, as steps one by one do.
    fn remember_block(&mut self, block: &Block) {
        self.remember();
        let (mut kept, mut count) = ([0; KEPT], 0_usize);
        let mut position = 0;
        // equal positions are near to all that follow
        while position < block.len().saturating_sub(1) {
            let values = block.values(position);
            let last = match count.checked_sub(1) {
                Some(last) => Some(block.values(kept[last % KEPT])),
                None => self.history.first().map(|place| place.values.as_slice()),
            };
            let near = last.map_or(0, |last| self.pace.surely_near(last, values, block.longest_step));
            if near == 0 && last.is_none_or(|last| self.pace.is_apart(last, values)) {
                kept[count % KEPT] = position;
                count += 1;
            }
            position = position.saturating_add(near.max(1));
        }
        // those before would be forgotten again
        for i in count.saturating_sub(KEPT)..count {
            let position = kept[i % KEPT];
            let (row, lane) = (&block.rows[position / WIDTH], position % WIDTH);
            let poses = row.motion.bodies.iter().map(|b| (vector(b.p, lane), vector(b.u, lane)));
            Self::keep(&mut self.history, block.values(position), poses);
        }
    }
}

/// A body that turns by more than its directions tell, or over the negative x axis: only there the angle jumps.
#[derive(Clone, Copy, Debug)]
pub(super) struct Uneven {
    position: usize,
    body: usize,
    /// Its direction at the position before.
    old: Vec2,
    new: Vec2,
}

pub(super) fn vector(v: V2<F64x8>, lane: usize) -> Vec2 {
    Vec2::new(v.x.0[lane], v.y.0[lane])
}

fn is_uneven(old: Vec2, new: Vec2) -> bool {
    let jumps = old.y.is_sign_negative() != new.y.is_sign_negative() && (old.x < 0.0 || new.x < 0.0);
    old.dot(new) <= 0.0 || jumps
}

impl Block {
    /// Looks how the bodies turn from each position to the next.
    pub(super) fn look_at_turns(&mut self) {
        self.uneven.clear();
        let bodies = self.rows.first().map_or(0, |row| row.motion.bodies.len());
        for body in 0..bodies {
            if in_avx2(
                #[inline(always)]
                || self.is_even(body),
            ) {
                continue;
            }
            let directions = self.rows.iter().flat_map(|row| {
                let u = row.motion.bodies[body].u;
                (0..WIDTH).map(move |lane| vector(u, lane))
            });
            let mut old = None;
            for (position, new) in directions.enumerate() {
                if let Some(old) = old.replace(new).filter(|old| is_uneven(*old, new)) {
                    self.uneven.push(Uneven { position, body, old, new });
                }
            }
        }
    }

    /// Whether a body turns by little from each position to the next, and not over the negative x axis.
    #[inline(always)]
    fn is_even(&self, body: usize) -> bool {
        let (mut near, mut sides) = ([u64::MAX; WIDTH], [0; WIDTH]);
        let mut before = None;
        for row in &self.rows {
            let u = &row.motion.bodies[body].u;
            let old = before.unwrap_or_else(|| vector(*u, 0));
            before = Some(vector(*u, WIDTH - 1));
            let (mut x, mut y) = ([old.x; WIDTH], [old.y; WIDTH]);
            x[1..].copy_from_slice(&u.x.0[..WIDTH - 1]);
            y[1..].copy_from_slice(&u.y.0[..WIDTH - 1]);
            for lane in 0..WIDTH {
                let (old, new) = ((x[lane], y[lane]), (u.x.0[lane], u.y.0[lane]));
                let turned = old.0 * new.0 + old.1 * new.1;
                near[lane] &= if turned > 0.0 { u64::MAX } else { 0 };
                let (left, crossed) = (old.0.to_bits() | new.0.to_bits(), old.1.to_bits() ^ new.1.to_bits());
                sides[lane] |= left & crossed;
            }
        }
        !near.contains(&0) && sides.iter().fold(0, |all, side| all | side) >> 63 == 0
    }

    /// Carries whole turns of the bodies on over the first positions. Returns how many these are: up to one where a body turns too
    /// far for that.
    fn turn_on(&mut self, angles: &[f64], bodies: &[BodyState], most: usize) -> usize {
        let Turns { before, changes, pairs, .. } = &mut self.turns;
        before.clear();
        before.extend(angles.iter().zip(bodies).map(|(angle, b)| whole_turns(*angle - b.u.angle())));
        pairs.clear();
        pairs.extend_from_slice(&angles[bodies.len()..]);
        changes.clear();
        let (mut taken, Some(first)) = (most, self.rows.first()) else { return 0 };
        let mut uneven = self.uneven.iter().copied().peekable();
        for (body, now) in bodies.iter().enumerate() {
            let (old, new) = (now.u, vector(first.motion.bodies[body].u, 0));
            let begin = is_uneven(old, new).then_some(Uneven { position: 0, body, old, new });
            let mut turns = before[body];
            let others = std::iter::from_fn(|| uneven.next_if(|next| next.body == body));
            for Uneven { position, old, new, .. } in begin.into_iter().chain(others) {
                if position >= taken {
                    continue;
                }
                if old.dot(new) <= 0.0 {
                    taken = position;
                } else {
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
