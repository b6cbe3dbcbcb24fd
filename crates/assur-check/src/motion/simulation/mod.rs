//! Motion under given loads.

mod allowed;
mod event;
mod of_time;
mod start;
mod steady;
mod stop;
mod swept;

pub(crate) use of_time::{differentiable, follows_time, own_rates};
pub(crate) use start::starts;
pub(crate) use stop::stops;

use crate::expr::{context::Context, positive::Want};
use crate::motion::drive::{MOST_STEPS, wrong_steps};
use crate::values::format_value::{digits, format_value};
use assur_model::model::Simulation;
use assur_syntax::document::{Expr, Simulate, Statement, TimeCourse};
use assur_text::diagnostic::{Diagnosis, Fix, Help};
use assur_text::source::Span;
use assur_text::units::Dimension;

/// The statement that asks for a motion under loads, and its place.
pub(crate) fn statement<'a>(cx: &Context<'a>) -> Option<(&'a Simulate, Span)> {
    cx.doc.statements.iter().find_map(|s| match &s.node {
        Statement::Simulate(simulate) => Some((simulate, s.span)),
        _ => None,
    })
}

/// Enters the time of the motion into the mechanism.
pub(crate) fn simulation(cx: &mut Context<'_>) {
    second_statement(cx);
    let Some((simulate, span)) = statement(cx) else {
        return swept::events(cx);
    };
    event::events(cx);
    cx.builder.mech.simulation = course(cx, simulate, span);
    allowed::check(cx, span);
}

fn second_statement(cx: &mut Context<'_>) {
    let statements = cx.doc.statements.iter().filter(|s| matches!(s.node, Statement::Simulate(_)));
    let spans = statements.map(|s| s.span).collect::<Vec<_>>();
    if let [first, again, ..] = spans[..] {
        let help = "keep one of them: a file follows one motion".to_owned();
        cx.error(
            Diagnosis::error("mech::simulate::twice", "a file has one `simulate`, and this is the second")
                .primary(again, "again here")
                .label(first, "first here")
                .help(help)
                .left_out("the second one", again),
        );
    }
}

/// Whether no statement that could not be read may be the `simulate` that is missing.
pub(crate) fn may_be_missing(cx: &Context<'_>) -> bool {
    !cx.doc.statements.iter().any(|s| matches!(s.node, Statement::Bad(_)))
}

/// Reports what has no meaning without a motion that is followed, unless it is in a statement that could not be read.
pub(crate) fn no_simulate(cx: &mut Context<'_>, word: &'static str, span: Span) {
    if may_be_missing(cx) {
        let help = "add `simulate 0 s .. 1 s` with a `start` for each free coordinate".to_owned();
        cx.error(no_simulation(word, help, span));
    }
}

fn course(cx: &mut Context<'_>, simulate: &Simulate, span: Span) -> Option<Simulation> {
    let within = match &simulate.within {
        Some(within) => Some(accuracy(cx, within)?),
        None => None,
    };
    let steps = match &simulate.steps {
        Some(steps) => Some(count(cx, steps)?),
        None => None,
    };
    let (from, to) = match &simulate.course {
        TimeCourse::Between { from, to } => (from, to),
        TimeCourse::Steady(steady) => {
            let steady = Some(steady::steady(cx, steady)?);
            return Some(Simulation { span, from: 0.0, to: f64::INFINITY, steady, steps, within });
        }
    };
    let want = Want(Dimension::TIME);
    let first = match from {
        Some(from) => cx.scalar_constant(from, &want, "the first instant"),
        None => Some(0.0),
    };
    let last = cx.scalar_constant(to, &want, "the last instant");
    let (first, last) = (first?, last?);
    if last <= first {
        let instant = |x| format_value(x, Dimension::TIME);
        let span = from.as_ref().map_or(to.span, |from| from.span.to(to.span));
        cx.error(
            Diagnosis::error(
                "mech::simulate::interval",
                format!("the motion ends at {}, and {} is not before it", instant(last), instant(first)),
            )
            .label(span, "no time between them")
            .help("write the earlier instant first: `simulate 0 s .. 2 s`"),
        );
        return None;
    }
    Some(Simulation { span, from: first, to: last, steady: None, steps, within })
}

fn accuracy(cx: &mut Context<'_>, within: &Expr) -> Option<f64> {
    let value = cx.scalar_constant(within, &Want::NUMBER, "the accuracy of the motion")?;
    if value > 0.0 && value < 1.0 {
        return Some(value);
    }
    cx.error(
        Diagnosis::error("mech::simulate::within", format!("{} is no accuracy of a motion", digits(value)))
            .label(within.span, "not between 0 and 1")
            .help(
                "write a number between 0 and 1: `within 1e-9` keeps all that is printed \
                 to 1e-9 of the greatest of its kind",
            ),
    );
    None
}

fn count(cx: &mut Context<'_>, steps: &Expr) -> Option<usize> {
    let value = cx.scalar_constant(steps, &Want::NUMBER, "the number of steps")?;
    #[allow(clippy::cast_precision_loss)] // a million is exact
    if value.fract() != 0.0 || !(1.0..=MOST_STEPS as f64).contains(&value) {
        let (value, most, span) = (digits(value), MOST_STEPS, steps.span);
        cx.error(wrong_steps(&value, most, span));
        return None;
    }
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // whole, from 1 to a million
    Some(value as usize)
}

/// What belongs to positions of a drive.
pub fn of_given_positions(what: &str, help: impl Into<Help>, span: Span, simulate: Span) -> Diagnosis {
    Diagnosis::error(
        "mech::simulate::positions",
        format!("{what} belongs to positions that are given, and this file follows a motion"),
    )
    .primary(span, "of given positions")
    .label(simulate, "the motion follows from the loads")
    .help(help)
}

/// An effect that a motion under loads has of itself.
pub fn without_meaning(what: &str, help: &str, span: Span) -> Diagnosis {
    meaningless(what, "where the motion follows from the loads", help, span)
}

/// What has no meaning in a file of this kind.
pub fn meaningless(what: &str, place: &str, help: &str, span: Span) -> Diagnosis {
    Diagnosis::error("mech::simulate::no_meaning", format!("{what} has no meaning {place}"))
        .label(span, "no meaning here")
        .fixes(help.starts_with("leave ").then(|| Fix::left_out("this", span)))
        .help(help)
}

/// A statement of a motion that is not followed.
pub fn no_simulation(word: &'static str, help: impl Into<Help>, span: Span) -> Diagnosis {
    Diagnosis::error(
        "mech::simulate::missing",
        format!("`{word}` belongs to a motion under loads, and the file has no `simulate`"),
    )
    .label(span, "no `simulate`")
    .help(help)
}
