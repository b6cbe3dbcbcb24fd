//! Which pairs are held by friction, in which sense the others slide, and which stops that are touched are closed: chosen where a
//! sliding speed passes zero, where friction at rest no longer holds, and at stops.
//!
//! First all pairs without sliding speed are held; those that need more than their friction at rest are let go, in the sense
//! in which they are pulled. Stops that would pull are opened, those that would be passed are closed. Where this comes to no end all ways
//! are tried. A way fits where what is held lies within friction at rest, what begins to slide accelerates in its sense, closed stops
//! press, and others are not passed.

use super::acting::wakes;
use super::dissipative::DissipativeElement;
use super::drives::moves;
use super::equations::Equations;
use super::plane::{rows, together};
use super::sliding_sense::{Held, Slipping};
use super::ways::Way;
use crate::math::Vec2;
use crate::plan::{FrictionElement, Opposing};
use crate::solve::failure::Halt;

/// A sliding speed below this part of the greatest so far is none.
pub(super) const NONE: f64 = 1e-11;
/// The same of the greatest speed of a body: this part of it counts as the sliding speed that is compared with.
const AS_ONE: f64 = 1e-3;
/// Friction at rest holds this much more: rounding.
const ROUNDING: f64 = 1e-10;
/// An effort below this part of the greatest term of the equations is rounding.
const NOTHING: f64 = 1e-12;
/// What is not held yet is not held at the limit.
const SURE: f64 = 1e-9;
/// What is at its limit begins to slide without acceleration: of the greatest term.
pub(super) const SLOW: f64 = 1e-9;
/// So many pairs at most are tried in all ways.
const MOST: usize = 6;
/// Pairs whose speeds depend on those of others but for this part.
const DEPENDS: f64 = 1e-9;
/// Shortly after an instant: these parts of the run, the first of which decides.
const SHORTLY: [f64; 3] = [1e-9, 1e-6, 1e-3];
/// What is chosen anew so often at one instant has no way on.
const AGAIN: u32 = 40;

/// What comes of a way.
enum Judged {
    Fits,
    /// The element needs more than friction at rest, and slides in this sense.
    LetGo(usize, f64),
    /// The element does not accelerate in its sense.
    Held(usize),
    /// The stop is to be closed, or open.
    Closed(usize, bool),
    /// No acceleration satisfies the laws.
    Jams,
}

impl Equations<'_, '_> {
    /// Lets every pair that rubs move in a way of its own, from here.
    ///
    /// # Errors
    /// There is no way on.
    pub fn begin_slipping(&mut self, t: f64, y: &mut [f64], held: Option<&Held>) -> Result<(), Halt> {
        let mut slipping = Box::new(Slipping::new(self.model, self.still));
        match held {
            Some(held) => slipping.take(held, self.model.plan),
            // loads may begin at zero
            None => slipping.again = (t, 0),
        }
        self.slipping = Some(slipping);
        self.choose_slips(t, y)
    }

    /// Chooses how all pairs that rub go on from here, and takes from the rates what is left of the speeds of those that are
    /// held.
    ///
    /// # Errors
    /// There is no way on.
    pub fn choose_slips(&mut self, t: f64, y: &mut [f64]) -> Result<(), Halt> {
        let Some(mut slipping) = self.slipping.take() else { return Ok(()) };
        let found = self.choose_slips_of(&mut slipping, t, y);
        slipping.passes = false;
        self.slipping = Some(slipping);
        self.forget();
        found
    }

