//! Where, within a step, what rubs comes to rest, turns, or is let go, and how the run goes on from there.

use super::contact_modes::NONE;
use super::depends::Kept;
use super::dissipative::DissipativeElement;
use super::equations::Equations;
use super::integration::Integration;
use super::plane::rows;
use super::records::within_step;
use super::report::Holder;
use super::sliding_sense::Slipping;
use crate::math::ode::event::first_crossing;
use crate::math::ode::{Integrator, Undefined};
use crate::model::{LinkId, PairId, PairKind, Situation};
use crate::plan::{Opposing, Path};
use crate::solve::failure::Halt;

/// Places within a step at which all sliding speeds are looked at, as parts of it.
const PLACES: [f64; 9] = [0.0, 0.02, 0.13, 0.31, 0.5, 0.69, 0.87, 0.98, 1.0];
/// What stays above this part of its variation in the step is smooth enough not to pass zero between the places.
const CLEAR: f64 = 0.5;
/// The slope of what turns is taken over this part of the step.
const SLOPE: f64 = 1e-3;
/// Rounding of an instant.
const ROUNDING: f64 = 1e-15;

impl Integration<'_, '_> {
    /// Where, in the last step, what rubs comes to rest, turns or leaves its rest.
    pub fn turning<M: Integrator<f64>>(
        &self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
    ) -> Option<f64> {
        let moves = |slipping: &&Slipping| !slipping.rests || self.wakes;
        let count = equations.slipping.as_deref().filter(moves)?.senses.len();
        if count == 0 {
            return None;
        }
        let (from, to) = (method.previous_t(), method.t());
        let mut y = method.y().to_vec();
        let mut rooms = vec![f64::INFINITY; count];
        let mut ranges = vec![(f64::INFINITY, f64::NEG_INFINITY); count];
        for part in PLACES {
            let t = if part < 1.0 { from + part * (to - from) } else { to };
            within_step(equations, method, t, &mut y);
            equations.slip_rooms(t, &y, &mut rooms);
            for (range, room) in ranges.iter_mut().zip(&rooms) {
                *range = (range.0.min(*room), range.1.max(*room));
            }
        }
        let near = (0..count).filter(|&e| ranges[e].0 <= CLEAR * (ranges[e].1 - ranges[e].0));
        let mut turning = Vec::new();
        for element in near.collect::<Vec<_>>() {
            let crossing = first_crossing((from, to), Some(true), |t| {
                within_step(equations, method, t, &mut y);
                equations.slip_rooms(t, &y, &mut rooms);
                rooms[element]
            });
            turning.extend(crossing.filter(|c| !c.rising).map(|c| (c.t, element)));
        }
        equations.forget();
        let first = turning.iter().map(|turns| turns.0).fold(f64::INFINITY, f64::min);
        let slipping = equations.slipping.as_mut()?;
        slipping.turning = turning;
        first.is_finite().then_some(first)
    }

    /// Ends the last step, which has been ended at a turning, where that is by its own end: the output between the ends is less accurate
    /// than the ends. Returns the instant; `end` is where the step could end.
    ///
    /// # Errors
    /// A stage has no value.
    pub fn turn_exactly<M: Integrator<f64>>(
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        end: f64,
    ) -> Result<f64, Undefined> {
        let (from, t) = (method.previous_t(), method.t());
        let before = t - SLOPE * (t - from);
        let [room_0, room_1] = [before, t].map(|t| Self::turning_room(equations, method, t));
        let late = room_1 * (t - before) / (room_1 - room_0);
        let exact = t - late;
        // what is not a number is not nearer
        if !(late.abs() > ROUNDING * t.abs() && late.abs() < t - before && exact < end) {
            return Ok(t);
        }
        method.shorten(equations, exact)?;
        if let Some(slipping) = &mut equations.slipping {
            slipping.turning.iter_mut().filter(|turns| turns.0 == t).for_each(|turns| turns.0 = exact);
        }
        Ok(exact)
    }

