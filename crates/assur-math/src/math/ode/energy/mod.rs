//! One coordinate whose forces depend on its value alone: the kinetic energy is their work, and time an integral over the
//! coordinate, t = ∫ dq √(J/2T).
//!
//! Mass J and force are taken at the nodes of Chebyshev series over intervals of the coordinate. What follows from them,
//! places of rest among it, needs no further evaluation; an interval that is gone again is not evaluated again.

mod stretch;
mod way;

use super::progress::Trial;
use super::{Integrator, Progress, Step, Stopped, System, Undefined};
use crate::math::chebyshev::{NODES, Nodes};
use stretch::Stretch;
use way::{Values, Way};

/// Intervals that are kept.
const KEPT: usize = 32;
/// The first interval, parts of the scale.
const FIRST: f64 = 0.5;
/// The next interval is so much shorter than it might be, and not shorter than this part of the last.
const SAFE: f64 = 0.8;
const LEAST: f64 = 0.2;
/// It is longer than the last by this part of it at most, where nothing makes it shorter.
const MORE: f64 = 0.4;
/// What series leave off is so much more than what integrals of them miss.
const OFF: f64 = 12.0;
/// Below this part of the scale an interval is too short.
const SHORTEST: f64 = 1e-9;
/// And below so many roundings of the coordinate: places within it would not be told apart.
const ROUNDINGS: f64 = 1e5;
/// The series of time leaves off less than this part of the tolerance: it costs no evaluation.
const OF_TIME: f64 = 0.02;
/// No tolerance is finer: rounding is what is left.
const FINEST: f64 = 2e-15;
/// Places are the same below this part of a way.
const SAME: f64 = 1e-13;
/// Below this, what is left off may be rounding: then shorter intervals do not leave off less.
const ROUNDING: f64 = 1e-10;
/// What a shorter interval must leave off, if it is not rounding.
const LESS: f64 = 0.25;
/// So often a part of a way is halved.
const HALVED: usize = 40;
/// A way is not longer than the motion at the present acceleration would need up to the end, by this factor.
const BEYOND: f64 = 1.2;

#[derive(Clone, Copy, Debug, PartialEq)]
enum Motion {
    /// On its way in this sense.
    Moves(f64),
    /// At rest without force.
    Rests,
}

/// The method of energy. The unknowns are the coordinate, its rate, the work of all forces, and further works.
#[derive(Clone, Debug)]
pub struct Energy {
    progress: Progress<f64>,
    tolerance: f64,
    scale: f64,
    nodes: Nodes,
    motion: Motion,
    /// The kinetic energy where the last step ended.
    kinetic: f64,
    /// How much later than t the state is where the last step began and ended: what rounding leaves off t would add up over a
    /// long run, always in the same sense where steps come again.
    late: [f64; 2],
    /// Length of the next interval.
    length: f64,
    /// It is longer than the last by this factor at most.
    growth: f64,
    ways: Vec<Way>,
    /// How many of them are known.
    known: usize,
    /// Which is made next.
    next: usize,
    /// That of the last step, with its part.
    current: Option<(usize, Stretch)>,
    values: Values,
    out: Vec<f64>,
    /// The most that a series has left off.
    worst: f64,
    /// The integral over time of what the series of mass, force and time leave off, and the time.
    left_off: f64,
    passed: f64,
    /// By how much rounding of the kinetic energy may shift the instants, where it is small.
    late_by_rounding: f64,
}

impl Energy {
    /// Of n unknowns and some watched values, with a relative accuracy; a change of the coordinate by `scale` is a great one.
    #[must_use]
    pub fn new(n: usize, watched: usize, tolerance: f64, scale: f64) -> Self {
        let works = n.saturating_sub(3);
        Self {
            progress: Progress::new(n),
            tolerance: OFF * tolerance.max(FINEST),
            scale,
            nodes: Nodes::new(),
            motion: Motion::Rests,
            kinetic: 0.0,
            late: [0.0; 2],
            length: FIRST * scale,
            growth: 1.0 + MORE,
            ways: vec![Way::new(works, watched); KEPT],
            known: 0,
            next: 0,
            current: None,
            values: vec![[0.0; NODES]; 2 + works + watched],
            out: vec![0.0; 2 + works + watched],
            worst: 0.0,
            left_off: 0.0,
            passed: 0.0,
            late_by_rounding: 0.0,
        }
    }

