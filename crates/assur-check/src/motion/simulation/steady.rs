//! Motions that come again: `simulate steady turn of crank`, `simulate steady cycle of down`.

use crate::expr::context::Context;
use crate::motion::simulation::without_meaning;
use crate::statements::written::text;
use assur_model::model::{DriveTarget, Expr, Mechanism, Query, Steady};
use assur_syntax::document;
use assur_text::source::{Span, Spanned};

/// Turns that are followed at most.
const MOST_TURNS: usize = 1000;

/// After what the motion comes again.
pub(super) fn steady(cx: &mut Context<'_>, steady: &document::Steady) -> Option<Steady> {
    let found = match steady.turns {
        Some(turns) => turns_of(cx, steady, turns)?,
        None => Steady::Cycle(event(cx, steady)?),
    };
    ends(cx);
    depends_on_time(cx);
    let turning = match found {
        Steady::Turns { link, .. } => Some(DriveTarget::Link(link)),
        Steady::Cycle(_) => None,
    };
    drives(cx, turning);
    Some(found)
}

fn turns_of(cx: &mut Context<'_>, steady: &document::Steady, turns: usize) -> Option<Steady> {
    let name = text(&steady.of);
    let link = if steady.of.tail.is_none() { cx.link(&steady.of.head)? } else { return no_link(cx, steady) };
    let given = cx.builder.mech.drives.iter().any(|d| d.target == DriveTarget::Link(link));
    if !given {
        let what = format!("a steady turn of `{name}`, which is neither started nor driven,");
        let help = format!("give it its place and speed: `start {name} = 0 deg at 60 rpm`");
        no_meaning(cx, what, help, steady.span);
        return None;
    }
    let count = u32::try_from(turns).ok().filter(|_| (1..=MOST_TURNS).contains(&turns));
    if count.is_none() {
        let what = format!("a steady motion of {turns} turns");
        let help = format!("write a whole number of turns from 1 to {MOST_TURNS}");
        no_meaning(cx, what, help, steady.span);
    }
    Some(Steady::Turns { link, count: count? })
}

fn no_link(cx: &mut Context<'_>, steady: &document::Steady) -> Option<Steady> {
    let what = format!("a steady turn of `{}`, which is not a link,", text(&steady.of));
    no_meaning(cx, what, "name a link or a shaft that turns".to_owned(), steady.of.span());
    None
}

fn event(cx: &mut Context<'_>, steady: &document::Steady) -> Option<usize> {
    let name = text(&steady.of);
    let event = cx.event(&Spanned::new(name.clone(), steady.of.span()))?;
    let found = &cx.builder.mech.events[event];
    if found.rising.is_none() && found.situation.is_none() {
        let what = format!("a steady cycle of `{name}`, which happens on the way up and on the way down,");
        let help = "add `rising` or `falling` to the event".to_owned();
        no_meaning(cx, what, help, steady.span);
        return None;
    }
    Some(event)
}

/// Reports an end of a motion that comes again.
fn ends(cx: &mut Context<'_>) {
    let ends = cx.builder.mech.events.iter().filter(|event| event.ends).map(|event| event.span);
    for span in ends.collect::<Vec<_>>() {
        let what = "an end of a steady motion".to_owned();
        no_meaning(cx, what, "leave `until` out: one period is followed".to_owned(), span);
    }
}

/// Reports loads that depend on the instant.
fn depends_on_time(cx: &mut Context<'_>) {
    let mech = &cx.builder.mech;
    let timed = |expr: &Expr| takes_time(mech, expr);
    let loads = mech.loads.iter().filter(|load| load.expressions().any(timed)).map(|load| load.span);
    for span in loads.collect::<Vec<_>>() {
        let what = "a load that depends on `time` in a steady motion".to_owned();
        let help = "let it depend on angles, positions and velocities, which repeat".to_owned();
        no_meaning(cx, what, help, span);
    }
}

/// Whether an expression depends on the instant, by the names of the file too.
fn takes_time(mech: &Mechanism, expr: &Expr) -> bool {
    let mut found = false;
    expr.parts(&mut |part| match part {
        Expr::Query(query) => found |= *query == Query::Time,
        Expr::Quantity(id) => found |= takes_time(mech, &mech.quantities[id.index()].expr),
        _ => {}
    });
    found
}

/// Reports drives that move on while the motion comes again.
fn drives(cx: &mut Context<'_>, turning: Option<DriveTarget>) {
    let moving = cx.builder.mech.drives.iter().filter(|d| {
        let steady = turning == Some(d.target) && d.acceleration.is_none();
        !d.free && !steady && (d.speed.is_some() || d.acceleration.is_some())
    });
    for (name, span) in moving.map(|d| (d.name.clone(), d.span)).collect::<Vec<_>>() {
        let what = format!("the motion of `{name}`, which goes on for all time, in a steady motion");
        let help = format!("ask for a `steady turn of {name}`, or give `{name}` a `start`");
        no_meaning(cx, what, help, span);
    }
}

fn no_meaning(cx: &mut Context<'_>, what: String, help: String, span: Span) {
    cx.error(without_meaning(&what, &help, span));
}
