//! Events, and conditions at which the motion ends.

use crate::expr::context::Context;
use crate::motion::simulation::meaningless;
use crate::values::fold;
use crate::values::typed::{Dim, Type};
use assur_model::model::{BinaryOp, Comparison, Event, Expr, Function, Query, Situation};
use assur_syntax::document::{self, Passing, PassingSense, Statement};
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;
use assur_text::units::Dimension;

/// Enters all events, in the order of the file, then the ends by `until`.
pub(super) fn events(cx: &mut Context<'_>) {
    let doc = cx.doc;
    for statement in &doc.statements {
        if let Statement::Event(event) = &statement.node {
            enter(cx, &event.passing, (Some(event.name.node.clone()), statement.span));
        }
    }
    for statement in &doc.statements {
        if let Statement::Until(until) = &statement.node {
            enter(cx, &until.passing, (None, statement.span));
        }
    }
}

/// What happens: a number that passes zero, and in which direction it counts.
struct Passage {
    value: Expr,
    rising: Option<bool>,
    strict: bool,
    dimension: Option<[i8; 3]>,
}

fn enter(cx: &mut Context<'_>, passing: &Passing, (name, span): (Option<String>, Span)) {
    let ends = name.is_none();
    let found = match &passing.value {
        Some(value) => passed(cx, passing, value),
        None => condition(cx, passing),
    };
    let found =
        found.filter(|found| situation(cx, &found.value).is_some() || is_of_instant(cx, &found.value, span));
    let situation = found.as_ref().and_then(|found| situation(cx, &found.value));
    // an event without a value keeps its place: what names it counts them
    let found = found.filter(|_| situation.is_none());
    let nothing = Passage { value: Expr::number(1.0), rising: None, strict: false, dimension: None };
    let Passage { value, rising, strict, dimension } = found.unwrap_or(nothing);
    cx.builder.mech.events.push(Event { name, span, value, rising, strict, dimension, ends, situation });
}

/// Reports what is known only once the whole motion is.
fn is_of_instant(cx: &mut Context<'_>, value: &Expr, span: Span) -> bool {
    let mut of_run = false;
    value.queries(&mut |query| of_run |= query.facts().of_solution);
    if of_run {
        let (run, instant) = if cx.names.simulates { ("motion", "the instant, on ") } else { ("sweep", "") };
        let what = format!("a function over the whole {run}");
        let help = format!("let it depend on {instant}positions, velocities, accelerations and forces");
        cx.error(meaningless(&what, "in an event", &help, span));
    }
    !of_run
}

/// A value that is passed.
fn passed(cx: &mut Context<'_>, passing: &Passing, value: &document::Expr) -> Option<Passage> {
    let what = cx.read(&passing.what)?;
    let Type::Number(dim) = what.ty else {
        let help = matches!(what.ty, Type::Vector(_)).then(|| "write `mag(…)`, `.x` or `.y`".to_owned());
        cx.shape("the value that is passed", "a number", what.ty, passing.what.span, help);
        return None;
    };
    let wanted = match dim {
        Dim::Any => cx.read(value)?.ty.dimension(),
        Dim::Of(_) => what.ty.dimension(),
    };
    let read = cx.read(value)?;
    let bound = cx.fit(read, wanted, "the value that is passed", value)?;
    let rising = passing.way.as_ref().map(|way| way.node == PassingSense::Rising);
    let value = fold::binary(BinaryOp::Sub, what.expr, bound.expr);
    Some(Passage { value, rising, strict: false, dimension: exponents(what.ty) })
}

/// A condition that becomes true.
fn condition(cx: &mut Context<'_>, passing: &Passing) -> Option<Passage> {
    let what = cx.read(&passing.what)?;
    if what.ty != Type::Bool {
        let (is, span) = (what.ty.phrase().to_owned(), passing.what.span);
        cx.error(
            Diagnosis::error(
                "mech::simulate::no_condition",
                format!("this is {is}: nothing says when it happens"),
            )
            .label(span, "when?")
            .help(
                "give the value that is passed, as in `omega(crank) = 0 rad/s`, or a \
                 condition, as in `omega(crank) < 0 rad/s`",
            ),
        );
        return None;
    }
    if let Some(way) = &passing.way {
        let help = "leave it out: it happens where the condition becomes true";
        cx.error(meaningless("`rising` or `falling`", "with a condition", help, way.span));
    }
    if situation(cx, &what.expr).is_some() {
        return Some(Passage { value: what.expr, rising: None, strict: false, dimension: None });
    }
    let Some(value) = margin(&what.expr) else {
        cx.error(
            Diagnosis::error(
                "mech::simulate::no_margin",
                "the instant at which this condition becomes true cannot be found",
            )
            .label(passing.what.span, "no comparison of numbers")
            .help("write it as a comparison of numbers, or as several with `and`, `or`, `not`"),
        );
        return None;
    };
    let dimension = match &passing.what.kind {
        document::ExprKind::Compare(first, rest) if rest.len() == 1 => exponents(cx.read(first)?.ty),
        _ => None,
    };
    Some(Passage { value, rising: Some(true), strict: is_strict(&what.expr), dimension })
}

fn exponents(ty: Type) -> Option<[i8; 3]> {
    let Dimension { length, mass, time, .. } = ty.dimension();
    Some([length, mass, time])
}

/// Whether a condition is not true where its number is zero.
fn is_strict(condition: &Expr) -> bool {
    match condition {
        Expr::Compare(how, ..) => matches!(how, Comparison::Less | Comparison::Greater),
        Expr::And(a, b) | Expr::Or(a, b) => is_strict(a) || is_strict(b),
        Expr::Not(a) => !is_strict(a),
        _ => false,
    }
}

/// What the motion is in for a while, and whether it is to be so: `rests(G)`, `not rests(G)`. A clutch slips while it does not
/// stick.
fn situation(cx: &Context<'_>, condition: &Expr) -> Option<(Situation, bool)> {
    match condition {
        Expr::Query(Query::In(situation)) => Some((*situation, true)),
        Expr::Query(Query::Slips(pair)) if cx.builder.mech.pair(*pair).rubs() => {
            Some((Situation::Sticks(*pair), false))
        }
        Expr::Not(inner) => situation(cx, inner).map(|(found, is)| (found, !is)),
        _ => None,
    }
}

/// A number that is positive where a condition is true: it passes zero where that changes.
fn margin(condition: &Expr) -> Option<Expr> {
    Some(match condition {
        Expr::Compare(Comparison::Less | Comparison::LessEqual, a, b) => {
            fold::binary(BinaryOp::Sub, (**b).clone(), (**a).clone())
        }
        Expr::Compare(Comparison::Greater | Comparison::GreaterEqual, a, b) => {
            fold::binary(BinaryOp::Sub, (**a).clone(), (**b).clone())
        }
        Expr::And(a, b) => scaled(Function::Min, a, b)?,
        Expr::Or(a, b) => scaled(Function::Max, a, b)?,
        Expr::Not(a) => Expr::Negate(Box::new(margin(a)?)),
        _ => return None,
    })
}

/// The least or the greatest of two margins: their units may differ, and their signs alone count.
fn scaled(function: Function, a: &Expr, b: &Expr) -> Option<Expr> {
    Some(Expr::Call(function, vec![margin(a)?, margin(b)?]))
}
