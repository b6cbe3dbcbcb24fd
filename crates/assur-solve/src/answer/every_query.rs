//! All expressions and results that a file asks for.

use crate::model::{Expr, Mechanism, Positions, Query};
use crate::source::Span;

/// Calls `look` on every result that the file asks for, with the place of its statement.
pub(crate) fn every_query(mechanism: &Mechanism, look: &mut impl FnMut(&Query, Span)) {
    every_expr(mechanism, &mut |expr, span| expr.queries(&mut |query| look(query, span)));
}

/// Calls `ask` on every expression of the file, with the place of its statement.
pub(crate) fn every_expr(mechanism: &Mechanism, ask: &mut impl FnMut(&Expr, Span)) {
    use crate::model::{At, FindKind, Relation};
    for drive in &mechanism.drives {
        match &drive.positions {
            Positions::None | Positions::Numbers(_) => {}
            Positions::List(list) => list.iter().for_each(|e| ask(e, drive.span)),
            Positions::Range { from, to, .. } => {
                ask(from, drive.span);
                ask(to, drive.span);
            }
        }
        drive.speed.iter().chain(&drive.acceleration).for_each(|e| ask(e, drive.span));
    }
    for pose in &mechanism.poses {
        pose.at.iter().for_each(|(_, e)| ask(e, pose.span));
    }
    mechanism.quantities.iter().for_each(|q| ask(&q.expr, q.span));
    mechanism.events.iter().for_each(|e| ask(&e.value, e.span));
    mechanism.cycles.iter().for_each(|c| ask(&c.expr, c.span));
    for load in &mechanism.loads {
        load.expressions().for_each(|e| ask(e, load.span));
    }
    for find in &mechanism.finds {
        match &find.kind {
            FindKind::Value { expr, .. } => ask(expr, find.span),
            FindKind::Table(table) => table.questions().for_each(|expr| ask(expr, find.span)),
            FindKind::Reactions => {}
        }
    }
    for expect in &mechanism.expects {
        ask(&expect.expr, expect.span);
        match &expect.relation {
            Relation::Equal(values) => values.iter().for_each(|e| ask(e, expect.span)),
            Relation::Compare(_, bound) => ask(bound, expect.span),
            Relation::Condition => {}
        }
        if let Some(At::Drives(list)) = &expect.at {
            list.iter().for_each(|(_, e)| ask(e, expect.span));
        }
    }
}