    /// How far from turning is what turns first in the last step.
    fn turning_room<M: Integrator<f64>>(equations: &mut Equations<'_, '_>, method: &mut M, t: f64) -> f64 {
        let mut y = method.y().to_vec();
        within_step(equations, method, t, &mut y);
        let Some(slipping) = &equations.slipping else { return f64::NAN };
        let Some(first) = slipping.turning.iter().copied().reduce(|a, b| if b.0 < a.0 { b } else { a })
        else {
            return f64::NAN;
        };
        let mut rooms = vec![f64::NAN; slipping.senses.len()];
        equations.slip_rooms(t, &y, &mut rooms);
        equations.forget();
        rooms[first.1]
    }

    /// Goes on from where something turns, comes to rest or is pulled off it; or from a corner of the loads, by which a rest may end.
    /// Returns the event that ends the motion by it.
    ///
    /// # Errors
    /// There is no way on.
    pub fn turn(
        &mut self,
        equations: &mut Equations<'_, '_>,
        (t, y): (f64, &mut [f64]),
    ) -> Result<Option<usize>, Halt> {
        equations.release_speeds();
        let Some(slipping) = &mut equations.slipping else { return Ok(None) };
        slipping.turning.retain(|turns| turns.0 <= t + self.at_once());
        let (was, kept) = (equations.closed.clone(), equations.kept());
        equations.choose_slips(t, y)?;
        self.watch.moves_again(equations.model.mechanism, &kept);
        let ended = self.note_held(equations, t);
        Ok(ended.or(self.note_stops(equations, &was, (t, &[], Some(t)))))
    }

    /// The loads have gone over a corner: goes on, and whether the motion ends there.
    ///
    /// # Errors
    /// There is no way on.
    pub fn corner<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
    ) -> Result<bool, Halt> {
        let t = method.t();
        if !equations.holds() {
            let resumed = method.restart(equations, self.corners.state(), self.last);
            return resumed.map(|()| false).map_err(|Undefined| equations.halt());
        }
        let mut y = self.corners.state().to_vec();
        self.watch.begin();
        self.ended_by = self.turn(equations, (t, &mut y))?;
        let ended = self.ended_by.is_some();
        if (ended || self.watch.any_happened()) && !self.keep(equations, method, (t, ended)) {
            return Err(equations.halt());
        }
        self.go_on(equations, method, &y).map(|()| ended)
    }

    /// Goes on from where something has turned.
    ///
    /// # Errors
    /// There is no way on.
    pub fn go_on<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        y: &[f64],
    ) -> Result<(), Halt> {
        equations.take_sides(method.t(), y);
        if let Some((pair, bond)) = self.bonds.at_once(equations, method.t(), y) {
            return Err(Halt::Opens { pair, bond });
        }
        method.restart(equations, y, self.last).map_err(|Undefined| equations.halt())
    }

    /// Notes what friction holds from now on, and what it does no longer. Returns the event that ends the motion by it.
    pub fn note_held(&mut self, equations: &mut Equations<'_, '_>, time: f64) -> Option<usize> {
        let jammed = equations.slipping.iter_mut().flat_map(|slipping| std::mem::take(&mut slipping.jammed));
        let holder = |element| DissipativeElement::of(equations.model.plan, element).holder();
        self.jammed.extend(jammed.filter_map(|(t, element)| Some((holder(element)?, t))));
        let now = equations.holders();
        let mut changed: Vec<(Holder, bool)> = Vec::new();
        for (holder, _, end) in self.held.iter_mut().filter(|held| held.2.is_none()) {
            if !now.contains(holder) {
                *end = Some(time);
                changed.push((*holder, false));
            }
        }
        for holder in now {
            if !self.held.iter().any(|held| held.0 == holder && held.2.is_none()) {
                self.held.push((holder, time, None));
                changed.push((holder, true));
            }
        }
        let ended = changed.into_iter().filter_map(|(holder, begins)| match holder {
            Holder::Pair(pair) => self.watch.situation(Situation::Sticks(pair), begins, time),
            Holder::Load(_) => None,
        });
        ended.min()
    }
}

