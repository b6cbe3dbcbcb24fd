//! Why a value does not exist.

use assur_model::model::{Bound, Expr, PairId, Query, Value};
use assur_solve::answer::{Nearest, Swept};
use assur_solve::message::undefined;
use assur_solve::solve::{Model, PoseAnswers, Solution, compare};
use assur_text::units::Dimension;

/// Digits in a sentence.
const DIGITS: usize = 4;

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
            let unit = model.mechanism.display_of(Dimension::TIME).unit;
            format!("until {} {unit}", model.mechanism.instant_text(run.end))
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
        (Nearest::Missing(least, at), Some([length, mass, time])) if [length, mass, time] != [0; 3] => {
            let dimension = Dimension { length, mass, time, ..Dimension::NUMBER };
            let least = model.mechanism.display_of(dimension).text(Value::Scalar(least), DIGITS);
            format!(": it comes nearest at {}, where {least} are missing", place(at))
        }
        // of an angle or a plain number, as of what has no one unit, the place alone is clear
        (Nearest::Missing(_, at), _) => format!(": it comes nearest at {}", place(at)),
    }
}
