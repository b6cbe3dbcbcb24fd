//! Notes on a file that can be solved and is probably not meant so: what has no effect, counts twice, or is out of all proportion.

mod asked;
mod effect;
mod texts;
mod values;

use crate::expr::context::Context;
use assur_syntax::document::Statement;

/// Notes on the whole file, once nothing in it is wrong; none where a row of variants is checked.
pub(crate) fn notes(cx: &mut Context<'_>) {
    if !cx.values.outside.row.is_empty() || cx.problems.has_errors() {
        return;
    }
    // where nothing is asked yet, something may still be written that uses it
    let asks = |s: &Statement| matches!(s, Statement::Find(_) | Statement::Expect(_));
    if cx.doc.statements.iter().any(|s| asks(&s.node)) {
        effect::masses(cx);
        let moves = |s: &Statement| {
            matches!(
                s,
                Statement::Drive(_) | Statement::Start(_) | Statement::Equilibrium(_) | Statement::Load(_)
            )
        };
        if cx.doc.statements.iter().any(|s| moves(&s.node)) {
            effect::unused(cx);
            asked::given_load(cx);
        }
    }
    effect::loads_twice(cx);
    effect::springs_twice(cx);
    texts::texts(cx);
    values::converted_twice(cx);
    values::properties(cx);
    values::gyration(cx);
}
