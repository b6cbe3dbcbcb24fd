//! Numbers over a sweep or a motion as they run, for pictures: by series where they are smooth between the places where something
//! switches, else by places that are as near to one another as a picture needs. They end where they have no bound or no value.

mod places;
mod refine;

pub(crate) use places::{Places, Pole};
pub(crate) use refine::refined;

use super::cycle::over_sweep;
use super::failure::Cause;
use super::simulate::over_time;
use super::solution::Solution;
use crate::element::search::greatest;
use crate::math::chebyshev::Series;
use crate::model::Expr;
use crate::position::Model;
use std::cell::RefCell;

/// The fewest parts of a series.
const FEWEST: f64 = 8.0;

/// Numbers that have their points at the same places.
#[derive(Clone, Debug, Default)]
pub struct CourseSet {
    pub exprs: Vec<Expr>,
    /// What is no greater than this is rounding, SI.
    pub rounding: f64,
}

/// The courses of numbers, set by set, and where every event happens: values of the drive, or instants.
#[derive(Clone, Debug, Default)]
pub struct Courses {
    pub sets: Vec<Vec<Course>>,
    pub events: Vec<Vec<f64>>,
}

/// A part of a number without a gap.
#[derive(Clone, Debug)]
pub(crate) enum Piece {
    Series(Vec<Series>),
    /// Places and values. Two at one place are a jump.
    Points(Vec<(f64, f64)>),
}

/// A number over a sweep or a motion.
#[derive(Clone, Debug, Default)]
pub struct Course {
    pub(crate) pieces: Vec<Piece>,
    /// Where it may jump.
    pub(crate) breaks: Vec<f64>,
    pub(crate) unbounded: Vec<Pole>,
    /// First value and length of what its places count from 0 to 1: of the sweep of the first drive, rad or m; 0 and 1 where that is a
    /// point, and of a motion, whose places are instants, s.
    pub interval: (f64, f64),
    /// Where it is least, as a value of the drive or an instant, and what it is there; none where it has no bound or no value.
    pub least: Option<(f64, f64)>,
    /// Where it is greatest.
    pub greatest: Option<(f64, f64)>,
    /// What is worth seeing of it; all of it where it has no poles.
    pub window: (f64, f64),
}

/// The courses of numbers over the sweep, or over the motion, of a solved file.
///
/// # Errors
/// There is no sweep, or the motion does not begin.
pub fn courses(model: &Model<'_>, solution: &Solution, sets: &[CourseSet]) -> Result<Courses, Cause> {
    if let (Some(simulation), Some(solved)) = (&model.mechanism.simulation, &solution.simulation) {
        return over_time(model, solution, (simulation, solved), sets).map_err(|failure| failure.cause);
    }
    let statics = &solution.statics;
    // the courses run over the first drive
    let events = statics.swept.as_ref().filter(|swept| swept.drive == 0).map(|_| statics.events.clone());
    Ok(Courses { sets: over_sweep(model, statics, sets)?, events: events.unwrap_or_default() })
}

impl Course {
    /// Its lines: values of the drive and of the number, with at least `parts` steps over the whole range where it is smooth.
    #[must_use]
    pub fn lines(&self, parts: f64) -> Vec<Vec<(f64, f64)>> {
        let line = |piece: &Piece| match piece {
            Piece::Series(panels) => self.points(panels, parts),
            Piece::Points(points) => points.iter().map(|(s, y)| (self.value(*s), *y)).collect(),
        };
        self.pieces.iter().map(line).collect()
    }