    fn choose_slips_of(&mut self, slipping: &mut Slipping, t: f64, y: &mut [f64]) -> Result<(), Halt> {
        let here = (t - slipping.again.0).abs() <= NONE * (self.last - self.from);
        let count = if here { slipping.again.1 + 1 } else { 0 };
        slipping.again = (t, count);
        if count > AGAIN {
            return Err(Halt::Jam);
        }
        let came = y.to_vec();
        let stopped = self.stop_in_plane(slipping, (t, y));
        let (later, state) = self.shortly(slipping, (t, y), count);
        self.set_position(later, &state);
        if !slipping.turning.is_empty() && !slipping.undetermined {
            // in which sense they are let go
            self.slipping_accelerations(slipping)?;
        }
        for element in 0..slipping.senses.len() {
            self.aim(slipping, element);
        }
        let released: Vec<f64> =
            (0..slipping.senses.len()).map(|element| self.released(slipping, element)).collect();
        self.set_position(t, y);
        self.reduced.run_motion(self.model.plan, &mut self.trial);
        let speeds = self.sliding_speeds(slipping);
        let stops = self.standing_stops(slipping, t, y);
        let touch: Vec<bool> = (0..speeds.len()).map(|element| self.may_touch(element, &stops)).collect();
        let slow: Vec<bool> =
            (0..speeds.len()).map(|element| self.may_rest(slipping, element, &speeds)).collect();
        let (mut open, let_go) = slipping.take_senses(&speeds, (&touch, &slow), &released);
        self.take_driven(slipping, (t, y), &mut open);
        (slipping.rests, slipping.undetermined) = (false, false);
        match self.find_way(slipping, (later, &state), (&open, &stops)) {
            Err(Halt::Jam) if !stopped.is_empty() => {
                // as at a cusp of its path a point goes on by its velocity, however small that is
                y.copy_from_slice(&came);
                slipping.let_points_pass(&stopped);
                let chosen = self.choose_slips_of(slipping, t, y);
                slipping.passes = false;
                return chosen;
            }
            Err(Halt::Jam) if self.stop_sliding(slipping, (t, y))? => {
                return self.choose_slips_of(slipping, t, y);
            }
            found => found?,
        }
        for element in 0..slipping.senses.len() {
            if slipping.senses[element] == 0.0 && !self.touches(element) {
                // what has opened bears nothing
                slipping.senses[element] = 1.0;
            }
        }
        self.find_still(slipping, &[open, let_go].concat());
        self.find_kept(slipping, &stops);
        slipping.begun = true;
        if count > 0 {
            self.find_slopes_at(slipping, (t, y));
        }
        self.stop_held(slipping, y)
    }

    /// Takes what is left of the speeds of what is held and closed from the rates at an instant.
    ///
    /// # Errors
    /// No impulses do so.
    pub fn keep_held(&mut self, t: f64, y: &mut [f64]) -> Result<(), Halt> {
        let Some(mut slipping) = self.slipping.take() else { return Ok(()) };
        self.find_slopes_at(&mut slipping, (t, y));
        let kept = self.stop_held(&slipping, y);
        self.slipping = Some(slipping);
        kept
    }

    pub fn find_slopes_at(&mut self, slipping: &mut Slipping, (t, y): (f64, &[f64])) {
        self.set_position(t, y);
        self.reduced.run_motion(self.model.plan, &mut self.trial);
        self.find_slopes(slipping);
    }

    /// Where it is decided how to go on: where that is undecided at an instant, as of loads that begin at zero, shortly after it.
    fn shortly(&mut self, slipping: &mut Slipping, (t, y): (f64, &[f64]), count: u32) -> (f64, Vec<f64>) {
        let mut state = y.to_vec();
        let Some(last) = (count as usize).checked_sub(1) else { return (t, state) };
        let (n, time) = (self.order(), SHORTLY[last.min(SHORTLY.len() - 1)] * (self.last - self.from));
        self.set_position(t, y);
        // where it jams as it was, it may go on in another way
        let moves = self.slipping_accelerations(slipping).is_ok() && !slipping.rests;
        for i in 0..n {
            let a = if moves { slipping.accelerations[i] } else { 0.0 };
            state[i] += (y[n + i] + 0.5 * a * time) * time;
            state[n + i] += a * time;
        }
        (t + time, state)
    }

