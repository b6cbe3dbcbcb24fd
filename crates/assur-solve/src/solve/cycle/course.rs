//! Numbers over the sweep as they run, for pictures: smooth between the places where something switches.

use super::super::failure::Cause;
use super::super::positions::Sweep;
use super::depends::{depends_on_forces, depends_on_nothing_else};
use super::interval::Interval;
use super::panels::{Piecewise, piecewise};
use super::sampler::Sampler;
use super::{extreme, switches};
use crate::answer::{Undefined, WholeCycle};
use crate::element::search::greatest;
use crate::math::chebyshev::Series;
use crate::model::Expr;
use crate::position::Model;
use std::cell::RefCell;

/// What a curve may leave off, of its greatest value. Extremes are solved where it has them, which is near enough for all digits of
/// their values.
const DRAWN: f64 = 2e-9;
/// Beside the greatest value an extreme below this may be one of nothing, and how far around it is looked for that.
const NOTHING: f64 = 1e-4;
const AROUND: f64 = 1e-3;

/// A number over the sweep.
#[derive(Clone, Debug, Default)]
pub struct SweepCurve {
    /// The number in the sweep's own coordinate from 0 to 1, panel by panel.
    panels: Vec<Series>,
    /// Where it may jump, in that coordinate.
    breaks: Vec<f64>,
    /// First value and length of the sweep of the first drive, rad or m; from 0 to 1 where that is a point.
    pub interval: (f64, f64),
    /// Where it is least, as a value of the drive, and what it is there.
    pub least: (f64, f64),
    /// Where it is greatest.
    pub greatest: (f64, f64),
    /// The greatest magnitude in play.
    pub scale: f64,
}

impl SweepCurve {
    /// Points of it: values of the drive and of the number, at least `parts` over the sweep. Two at one place are a jump.
    #[must_use]
    pub fn points(&self, parts: f64) -> Vec<(f64, f64)> {
        let mut all = Vec::new();
        for panel in &self.panels {
            let count = ((panel.to - panel.from) * parts).ceil().max(4.0);
            let follows = !all.is_empty() && !self.breaks.contains(&panel.from);
            let mut i = if follows { 1.0 } else { 0.0 };
            while i <= count {
                let s = if i == count { panel.to } else { panel.from + (panel.to - panel.from) * i / count };
                all.push((self.value(s), panel.value(s)));
                i += 1.0;
            }
        }
        all
    }

    /// Values of the drive where it passes through a level, in order; a jump through it is one.
    #[must_use]
    pub fn crossings(&self, level: f64) -> Vec<f64> {
        let mut all: Vec<f64> = Vec::new();
        let mut before: Option<f64> = None;
        for panel in &self.panels {
            let apart = panel.clone().less(level);
            let begin = apart.value(apart.from);
            if before.is_some_and(|b| b * begin < 0.0) {
                all.push(panel.from);
            }
            all.extend(apart.roots());
            before = Some(apart.value(apart.to));
        }
        all.into_iter().map(|s| self.value(s)).collect()
    }

    /// Values of the drive where something switches.
    pub fn switches(&self) -> impl Iterator<Item = f64> + '_ {
        self.breaks.iter().map(|s| self.value(*s))
    }

    fn value(&self, s: f64) -> f64 {
        self.interval.0 + self.interval.1 * s
    }
}

/// Numbers that have their points at the same places.
#[derive(Clone, Debug, Default)]
pub struct CourseSet {
    pub exprs: Vec<Expr>,
    /// What is no greater than this is rounding, SI.
    pub rounding: f64,
}

