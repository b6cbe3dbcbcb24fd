//! Where numbers and vectors pass through zero over the sweep, and where numbers pass the points of a curve.

use super::sampler::{Need, Sampler};
use super::switches::Switch;
use crate::answer::{ROUNDING, Undefined, WholeCycle, is_zero};
use crate::math::{Vec2, root_within};
use crate::model::{Axis, Curve, Expr, Value};

/// A vector below this part of its greatest magnitude passes through zero.
const NULL: f64 = 1e-9;
/// A number that is no nearer to zero than this part of its size need not come nearer.
const NEAR: f64 = 4.0 * f64::EPSILON;
/// A stretch on which a number is zero ends where it exceeds its greatest magnitude there by this factor.
const BEYOND: f64 = 4.0;

/// A number as a vector whose second component is null, or a vector, at a place of the sweep.
#[derive(Clone, Copy)]
struct Sample {
    place: f64,
    value: Vec2,
    size: f64,
}

/// A component of a function between places.
struct Component<'f, 'a> {
    statics: &'f WholeCycle,
    sampler: &'f mut Sampler<'a>,
    expr: &'f Expr,
    need: Need,
    axis: Axis,
    /// Why it could not be computed.
    failed: Option<Undefined>,
}

/// The roots of each function over the sweep. A vector counts where it is null.
pub(super) fn roots(
    statics: &WholeCycle,
    sampler: &mut Sampler<'_>,
    all: &[Switch],
) -> Result<Vec<Vec<f64>>, Undefined> {
    let intervals = sampler.intervals();
    let needs: Vec<Need> = all.iter().map(|switch| sampler.need_of(&switch.expr)).collect();
    let mut table: Vec<Vec<Sample>> = vec![Vec::new(); all.len()];
    let mut index = 0.0;
    while index <= intervals {
        let place = index / intervals;
        for ((samples, switch), need) in table.iter_mut().zip(all).zip(&needs) {
            samples.push(sample(statics, sampler, place, &switch.expr, *need)?);
        }
        index += 1.0;
    }
    let mut found = Vec::new();
    for ((switch, samples), need) in all.iter().zip(&table).zip(needs) {
        let mut roots = Vec::new();
        for axis in [Axis::X, Axis::Y] {
            let expr = &switch.expr;
            let mut component = Component { statics, sampler, expr, need, axis, failed: None };
            match &switch.curve {
                Some(curve) => component.passes(curve, samples, &mut roots),
                None => component.changes(samples, &mut roots),
            }
            if let Some(why) = component.failed {
                return Err(why);
            }
        }
        found.push(roots);
    }
    Ok(found)
}

fn sample(
    statics: &WholeCycle,
    sampler: &mut Sampler<'_>,
    place: f64,
    expr: &Expr,
    need: Need,
) -> Result<Sample, Undefined> {
    let found = sampler.measured(statics, place, expr, need)?;
    let value = match found.value {
        Value::Scalar(x) => Vec2::new(x, 0.0),
        Value::Vector(v) => v,
        Value::Bool(_) => Vec2::new(f64::NAN, f64::NAN),
    };
    Ok(Sample { place, value, size: found.size })
}

impl Component<'_, '_> {
    const fn of(&self, sample: &Sample) -> f64 {
        match self.axis {
            Axis::X => sample.value.x,
            Axis::Y => sample.value.y,
        }
    }

    const fn other(&self, sample: &Sample) -> f64 {
        match self.axis {
            Axis::X => sample.value.y,
            Axis::Y => sample.value.x,
        }
    }

    /// Its sign; zero where it is zero but for rounding.
    fn sign(&self, sample: &Sample) -> f64 {
        let x = self.of(sample);
        if is_zero(x, sample.size) { 0.0 } else { x.signum() }
    }

    fn at(&mut self, place: f64) -> Sample {
        let found = sample(self.statics, self.sampler, place, self.expr, self.need);
        found.unwrap_or_else(|why| {
            self.failed = Some(why);
            Sample { place, value: Vec2::zero(), size: 0.0 }
        })
    }

    /// The place between two at which the component has a value; beside them it is on either side of it.
    fn reaches(&mut self, level: f64, [a, b]: [&Sample; 2]) -> Sample {
        let tolerance = self.sampler.settings().root;
        let values = (self.of(a) - level, self.of(b) - level);
        let place = root_within(tolerance, (a.place, b.place), values, |s| {
            let here = self.at(s);
            let x = self.of(&here) - level;
            if x.abs() <= NEAR * here.size { 0.0 } else { x }
        });
        self.at(place)
    }

    /// Places where the number passes a point of a curve's table.
    fn passes(&mut self, curve: &Curve, samples: &[Sample], found: &mut Vec<f64>) {
        for pair in samples.windows(2) {
            let [mut before, after] = [pair[0], pair[1]];
            let (from, to) = (self.of(&before), self.of(&after));
            if is_zero(to - from, before.size + after.size) {
                continue;
            }
            curve.function.points_between(from, to, |point| {
                if self.of(&before) != point {
                    before = self.reaches(point, [&before, &after]);
                }
                found.push(before.place);
            });
        }
    }

    /// Places where the component changes its sign, and ends of the stretches on which it is zero.
    fn changes(&mut self, samples: &[Sample], found: &mut Vec<f64>) {
        let (greatest, size) = samples
            .iter()
            .filter(|s| s.size.is_finite())
            .fold((0.0, 0.0), |most, s| (s.value.norm().max(most.0), s.size.max(most.1)));
        let null = (NULL * greatest).max(ROUNDING * size);
        let mut first = 0;
        while first < samples.len() {
            let sign = self.sign(&samples[first]);
            let next = (first + 1..samples.len()).find(|i| self.sign(&samples[*i]) != sign);
            let end = next.unwrap_or(samples.len());
            if sign == 0.0 {
                self.stretch(samples, (first, end), null, found);
            } else if let Some(next) = next
                && self.sign(&samples[next]) == -sign
            {
                let root = self.reaches(0.0, [&samples[end - 1], &samples[next]]);
                if self.other(&root).abs() <= null {
                    found.push(root.place);
                }
            }
            first = end;
        }
    }

    /// The ends of a stretch on which the component is zero, where it is longer than one place.
    fn stretch(&mut self, samples: &[Sample], (first, end): (usize, usize), null: f64, found: &mut Vec<f64>) {
        if !samples[first..end].iter().any(|sample| self.other(sample).abs() <= null) {
            return;
        }
        if end - first == 1 {
            found.push(samples[first].place);
            return;
        }
        let zero = samples[first..end].iter().map(|s| self.of(s).abs()).fold(0.0, f64::max) * BEYOND;
        if let Some(before) = first.checked_sub(1) {
            found.push(self.end_of_stretch(samples[first].place, samples[before].place, zero));
        }
        if let Some(after) = samples.get(end) {
            found.push(self.end_of_stretch(samples[end - 1].place, after.place, zero));
        }
    }

    /// How far the component stays below a magnitude from a place on towards another one.
    fn end_of_stretch(&mut self, mut inside: f64, mut outside: f64, zero: f64) -> f64 {
        let tolerance = self.sampler.settings().root;
        while (outside - inside).abs() > tolerance.max(f64::EPSILON) {
            let middle = 0.5 * (inside + outside);
            if middle == inside || middle == outside {
                break;
            }
            let here = self.at(middle);
            if self.of(&here).abs() <= zero { inside = middle } else { outside = middle }
        }
        0.5 * (inside + outside)
    }
}