    /// Takes out of the open elements those that drives alone move: they have the sense of their speed shortly after.
    fn take_driven(&mut self, slipping: &mut Slipping, (t, y): (f64, &[f64]), open: &mut Vec<usize>) {
        for &element in &*open {
            slipping.driven[element] = self.is_driven(element);
        }
        let (mut driven, others): (Vec<usize>, Vec<usize>) =
            open.iter().partition(|element| slipping.driven[**element]);
        *open = others;
        driven.iter().for_each(|&element| slipping.senses[element] = 0.0);
        for part in SHORTLY {
            if driven.is_empty() {
                break;
            }
            self.set_position(t + part * (self.last - self.from), y);
            self.reduced.run_motion(self.model.plan, &mut self.trial);
            let speeds = self.sliding_speeds(slipping);
            driven.retain(|&element| {
                let moves = speeds[element].abs() > NONE * slipping.fastest;
                if moves {
                    slipping.senses[element] = speeds[element].signum();
                }
                !moves
            });
        }
    }

    /// Whether an element is that of a closed contact, or of none that parts.
    pub fn touches(&self, element: usize) -> bool {
        self.may_touch(element, &self.closed)
    }

    /// The same where these stops may be closed.
    fn may_touch(&self, element: usize, stops: &[usize]) -> bool {
        match DissipativeElement::of(self.model.plan, element) {
            DissipativeElement::Pair(FrictionElement { stop: Some(stop), .. }) => stops.contains(stop),
            _ => true,
        }
    }

    /// Whether an element may be held: it turns, or has no speed.
    fn may_rest(&self, slipping: &Slipping, element: usize, speeds: &[f64]) -> bool {
        match DissipativeElement::of(self.model.plan, element) {
            DissipativeElement::Load(load) if rows(self.model.plan, element).is_some() => {
                !slipping.passes && self.is_slow(slipping, load)
            }
            _ => {
                let turns = slipping.turning.iter().any(|(_, turns)| *turns == element);
                turns || speeds[element].abs() <= NONE * slipping.fastest
            }
        }
    }

    /// Whether drives alone move an element.
    fn is_driven(&mut self, element: usize) -> bool {
        let mut slopes = Vec::with_capacity(self.order());
        together(self.model.plan, element).for_each(|row| self.slopes_of_element(row, &mut slopes));
        slopes.iter().all(|slope| *slope == 0.0)
    }

    /// Sliding speeds of all elements in the state that was moved last; the greatest is kept, lengths over the extent.
    pub fn sliding_speeds(&self, slipping: &mut Slipping) -> Vec<f64> {
        let extent = self.extent();
        let speed =
            |rubs: DissipativeElement<'_>| rubs.speed(&self.trial) / if rubs.turns() { 1.0 } else { extent };
        let speeds: Vec<f64> = DissipativeElement::all(self.model.plan).map(speed).collect();
        // what turns as one body slides by rounding of its speed
        let bodies = self.trial.motion.bodies.iter();
        let rates = bodies.map(|body| AS_ONE * body.omega.abs().max(body.v.norm() / extent));
        let all = speeds.iter().map(|speed| speed.abs()).chain(rates);
        slipping.fastest = all.fold(slipping.fastest, f64::max);
        speeds
    }

    /// Finds how the open elements and the stops that are touched go on.
    fn find_way(
        &mut self,
        slipping: &mut Slipping,
        at: (f64, &[f64]),
        may: (&[usize], &[usize]),
    ) -> Result<(), Halt> {
        let (open, stops) = may;
        let first: Vec<bool> = stops.iter().map(|stop| self.closed.contains(stop)).collect();
        let mut way = Way { senses: vec![0.0; open.len()], closed: first.clone() };
        let mut seen: Vec<Way> = Vec::new();
        while !seen.contains(&way) {
            seen.push(way.clone());
            let place = |element: usize| open.iter().position(|e| *e == element);
            match self.judge(slipping, at, may, &way)? {
                Judged::Fits => return Ok(()),
                Judged::LetGo(element, sense) => {
                    let all = together(self.model.plan, element).filter_map(place);
                    all.for_each(|i| way.senses[i] = sense);
                }
                Judged::Held(element) => {
                    let all = together(self.model.plan, element).filter_map(place);
                    all.for_each(|i| way.senses[i] = 0.0);
                }
                Judged::Closed(stop, closed) => {
                    if closed {
                        // what moved towards it may be held there
                        way.senses.fill(0.0);
                        self.hold_at(slipping, stop);
                    }
                    let place = stops.iter().position(|s| *s == stop);
                    place.into_iter().for_each(|i| way.closed[i] = closed);
                }
                Judged::Jams => break,
            }
        }
        if open.len() + stops.len() <= MOST {
            for way in Way::all(open.len(), stops.len()).iter().filter(|way| !seen.contains(way)) {
                if matches!(self.judge(slipping, at, may, way)?, Judged::Fits) {
                    return Ok(());
                }
            }
        }
        self.close_those(stops, &first);
        self.without_way(slipping, at, open)
    }