/// The courses of numbers over the sweep of a solved file, set by set.
///
/// # Errors
/// There is no sweep.
pub fn courses(
    model: &Model<'_>,
    statics: &WholeCycle,
    sets: &[CourseSet],
) -> Result<Vec<Result<Vec<SweepCurve>, Undefined>>, Cause> {
    let sweep = Sweep::of(model, statics);
    let interval = Interval::of(model, statics, &sweep).map_err(Cause::NoSweep)?;
    let mut sampler = Sampler::new(model, statics, &interval)?;
    sampler.tolerance = sampler.tolerance.max(DRAWN);
    let mut found: Vec<Option<Result<Vec<SweepCurve>, Undefined>>> = vec![None; sets.len()];
    for forces in [false, true] {
        let late = |set: &CourseSet| set.exprs.iter().any(|e| depends_on_forces(model.mechanism, e));
        let sets = || sets.iter().enumerate().filter(|(_, set)| late(set) == forces);
        // what is solved at a place for one of them is there for all
        sampler.share(
            sets()
                .flat_map(|(_, set)| &set.exprs)
                .filter(|e| depends_on_nothing_else(model.mechanism, e))
                .cloned(),
        );
        for (i, set) in sets() {
            sampler.rounding = set.rounding;
            found[i] = Some(of_set(model, statics, &mut sampler, &set.exprs));
        }
    }
    Ok(found.into_iter().flatten().collect())
}

fn of_set(
    model: &Model<'_>,
    statics: &WholeCycle,
    sampler: &mut Sampler<'_>,
    exprs: &[Expr],
) -> Result<Vec<SweepCurve>, Undefined> {
    sampler.begin();
    let mut breaks = Vec::new();
    for expr in exprs {
        breaks.extend(switches::breaks(model, statics, sampler, expr)?);
    }
    breaks.sort_by(f64::total_cmp);
    breaks.dedup_by(|a, b| *a - *b <= switches::APART);
    let all: Vec<&Expr> = exprs.iter().collect();
    let found = piecewise(sampler, statics, (&all, None), &breaks)?;
    let (first, length) = (sampler.interval.value(0.0), sampler.interval.length());
    let interval = if first.is_finite() && length.is_finite() { (first, length) } else { (0.0, 1.0) };
    let course = |(expr, piecewise): (&Expr, Piecewise)| {
        let mut found = |sign| -> Result<(f64, f64), Undefined> {
            let found = extreme(statics, sampler, expr, &piecewise, sign)?;
            Ok(or_end(&piecewise, near_nothing(statics, sampler, expr, &piecewise, found), sign))
        };
        let (least, greatest) = (found(-1.0)?, found(1.0)?);
        let scale = piecewise.scale;
        let mut course = SweepCurve {
            panels: piecewise.panels,
            breaks: breaks.clone(),
            interval,
            scale,
            ..SweepCurve::default()
        };
        course.least = (course.value(least.0), least.1);
        course.greatest = (course.value(greatest.0), greatest.1);
        Ok(course)
    };
    exprs.iter().zip(found).map(course).collect()
}

/// An extreme that is next to nothing: of a magnitude that passes through zero, where no series is smooth. It is looked for around.
fn near_nothing(
    statics: &WholeCycle,
    sampler: &mut Sampler<'_>,
    expr: &Expr,
    of: &Piecewise,
    (at, value): (f64, f64),
) -> (f64, f64) {
    let (from, to) = ((at - AROUND).max(0.0), (at + AROUND).min(1.0));
    let jumps = of.breaks.iter().any(|s| (from..=to).contains(s));
    if jumps || value == 0.0 || value.abs() > NOTHING * of.scale {
        return (at, value);
    }
    let sampler = RefCell::new(sampler);
    let magnitude = |s| sampler.borrow_mut().sample(statics, s, expr).map_or(f64::NAN, |x| x.value.abs());
    let (s, least) = greatest(from, to, &|s| -magnitude(s));
    if -least < value.abs() { (s, value.signum() * -least) } else { (at, value) }
}

/// An extreme, or an end of the sweep where the number runs beyond it: there it may jump.
fn or_end(of: &Piecewise, found: (f64, f64), sign: f64) -> (f64, f64) {
    let first = of.panels.first().map(|p| (p.from, p.value(p.from)));
    let last = of.panels.last().map(|p| (p.to, p.value(p.to)));
    let beyond = |best: (f64, f64), end: (f64, f64)| sign * end.1 > sign * best.1 + 1e-6 * of.scale;
    let ends = first.into_iter().chain(last);
    ends.fold(found, |best, end| if beyond(best, end) { end } else { best })
}
