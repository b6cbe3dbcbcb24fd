//! Numbers over a motion under loads as they run, for pictures.

use super::SimulationReport;
use super::functions::OverRun;
use super::options::{Drawn, IntegrationOptions};
use super::trajectory::trajectory;
use crate::math::chebyshev::roots;
use crate::math::lobatto::Short;
use crate::model::{BinaryOp, Cycle, CycleFunction, Expr, Function, Mechanism, Part, Query, Simulation};
use crate::position::{Model, PoseOrigin, State};
use crate::solve::course::{Course, CourseSet, Courses, Piece, Places};
use crate::solve::cycle::denominators;
use crate::solve::failure::Failure;
use crate::solve::inputs::Rates;
use crate::solve::positions::Sweep;
use crate::solve::solution::Solution;
use crate::source::Span;

/// Points of a course over the whole motion at least, apart from those where its series meet.
const PARTS: f64 = 960.0;
/// The fewest of a series.
const FEWEST: f64 = 4.0;
/// What a picture shows.
const WITHIN: f64 = 1e-6;
/// What series leave off of that.
const SMOOTH: f64 = 0.1 * WITHIN;

/// Numbers that differ by less, relative to the greatest, are the same; of several extremes the first is reported.
const ROUNDING: f64 = 1e-12;
const SAME: f64 = 1e-5;