    /// No way fits: where more is held than coordinates are free all of it rests.
    fn without_way(
        &mut self,
        slipping: &mut Slipping,
        at: (f64, &[f64]),
        open: &[usize],
    ) -> Result<(), Halt> {
        open.iter().for_each(|&element| slipping.senses[element] = 0.0);
        self.take_independent(slipping, at, 0);
        let depends = slipping.held.len() < open.len();
        let all = slipping.held.len() + self.closed.len() == self.order() && !self.drives_move();
        let rubs = |element: &usize| DissipativeElement::of(self.model.plan, *element);
        if let Some(pair) =
            open.iter().map(rubs).find(|rubs| !rubs.can_hold()).and_then(DissipativeElement::pair)
        {
            return Err(Halt::Rolls { pair });
        }
        if !depends || !all || wakes(self) {
            return Err(Halt::Jam);
        }
        slipping.held.clear();
        slipping.efforts.fill(0.0);
        (slipping.undetermined, slipping.rests) = (true, true);
        self.slipping_accelerations(slipping)
    }

    /// What comes of the open elements going on in these senses.
    fn judge(
        &mut self,
        slipping: &mut Slipping,
        at: (f64, &[f64]),
        (open, stops): (&[usize], &[usize]),
        way: &Way,
    ) -> Result<Judged, Halt> {
        for (&element, &sense) in open.iter().zip(&way.senses) {
            slipping.senses[element] = sense;
        }
        self.close_those(stops, &way.closed);
        let mut judged = Judged::Jams;
        if !open.iter().all(|&element| self.is_whole(slipping, element)) {
            return Ok(judged);
        }
        // which of those that depend on each other hold is not known: any will do
        for first in 0..open.len().max(1) {
            self.take_independent(slipping, at, first);
            if slipping.held.len() + self.closed.len() > self.order() {
                break;
            }
            judged = self.judge_held(slipping, (open, &way.senses))?;
            if matches!(judged, Judged::Fits)
                && let Some((stop, closed)) = self.misjudged_stop(slipping, stops)
            {
                return Ok(Judged::Closed(stop, closed));
            }
            let held = open.iter().filter(|element| slipping.senses[**element] == 0.0).count();
            if matches!(judged, Judged::Fits) || held == slipping.held.len() {
                break;
            }
        }
        Ok(judged)
    }

    fn judge_held(
        &mut self,
        slipping: &mut Slipping,
        (open, senses): (&[usize], &[f64]),
    ) -> Result<Judged, Halt> {
        let plan = self.model.plan;
        slipping.rests = slipping.held.len() + self.closed.len() == self.order() && !self.drives_move();
        match self.slipping_accelerations(slipping) {
            Err(Halt::Jam) => return Ok(Judged::Jams),
            other => other?,
        }
        if !self.is_stable(slipping)? {
            return Ok(Judged::Jams);
        }
        for &element in open {
            match self.turn_along(slipping, element) {
                Err(Halt::Jam) => return Ok(Judged::Jams),
                other => other?,
            }
        }
        let mut most = (0.0, None);
        for &element in &slipping.held {
            if !DissipativeElement::of(plan, element).can_hold() {
                return Ok(Judged::Jams);
            }
            let limit = if slipping.before[element] { 1.0 + ROUNDING } else { 1.0 - SURE };
            let beyond = self.part_held(slipping, element) - limit;
            if beyond > most.0 {
                most = (beyond, Some(element));
            }
        }
        if let Some(element) = most.1 {
            self.aim(slipping, element);
            return Ok(Judged::LetGo(element, self.released(slipping, element)));
        }
        for (&element, &sense) in open.iter().zip(senses) {
            if slipping.held.contains(&element) {
                continue;
            }
            let begins = self.begins(slipping, element);
            if sense == 0.0 && begins != 0.0 {
                // it depends on what is held and on drives, which move it
                return Ok(Judged::LetGo(element, begins));
            }
            if begins * sense < 0.0 {
                return Ok(Judged::Held(element));
            }
        }
        Ok(Judged::Fits)
    }

