//! A run at a stop: the state jumps, and what is looked at with it.

use super::equations::Equations;
use super::going::Going;
use super::stop::Touch;
use crate::math::ode::Integrator;
use crate::model::Situation;
use crate::solve::failure::Halt;

impl Going<'_, '_> {
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
        let begun = self.watch.counts();
        let before = self.watch.values(equations, t, &y);
        let ended = match touch {
            Touch::Opens(index) => {
                self.stops.open(equations, t, index);
                if method.restart(equations, &y, last).is_err() {
                    return Err(equations.halt());
                }
                self.watch.situation(Situation::Rests(equations.stop(index).pair), false, t)
            }
            Touch::Hits(hit) => {
                equations.held = false;
                let struck = match hit[..] {
                    [only] => self.stops.strike(equations, t, &y, only)?,
                    _ => self.stops.strike_all(equations, t, &y, &hit)?,
                };
                let closed: Vec<usize> =
                    hit.into_iter().filter(|index| equations.closed.contains(index)).collect();
                let until = struck.closed.map(|lasting| t + lasting).filter(|until| *until < last);
                let resumed = match until.filter(|until| *until > t) {
                    None => {
                        equations.take_sides(t, &struck.y);
                        method.restart(equations, &struck.y, last)
                    }
                    Some(until) => {
                        let y = equations.carried_on(t, &struck.y, until - t)?;
                        equations.take_sides(until, &y);
                        method.start(equations, until, &y, last)
                    }
                };
                if resumed.is_err() {
                    return Err(equations.halt());
                }
                method.progress_mut().begin_with(struck.step);
                let now = (method.t(), method.y().to_vec());
                let ended = self.watch.jumped(equations, (now.0, &now.1), &before);
                closed.into_iter().fold(ended, |ended, index| {
                    let rests = Situation::Rests(equations.stop(index).pair);
                    ended.or(until.and_then(|until| self.watch.situation(rests, true, until)))
                })
            }
        };
        self.ended_by = ended;
        let happened = self.watch.counts() != begun;
        if happened && !self.keep(equations, method, (&begun, ended.is_some())) {
            return Err(equations.halt());
        }
        Ok(ended.is_some())
    }
}