impl Equations<'_, '_> {
    /// How far every element is from turning: its sliding speed in its sense, or what friction at rest has left.
    fn slip_rooms(&mut self, t: f64, y: &[f64], rooms: &mut [f64]) {
        let Some(mut slipping) = self.slipping.take() else { return };
        self.set_position(t, y);
        let known = slipping.held.is_empty() || self.slipping_accelerations(&mut slipping).is_ok();
        self.trial.run_motion::<1>(self.model.plan);
        let speeds = self.sliding_speeds(&mut slipping);
        for (element, room) in rooms.iter_mut().enumerate() {
            *room = if slipping.still[element] || !self.touches(element) {
                f64::INFINITY
            } else if slipping.senses[element] != 0.0 {
                match DissipativeElement::of(self.model.plan, element) {
                    DissipativeElement::Load(load) if rows(self.model.plan, element).is_some() => {
                        self.plane_room(&slipping, element, load)
                    }
                    _ => slipping.senses[element] * speeds[element],
                }
            } else if !known {
                f64::NAN
            } else if slipping.held.contains(&element) {
                1.0 - self.part_held(&slipping, element)
            } else if slipping.driven[element] {
                1.0 - speeds[element].abs() / (NONE * slipping.fastest)
            } else {
                f64::INFINITY
            };
        }
        self.slipping = Some(slipping);
    }

    /// Whether something is held at rest.
    pub fn holds(&self) -> bool {
        let held = |slipping: &Slipping| slipping.undetermined || slipping.senses.contains(&0.0);
        self.slipping.as_deref().is_some_and(held)
    }

    /// What does not move: friction holds it, or a load against the motion, or a stop is closed.
    pub fn kept(&self) -> Kept {
        let mut kept = Kept { pairs: self.held_pairs(), links: Vec::new() };
        kept.pairs.extend(self.closed.iter().map(|index| self.stop(*index).pair));
        let Some(slipping) = &self.slipping else { return kept };
        let held = DissipativeElement::all(self.model.plan)
            .enumerate()
            .filter(|(element, _)| slipping.holds(*element));
        kept.links.extend(held.filter_map(|(_, rubs)| match rubs {
            DissipativeElement::Load(Opposing { point: Some((_, Path::Plane(_))), .. }) => None,
            DissipativeElement::Load(Opposing { body, against: None, .. }) => Some(LinkId::at(*body)),
            _ => None,
        }));
        let body = |link: LinkId| LinkId::at(self.model.structure.replaced.body_of(link).0);
        let is_held = |link: LinkId| body(link) == LinkId::GROUND || kept.links.contains(&body(link));
        for (index, pair) in self.model.mechanism.pairs.iter().enumerate() {
            let hinge = matches!(pair.kind, PairKind::Revolute(_));
            if !kept.links.is_empty() && hinge && pair.kind.links().into_iter().all(is_held) {
                kept.pairs.push(PairId::at(index));
            }
        }
        kept
    }

    /// What holds: friction in pairs, losses, and loads against the motion.
    pub fn holders(&self) -> Vec<Holder> {
        let Some(slipping) = &self.slipping else { return Vec::new() };
        let rubs = DissipativeElement::all(self.model.plan).enumerate();
        let holds = rubs.filter(|(index, _)| slipping.holds(*index));
        let mut holders: Vec<Holder> = holds.filter_map(|(_, rubs)| rubs.holder()).collect();
        holders.sort_unstable();
        holders.dedup();
        holders
    }

    /// The pairs that friction holds.
    pub fn held_pairs(&self) -> Vec<PairId> {
        let pair = |holder| if let Holder::Pair(pair) = holder { Some(pair) } else { None };
        self.holders().into_iter().filter_map(pair).collect()
    }
}
