//! Starts: where free coordinates are at the first instant, and how fast.

use super::{may_be_missing, statement};
use crate::expr::context::Context;
use crate::motion::{
    drive::{Moves, has_wheels, target, value, zero},
    place,
    simulation::no_simulation,
};
use crate::statements::written::{text, written};
use assur_math::math::Vec2;
use assur_model::model::{Drive, DriveTarget, Expr, Pair, PairKind, Positions, Value};
use assur_syntax::document::{Start, Statement};
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;
use assur_text::units::Dimension;

/// Enters all starts into the mechanism. For the structure a start is a drive: one freedom whose position is known.
pub(crate) fn starts(cx: &mut Context<'_>) {
    let doc = cx.doc;
    for statement in &doc.statements {
        if let Statement::Start(s) = &statement.node
            && let Some(drive) = start(cx, s, statement.span)
        {
            cx.builder.mech.drives.extend(place::coordinates(&drive));
        }
    }
    // those of places last: one that is left out changes no number of another
    cx.builder.mech.drives.sort_by_key(|drive| drive.free && matches!(drive.target, DriveTarget::Place(..)));
}

fn start(cx: &mut Context<'_>, start: &Start, span: Span) -> Option<Drive> {
    let name = text(&start.target);
    let (target, moves) = target(cx, &start.target, "a start")?;
    if statement(cx).is_none() && may_be_missing(cx) {
        let line = written_start(start, &name);
        let help = format!("add `simulate 0 s .. 1 s`, or write `{}` for a motion that is given", line);
        cx.error(no_simulation("start", help, span));
        return None;
    }
    if let Some(pair) = sliding_pair(cx, start, target.filter(|_| moves == Moves::Turning)) {
        let line = [
            Some(format!("start {pair}")),
            start.value.as_ref().and_then(|v| written(&v.value)).map(|v| format!(" = {v}")),
        ];
        let rate = start.rate.as_ref().and_then(|v| written(&v.value)).map(|v| format!(" at {v}"));
        let line = line.into_iter().flatten().chain(rate).collect::<String>();
        let message = format!("`{name}` slides, so that its position is that of `{pair}`");
        cx.error(
            Diagnosis::error("mech::unit::mismatch", message)
                .primary(start.target.span(), "a link, whose position is an angle")
                .help(format!("write `{line}`"))
                .quoted(span),
        );
        return None;
    }
    let once = target.is_none_or(|target| once(cx, target, &name, span));
    let position = start.value.as_ref().map(|v| value(cx, v, moves, 0, &name));
    let speed = match &start.rate {
        Some(rate) => value(cx, rate, moves, 1, &name),
        None if moves == Moves::Freely => Some(Expr::Constant(Value::Vector(Vec2::zero()))),
        None => Some(Expr::number(0.0)),
    };
    if position.is_none() && (moves == Moves::Freely || !has_wheels(cx)) {
        let example = match moves {
            Moves::Turning => "45 deg",
            Moves::Sliding => "100 mm",
            Moves::Freely => "(0, 100 mm)",
        };
        let name = format!("{name} = {example} at {}", zero(moves, 1));
        cx.error(
            Diagnosis::error(
                "mech::geometry::no_drive_position",
                "a start needs a position where the motion depends on it",
            )
            .label(span, "no position")
            .help(format!("write `start {name}`, with your own values")),
        );
        return None;
    }
    let positions = match position {
        None => Positions::None,
        Some(position) => Positions::List(vec![position?]),
    };
    let (speed, target) = (Some(speed?), target?);
    let written = start.value.as_ref().and_then(|v| written(&v.value));
    let (acceleration, sense) = (None, None);
    let (free, of_time) = (true, false);
    once.then_some(Drive {
        name,
        span,
        target,
        positions,
        written,
        speed,
        acceleration,
        sense,
        free,
        sought: None,
        of_time,
    })
}

/// The only pair in which a link slides whose position is given as a length.
fn sliding_pair(cx: &mut Context<'_>, start: &Start, target: Option<DriveTarget>) -> Option<String> {
    let (Some(DriveTarget::Link(link)), Some(value)) = (target, &start.value) else { return None };
    let found = cx.quietly(|cx| cx.read(&value.value)).map(|t| t.ty.dimension())?;
    let slides = |pair: &&Pair| matches!(&pair.kind, PairKind::Prismatic(g) if g.slider == link);
    let mut pairs = cx.builder.mech.pairs.iter().filter(slides);
    let only = pairs.next().filter(|_| pairs.next().is_none())?;
    (found == Dimension::LENGTH).then(|| only.name.clone())
}

/// The drive that stands for a start whose motion is given.
fn written_start(start: &Start, name: &str) -> String {
    let value = start.value.as_ref().and_then(|v| written(&v.value));
    format!("drive {name} = {}", value.unwrap_or_else(|| "…".into()))
}

/// Whether nothing else gives the coordinate.
fn once(cx: &mut Context<'_>, target: DriveTarget, name: &str, again: Span) -> bool {
    let other = cx.builder.mech.drives.iter().find(|d| place::is_given(d, target));
    let Some((first, free)) = other.map(|d| (d.span, d.free)) else { return true };
    let (what, help) = if free {
        (format!("`{name}` is started twice"), "keep one of them".to_owned())
    } else {
        let help = format!(
            "keep `drive {name}` for a motion that is given, or `start {name}` for one that follows \
             from the loads"
        );
        (format!("`{name}` has a `drive` and a `start`"), help)
    };
    cx.error(
        Diagnosis::error("mech::simulate::twice", what)
            .primary(again, "started here")
            .label(first, "given here")
            .help(help),
    );
    false
}
