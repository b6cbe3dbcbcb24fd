//! Impacts without a collision: where friction admits no acceleration of what slides, it may stop at once, if impulses that bring it to
//! rest satisfy the law of friction (Bernard Brogliato, Nonsmooth mechanics, 3rd edition, chapter 5).

use super::dissipative::DissipativeElement;
use super::equations::Equations;
use super::sliding_sense::Slipping;
use crate::math::Lu;
use crate::plan::{FrictionElement, FrictionLaw};
use crate::solve::failure::Halt;

/// Impulses as forces that last this part of a second, next to which loads are rounding.
const SHORT: f64 = 1e-9;
/// What rounding and loads may add to what holds.
const NEARLY: f64 = 1.0 + 1e-6;

impl Equations<'_, '_> {
    /// Takes the speed of what slides and jams, one element or all of them; whether that is possible. A contact that may open does not
    /// stop so: how it goes on after such an impulse is not known.
    ///
    /// # Errors
    /// The equations have no value.
    pub fn stop_sliding(&mut self, slipping: &mut Slipping, at: (f64, &mut [f64])) -> Result<bool, Halt> {
        let stops = |element: &usize| {
            let rubs = DissipativeElement::of(self.model.plan, *element);
            let opens = |own: &FrictionElement| matches!(own.kind, FrictionLaw::Contact { presses, .. } if presses != 0.0);
            let opens = matches!(rubs, DissipativeElement::Pair(own) if opens(own));
            slipping.senses[*element] != 0.0 && !slipping.driven[*element] && rubs.can_hold() && !opens
        };
        let all: Vec<usize> = (0..DissipativeElement::inner(self.model.plan)).filter(stops).collect();
        let mut sets: Vec<Vec<usize>> = all.iter().map(|&element| vec![element]).collect();
        if all.len() > 1 {
            sets.push(all);
        }
        let (t, y) = at;
        for set in sets {
            let senses = slipping.senses.clone();
            set.iter().for_each(|&element| slipping.senses[element] = 0.0);
            if self.take_speeds(slipping, (t, y), &set)? {
                slipping.jammed.extend(set.first().map(|&element| (t, element)));
                return Ok(true);
            }
            slipping.senses = senses;
        }
        Ok(false)
    }

    /// Takes the speeds of all that is held from the rates, if the impulses on these elements lie within their friction.
    fn take_speeds(
        &mut self,
        slipping: &mut Slipping,
        (t, y): (f64, &mut [f64]),
        stopped: &[usize],
    ) -> Result<bool, Halt> {
        let n = self.order();
        self.take_independent(slipping, (t, y), 0);
        slipping.loaded.resize(n, 0.0);
        self.accelerations_without_friction(&mut slipping.loaded)?;
        slipping.take_sliding(self.model.plan);
        self.find_slopes(slipping);
        self.find_held(slipping)?;
        let Some(impulses) = self.impulses_of_held(slipping, y) else { return Ok(false) };
        let mut jump = vec![0.0; n];
        for (impulse, column) in impulses.iter().zip(slipping.columns.chunks_exact(n)) {
            jump.iter_mut().zip(column).for_each(|(rate, c)| *rate -= c * impulse);
        }
        slipping.efforts.fill(0.0);
        for (&element, impulse) in slipping.held.iter().zip(&impulses) {
            slipping.efforts[element] = -impulse / SHORT;
        }
        slipping.pressed.clear();
        slipping.pressed.extend(impulses[slipping.held.len()..].iter().map(|impulse| -impulse / SHORT));
        let bears = impulses.iter().zip(&slipping.units[n..]).map(|(impulse, unit)| -impulse / SHORT / unit);
        slipping.bears = bears.collect();
        slipping.greatest =
            slipping.bears.iter().fold(f64::MIN_POSITIVE, |most, bears| most.max(bears.abs()));
        slipping.accelerations = jump.iter().map(|rate| rate / SHORT).collect();
        self.put(slipping)?;
        let holds = |element: &usize| self.part_held(slipping, *element) <= NEARLY;
        if !stopped.iter().all(holds) {
            return Ok(false);
        }
        y[n..2 * n].iter_mut().zip(&jump).for_each(|(rate, jump)| *rate += jump);
        Ok(true)
    }

    /// The impulses that the speeds of held elements and closed stops are, where everything was moved and their slopes are known; none
    /// where they depend on each other.
    pub fn impulses_of_held(&mut self, slipping: &Slipping, y: &[f64]) -> Option<Vec<f64>> {
        let (n, held) = (self.order(), slipping.held.len());
        let count = held + self.closed.len();
        let columns: Vec<Vec<f64>> = (0..count)
            .map(|k| {
                let mut column = slipping.slopes_of(k, n).to_vec();
                self.reduced.solve(&mut column);
                column
            })
            .collect();
        let mut factors = Lu::new(count);
        let mut impulses = Vec::with_capacity(count);
        for k in 0..count {
            impulses.push(match k.checked_sub(held) {
                None => DissipativeElement::of(self.model.plan, slipping.held[k]).row_speed(&self.trial),
                Some(place) => self.rate(self.closed[place], y).0,
            });
            for (j, column) in columns.iter().enumerate() {
                let slopes = slipping.slopes_of(k, n).iter();
                *factors.at_mut(k, j) = slopes.zip(column).map(|(a, b)| a * b).sum();
            }
        }
        if count > 0 {
            if !factors.factor() {
                return None;
            }
            factors.solve(&mut impulses);
        }
        Some(impulses)
    }
}
