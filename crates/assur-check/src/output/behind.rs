//! The results that an expression depends on, directly or through quantities of the mechanism.

use assur_model::model::{self, Mechanism, QuantityId};
use indexmap::IndexSet;

/// Calls `visit` on every result the expression depends on, those of its quantities included.
pub fn queries(mech: &Mechanism, expr: &model::Expr, visit: &mut dyn FnMut(&model::Query)) {
    let mut found = Behind::default();
    found.visit_queries(expr, visit);
    let (mut quantities, mut cycles) = (0, 0);
    loop {
        let quantity = found.quantities.get_index(quantities).map(|id| id.index());
        let cycle = found.cycles.get_index(cycles).copied();
        let next = match (quantity, cycle) {
            (Some(index), _) => {
                quantities += 1;
                mech.quantities.get(index).map(|q| &q.expr)
            }
            (None, Some(index)) => {
                cycles += 1;
                mech.cycles.get(index).map(|c| &c.expr)
            }
            (None, None) => return,
        };
        if let Some(next) = next {
            found.visit_queries(next, visit);
        }
    }
}

/// What an expression depends on: quantities and functions over the sweep.
#[derive(Default)]
struct Behind {
    quantities: IndexSet<QuantityId>,
    cycles: IndexSet<usize>,
}

impl Behind {
    fn visit_queries(&mut self, expr: &model::Expr, visit: &mut dyn FnMut(&model::Query)) {
        expr.parts(&mut |part| match part {
            model::Expr::Query(query) => {
                visit(query);
                if let model::Query::Cycle(index) = query {
                    self.cycles.insert(*index);
                }
            }
            model::Expr::Quantity(id) => {
                self.quantities.insert(*id);
            }
            _ => {}
        });
    }
}
