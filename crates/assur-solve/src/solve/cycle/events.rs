//! Events of a sweep: where a number passes a value or a condition becomes true, from the first position to the last.
//!
//! They are looked for between the places where the mechanism is known, as those of a motion under loads are within its
//! steps.

use super::interval::Interval;
use super::sampler::{Sample, Sampler};
use super::switches::APART;
use super::within_curves;
use crate::answer::{Nearest, ROUNDING, Swept, WholeCycle, constant};
use crate::math::ROUNDING as OF_GREATEST;
use crate::math::ode::event::{Touching, crossings_and_touches};
use crate::model::{Event, Expr, Value};
use crate::position::{DriveValue, Model};
use crate::solve::failure::Cause;
use crate::solve::note::Note;
use crate::solve::positions::Sweep;
use std::ops::ControlFlow;

/// A number no greater than this part of its size is zero where a root is searched.
const NEAR: f64 = 4.0 * f64::EPSILON;
/// Between two places a number that stays zero is looked at here too.
const INSIDE: f64 = 0.4;

/// Finds the events of a file with a sweep, and where it ends.
pub(crate) fn events(model: &Model<'_>, statics: &mut WholeCycle, sweep: &Sweep) -> Result<(), Cause> {
    let mechanism = model.mechanism;
    let Some(drive) = mechanism.swept_drive().filter(|_| !mechanism.events.is_empty()) else { return Ok(()) };
    let interval = Interval::of(model, statics, sweep).map_err(Cause::NoSweep)?;
    let mut sampler = Sampler::new(model, statics, &interval)?;
    let mut places = Vec::new();
    let mut seen = Vec::new();
    for event in &mechanism.events {
        let Event { value: expr, strict, .. } = event;
        let mut search = Search { statics, sampler: &mut sampler, expr, strict: *strict, seen: Vec::new() };
        places.push(search.places(event));
        seen.push(search.seen);
    }
    within_curves(&sampler)?;
    let steps = sweep.steps(drive);
    let own = |s: &f64| {
        let nearest = (s * steps).round() / steps;
        if (s - nearest).abs() <= APART { nearest } else { *s }
    };
    places.iter_mut().flatten().for_each(|s| *s = own(s));
    let ends = places.iter().zip(&mechanism.events).filter(|(_, event)| event.ends);
    let end = ends.flat_map(|(places, _)| places).copied().fold(1.0, f64::min);
    let value = |s: f64| match interval.values(s).nth(drive) {
        Some(DriveValue::Scalar(value)) => value,
        _ => f64::NAN,
    };
    let given = &mechanism.drives[drive];
    let speed = given.speed.as_ref().filter(|_| given.acceleration.is_none());
    let speed = speed.and_then(|speed| match constant(model, statics, speed) {
        Value::Scalar(speed) => Some(speed),
        _ => None,
    });
    let nearest = places.iter().zip(&seen).map(|(places, seen)| nearest(places, seen, end, value)).collect();
    places.iter_mut().for_each(|places| places.retain(|s| *s <= end));
    let swept = Swept { drive, from: value(0.0), to: value(end), speed, nearest };
    statics.events = places.into_iter().map(|all| all.into_iter().map(value).collect()).collect();
    statics.swept = Some(swept);
    Ok(())
}

/// The ends that a sweep does not come to, where it comes to none.
pub(crate) fn never_ended(model: &Model<'_>, statics: &WholeCycle) -> Vec<Note> {
    let Some(swept) = &statics.swept else { return Vec::new() };
    let all = model.mechanism.events.iter().enumerate().filter(|(_, event)| event.ends);
    let ends: Vec<usize> = all.map(|(event, _)| event).collect();
    let open = ends.iter().all(|event| statics.count(*event) == 0.0);
    ends.into_iter().filter(|_| open).map(|event| Note::NeverEnded { event, at: swept.to }).collect()
}

/// How near an event comes, from where it happens and what was seen of its number.
fn nearest(places: &[f64], seen: &[(f64, f64)], end: f64, value: impl Fn(f64) -> f64) -> Nearest {
    if let Some(later) = places.iter().copied().filter(|s| *s > end).min_by(f64::total_cmp) {
        return Nearest::Later(value(later));
    }
    let before = seen.iter().copied().filter(|(_, s)| *s <= end);
    let (least, s) = before.fold((f64::INFINITY, 0.0), |a, b| if b.0 < a.0 { b } else { a });
    if least == 0.0 { Nearest::Reached(value(s)) } else { Nearest::Missing(least, value(s)) }
}

/// A part of the sweep on which a number has one sign, or stays zero: where it begins.
type Part = (f64, i8);

struct Search<'f, 'a> {
    statics: &'f WholeCycle,
    sampler: &'f mut Sampler<'a>,
    expr: &'f Expr,
    /// At a touch it does not happen.
    strict: bool,
    /// Magnitudes, and where.
    seen: Vec<(f64, f64)>,
}

