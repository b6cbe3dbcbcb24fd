//! Numbers over a motion under loads as they run, for pictures.

use super::conduct::Conduct;
use super::report::SimulationReport;
use crate::model::{Cycle, CycleFunction, Expr, Part, Value};
use crate::position::{Model, PoseOrigin};
use crate::solve::failure::Failure;
use crate::solve::solution::Solution;
use crate::solve::sweep::Following;
use crate::source::Span;

/// Instants of a course at least, with the first.
const STEPS: usize = 480;
/// What a picture shows.
const WITHIN: f64 = 1e-7;

/// Numbers that differ by less, relative to the greatest, are the same; extremes of one run.
const ROUNDING: f64 = 1e-12;
const SAME: f64 = 1e-6;

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
    /// The numbers.
    pub courses: Vec<TimeCourse>,
    /// Instants of every event, s.
    pub events: Vec<Vec<f64>>,
}

impl TimeCourse {
    /// An extreme where it stands, or at the first instant that has it but for rounding.
    fn at_once(&self, time: f64, value: f64) -> (f64, f64) {
        let points = || self.lines.iter().flatten();
        let most = points().fold(0.0_f64, |most, point| most.max(point.1.abs()));
        let first = points().find(|point| (point.1 - value).abs() <= ROUNDING * most);
        first.filter(|point| point.0 < time).copied().unwrap_or((time, value))
    }
}

/// Numbers over the motion of a solved file, one after another, from what it says of itself: one run more, as accurate as is seen.
/// Of a file without a motion nothing.
///
/// # Errors
/// The motion does not begin.
pub fn over_time(
    model: &Model<'_>,
    solved: Option<&SimulationReport>,
    exprs: &[Expr],
) -> Result<Option<OverTime>, Vec<Failure>> {
    let Some(solved) = solved else { return Ok(None) };
    let mut mechanism = model.mechanism.clone();
    let Some(simulation) = &mut mechanism.simulation else { return Ok(None) };
    let own = simulation.steps.unwrap_or(1).max(1);
    simulation.steps = Some(own * STEPS.div_ceil(own));
    simulation.within = Some(simulation.within.unwrap_or(WITHIN).max(WITHIN));
    mechanism.expects.clear();
    let known = mechanism.cycles.len();
    for expr in exprs {
        for how in [CycleFunction::Min, CycleFunction::Max] {
            let (span, part) = (Span::default(), Part::default());
            mechanism.cycles.push(Cycle { span, how, expr: expr.clone(), part });
        }
    }
    let model = Model { mechanism: &mechanism, ..*model };
    let looser = (WITHIN / solved.within).max(1.0);
    let alone = Some(solved.tolerance * looser);
    let conduct = Conduct { alone, same: SAME, ..Conduct::default() };
    let Some(mut following) = Following::conducted(&model, Vec::new(), &conduct)? else { return Ok(None) };
    let mut poses = Vec::with_capacity(following.positions());
    while let Some(pose) = following.next() {
        poses.push(pose.map_err(|e| vec![e])?);
    }
    let solution = Solution { poses, ..following.end() };
    let mut courses = vec![TimeCourse { lines: vec![Vec::new()], ..TimeCourse::default() }; exprs.len()];
    for pose in solution.poses.iter().filter(|pose| matches!(pose.origin, PoseOrigin::Sweep(_))) {
        let Ok(solved) = &pose.outcome else { continue };
        let (view, time) = (solution.view(&model, solved), solved.state.motion.time);
        for (course, expr) in courses.iter_mut().zip(exprs) {
            match view.value(expr) {
                Value::Scalar(y) if y.is_finite() => {
                    course.lines.last_mut().into_iter().for_each(|line| line.push((time, y)));
                }
                _ => course.lines.push(Vec::new()),
            }
        }
    }
    let found = solution.statics.cycles.get(known..).unwrap_or_default();
    for (course, extremes) in courses.iter_mut().zip(found.chunks_exact(2)) {
        course.lines.retain(|line| line.len() > 1);
        course.least = course.at_once(extremes[0].at, extremes[0].value);
        course.greatest = course.at_once(extremes[1].at, extremes[1].value);
    }
    let events = solution.simulation.map(|report| report.events).unwrap_or_default();
    Ok(Some(OverTime { courses, events }))
}