    /// Begins with a longer interval and lets them grow by more: of two runs whose intervals are the same the difference would say
    /// nothing.
    pub fn lengthen(&mut self, longer: f64) {
        (self.length, self.growth) = (FIRST * longer * self.scale, 1.0 + MORE * longer);
    }

    /// What the series of all steps so far leave off of integrals, at most and in the mean over time: a relative accuracy, that may be
    /// far better than the wanted one.
    #[must_use]
    pub fn left_off(&self) -> (f64, f64) {
        let mean = if self.passed > 0.0 { self.left_off / self.passed } else { 0.0 };
        (self.worst / OFF, mean / OFF)
    }

    /// By how much rounding of the kinetic energy, which is small where it passes slowly, may have shifted the instants so far.
    #[must_use]
    pub const fn late_by_rounding(&self) -> f64 {
        self.late_by_rounding
    }

    /// Mass, force and rates of works at a value of the coordinate.
    fn evaluate<F: System<f64> + ?Sized>(&mut self, system: &mut F, q: f64) -> Result<(), Undefined> {
        self.progress.counts.evaluations += 1;
        match system.along(q, &mut self.out) {
            Ok(true) if self.out.iter().all(|x| x.is_finite()) => Ok(()),
            _ => Err(Undefined),
        }
    }

    /// Takes the state from which it goes on, and forgets what was known of the forces.
    fn begin<F: System<f64> + ?Sized>(&mut self, system: &mut F) -> Result<(), Undefined> {
        let (q, rate) = (self.progress.y1[0], self.progress.y1[1]);
        (self.known, self.next) = (0, 0);
        self.current = None;
        self.evaluate(system, q)?;
        let (mass, force) = (self.out[0], self.out[1]);
        self.kinetic = 0.5 * mass * rate * rate;
        let towards = if rate == 0.0 { force } else { rate };
        self.motion = if towards == 0.0 { Motion::Rests } else { Motion::Moves(towards.signum()) };
        Ok(())
    }

    /// The way on which a place lies, that leads on in a sense.
    fn way<F: System<f64> + ?Sized>(
        &mut self,
        system: &mut F,
        (q, sense): (f64, f64),
    ) -> Result<usize, Stopped> {
        let known = self.ways[..self.known].iter().position(|way| way.leads_on(q, sense));
        if let Some(known) = known {
            return Ok(known);
        }
        let index = self.next;
        let shortest = (SHORTEST * self.scale).max(ROUNDINGS * f64::EPSILON * q.abs());
        let longest = self.reach().max(shortest);
        let wanted = self.length;
        let (mut length, mut before) = (wanted.min(longest), f64::INFINITY);
        let mut undefined = false;
        loop {
            if length < shortest {
                return Err(if undefined { Stopped::Undefined } else { Stopped::StepTooSmall });
            }
            let range = if sense > 0.0 { q..q + length } else { q - length..q };
            undefined = self.sample(system, (range.start, range.end)).is_err()
                || self.ways[index].set(range, (&self.nodes, &self.values), (q, self.kinetic)).is_err();
            if undefined {
                self.progress.counts.rejected += 1;
                length *= 0.5;
                continue;
            }
            let way = &self.ways[index];
            let left_off = way.leaves_off(&self.values, sense, way.rests(q, sense, self.kinetic));
            // the sixteenth root
            let factor = (self.tolerance / left_off).sqrt().sqrt().sqrt().sqrt();
            let rounding = left_off < ROUNDING && left_off > LESS * before;
            if left_off <= self.tolerance || rounding {
                self.worst = self.worst.max(left_off);
                self.ways[index].left_off = left_off;
                let next = length * if rounding { 1.0 } else { (SAFE * factor).min(self.growth) };
                self.length = if length < wanted { next.max(wanted.min(self.growth * length)) } else { next };
                break;
            }
            self.progress.counts.rejected += 1;
            before = left_off;
            length *= if factor.is_nan() { LEAST } else { (SAFE * factor).clamp(LEAST, SAFE) };
        }
        self.known = self.known.max(index + 1);
        self.next = (index + 1) % KEPT;
        Ok(index)
    }

