//! Whole turns of the bodies over a sweep in lanes, and whether all of it goes so: found before the positions are handed out.

use super::block::{Block, FreeSweep};
use super::track::continued;
use crate::answer::whole_turns;
use crate::math::Vec2;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};

/// Calls its argument for all numbers below a count, on any thread.
type ForEach<'e> = dyn Fn(usize, &(dyn Fn(usize) + Sync)) + 'e;

/// Positions that are looked at together.
const PART: usize = 4096;

/// Whole turns, rad: they change at few positions.
#[derive(Debug, Default)]
pub(super) struct Turns {
    /// By body: positions with the turns from there on, the first position before all others.
    bodies: Vec<Vec<(usize, f64)>>,
    /// The same over all positions, by pair.
    pub pairs: Vec<f64>,
}

impl Turns {
    /// At the first position, whose angles are known.
    pub(super) fn begin(angles: &[f64], directions: impl Iterator<Item = Vec2>) -> Self {
        let bodies: Vec<_> =
            directions.zip(angles).map(|(u, angle)| vec![(0, whole_turns(angle - u.angle()))]).collect();
        let pairs = angles[bodies.len()..].to_vec();
        Self { bodies, pairs }
    }

    /// Of a body at a position.
    pub(super) fn of(&self, body: usize, position: usize) -> f64 {
        let changes = &self.bodies[body];
        changes[changes.partition_point(|change| change.0 <= position) - 1].1
    }
}

/// A body whose angle jumps: it goes over the negative x axis.
struct Jump {
    position: usize,
    body: usize,
    turns: f64,
}

impl FreeSweep<'_> {
    /// The whole turns at all positions; `None` where one of the positions depends on others.
    pub(super) fn turns(&self, each: &ForEach<'_>) -> Option<Turns> {
        let parts: Vec<Mutex<Option<Vec<Jump>>>> =
            (0..self.count().div_ceil(PART)).map(|_| Mutex::default()).collect();
        let failed = AtomicBool::new(false);
        each(parts.len(), &|part| {
            if failed.load(Ordering::Relaxed) {
                return;
            }
            let found = self.jumps(part * PART);
            failed.fetch_or(found.is_none(), Ordering::Relaxed);
            *parts[part].lock().unwrap_or_else(PoisonError::into_inner) = found;
        });
        let mut turns = Turns { bodies: self.turns.bodies.clone(), pairs: self.turns.pairs.clone() };
        for part in parts {
            for jump in part.into_inner().unwrap_or_else(PoisonError::into_inner)? {
                let changes = &mut turns.bodies[jump.body];
                let before = changes.last().map_or(0.0, |change| change.1);
                changes.push((jump.position, whole_turns(before + jump.turns)));
            }
        }
        Some(turns)
    }

    /// Where bodies jump, from one position on to the last of its part.
    fn jumps(&self, first: usize) -> Option<Vec<Jump>> {
        let (mut block, mut jumps) = (Block::default(), Vec::new());
        let (mut before, mut values) = (Vec::new(), Vec::new());
        // the last position is the first of the next part
        let end = (first + PART + 1).min(self.first + self.count());
        let mut from = first;
        while from < end {
            self.place(&mut block, from, end - from);
            if !block.is_regular(self.model) {
                return None;
            }
            for i in 0..block.len() {
                let now = block.values(i);
                if !values.is_empty() && !self.pace.is_one_step(&values, now) {
                    return None;
                }
                values.clear();
                values.extend_from_slice(now);
                for (body, new) in block.directions(i).enumerate() {
                    let Some(old) = before.get_mut(body) else {
                        before.push(new);
                        continue;
                    };
                    let old = std::mem::replace(old, new);
                    if old.dot(new) <= 0.0 {
                        return None;
                    }
                    if old.y.is_sign_negative() != new.y.is_sign_negative() && (old.x < 0.0 || new.x < 0.0) {
                        let turns = whole_turns(continued(old.angle(), old, new) - new.angle());
                        jumps.push(Jump { position: from + i, body, turns });
                    }
                }
            }
            from += block.len();
        }
        Some(jumps)
    }
}
