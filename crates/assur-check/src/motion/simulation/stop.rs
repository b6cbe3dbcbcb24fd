//! Stops: bounds of coordinates in a motion.

use super::{may_be_missing, statement};
use crate::expr::context::Context;
use crate::expr::positive::Want;
use crate::expr::property::{Read, find, read};
use crate::motion::drive::{Moves, coordinate};
use crate::motion::simulation::no_simulation;
use crate::values::format_value::digits;
use assur_model::model::{Expr, Load, LoadKind, PairId, PairKind, Query, Stop};
use assur_syntax::document::{self, CompareOp, Statement};
use assur_text::diagnostic::Diagnosis;
use assur_text::language::{STOP, properties_of_pair};
use assur_text::source::Span;
use assur_text::units::Dimension;

/// Enters all stops into the mechanism, each with the effort that it bears while it is closed. They come after all other
/// loads, which are counted as they are written.
pub(crate) fn stops(cx: &mut Context<'_>) {
    let doc = cx.doc;
    for item in &doc.statements {
        let Statement::Stop(written) = &item.node else { continue };
        if statement(cx).is_none() && may_be_missing(cx) {
            let help = "add `simulate 0 s .. 1 s` with a `start` for each free coordinate".to_owned();
            cx.error(no_simulation("stop", help, item.span));
            continue;
        }
        let Some(stop) = stop(cx, written, item.span) else { continue };
        enter(cx, stop);
    }
    for index in 0..cx.builder.mech.pairs.len() {
        let pair = &cx.builder.mech.pairs[index];
        if matches!(pair.kind, PairKind::Contact { parts: true, .. }) {
            if statement(cx).is_none() && may_be_missing(cx) {
                let help = "add `simulate 0 s .. 1 s`, or leave `parts` out: it then stays closed".to_owned();
                let span = pair.span;
                cx.error(no_simulation("contact that parts", help, span));
                continue;
            }
            let (pair, span, name) = (PairId::at(index), pair.span, pair.name.clone());
            let Some(restitution) = restitution_of_contact(cx, &name) else { continue };
            enter(cx, Stop { pair, span, turns: false, side: 1.0, bound: 0.0, restitution });
        }
    }
}

/// Enters a stop, and what it bears as a load.
fn enter(cx: &mut Context<'_>, stop: Stop) {
    let value = Expr::Query(Query::StopEffort(cx.builder.mech.stops.len()));
    let kind = LoadKind::InPair { pair: stop.pair, value, against_motion: false };
    let span = stop.span;
    cx.builder.mech.loads.push(Load { name: None, span, kind, pin: None, spread: None, when: None });
    cx.builder.mech.stops.push(stop);
}

/// The restitution that a contact that parts says.
fn restitution_of_contact(cx: &mut Context<'_>, name: &str) -> Option<f64> {
    let doc = cx.doc;
    let joint = doc.statements.iter().find_map(|item| match &item.node {
        Statement::Joint(joint) if joint.name.node == name => Some(joint),
        _ => None,
    })?;
    let properties = read(cx, "a contact", &joint.properties, properties_of_pair(joint.kind.node))?;
    restitution(cx, &properties, (&joint.properties, joint.name.span))
}

/// The restitution among properties: none is that nothing rebounds.
fn restitution(
    cx: &mut Context<'_>,
    properties: &[Read],
    (written, span): (&[document::Property], Span),
) -> Option<f64> {
    let restitution = find(properties, "restitution").map_or(0.0, Read::number);
    if restitution > 1.0 {
        let place = written.iter().find(|p| p.name.node == "restitution");
        let what = format!("the restitution of a stop is between 0 and 1; got {}", digits(restitution));
        let help = match place.and_then(|p| crate::statements::written::written(p.values.first()?)) {
            Some(value) if (2.0..=100.0).contains(&restitution) && !value.contains('%') => {
                format!("write `restitution {value} %`, if percent is meant")
            }
            _ => "write the speed after the impact over that before it, as in `restitution 0.7`".to_owned(),
        };
        let span = place.map_or(span, |p| p.name.span);
        cx.error(Diagnosis::error("mech::simulate::stop", what).primary(span, "this stop").help(help));
        return None;
    }
    Some(restitution)
}

fn stop(cx: &mut Context<'_>, stop: &document::Stop, span: Span) -> Option<Stop> {
    let properties = read(cx, "a stop", &stop.properties, STOP);
    let (pair, moves) = coordinate(cx, &stop.pair)?;
    let turns = moves == Moves::Turning;
    let dimension = if turns { Dimension::ANGLE } else { Dimension::LENGTH };
    let bound = cx.scalar_constant(&stop.bound, &Want(dimension), "the place of a stop")?;
    let restitution = restitution(cx, &properties?, (&stop.properties, span))?;
    let above = matches!(stop.op.node, CompareOp::Greater | CompareOp::GreaterOrEqual);
    let side = if above { 1.0 } else { -1.0 };
    let found = Stop { pair, span, turns, side, bound, restitution };
    is_free(cx, stop, &found).then_some(found)
}

/// Whether nothing else bounds or drives the coordinate on this side.
fn is_free(cx: &mut Context<'_>, stop: &document::Stop, found: &Stop) -> bool {
    let name = &stop.pair.node;
    let others = cx.builder.mech.stops.iter().filter(|other| other.pair == found.pair);
    for other in others.cloned().collect::<Vec<_>>() {
        if other.side == found.side {
            let what = format!("`{name}` has two stops on the same side");
            cx.error(two_stops(what, (found.span, other.span), "keep the one that is reached first"));
            return false;
        }
        if found.side * (other.bound - found.bound) <= 0.0 {
            let what = format!("nothing is left between the two stops of `{name}`");
            let help = "let the coordinate stay above the lesser bound and below the greater one";
            cx.error(two_stops(what, (found.span, other.span), help));
            return false;
        }
    }
    true
}

/// Two stops of a pair that cannot both be.
fn two_stops(what: String, (at, first): (Span, Span), help: &str) -> Diagnosis {
    Diagnosis::error("mech::simulate::stop", what)
        .primary(at, "this stop")
        .label(first, "first here")
        .help(help)
        .left_out("this stop", at)
}