    /// How far the coordinate comes at most at the present acceleration.
    fn reach(&self) -> f64 {
        let left = (self.progress.end - self.progress.t1).abs();
        let (rate, acceleration) = (self.progress.f1[0].abs(), self.progress.f1[1].abs());
        BEYOND * (rate + 0.5 * acceleration * left) * left
    }

    fn sample<F: System<f64> + ?Sized>(
        &mut self,
        system: &mut F,
        (low, high): (f64, f64),
    ) -> Result<(), Undefined> {
        for node in 0..NODES {
            self.evaluate(system, self.nodes.at(low, high, node))?;
            for (values, value) in self.values.iter_mut().zip(&self.out) {
                values[node] = *value;
            }
        }
        Ok(())
    }

    /// A part of a way whose time is known well enough.
    fn stretch(&self, way: &Way, (q, sense): (f64, f64)) -> Option<(Stretch, Option<f64>)> {
        let [behind, ahead] = way.rests(q, sense, self.kinetic);
        let end = if sense > 0.0 { way.high } else { way.low };
        let before = |a: f64, b: f64| (b - a) * sense > 0.0;
        // a place of rest at the end but for rounding is the end
        let ahead = ahead.map(|r| if (r - end).abs() < SAME * way.length() { end } else { r });
        let mut target = ahead.filter(|r| before(*r, end)).unwrap_or(end);
        let rest = match (behind, ahead) {
            (Some(behind), Some(ahead)) => {
                let middle = 0.5 * (behind + ahead);
                // the middle but for rounding is the middle: no stretch has no length
                if before(q, middle) && (middle - q).abs() > SAME * way.length() {
                    target = if before(middle, target) { middle } else { target };
                    Some(behind)
                } else {
                    Some(ahead)
                }
            }
            (one, other) => one.or(other),
        };
        // what each step leaves off its time adds up to the end
        let (left, enough) = (self.progress.end - self.progress.t0, OF_TIME * self.tolerance);
        let mut before = f64::INFINITY;
        for _ in 0..HALVED {
            let stretch = Stretch::new(&self.nodes, way, (q, target), rest);
            let (left_off, part) = (stretch.left_off(), (stretch.duration() / left).min(1.0));
            let rounding = left_off <= enough && left_off > LESS * before;
            if rounding || left_off <= (enough * part).max(4.0 * FINEST) {
                return Some((stretch, ahead.filter(|r| *r == target)));
            }
            before = left_off;
            target = q + 0.5 * (target - q);
        }
        None
    }

    /// State and rates at a place of the last step's way.
    fn fill(&self, (index, stretch): (usize, &Stretch), (q, sense): (f64, f64), y: &mut [f64]) -> f64 {
        let way = &self.ways[index];
        let kinetic = stretch.energy(way, q);
        y[0] = q;
        y[1] = sense * (2.0 * kinetic / way.mass(q)).sqrt();
        let start = self.progress.y0[0];
        let from = stretch.energy(way, start);
        y[2] = self.progress.y0[2] + (kinetic - from);
        for ((y, y_0), work) in y[3..].iter_mut().zip(&self.progress.y0[3..]).zip(way.works(start, q)) {
            *y = y_0 + work;
        }
        kinetic
    }
}

impl Energy {
    /// Ends the step at an instant, where the coordinate has a value.
    fn end_at<F: System<f64> + ?Sized>(
        &mut self,
        system: &mut F,
        (t, q): (f64, f64),
        sense: f64,
    ) -> Result<(), Undefined> {
        let mut y = std::mem::take(&mut self.progress.y1);
        if let Some((way, stretch)) = &self.current {
            self.kinetic = self.fill((*way, stretch), (q, sense), &mut y);
        }
        self.progress.y1 = y;
        self.evaluate_rates(system, t)
    }

    fn evaluate_rates<F: System<f64> + ?Sized>(&mut self, system: &mut F, t: f64) -> Result<(), Undefined> {
        let progress = &mut self.progress;
        progress.counts.evaluations += 1;
        system.rates(t, &progress.y1, &mut progress.f1)
    }

    /// The sense in which the last step went.
    fn sense(&self) -> f64 {
        let Some((_, stretch)) = &self.current else { return 1.0 };
        stretch.sense()
    }

    fn undone(&mut self, stopped: Stopped) -> Stopped {
        self.progress.undo();
        stopped
    }

