//! Which numbers leave a constant expression without a value.

use crate::expr::context::Context;
use crate::names::declared::QuantityKind;
use crate::statements::walk;
use crate::statements::written::written;
use crate::values::definition::Settled;
use crate::values::typed::Typed;
use assur_syntax::document::{Expr, ExprKind};
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;
use indexmap::IndexSet;

/// Most values that a help states.
const VALUES: usize = 6;

impl Context<'_> {
    /// Reports a constant that is no number, where `operand` is what makes it none.
    pub(crate) fn without_value(&mut self, why: &'static str, span: Span, t: &Typed, operand: &Expr) {
        let help = self.numbers_of(t, operand);
        self.error(undefined(why, span, help));
    }

    /// ``change `K`: `K - 1` is 0 where `K` = 1``
    fn numbers_of(&self, t: &Typed, operand: &Expr) -> Option<String> {
        let mut names = IndexSet::new();
        named(operand, &mut names);
        let mut next = 0;
        while let Some(name) = names.get_index(next).copied().filter(|_| names.len() < VALUES) {
            if let Some(QuantityKind::Let(value)) = self.names.quantities.get(name).map(|d| d.what) {
                named(value, &mut names);
            }
            next += 1;
        }
        let value = |name: &&str| match self.values.definitions.settled.get(*name) {
            Some(Settled::Constant(t)) => {
                Some(format!("`{name}` = {}", self.values.display(t.ty.dimension()).text(t.value()?, 6)))
            }
            _ => None,
        };
        let values = names.iter().filter_map(value).take(VALUES).collect::<Vec<_>>();
        let is = self.values.display(t.ty.dimension()).text(t.value()?, 6);
        let text = written(operand)?;
        Some(match values.as_slice() {
            [] => format!("write another number: `{text}` is {is}"),
            _ => format!("change the values: `{text}` is {is} where {}", values.join(", ")),
        })
    }
}

/// The names in an expression, in the order written.
fn named<'e>(expr: &'e Expr, names: &mut IndexSet<&'e str>) {
    walk::parts(expr, &mut |part| {
        if let ExprKind::Name(name) = &part.kind {
            names.insert(name);
        }
    });
}

/// A constant expression that is not defined.
pub fn undefined(why: &'static str, span: Span, help: Option<String>) -> Diagnosis {
    Diagnosis::error("mech::unit::no_value", format!("this expression is not defined: {why}"))
        .primary(span, why)
        .help_if(help)
}