    fn points(&self, panels: &[Series], parts: f64) -> Vec<(f64, f64)> {
        let mut all = Vec::new();
        for panel in panels {
            let count = ((panel.to - panel.from) * parts).ceil().max(FEWEST);
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

    /// The number at a value of the drive, or at an instant; none where it has none.
    #[must_use]
    pub fn at(&self, drive: f64) -> Option<f64> {
        let s = (drive - self.interval.0) / self.interval.1;
        // an end of the way is one of it whatever the rounding
        let slack = 1e-12;
        let within = |from: f64, to: f64| s >= from - slack && s <= to + slack;
        self.pieces.iter().find_map(|piece| match piece {
            Piece::Series(panels) => {
                let panel = panels.iter().find(|panel| within(panel.from, panel.to))?;
                Some(panel.value(s.clamp(panel.from, panel.to)))
            }
            Piece::Points(points) => {
                let (first, last) = (points.first()?, points.last()?);
                if !within(first.0, last.0) {
                    return None;
                }
                let after = points.partition_point(|point| point.0 < s).clamp(1, points.len() - 1);
                Some(self.between(points[after - 1], points[after], s))
            }
        })
    }

    /// Between two points; beyond what is shown by the reciprocal, which is nearly straight beside a pole.
    fn between(&self, (from, a): (f64, f64), (to, b): (f64, f64), s: f64) -> f64 {
        let share = if to > from { ((s - from) / (to - from)).clamp(0.0, 1.0) } else { 0.0 };
        let (low, high) = self.window;
        if (a > high && b > high) || (a < low && b < low) {
            return 1.0 / (1.0 / a + (1.0 / b - 1.0 / a) * share);
        }
        a + (b - a) * share
    }

    /// Where it has no bound: values of the drive, and the sign of the number on either side, 0 where the way ends.
    pub fn poles(&self) -> impl Iterator<Item = (f64, [f64; 2])> + '_ {
        self.unbounded.iter().map(|pole| (self.value(0.5 * (pole.from + pole.to)), pole.signs))
    }

    /// Values of the drive where it passes through a level, in order; a jump through it is one. Of what is no series none.
    #[must_use]
    pub fn crossings(&self, level: f64) -> Vec<f64> {
        let mut all: Vec<f64> = Vec::new();
        let mut before: Option<f64> = None;
        let panels = self.pieces.iter().filter_map(|piece| match piece {
            Piece::Series(panels) => Some(panels),
            Piece::Points(_) => None,
        });
        for panel in panels.flatten() {
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

    pub(crate) fn value(&self, s: f64) -> f64 {
        self.interval.0 + self.interval.1 * s
    }

    /// The courses of `count` numbers by places that are near enough to one another; breaks are known places where they may jump or
    /// grow without bound.
    pub(crate) fn by_places(
        places: &mut Places<'_>,
        interval: (f64, f64),
        count: usize,
        (breaks, turns): (&[f64], f64),
    ) -> Vec<Self> {
        let Some(found) = refined(places, count, breaks, turns) else {
            return vec![Self { interval, ..Self::default() }; count];
        };
        let mut all = Vec::new();
        for (which, look) in found.looks.into_iter().enumerate() {
            let mut point = |s: &f64| (*s, places.at(*s, which));
            let points: Vec<Vec<(f64, f64)>> =
                found.pieces.iter().map(|piece| piece.iter().map(&mut point).collect()).collect();
            let (breaks, window) = (breaks.to_vec(), look.window);
            let mut course = Self { breaks, unbounded: look.poles, interval, window, ..Self::default() };
            course.least = course.extreme(places, &points, (which, -1.0));
            course.greatest = course.extreme(places, &points, (which, 1.0));
            course.pieces = points.into_iter().map(Piece::Points).collect();
            all.push(course);
        }
        all
    }

    /// The greatest of points times a sign, with what is between them; none where there is a pole on that side.
    fn extreme(
        &self,
        places: &mut Places<'_>,
        pieces: &[Vec<(f64, f64)>],
        (which, sign): (usize, f64),
    ) -> Option<(f64, f64)> {
        if self.unbounded.iter().any(|pole| pole.signs.contains(&sign)) {
            return None;
        }
        let mut best: Option<([f64; 2], (f64, f64))> = None;
        for piece in pieces {
            for (i, point) in piece.iter().enumerate() {
                if best.is_none_or(|(_, most)| sign * point.1 > sign * most.1) {
                    let around = [i.saturating_sub(1), (i + 1).min(piece.len() - 1)].map(|i| piece[i].0);
                    best = Some((around, *point));
                }
            }
        }
        let ([from, to], mut found) = best?;
        let places = RefCell::new(places);
        let (at, most) = greatest(from, to, &|s| sign * places.borrow_mut().at(s, which));
        if most > sign * found.1 {
            found = (at, sign * most);
        }
        Some((self.value(found.0), found.1))
    }
}
