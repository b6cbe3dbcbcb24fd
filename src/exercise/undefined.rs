//! Why a value does not exist.

use assur_model::model::{Bound, Expr, PairId, Query, Value};
use assur_solve::answer::{Nearest, Swept};
use assur_solve::message::undefined;
use assur_solve::solve::{Model, Pose, PoseAnswers, Solution, compare};
use assur_text::units::Dimension;

/// Digits in a sentence.
const DIGITS: usize = 4;
/// What changes by a lesser part between two printed instants has come to rest.
const SETTLED: f64 = 1e-4;

/// Whether a condition holds; `None` where that depends on a value that does not exist.
pub(super) fn truth(view: &PoseAnswers<'_>, expr: &Expr) -> Option<bool> {
    match expr {
        Expr::Compare(how, a, b) => match (view.value(a), view.value(b)) {
            (Value::Scalar(a), Value::Scalar(b)) if a.is_finite() && b.is_finite() => {
                Some(compare(*how, a, b))
            }
            _ => None,
        },
        Expr::Not(a) => truth(view, a).map(|t| !t),
        Expr::And(a, b) => match (truth(view, a), truth(view, b)) {
            (Some(false), _) | (_, Some(false)) => Some(false),
            (a, b) => Some(a? && b?),
        },
        Expr::Or(a, b) => match (truth(view, a), truth(view, b)) {
            (Some(true), _) | (_, Some(true)) => Some(true),
            (a, b) => Some(a? || b?),
        },
        Expr::Quantity(id) => truth(view, &view.mechanism.quantities.get(id.index())?.expr),
        Expr::Frictionless(a) => truth(&view.without_friction(), a),
        Expr::Query(Query::Locked) if !view.efficiency().is_finite() => None,
        _ => match view.value(expr) {
            Value::Bool(t) => Some(t),
            _ => None,
        },
    }
}

/// Why an expression has no value, where the structure says so.
#[must_use]
pub fn why_undefined(model: &Model<'_>, expr: &Expr) -> Option<String> {
    if let Expr::Quantity(id) = expr {
        return why_undefined(model, &model.mechanism.quantities.get(id.index())?.expr);
    }
    let mut why = None;
    expr.queries(&mut |query| {
        if let Query::Critical(index) = query
            && let Some(name) = model.mechanism.criticals.get(*index)
        {
            why = Some(format!("no value of `{name}` within its range is a limit of locking"));
        }
        let open = &model.structure.undetermined_couples;
        let pair = match query {
            Query::Internal(asked) => {
                let of_link =
                    |pair: &&PairId| model.mechanism.pair(**pair).kind.links().contains(&asked.link);
                open.iter().find(of_link).copied()
            }
            _ => query.facts().couple.filter(|pair| open.contains(pair)),
        };
        if let Some(pair) = pair {
            let name = &model.mechanism.pair(pair).name;
            why = Some(format!(
                "the couple in `{name}` is not determined: the pair closes a chain of prismatic pairs"
            ));
        }
    });
    why
}

/// Why a function has no value: its quantity, or an end of its part of the motion.
fn no_cycle(model: &Model<'_>, solution: &Solution, index: usize) -> Option<String> {
    let why = solution.statics.cycles.get(index).and_then(|c| c.why);
    let part = model.mechanism.cycles.get(index).map(|cycle| cycle.part);
    let bounds = part.into_iter().flat_map(|part| [part.after, part.before]).flatten();
    let mut missing = bounds.filter_map(|bound| match bound {
        Bound::Event(event, which) => not_happened(model, solution, event, which),
        Bound::At(_) => None,
    });
    why.map(|why| undefined(model, why)).or_else(|| missing.next())
}

/// Why a function over the sweep or the motion, or the instant of an event, in an expression has no value.
pub(super) fn without_cycle(model: &Model<'_>, solution: &Solution, expr: &Expr) -> Option<String> {
    let mut why = None;
    expr.parts(&mut |part| {
        let found = match part {
            Expr::Quantity(id) => {
                let quantity = model.mechanism.quantities.get(id.index());
                quantity.and_then(|q| without_cycle(model, solution, &q.expr))
            }
            Expr::Query(Query::Cycle(index)) => no_cycle(model, solution, *index),
            Expr::Query(Query::EventTime(event, which) | Query::EventDrive(event, which)) => {
                not_happened(model, solution, *event, *which)
            }
            _ => None,
        };
        why = why.take().or(found);
    });
    why
}