impl Search<'_, '_> {
    /// Where the event happens, in the sweep's own coordinate from 0 to 1.
    fn places(&mut self, event: &Event) -> Vec<f64> {
        let intervals = self.sampler.intervals();
        let (mut parts, mut places): (Vec<Part>, Vec<f64>) = (Vec::new(), Vec::new());
        let mut index = 0.0;
        while index < intervals {
            let step = (index / intervals, (index + 1.0) / intervals);
            if self.is_known(step) {
                self.parts_of(step, &mut parts);
            } else {
                // what is beyond a gap begins anew
                places.extend(happens(event, &parts));
                parts.clear();
            }
            index += 1.0;
        }
        if !parts.is_empty() && self.sign(1.0) == 0 {
            parts.push((1.0, 0));
        }
        places.extend(happens(event, &parts));
        places
    }

    fn is_known(&mut self, (from, to): (f64, f64)) -> bool {
        [from, inside(from, to), to].iter().all(|s| !self.value(*s, 0.0).is_nan())
    }

    /// Adds the parts that begin between two places where the number is known.
    fn parts_of(&mut self, (from, to): (f64, f64), parts: &mut Vec<Part>) {
        let middle = inside(from, to);
        let [begin, between, end] = [from, middle, to].map(|s| self.sign(s));
        if [begin, between, end] == [0; 3] {
            let before = parts.last().copied();
            match before {
                Some((_, 0)) => {}
                Some((since, _)) => {
                    parts.push((self.end_of_zero(from, 0.5 * (from + since.max(2.0 * from - to))), 0))
                }
                None => parts.push((from, 0)),
            }
            return;
        }
        let mut inner = Vec::new();
        let touching = Touching { part: OF_GREATEST, greatest: 0.0 };
        // what was touched there is not touched again
        let passed = parts.last().filter(|part| **part == (from, 0)).map(|_| between > 0);
        let _ = crossings_and_touches(
            (from, to),
            passed,
            touching,
            |s| match (0.0..=1.0).contains(&s) {
                true => self.value(s, if s == from || s == to { ROUNDING } else { NEAR }),
                false => f64::NAN,
            },
            |crossing| {
                inner.push(crossing);
                ControlFlow::<()>::Continue(())
            },
        );
        // a zero at the end begins the next part, or none
        inner.retain(|crossing| if crossing.touches { !self.strict } else { crossing.t < to });
        let sign = |rising: bool| if rising { 1 } else { -1 };
        let first = inner.first().map_or_else(
            || [between, begin, end].into_iter().find(|sign| *sign != 0).unwrap_or(0),
            |crossing| -sign(crossing.rising),
        );
        let since = match parts.last() {
            Some((_, 0)) => self.end_of_zero(from, if between == 0 { to } else { middle }),
            _ => from,
        };
        let behind = inner.iter().flat_map(|c| {
            let touched = c.touches.then_some((c.t, 0));
            touched.into_iter().chain((c.t < to).then_some((c.t, sign(c.leads_up()))))
        });
        for (since, sign) in [(since, first)].into_iter().chain(behind) {
            if parts.last().is_none_or(|part| part.1 != sign) {
                parts.push((since, sign));
            }
        }
    }

    /// How far the number stays zero from a place on towards another one.
    fn end_of_zero(&mut self, mut zero: f64, mut other: f64) -> f64 {
        while (other - zero).abs() > f64::EPSILON {
            let middle = 0.5 * (zero + other);
            if middle == zero || middle == other {
                break;
            }
            if self.sign(middle) == 0 { zero = middle } else { other = middle }
        }
        zero
    }

    fn sign(&mut self, s: f64) -> i8 {
        let value = self.value(s, ROUNDING);
        i8::from(value > 0.0) - i8::from(value < 0.0)
    }

    /// The number at a place; 0 below this part of its size.
    fn value(&mut self, s: f64, zero: f64) -> f64 {
        let Ok(Sample { value, size }) = self.sampler.sample(self.statics, s, self.expr) else {
            return f64::NAN;
        };
        let is_zero = value.abs() <= ROUNDING * size;
        self.seen.push((if is_zero { 0.0 } else { value.abs() }, s));
        if value.abs() <= zero * size { 0.0 } else { value }
    }
}

fn inside(from: f64, to: f64) -> f64 {
    from + INSIDE * (to - from)
}

/// Where the event happens among parts that follow one another: a number comes to zero, or a strict condition leaves it.
fn happens(event: &Event, parts: &[Part]) -> Vec<f64> {
    let is_one = |sign: i8, before: i8, after: i8| {
        if event.strict { after == sign && before != sign } else { before == -sign && after != before }
    };
    let rises = event.rising != Some(false);
    let falls = event.rising != Some(true);
    let happens =
        |before: i8, after: i8| (rises && is_one(1, before, after)) || (falls && is_one(-1, before, after));
    parts.windows(2).filter(|pair| happens(pair[0].1, pair[1].1)).map(|pair| pair[1].0).collect()
}
