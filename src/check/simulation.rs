//! Motion under loads: names and units are checked, nothing of it can be solved yet.

use super::context::Context;
use super::drive::{target, value};
use super::element::constant;
use super::expr::typed::Type;
use crate::syntax::document::{Start, Statement, Until};
use crate::units::Dimension;

/// Checks `start`, `simulate` and `until`.
pub(super) fn simulation(cx: &mut Context<'_>) {
    let doc = cx.doc;
    for statement in &doc.statements {
        match &statement.node {
            Statement::Start(s) => {
                start(cx, s);
                cx.unsupported("motion under loads", statement.span);
            }
            Statement::Simulate(s) => {
                constant(cx, &s.from, Dimension::TIME, "the first instant");
                constant(cx, &s.to, Dimension::TIME, "the last instant");
                if let Some(within) = &s.within {
                    constant(cx, within, Dimension::NUMBER, "the tolerance of the simulation");
                }
                cx.unsupported("motion under loads", statement.span);
            }
            Statement::Until(u) => {
                until(cx, u);
                cx.unsupported("motion under loads", statement.span);
            }
            _ => {}
        }
    }
}

fn until(cx: &mut Context<'_>, until: &Until) {
    let what = cx.read(&until.what);
    let value = cx.read(&until.value);
    if let (Some(what), Some(value)) = (what, value)
        && let Type::Number(_) = what.ty
    {
        cx.fit(value, what.ty.dimension(), "the value that is waited for", &until.value);
    }
}

fn start(cx: &mut Context<'_>, start: &Start) {
    let Some((_, moves)) = target(cx, &start.target, "a start") else { return };
    let name = super::drive::text(&start.target);
    value(cx, &start.value, moves, 0, &name);
    if let Some(rate) = &start.rate {
        value(cx, rate, moves, 1, &name);
    }
}