/// Why an event has no instant.
pub(super) fn not_happened(
    model: &Model<'_>,
    solution: &Solution,
    event: usize,
    which: usize,
) -> Option<String> {
    let happened = solution.statics.events.get(event)?.len();
    let name = model.mechanism.events.get(event)?.name.as_deref().unwrap_or("until");
    let times = match happened {
        0 => "does not happen".to_owned(),
        1 => "happens once".to_owned(),
        n => format!("happens {n} times"),
    };
    let during = match (&solution.simulation, &solution.statics.swept) {
        (Some(run), _) => {
            let missing = match printed(model, solution, event).filter(|_| happened == 0) {
                Some(Printed { missing, at, .. }) => format!(": at {at} {missing} are missing"),
                None => String::new(),
            };
            format!("until {}{missing}", instant(model, run.end))
        }
        (None, Some(swept)) => {
            let nearest = if happened == 0 { nearest(model, swept, event) } else { String::new() };
            let [from, to] = [swept.from, swept.to].map(|x| drive_value(model, swept, x));
            format!("between {from} and {to}{nearest}")
        }
        (None, None) => return None,
    };
    (happened < which).then(|| format!("the event `{name}` {times} {during}"))
}

fn instant(model: &Model<'_>, time: f64) -> String {
    format!("{} {}", model.mechanism.instant_text(time), model.mechanism.display_of(Dimension::TIME).unit)
}

/// The printed instant of a motion at which an event comes nearest to happening.
struct Printed {
    at: String,
    /// What is missing there, with its unit.
    missing: String,
    /// It comes no nearer at the end of the motion.
    settled: bool,
}

fn printed(model: &Model<'_>, solution: &Solution, event: usize) -> Option<Printed> {
    let asked = &model.mechanism.events[event];
    let dimension = asked.dimension.filter(|d| *d != [0; 3] && asked.situation.is_none())?;
    let value = |pose: &Pose| {
        let solved = pose.outcome.as_ref().ok()?;
        match solution.view(model, solved).value(&asked.value) {
            Value::Scalar(x) if x.is_finite() => Some((x.abs(), solved.state.motion.time)),
            _ => None,
        }
    };
    let seen = solution.poses.iter().filter_map(value).collect::<Vec<_>>();
    let (least, at) = seen.iter().copied().min_by(|a, b| a.0.total_cmp(&b.0)).filter(|(x, _)| *x > 0.0)?;
    let missing = amount(model, dimension, least);
    let settled = match seen.as_slice() {
        [.., (a, _), (b, _)] => (a - b).abs() <= SETTLED * least && *b - least <= SETTLED * least,
        _ => false,
    };
    let at = seen.last().filter(|_| settled).map_or(at, |(_, time)| *time);
    Some(Printed { at: instant(model, at), missing, settled })
}

/// A number with its unit; 1/s is the unit of speeds of what turns.
fn amount(model: &Model<'_>, [length, mass, time]: [i8; 3], value: f64) -> String {
    let dimension = match [length, mass, time] {
        [0, 0, -1] => Dimension::ANGULAR_VELOCITY,
        _ => Dimension { length, mass, time, ..Dimension::NUMBER },
    };
    model.mechanism.display_of(dimension).text(Value::Scalar(value), DIGITS)
}

/// Whether a longer motion would not come nearer to an event that an expression names.
pub(super) fn is_settled(model: &Model<'_>, solution: &Solution, expr: &Expr) -> bool {
    if let Expr::Quantity(id) = expr {
        let quantity = model.mechanism.quantities.get(id.index());
        return quantity.is_some_and(|q| is_settled(model, solution, &q.expr));
    }
    let mut settled = false;
    expr.queries(&mut |query| {
        if let Query::EventTime(event, _) | Query::EventDrive(event, _) = query {
            let happens = solution.statics.events.get(*event).is_some_and(|all| !all.is_empty());
            settled |= !happens && printed(model, solution, *event).is_some_and(|p| p.settled);
        }
    });
    settled
}

fn drive_value(model: &Model<'_>, swept: &Swept, value: f64) -> String {
    let target = model.mechanism.drives[swept.drive].target;
    model.mechanism.drive_display(target).text(Value::Scalar(value), DIGITS)
}

/// How near an event comes to happening.
fn nearest(model: &Model<'_>, swept: &Swept, event: usize) -> String {
    let place = |at: f64| drive_value(model, swept, at);
    let event_asked = &model.mechanism.events[event];
    match (swept.nearest[event], event_asked.dimension) {
        (Nearest::Later(at), _) => format!(": it would happen at {}, after the end of the sweep", place(at)),
        (Nearest::Reached(at), _) if at == swept.from => {
            format!(": what holds at {}, where the sweep begins, does not count", place(at))
        }
        (Nearest::Reached(at), _) if event_asked.rising.is_some() => {
            format!(": its value is reached at {}, but not passed in this direction", place(at))
        }
        (Nearest::Reached(at), _) => format!(": its value is reached at {}, but not passed", place(at)),
        (Nearest::Missing(least, _), _) if !least.is_finite() => {
            ": its condition has no value there".to_owned()
        }
        (Nearest::Missing(least, at), Some(dimension)) if dimension != [0; 3] => {
            let least = amount(model, dimension, least);
            format!(": it comes nearest at {}, where {least} are missing", place(at))
        }
        // of an angle or a plain number, as of what has no one unit, the place alone is clear
        (Nearest::Missing(_, at), _) => format!(": it comes nearest at {}", place(at)),
    }
}