    /// The sense in which an element accelerates, where everything was evaluated; 0 for rounding.
    fn begins(&mut self, slipping: &Slipping, element: usize) -> f64 {
        let plan = self.model.plan;
        let along = |row: usize| DissipativeElement::of(plan, row).acceleration(&self.trial);
        let acceleration = match rows(plan, element) {
            Some([x, y]) if slipping.senses[x] != 0.0 => {
                Vec2::new(along(x), along(y)).dot(slipping.along[x].unit().unwrap_or_default())
            }
            _ => along(element),
        };
        let mut slopes = Vec::with_capacity(self.order());
        self.slopes_of_element(element, &mut slopes);
        let unit: f64 = slopes.iter().zip(&slipping.units).map(|(slope, unit)| (slope * unit).abs()).sum();
        if acceleration.abs() > SLOW * unit * slipping.greatest { acceleration.signum() } else { 0.0 }
    }

    /// Which of the elements that slide from rest are kept from it by those that are held: their friction is at its limit.
    fn find_still(&mut self, slipping: &mut Slipping, slow: &[usize]) {
        let mut basis = self.basis(&slipping.held);
        let count = basis.len();
        slipping.still.fill(false);
        for &element in slow.iter().filter(|element| slipping.senses[**element] != 0.0) {
            slipping.still[element] = self.touches(element)
                && !self.is_independent(element, &mut basis)
                && self.begins(slipping, element) == 0.0;
            basis.truncate(count);
        }
    }

    /// What holds an element over what friction at rest, or the losses, can, where everything was evaluated.
    pub fn part_held(&self, slipping: &Slipping, index: usize) -> f64 {
        let effort = slipping.efforts[index];
        match DissipativeElement::of(self.model.plan, index) {
            _ if effort == 0.0 => 0.0,
            DissipativeElement::Pair(element) => {
                let pressing = self.trial.pressing(self.model.plan, element);
                effort.abs() / (element.kind.factor() * slipping.at_rest[index] * pressing)
            }
            // where no power flows what holds is rounding
            DissipativeElement::Law(..) if slipping.share(index) <= NOTHING => 0.0,
            DissipativeElement::Law(law, slot) => self.trial.part_of_losses(law, slot, effort),
            DissipativeElement::Load(_) if slipping.share(index) <= NOTHING => 0.0,
            // between nothing and its capacity
            DissipativeElement::Load(Opposing { load, free, .. }) if *free != 0.0 => {
                (2.0 * effort * free / self.greatest_of_load(*load).max(0.0) - 1.0).abs()
            }
            DissipativeElement::Load(load) => {
                let all = together(self.model.plan, index).map(|row| slipping.efforts[row]);
                let effort = all.fold(0.0, f64::hypot);
                effort / self.greatest_of_load(load.load).max(0.0)
            }
        }
    }

    /// The sense in which an element slides that needs more than what holds it.
    fn released(&self, slipping: &Slipping, index: usize) -> f64 {
        let effort = slipping.efforts[index];
        match DissipativeElement::of(self.model.plan, index) {
            DissipativeElement::Load(Opposing { load, free, .. })
                if *free != 0.0 && 2.0 * effort * free < self.greatest_of_load(*load) =>
            {
                *free
            }
            _ if rows(self.model.plan, index).is_some() => 1.0,
            _ => -effort.signum(),
        }
    }

