//! Unknown efforts.

use crate::error::LoadError;
use crate::expr::context::Context;
use crate::expr::want::Want;
use crate::loads::load::{
    effort, example, form, frame, moving, no_place, of_open_shaft, place, slider, whole_link,
};
use assur_math::math::Vec2;
use assur_model::model;
use assur_model::model::BalanceKind;
use assur_syntax::document;
use assur_syntax::document::{Balance, LoadKind, Name, Site, Statement};

/// Enters all unknown efforts into the mechanism.
pub(crate) fn balances(cx: &mut Context<'_>) {
    let doc = cx.doc;
    for statement in &doc.statements {
        if let Statement::Balance(balance) = &statement.node
            && let Some(kind) = kind(cx, balance)
        {
            let (name, span) = (balance.name.node.clone(), balance.name.span);
            cx.builder.mech.balances.push(model::Balance { name, span, kind });
        }
    }
}

fn kind(cx: &mut Context<'_>, balance: &Balance) -> Option<BalanceKind> {
    let (link, at) = match &balance.site {
        Site::Link { link, at } => (link, at.as_ref()),
        Site::Pair(pair) => {
            let word = if balance.kind.node == LoadKind::Torque { "torque" } else { "force" };
            let line = format!("balance {word} {} in {}", balance.name.node, pair.node);
            let pair = effort(cx, balance.kind.node, balance.kind.span, (&line, pair));
            undirected(cx, balance, "a load in a pair acts along its coordinate")?;
            return Some(BalanceKind::InPair(pair?.0));
        }
    };
    match balance.kind.node {
        LoadKind::Torque => {
            let on = moving(cx, link, "a torque");
            whole_link(cx, at, &format!("balance torque {} on {}", balance.name.node, link.node))?;
            undirected(cx, balance, "a torque has no direction in the plane")?;
            on.map(BalanceKind::Torque)
        }
        LoadKind::Force => force(cx, balance, link, at),
    }
}

fn force(
    cx: &mut Context<'_>,
    balance: &Balance,
    link: &Name,
    at: Option<&document::Place>,
) -> Option<BalanceKind> {
    if let Some(pair) = slider(cx, link) {
        undirected(cx, balance, "a slider moves along one line")?;
        return Some(BalanceKind::InPair(pair));
    }
    of_open_shaft(cx, link, "an unknown force")?;
    let on = moving(cx, link, "a force");
    let name = &balance.name.node;
    let site = match at {
        Some(document::Place::Point(point)) => format!("{} at {}", link.node, point.node),
        _ => example(cx, on, &link.node),
    };
    let example = format!("balance force {name} on {site} along 90 deg");
    let place = match at {
        Some(at) => on.and_then(|on| place(cx, on, at)),
        None => {
            no_place(cx, "an unknown force", link, example);
            return None;
        }
    };
    let Some(along) = &balance.along else {
        cx.error(LoadError::ForceWithoutDirection { name: name.clone(), example, span: balance.name.span });
        return None;
    };
    let along = cx.scalar_constant(along, &Want::ANGLE, &format!("the direction of the force `{name}`"));
    let frame = frame(cx, balance.frame.as_ref());
    Some(BalanceKind::Force { on: on?, at: place?, along: Vec2::direction(along?), frame: frame? })
}

/// Reports a direction where there can be none.
fn undirected(cx: &mut Context<'_>, balance: &Balance, message: &str) -> Option<()> {
    let along = balance.along.as_ref().map(|e| e.span).or(balance.frame.as_ref().map(|f| f.span));
    let Some(span) = along else { return Some(()) };
    form(cx, message.into(), "leave the direction out", span);
    None
}