/// The lines through the series of a number over a motion of this length, s.
fn through(series: &[Short], length: f64) -> Vec<Vec<(f64, f64)>> {
    let mut lines: Vec<Vec<(f64, f64)>> = vec![Vec::new()];
    for part in series {
        let count = (PARTS * (part.to - part.from) / length).ceil().clamp(FEWEST, PARTS);
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
    lines
}

/// The first instant at which the series have an extreme that is as good as the one found but for what is small; numbers up to `most`.
fn first(series: &[Short], (most, small): (f64, f64), (sign, found): (f64, &OverRun)) -> Option<(f64, f64)> {
    // numbers from −small to small are 0
    let same = (2.0 * small).max(SAME * most);
    let turns = turns(series, ROUNDING * most);
    let rises = |i: usize| i == 0 || sign * turns[i - 1].1 < sign * turns[i].1;
    let falls = |i: usize| i + 1 == turns.len() || sign * turns[i + 1].1 < sign * turns[i].1;
    let as_good = |i: &usize| sign * turns[*i].1 >= sign * found.value - same;
    let stays = (0..turns.len()).all(|i| as_good(&i));
    let first = (0..turns.len()).filter(as_good).find(|&i| stays || rises(i) && falls(i));
    let at = first.map_or(found.at, |i| turns[i].0);
    (at.is_finite() && found.value.is_finite()).then_some((at, found.value))
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

/// The courses of numbers over the motion of a solved file, set by set: one run more, as accurate as is seen, and another one for those
/// that have no bound somewhere.
///
/// # Errors
/// The motion does not begin.
pub(crate) fn over_time(
    model: &Model<'_>,
    solution: &Solution,
    motion: (&Simulation, &SimulationReport),
    sets: &[CourseSet],
) -> Result<Courses, Failure> {
    let asked: Vec<(&Expr, f64)> =
        sets.iter().flat_map(|set| set.exprs.iter().map(|e| (e, set.rounding))).collect();
    let divisors: Vec<Vec<Expr>> = asked.iter().map(|(e, _)| denominators(model.mechanism, e)).collect();
    let mut all = vec![Course::default(); asked.len()];
    // what has no bound somewhere stops a run: first what it is divided by
    let first = asked.iter().zip(&divisors).flat_map(|((expr, rounding), by)| match by.as_slice() {
        [] => extremes(expr, *rounding),
        by => by.iter().map(|by| (cycle(by, CycleFunction::Mean), 0.0)).collect(),
    });
    let run = Run::of(model, solution, motion, first.collect())?;
    let mut zeros: Vec<Vec<f64>> = vec![Vec::new(); asked.len()];
    let mut next = 0;
    for (i, by) in divisors.iter().enumerate() {
        if by.is_empty() {
            all[i] = run.course(next, asked[i].1);
            next += 2;
        } else {
            zeros[i] = run.series.iter().skip(next).take(by.len()).flat_map(|s| crossings(s)).collect();
            zeros[i].sort_by(f64::total_cmp);
            next += by.len();
        }
    }
    if divisors.iter().any(|by| !by.is_empty()) {
        let second = (0..asked.len()).filter(|i| !divisors[*i].is_empty()).flat_map(|i| {
            let (expr, rounding) = asked[i];
            if zeros[i].is_empty() {
                extremes(expr, rounding)
            } else {
                quotient(model.mechanism, expr, &divisors[i])
            }
        });
        let run = Run::of(model, solution, motion, second.collect())?;
        let mut next = 0;
        for (i, by) in divisors.iter().enumerate().filter(|(_, by)| !by.is_empty()) {
            if zeros[i].is_empty() {
                all[i] = run.course(next, asked[i].1);
                next += 2;
            } else {
                all[i] = run.unbounded((next, by.len()), (&zeros[i], asked[i].1));
                next += 1 + by.len();
            }
        }
    }
    let mut all = all.into_iter();
    let sets = sets.iter().map(|set| all.by_ref().take(set.exprs.len()).collect()).collect();
    Ok(Courses { sets, events: motion.1.events.clone() })
}

/// Where a number is least and greatest, with what is rounding of it.
fn extremes(expr: &Expr, rounding: f64) -> Vec<(Cycle, f64)> {
    [CycleFunction::Min, CycleFunction::Max].map(|how| (cycle(expr, how), rounding)).to_vec()
}

/// A number times what it is divided by, which has a bound, and that.
fn quotient(mechanism: &Mechanism, expr: &Expr, by: &[Expr]) -> Vec<(Cycle, f64)> {
    let product = by.iter().fold(expr.clone(), |all, by| times(mechanism, &all, by));
    std::iter::once(&product).chain(by).map(|expr| (cycle(expr, CycleFunction::Mean), 0.0)).collect()
}

/// A number times one that it may be divided by, reduced: it has a value where that is zero.
fn times(mechanism: &Mechanism, expr: &Expr, by: &Expr) -> Expr {
    let both = |op, a, b| Expr::Binary(op, Box::new(a), Box::new(b));
    let times = |a: &Expr| times(mechanism, a, by);
    let divided = |a: &Expr| denominators(mechanism, a).contains(by);
    match expr {
        _ if !divided(expr) => both(BinaryOp::Mul, expr.clone(), by.clone()),
        Expr::Quantity(id) => times(&mechanism.quantities[id.index()].expr),
        Expr::Negate(a) => Expr::Negate(Box::new(times(a))),
        Expr::Binary(BinaryOp::Div, a, b) if **b == *by => (**a).clone(),
        Expr::Binary(BinaryOp::Div, a, b) => both(BinaryOp::Div, times(a), (**b).clone()),
        Expr::Binary(BinaryOp::Mul, a, b) if divided(a) => both(BinaryOp::Mul, times(a), (**b).clone()),
        Expr::Binary(BinaryOp::Mul, a, b) => both(BinaryOp::Mul, (**a).clone(), times(b)),
        Expr::Binary(op, a, b) => both(*op, times(a), times(b)),
        Expr::Call(Function::Tan, of) => Expr::Call(Function::Sin, of.clone()),
        Expr::Query(Query::CurvatureRadius(point)) => {
            let speed = Expr::Call(Function::Mag, vec![Expr::Query(Query::Velocity(*point))]);
            Expr::Power(Box::new(speed), Box::new(Expr::number(3.0)))
        }
        _ => both(BinaryOp::Mul, expr.clone(), by.clone()),
    }
}

fn cycle(expr: &Expr, how: CycleFunction) -> Cycle {
    Cycle { span: Span::default(), how, expr: expr.clone(), dimension: [0; 3], part: Part::default() }
}

/// The number that series are at an instant.
fn value(series: &[Short], t: f64) -> f64 {
    let after = series.partition_point(|part| part.to < t).min(series.len().saturating_sub(1));
    series.get(after).map_or(f64::NAN, |part| part.value(t))
}

/// Where series pass through zero.
fn crossings(series: &[Short]) -> Vec<f64> {
    let mut all = Vec::new();
    for part in series {
        roots((part.from, part.to), part.coefficients(), |t| all.push(t));
    }
    all
}

/// Functions over the motion once more.
struct Run {
    between: (f64, f64),
    series: Vec<Vec<Short>>,
    found: Vec<OverRun>,
}

impl Run {
    /// Of functions, each with what is rounding of it.
    fn of(
        model: &Model<'_>,
        solution: &Solution,
        (simulation, solved): (&Simulation, &SimulationReport),
        functions: Vec<(Cycle, f64)>,
    ) -> Result<Self, Failure> {
        let mut mechanism = model.mechanism.clone();
        let within = simulation.within.unwrap_or(WITHIN).max(WITHIN);
        let simulation = Simulation { within: Some(within), ..simulation.clone() };
        mechanism.expects.clear();
        let roundings: Vec<f64> = functions.iter().map(|function| function.1).collect();
        mechanism.cycles = functions.into_iter().map(|function| function.0).collect();
        let model = Model { mechanism: &mechanism, ..*model };
        let start = first_state(solution).filter(|_| simulation.steady.is_none());
        let looser = (WITHIN / solved.within).max(1.0);
        let alone = Some(solved.tolerance * looser);
        let drawn = Some(Drawn { smooth: SMOOTH, roundings: &roundings, start });
        let conduct = IntegrationOptions { alone, drawn, ..IntegrationOptions::default() };
        let statics = &solution.statics;
        let first = Sweep::of(&model, statics).at(0).drives;
        let found = trajectory(&model, statics, &Rates::of(&model, statics), &first, &simulation, &conduct)?;
        Ok(Self { between: (found.from, found.report.end), series: found.courses, found: found.functions })
    }

    /// The course of the quotient of a function and of the `count` functions that follow it, which are zero at these instants.
    fn unbounded(&self, (index, count): (usize, usize), (zeros, rounding): (&[f64], f64)) -> Course {
        let Some([product, by @ ..]) = self.series.get(index..=index + count) else {
            return Course::default();
        };
        let mut path = |t: f64, out: &mut Vec<f64>| {
            out.push(value(product, t) / by.iter().map(|series| value(series, t)).product::<f64>());
        };
        let mut places = Places::new(self.between, rounding, &mut path);
        Course::by_places(&mut places, (0.0, 1.0), 1, (zeros, 0.0)).pop().unwrap_or_default()
    }

    /// The course of the number whose least and greatest are these functions; nothing of a run that stopped where it began.
    fn course(&self, index: usize, rounding: f64) -> Course {
        let extremes = self.found.get(index..index + 2);
        let (Some(series), Some(extremes)) = (self.series.get(index), extremes) else {
            return Course::default();
        };
        let mut lines = through(series, self.between.1 - self.between.0);
        let most = lines.iter().flatten().fold(0.0_f64, |most, point| most.max(point.1.abs()));
        let small = rounding.max(SMOOTH * most);
        let [mut least, mut greatest] =
            [(-1.0, &extremes[0]), (1.0, &extremes[1])].map(|extreme| first(series, (most, small), extreme));
        let numbers = lines.iter_mut().flatten().chain([&mut least, &mut greatest].into_iter().flatten());
        numbers.filter(|point| point.1.abs() <= small).for_each(|point| point.1 = 0.0);
        let seen = lines.iter().flatten().chain([&least, &greatest].into_iter().flatten());
        let window = seen.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), p| (a.min(p.1), b.max(p.1)));
        let pieces = lines.into_iter().map(Piece::Points).collect();
        Course { pieces, least, greatest, window, interval: (0.0, 1.0), ..Course::default() }
    }
}

/// The state at the first instant.
fn first_state(solution: &Solution) -> Option<&State> {
    let first = solution.poses.first().filter(|pose| pose.origin == PoseOrigin::Sweep(0))?;
    first.outcome.as_ref().ok().map(|solved| &solved.state)
}
