//! When a coordinate comes to its stop, and when a closed stop would have to pull: looked for within the last step.

use super::equations::Equations;
use super::impact::PULLS;
use super::lookout::Lookout;
use super::records::within_step;
use crate::math::ode::Integrator;
use crate::math::ode::event::first_crossing;

/// Where, in the last step, the coordinate of a stop comes to it.
pub(super) fn hit<M: Integrator<f64>>(
    equations: &mut Equations<'_, '_>,
    method: &mut M,
    index: usize,
    (left, at_once): (bool, f64),
    lookout: &mut Lookout,
) -> Option<f64> {
    let (begin, to) = (method.previous_t(), method.t());
    let mut from = begin;
    let mut y = method.y().to_vec();
    let mut observed = |equations: &mut Equations<'_, '_>, t: f64, rate: bool| {
        let known = within_step(equations, method, t, &mut y) && equations.observe(t, &y, false);
        match rate {
            _ if !known => f64::NAN,
            true => equations.rate(index, &y).0,
            false => equations.distance(index),
        }
    };
    if left {
        // it comes back after it has turned
        let turn = first_crossing((from, to), Some(true), |t| observed(equations, t, true))?;
        from = turn.t;
        if observed(equations, from, false) <= 0.0 {
            return Some(from);
        }
    } else if observed(equations, from, false) <= 0.0 && observed(equations, from, true) < 0.0 {
        // rebounds elsewhere that are not followed have brought it there
        return Some((from + at_once).min(to));
    }
    let crossing = first_crossing((from, to), None, |t| {
        let distance = observed(equations, t, false);
        lookout.note((t - begin) / (to - begin), distance);
        distance
    });
    crossing.filter(|c| !c.rising).map(|c| c.t)
}

/// Where, in the last step, a closed stop would have to pull.
pub(super) fn opening<M: Integrator<f64>>(
    equations: &mut Equations<'_, '_>,
    method: &mut M,
    index: usize,
    pressed: f64,
) -> Option<f64> {
    // it is left as any rest
    let undetermined = equations.slipping.as_ref().is_some_and(|slipping| slipping.undetermined);
    if undetermined {
        return None;
    }
    let step = (method.previous_t(), method.t());
    let side = equations.stop(index).side;
    let mut y = method.y().to_vec();
    let crossing = first_crossing(step, Some(true), |t| {
        let known = within_step(equations, method, t, &mut y) && equations.observe(t, &y, false);
        if known { side * equations.trial.motion.stops[index] } else { f64::NAN }
    });
    let opens = crossing.filter(|c| !c.rising)?;
    // what presses no more by anything but rounding stays
    let known = equations.observe(step.1, method.y(), false);
    let effort = side * equations.trial.motion.stops[index];
    (!known || effort < -PULLS * pressed).then_some(opens.t)
}
