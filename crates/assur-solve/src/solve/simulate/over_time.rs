//! Numbers over a motion under loads as they run, for pictures.

use super::functions::OverRun;
use super::options::{Drawn, IntegrationOptions};
use super::trajectory::trajectory;
use crate::math::lobatto::Short;
use crate::model::{Cycle, CycleFunction, Expr, Part, Simulation};
use crate::position::{Model, PoseOrigin, State};
use crate::solve::failure::Failure;
use crate::solve::inputs::Rates;
use crate::solve::positions::Sweep;
use crate::solve::solution::Solution;
use crate::source::Span;

/// Points of a course over the whole motion at least, apart from those where its series meet.
const PARTS: f64 = 960.0;
/// What a picture shows.
const WITHIN: f64 = 1e-6;
/// What series leave off of that.
const SMOOTH: f64 = 0.1 * WITHIN;

/// Numbers that differ by less, relative to the greatest, are the same; of several extremes the first is reported.
const ROUNDING: f64 = 1e-12;
const SAME: f64 = 1e-5;

/// A number over a motion.
#[derive(Clone, Debug, Default)]
pub struct TimeCourse {
    /// Instants, s, and the number there; apart where it has no value.
    pub lines: Vec<Vec<(f64, f64)>>,
    /// Where it is least, s, and what it is there, between the instants too.
    pub least: (f64, f64),
    /// Where it is greatest.
    pub greatest: (f64, f64),
}

/// What is drawn over a motion.
#[derive(Clone, Debug, Default)]
pub struct OverTime {
    pub courses: Vec<TimeCourse>,
    /// Instants of every event, s.
    pub events: Vec<Vec<f64>>,
}

impl TimeCourse {
    /// Through the series of a number over a motion of this length, s.
    fn through(series: &[Short], length: f64) -> Self {
        let mut lines: Vec<Vec<(f64, f64)>> = vec![Vec::new()];
        for part in series {
            let count = (PARTS * (part.to - part.from) / length).ceil().clamp(1.0, PARTS);
            let mut line = lines.pop().unwrap_or_default();
            let mut place = 0.0;
            while place <= count {
                let t = part.from + (part.to - part.from) * (place / count);
                let value = part.value(t);
                if value.is_finite() {
                    line.push((t, value));
                }
                place += 1.0;
            }
            let ends = !part.tail().is_finite();
            lines.push(line);
            if ends {
                lines.push(Vec::new());
            }
        }
        lines.retain(|line| line.len() > 1);
        Self { lines, ..Self::default() }
    }

    fn most(&self) -> f64 {
        self.lines.iter().flatten().fold(0.0_f64, |most, point| most.max(point.1.abs()))
    }

    /// With 0 for what is no greater than this.
    fn cleared(mut self, small: f64) -> Self {
        let numbers = self.lines.iter_mut().flatten().chain([&mut self.least, &mut self.greatest]);
        numbers.filter(|point| point.1.abs() <= small).for_each(|point| point.1 = 0.0);
        self
    }

    /// The first instant at which the series have an extreme that is as good as the one found but for what is small.
    fn first(&self, series: &[Short], small: f64, (sign, found): (f64, &OverRun)) -> (f64, f64) {
        let most = self.most();
        // numbers from −small to small are 0
        let same = (2.0 * small).max(SAME * most);
        let turns = turns(series, ROUNDING * most);
        let rises = |i: usize| i == 0 || sign * turns[i - 1].1 < sign * turns[i].1;
        let falls = |i: usize| i + 1 == turns.len() || sign * turns[i + 1].1 < sign * turns[i].1;
        let as_good = |i: &usize| sign * turns[*i].1 >= sign * found.value - same;
        let stays = (0..turns.len()).all(|i| as_good(&i));
        let first = (0..turns.len()).filter(as_good).find(|&i| stays || rises(i) && falls(i));
        (first.map_or(found.at, |i| turns[i].0), found.value)
    }
}

/// Where series begin, turn and end, s, and what they are there; of what stays but for rounding the first instant.
fn turns(series: &[Short], rounding: f64) -> Vec<(f64, f64)> {
    let mut all: Vec<(f64, f64)> = Vec::new();
    let mut add = |t: f64, x: f64| {
        if x.is_finite() && all.last().is_none_or(|last| (last.1 - x).abs() > rounding) {
            all.push((t, x));
        }
    };
    for part in series {
        add(part.from, part.value(part.from));
        part.turns(&mut add);
        add(part.to, part.value(part.to));
    }
    all
}

/// Numbers over the motion of a solved file, each with what is rounding of it: one run more, as accurate as is seen. Of a file without
/// a motion nothing.
///
/// # Errors
/// The motion does not begin.
pub fn over_time(
    model: &Model<'_>,
    solution: &Solution,
    exprs: &[(Expr, f64)],
) -> Result<Option<OverTime>, Failure> {
    let Some(solved) = &solution.simulation else { return Ok(None) };
    let mut mechanism = model.mechanism.clone();
    let Some(simulation) = mechanism.simulation.clone() else { return Ok(None) };
    let within = simulation.within.unwrap_or(WITHIN).max(WITHIN);
    let simulation = Simulation { within: Some(within), ..simulation };
    mechanism.expects.clear();
    let cycle = |expr: &Expr, how| Cycle {
        span: Span::default(),
        how,
        expr: expr.clone(),
        dimension: [0; 3],
        part: Part::default(),
    };
    let extremes =
        |(expr, _): &(Expr, f64)| [CycleFunction::Min, CycleFunction::Max].map(|how| cycle(expr, how));
    mechanism.cycles = exprs.iter().flat_map(extremes).collect();
    let model = Model { mechanism: &mechanism, ..*model };
    let roundings: Vec<f64> = exprs.iter().flat_map(|(_, rounding)| [*rounding; 2]).collect();
    let start = first_state(solution).filter(|_| simulation.steady.is_none());
    let looser = (WITHIN / solved.within).max(1.0);
    let alone = Some(solved.tolerance * looser);
    let drawn = Some(Drawn { smooth: SMOOTH, roundings: &roundings, start });
    let conduct = IntegrationOptions { alone, drawn, ..IntegrationOptions::default() };
    let statics = &solution.statics;
    let first = Sweep::of(&model, statics).at(0).drives;
    let found = trajectory(&model, statics, &Rates::of(&model, statics), &first, &simulation, &conduct)?;
    let length = found.report.end - found.from;
    let pairs = found.courses.chunks_exact(2).zip(found.functions.chunks_exact(2));
    let courses = pairs.zip(exprs).map(|((series, extremes), (_, rounding))| {
        let course = TimeCourse::through(&series[0], length);
        let small = rounding.max(SMOOTH * course.most());
        let [least, greatest] = [(-1.0, &extremes[0]), (1.0, &extremes[1])]
            .map(|extreme| course.first(&series[0], small, extreme));
        TimeCourse { least, greatest, ..course }.cleared(small)
    });
    Ok(Some(OverTime { courses: courses.collect(), events: solved.events.clone() }))
}

/// The state at the first instant.
fn first_state(solution: &Solution) -> Option<&State> {
    let first = solution.poses.first().filter(|pose| pose.origin == PoseOrigin::Sweep(0))?;
    first.outcome.as_ref().ok().map(|solved| &solved.state)
}
