//! Numbers over the sweep as they run, for pictures.

use super::super::course::{Course, CourseSet, Piece, Places};
use super::super::failure::Cause;
use super::super::positions::Sweep;
use super::depends::{depends_on_forces, depends_on_nothing_else};
use super::interval::Interval;
use super::panels::{Piecewise, piecewise};
use super::sampler::Sampler;
use super::{extreme, switches};
use crate::answer::{Undefined, WholeCycle};
use crate::element::search::greatest;
use crate::model::Expr;
use crate::position::Model;
use std::cell::RefCell;

/// What a curve may leave off, of its greatest value. Extremes are solved where it has them, which is near enough for all digits of
/// their values.
const DRAWN: f64 = 2e-9;
/// Beside the greatest value an extreme below this may be one of nothing, and how far around it is looked for that.
const NOTHING: f64 = 1e-4;
const AROUND: f64 = 1e-3;
/// Series that leave off more than this part of what their numbers mostly go through are none for a picture.
const SEEN: f64 = 1e-4;
/// Where that is looked for.
const LOOKS: usize = 128;
/// What hardly changes is looked at as if it changed by this part.
const CHANGES: f64 = 1e-3;

/// The courses of numbers over the sweep of a solved file, set by set.
///
/// # Errors
/// There is no sweep.
pub(crate) fn over_sweep(
    model: &Model<'_>,
    statics: &WholeCycle,
    sets: &[CourseSet],
) -> Result<Vec<Vec<Course>>, Cause> {
    let sweep = Sweep::of(model, statics);
    let interval = Interval::of(model, statics, &sweep).map_err(Cause::NoSweep)?;
    let mut sampler = Sampler::new(model, statics, &interval)?;
    sampler.tolerance = sampler.tolerance.max(DRAWN);
    let is_whole = sampler.draw(model);
    let mut found: Vec<Vec<Course>> = vec![Vec::new(); sets.len()];
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
            found[i] = of_set(model, statics, (&mut sampler, is_whole), &set.exprs);
        }
    }
    Ok(found)
}

fn of_set(
    model: &Model<'_>,
    statics: &WholeCycle,
    (sampler, is_whole): (&mut Sampler<'_>, bool),
    exprs: &[Expr],
) -> Vec<Course> {
    sampler.begin();
    let switches: Vec<Vec<f64>> =
        exprs.iter().filter_map(|expr| switches::breaks(model, statics, sampler, expr).ok()).collect();
    let in_order = |mut all: Vec<f64>| {
        all.sort_by(f64::total_cmp);
        all.dedup_by(|a, b| *a - *b <= switches::APART);
        all
    };
    let breaks = in_order(switches.concat());
    let zeros = exprs.iter().flat_map(|expr| switches::zeros(model, statics, sampler, expr));
    let zeros: Vec<f64> = in_order(zeros.collect());
    let (first, length) = (sampler.interval.value(0.0), sampler.interval.length());
    let interval = if first.is_finite() && length.is_finite() { (first, length) } else { (0.0, 1.0) };
    let turns = sampler.interval.turns.unwrap_or(0.0).abs();
    let rounding = sampler.rounding;
    let sampler = RefCell::new(sampler);
    let mut path = |s: f64, out: &mut Vec<f64>| {
        let mut sampler = sampler.borrow_mut();
        out.extend(exprs.iter().map(|expr| sampler.number(statics, s, expr)));
    };
    let mut places = Places::new((0.0, 1.0), rounding, &mut path);
    let has_bounds = is_whole
        && switches.len() == exprs.len()
        && !zeros.iter().any(|s| (0..exprs.len()).any(|i| places.pole(*s, i).is_some()));
    let series = has_bounds.then(|| smooth(statics, &mut sampler.borrow_mut(), exprs, (&breaks, interval)));
    if let Some(Ok(series)) = series
        && (0..exprs.len()).all(|i| follows(&mut places, &series[i], i))
    {
        return series;
    }
    let known = in_order([breaks, zeros].concat());
    Course::by_places(&mut places, interval, exprs.len(), (&known, turns))
}

/// Whether series follow a number so near that a picture shows nothing else: neither a pole nor a jump has hidden in a narrow one.
fn follows(places: &mut Places<'_>, course: &Course, which: usize) -> bool {
    #[allow(clippy::cast_precision_loss)] // a few
    let mut seen: Vec<f64> =
        (0..=LOOKS).map(|i| places.at(i as f64 / LOOKS as f64, which)).filter(|y| y.is_finite()).collect();
    seen.sort_by(f64::total_cmp);
    let tenth = seen.len() / 10;
    let (Some(low), Some(high)) = (seen.get(tenth), seen.iter().rev().nth(tenth)) else { return false };
    let wide = (high - low).max(CHANGES * low.abs().max(high.abs()));
    course.pieces.iter().all(|piece| match piece {
        Piece::Series(panels) => panels.iter().all(|panel| panel.tail() <= SEEN * wide),
        Piece::Points(_) => true,
    })
}

/// Numbers that are smooth between the breaks.
fn smooth(
    statics: &WholeCycle,
    sampler: &mut Sampler<'_>,
    exprs: &[Expr],
    (breaks, interval): (&[f64], (f64, f64)),
) -> Result<Vec<Course>, Undefined> {
    let all: Vec<&Expr> = exprs.iter().collect();
    let found = piecewise(sampler, statics, (&all, None), breaks)?;
    let course = |(expr, piecewise): (&Expr, Piecewise)| {
        let mut found = |sign| -> Result<(f64, f64), Undefined> {
            let found = extreme(statics, sampler, expr, &piecewise, sign)?;
            Ok(or_end(&piecewise, near_nothing(statics, sampler, expr, &piecewise, found), sign))
        };
        let (least, greatest) = (found(-1.0)?, found(1.0)?);
        let (breaks, window) = (breaks.to_vec(), (least.1, greatest.1));
        let course = Course { breaks, interval, window, ..Course::default() };
        let at = |(s, y): (f64, f64)| Some((course.value(s), y));
        let (least, greatest) = (at(least), at(greatest));
        Ok(Course { pieces: vec![Piece::Series(piecewise.panels)], least, greatest, ..course })
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
