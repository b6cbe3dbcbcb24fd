//! A run at a stop: the state jumps, and what is looked at with it.

use super::equations::Equations;
use super::integration::Integration;
use super::stop::Touch;
use crate::math::ode::Integrator;
use crate::model::Situation;
use crate::solve::failure::Halt;

impl Integration<'_, '_> {
    /// Goes on from what happens at a stop where the last step ended; whether the motion ends there.
    ///
    /// # Errors
    /// There is no motion afterwards.
    pub fn touch<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        touch: Option<Touch>,
    ) -> Result<bool, Halt> {
        let Some(touch) = touch else { return Ok(false) };
        let (t, last) = (method.t(), self.last);
        let y = method.y().to_vec();
        self.watch.begin();
        let before = self.watch.values(equations, t, &y);
        let (was, kept) = (equations.closed.clone(), equations.kept());
        let ended = match touch {
            Touch::Opens(index) => {
                equations.closed.retain(|closed| *closed != index);
                // what turns later does so after this
                equations.slipping.iter_mut().for_each(|slipping| slipping.turning.clear());
                let mut y = y;
                equations.choose_slips(t, &mut y)?;
                if method.restart(equations, &y, last).is_err() {
                    return Err(equations.halt());
                }
                self.note_stops(equations, &was, (t, &[], Some(t)))
            }
            Touch::Hits(hit) => {
                equations.held = false;
                let struck = self.stops.strike(equations, (t, &y), &hit)?;
                self.recorder.strike((t, self.at_once()), &struck.impulses);
                let until = struck.closed.map(|lasting| t + lasting).filter(|until| *until < last);
                let resumed = match until.filter(|until| *until > t) {
                    None => {
                        equations.take_sides(t, &struck.y);
                        method.restart(equations, &struck.y, last)
                    }
                    Some(until) => {
                        let mut y = equations.carried_on(t, &struck.y, until - t)?;
                        equations.keep_held(until, &mut y)?;
                        equations.take_sides(until, &y);
                        method.start(equations, until, &y, last)
                    }
                };
                if resumed.is_err() {
                    return Err(equations.halt());
                }
                method.progress_mut().begin_with(struck.step);
                self.first = if self.by_energy { struck.step } else { f64::INFINITY };
                let now = (method.t(), method.y().to_vec());
                let ended = self.watch.jumped(equations, (now.0, &now.1), (&before, &kept));
                ended.or(self.note_stops(equations, &was, (t, &hit, until)))
            }
        };
        let ended = ended.or(self.note_held(equations, t));
        self.watch.moves_again(equations.model.mechanism, &kept);
        self.ended_by = ended;
        let here = method.t();
        // how it goes on is printed too
        self.printed = f64::NEG_INFINITY;
        if self.watch.any_happened() && !self.keep(equations, method, (here, ended.is_some())) {
            return Err(equations.halt());
        }
        let (t, y) = (method.t(), method.y().to_vec());
        match self.bonds.at_once(equations, t, &y).filter(|_| ended.is_none()) {
            Some((pair, bond)) => Err(Halt::Opens { pair, bond }),
            None => Ok(ended.is_some()),
        }
    }

    /// Notes which stops have been closed and opened since then; those that are hit are closed a little later, s, if the motion goes on so
    /// long. Returns the event that ends the motion by it.
    pub fn note_stops(
        &mut self,
        equations: &Equations<'_, '_>,
        was: &[usize],
        (t, hit, until): (f64, &[usize], Option<f64>),
    ) -> Option<usize> {
        self.stops.reconcile(equations, (t, hit, until.map_or(0.0, |until| until - t)));
        let now = equations.closed.clone();
        let rests = |index: usize| Situation::Rests(equations.stop(index).pair);
        let opened = was.iter().filter(|index| !now.contains(index));
        let mut ended = None;
        for &index in opened {
            ended = ended.or(self.watch.situation(rests(index), false, t));
        }
        for &index in now.iter().filter(|index| !was.contains(index)) {
            let Some(time) = (if hit.contains(&index) { until } else { Some(t) }) else { continue };
            ended = ended.or(self.watch.situation(rests(index), true, time));
        }
        ended
    }
}