    /// Counts an accepted step up to an instant.
    fn accept(&mut self, t: f64) -> Step {
        let (h, last) = (t - self.progress.t0, t == self.progress.end);
        self.progress.accept(Trial { h, t, last }, h)
    }
}

impl Integrator<f64> for Energy {
    fn progress(&self) -> &Progress<f64> {
        &self.progress
    }

    fn progress_mut(&mut self) -> &mut Progress<f64> {
        &mut self.progress
    }

    fn start<F: System<f64> + ?Sized>(
        &mut self,
        system: &mut F,
        t: f64,
        y: &[f64],
        end: f64,
    ) -> Result<(), Undefined> {
        self.progress.place(system, Some(t), y, end)?;
        self.late = [0.0; 2];
        self.begin(system)
    }

    fn restart<F: System<f64> + ?Sized>(
        &mut self,
        system: &mut F,
        y: &[f64],
        end: f64,
    ) -> Result<(), Undefined> {
        self.progress.place(system, None, y, end)?;
        self.begin(system)
    }

    fn step<F: System<f64> + ?Sized>(&mut self, system: &mut F) -> Result<Step, Stopped> {
        if !self.progress.begin(system) {
            return Ok(Step::Last);
        }
        self.late[0] = self.late[1];
        let (t, end) = (self.progress.t0, self.progress.end);
        let limit = t + self.progress.bounded(end - t);
        if self.progress.counts.steps >= self.progress.most_steps {
            return Err(self.undone(Stopped::TooManySteps));
        }
        let Motion::Moves(sense) = self.motion else {
            self.current = None;
            let known = self.evaluate_rates(system, limit);
            known.map_err(|Undefined| self.undone(Stopped::Undefined))?;
            return Ok(self.accept(limit));
        };
        let q = self.progress.y0[0];
        let way = self.way(system, (q, sense)).map_err(|stopped| self.undone(stopped))?;
        let Some((stretch, rest)) = self.stretch(&self.ways[way], (q, sense)) else {
            return Err(self.undone(Stopped::StepTooSmall));
        };
        self.worst = self.worst.max(stretch.left_off());
        let duration = stretch.duration() + self.late[0];
        let reached = t + duration;
        let (t, q) = if reached < limit {
            self.late[1] = duration - (reached - t);
            (reached, stretch.place(1.0))
        } else {
            self.late[1] = 0.0;
            (limit, stretch.place_after(limit - t - self.late[0]))
        };
        let (passed, gone) = (t - self.progress.t0, &self.ways[way]);
        let rounding = f64::EPSILON * gone.energies_at_most();
        self.late_by_rounding += 0.5 * rounding / stretch.slowest * passed;
        self.left_off += (gone.left_off + stretch.left_off()) * passed;
        self.passed += passed;
        self.current = Some((way, stretch));
        self.end_at(system, (t, q), sense).map_err(|Undefined| self.undone(Stopped::Undefined))?;
        if rest == Some(q) {
            // it turns back there
            self.kinetic = 0.0;
            self.progress.y1[1] = 0.0;
            self.motion = Motion::Moves(-sense);
        }
        Ok(self.accept(t))
    }

    fn shorten<F: System<f64> + ?Sized>(&mut self, system: &mut F, t: f64) -> Result<(), Undefined> {
        let sense = self.sense();
        if let Some((_, stretch)) = &self.current {
            let q = stretch.place_after(t - self.progress.t0 - self.late[0]);
            self.late[1] = 0.0;
            self.motion = Motion::Moves(sense);
            self.end_at(system, (t, q), sense).inspect_err(|Undefined| self.progress.undo())?;
        }
        self.progress.shortened(t);
        Ok(())
    }

    fn keeps_off(&self, watched: usize) -> bool {
        let ends = (self.progress.y0[0], self.progress.y1[0]);
        self.current.as_ref().is_some_and(|(way, _)| self.ways[*way].keeps_off(watched, ends))
    }

    fn prepare_dense<F: System<f64> + ?Sized>(&mut self, _system: &mut F) -> Result<(), Undefined> {
        Ok(())
    }

    fn dense(&self, t: f64, y: &mut [f64]) {
        y.copy_from_slice(&self.progress.y0);
        if let Some((way, stretch)) = &self.current {
            let q = stretch.place_after(t - self.progress.t0 - self.late[0]);
            self.fill((*way, stretch), (q, stretch.sense()), y);
        }
    }
}
