//! Springs whose length passes zero: the force turns round there at once, and at zero itself it has no direction.

use super::equations::Equations;
use super::integration::{Ended, Integration};
use super::records::within_step;
use crate::math::ode::Integrator;
use crate::math::ode::event::first_crossing;
use crate::solve::failure::Halt;

/// The output between the ends of a step is as exact as this, of the size of the mechanism.
const NOTHING: f64 = 1e-7;
/// In a step an end of a spring may move this many times as far as its velocities at both ends of the step say.
const FURTHER: f64 = 2.0;

impl Integration<'_, '_> {
    /// Ends the motion where a spring passes length zero in the last step.
    ///
    /// # Errors
    /// Where one does.
    pub fn springs<M: Integrator<f64>>(
        &self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
    ) -> Result<(), Ended> {
        let springs = &equations.model.mechanism.springs;
        let step = (method.previous_t(), method.t());
        for (spring, own) in springs.iter().enumerate().filter(|(_, spring)| spring.has_direction()) {
            let (_, before, _) = equations.here();
            let ((r_0, v_0), (r_1, v_1)) = (before.spring_between(own), equations.trial.spring_between(own));
            let way = FURTHER * (step.1 - step.0) * v_0.norm().max(v_1.norm());
            if r_0.norm() + r_1.norm() > way {
                continue;
            }
            let mut y = method.y().to_vec();
            // how far it is, and how fast that grows
            let mut between = |t: f64| {
                let known = within_step(equations, method, t, &mut y) && equations.observe(t, &y, false);
                let (r, v) = equations.trial.spring_between(own);
                if known { (r.norm(), r.dot(v)) } else { (f64::NAN, f64::NAN) }
            };
            let Some(nearest) = first_crossing(step, Some(false), |t| between(t).1).filter(|c| c.rising)
            else {
                continue;
            };
            if between(nearest.t).0 <= NOTHING * equations.extent() {
                let halt = Halt::SpringAtZero { spring };
                return Err(Ended::Halted(match method.shorten(equations, nearest.t) {
                    Ok(()) => halt,
                    Err(_) => equations.halt(),
                }));
            }
        }
        Ok(())
    }
}
