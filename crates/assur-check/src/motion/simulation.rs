//! Motion under loads: names and units are checked, nothing of it can be solved yet.

use crate::expr::context::Context;
use crate::motion::drive::{target, value};
use crate::pairs::transmission::constant;
use crate::statements::lines::text;
use crate::values::typed::Type;
use assur_model::model::{Drive, Positions};
use assur_syntax::document::{Start, Statement, Until};
use assur_text::source::Span;
use assur_text::units::Dimension;

/// Checks `start`, `simulate` and `until`.
pub(crate) fn simulation(cx: &mut Context<'_>) {
    let doc = cx.doc;
    for statement in &doc.statements {
        match &statement.node {
            Statement::Start(s) => {
                if let Some(drive) = start(cx, s, statement.span) {
                    cx.builder.mech.drives.push(drive);
                }
                cx.builder.unsupported("motion under loads", statement.span);
            }
            Statement::Simulate(s) => {
                constant(cx, &s.from, Dimension::TIME, "the first instant");
                constant(cx, &s.to, Dimension::TIME, "the last instant");
                if let Some(within) = &s.within {
                    constant(cx, within, Dimension::NUMBER, "the tolerance of the simulation");
                }
                cx.builder.unsupported("motion under loads", statement.span);
            }
            Statement::Until(u) => {
                until(cx, u);
                cx.builder.unsupported("motion under loads", statement.span);
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
        cx.fit(value, what.ty.dimension(), "the value after `until`", &until.value);
    }
}

/// For the structure a start is a drive: one freedom whose position is known.
fn start(cx: &mut Context<'_>, start: &Start, span: Span) -> Option<Drive> {
    let (target, moves) = target(cx, &start.target, "a start")?;
    let name = text(&start.target);
    let position = value(cx, &start.value, moves, 0, &name);
    let speed = start.rate.as_ref().map(|rate| value(cx, rate, moves, 1, &name));
    let (target, position) = (target?, position?);
    let driven = cx.builder.mech.drives.iter().any(|d| d.target == target);
    (!driven).then(|| Drive {
        name,
        span,
        target,
        positions: Positions::List(vec![position]),
        written: crate::statements::written::written(&start.value.value),
        speed: speed.flatten(),
        acceleration: None,
        sense: None,
    })
}
