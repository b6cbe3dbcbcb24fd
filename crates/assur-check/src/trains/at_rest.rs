//! Wheels of which the geometry alone is asked.

use crate::expr::context::Context;
use assur_model::model::{Expr, FindKind, PairKind, Relation};
use assur_syntax::document::Statement;

/// Wheels that nothing moves and of which nothing is asked but their geometry are no mechanism.
pub(crate) fn at_rest(cx: &mut Context<'_>) {
    let linked = cx
        .builder
        .mech
        .pairs
        .iter()
        .any(|p| p.bearing.is_none() && !matches!(p.kind, PairKind::Transmission(_)));
    let has = |wanted: fn(&Statement) -> bool| cx.doc.statements.iter().any(|s| wanted(&s.node));
    let acts = has(|s| {
        matches!(
            s,
            Statement::Drive(_)
                | Statement::Load(_)
                | Statement::Brake(_)
                | Statement::Balance(_)
                | Statement::Link(_)
                | Statement::Start(_)
                | Statement::Simulate(_)
                | Statement::Equilibrium(_)
                | Statement::Spring(_)
                | Statement::Counterweight(_)
        )
    });
    let asks = has(|s| matches!(s, Statement::Find(_) | Statement::Expect(_)));
    if !linked && !acts && asks && !asks_of_motion(cx) {
        cx.builder.mech.links.truncate(1);
        cx.builder.mech.pairs.clear();
        cx.builder.mech.open_sizes.clear();
    }
}

/// Whether anything that is asked depends on the motion.
fn asks_of_motion(cx: &Context<'_>) -> bool {
    let mut found = false;
    let mut look = |expr: &Expr| expr.queries(&mut |_| found = true);
    cx.builder.mech.quantities.iter().for_each(|q| look(&q.expr));
    for find in &cx.builder.mech.finds {
        if let FindKind::Value { expr, .. } = &find.kind {
            look(expr);
        }
    }
    for expect in &cx.builder.mech.expects {
        look(&expect.expr);
        match &expect.relation {
            Relation::Equal(values) => values.iter().for_each(&mut look),
            Relation::Compare(_, bound) => look(bound),
            Relation::Condition => {}
        }
    }
    found || cx.builder.mech.finds.iter().any(|f| matches!(f.kind, FindKind::Reactions))
}