    /// Of all elements that are held, those whose speeds do not depend on closed stops and those before them, from one of them on.
    pub fn take_independent(&mut self, slipping: &mut Slipping, (t, y): (f64, &[f64]), first: usize) {
        let n = self.order();
        self.set_position(t, y);
        self.reduced.run_motion(self.model.plan, &mut self.trial);
        let mut held: Vec<usize> =
            (0..slipping.senses.len()).filter(|&e| slipping.senses[e] == 0.0).collect();
        let turn = first.checked_rem(held.len()).unwrap_or(0);
        held.rotate_left(turn);
        slipping.held.clear();
        let mut basis = self.basis(&[]);
        for element in held {
            if basis.len() == n {
                break;
            }
            if self.is_independent(element, &mut basis) {
                slipping.held.push(element);
            }
        }
    }

    /// Whether the speed of an element does not depend on those of others, which it then joins.
    pub fn is_independent(&mut self, element: usize, basis: &mut Vec<Vec<f64>>) -> bool {
        let mut row = Vec::with_capacity(self.order());
        self.slopes_of_element(element, &mut row);
        joins(row, basis)
    }

    /// Takes what is left of the speeds of the elements that are held from the rates, by impulses of what holds them.
    pub fn stop_held(&mut self, slipping: &Slipping, y: &mut [f64]) -> Result<(), Halt> {
        let (n, held) = (self.order(), slipping.held.len());
        let count = held + self.closed.len();
        if slipping.rests {
            y[n..2 * n].fill(0.0);
            return Ok(());
        }
        if count == 0 {
            return Ok(());
        }
        let impulses = self.impulses_of_held(slipping, y).ok_or(Halt::Jam)?;
        for (k, impulse) in impulses.iter().enumerate() {
            let mut column = slipping.slopes_of(k, n).to_vec();
            self.reduced.solve(&mut column);
            y[n..2 * n].iter_mut().zip(&column).for_each(|(rate, c)| *rate -= c * impulse);
        }
        Ok(())
    }

    /// Whether a drive that is prescribed moves.
    fn drives_move(&self) -> bool {
        let drives = self.model.mechanism.drives.iter().zip(&self.first);
        drives.into_iter().any(|(drive, first)| !drive.free && (drive.of_time || moves(first)))
    }
}

impl Slipping {
    /// The senses at these speeds, of elements that are in touch or not. Returns those that may be held or slide in either sense, and
    /// those that are let go.
    fn take_senses(
        &mut self,
        speeds: &[f64],
        (touch, slow): (&[bool], &[bool]),
        released: &[f64],
    ) -> (Vec<usize>, Vec<usize>) {
        let (mut open, mut let_go) = (Vec::new(), Vec::new());
        for (element, speed) in speeds.iter().enumerate() {
            let turns = self.turning.iter().any(|(_, turns)| *turns == element);
            let struck = std::mem::take(&mut self.struck[element]) && speed.abs() > NONE * self.fastest;
            let held = self.begun && self.senses[element] == 0.0 && !struck;
            self.before[element] = touch[element] && (!self.begun || held || self.still[element]);
            if !touch[element] {
                // it bears nothing
                self.senses[element] = 1.0_f64.copysign(*speed);
            } else if held && turns && !self.driven[element] {
                let_go.push(element);
                self.senses[element] = released[element];
            } else if held || self.still[element] || slow[element] {
                open.push(element);
            } else {
                self.senses[element] = speed.signum();
            }
        }
        self.turning.clear();
        (open, let_go)
    }
}

/// Whether a row does not depend on those of a basis, which it then joins.
pub(super) fn joins(mut row: Vec<f64>, basis: &mut Vec<Vec<f64>>) -> bool {
    let size = norm(&row);
    for known in &*basis {
        let along: f64 = row.iter().zip(known).map(|(a, b)| a * b).sum();
        row.iter_mut().zip(known).for_each(|(a, b)| *a -= along * b);
    }
    let left = norm(&row);
    let alone = left > DEPENDS * size;
    if alone {
        row.iter_mut().for_each(|x| *x /= left);
        basis.push(row);
    }
    alone
}

fn norm(row: &[f64]) -> f64 {
    row.iter().map(|x| x * x).sum::<f64>().sqrt()
}
