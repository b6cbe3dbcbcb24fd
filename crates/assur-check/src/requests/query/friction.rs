//! Verdicts on friction: `efficiency()`, `locked()`, `critical(al)`, `frictionless(Mb)`.

use crate::expr::context::Context;
use crate::expr::results::Call;
use crate::names::declared::QuantityKind;
use crate::values::definition::Settled;
use crate::values::typed::{Type, Typed};
use assur_model::model::{Expr, Query};
use assur_syntax::document::ExprKind;
use assur_text::source::Spanned;

impl Context<'_> {
    /// `efficiency()`, `locked()`
    pub(crate) fn verdict(&mut self, call: Call<'_>, query: Query, ty: Type) -> Option<Typed> {
        self.arguments(call, 0, 0)?;
        Some(Typed::new(Expr::Query(query), ty))
    }

    /// `critical(al)`: a `given`.
    pub(crate) fn critical(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 1)?;
        let wanted = "the name of a `given` that is a number";
        let ExprKind::Name(name) = &args[0].kind else {
            self.wrong_argument(call, wanted, args[0].span);
            return None;
        };
        self.names.note_quantity(&Spanned::new(name.clone(), args[0].span));
        match self.names.quantities.get(name).map(|d| d.what) {
            Some(QuantityKind::Given(_)) => {}
            Some(_) => {
                self.wrong_argument(call, wanted, args[0].span);
                return None;
            }
            None => {
                self.named(&Spanned::new(name.clone(), args[0].span));
                return None;
            }
        }
        let ty = match self.values.definitions.settled(name)? {
            Settled::Constant(t) => t.ty,
            Settled::Pending(ty) => return Some(Typed::pending(*ty)),
            Settled::Result(..) | Settled::Failed => return None,
        };
        if !matches!(ty, Type::Number(_)) {
            self.wrong_argument(call, wanted, args[0].span);
            return None;
        }
        let known = self.builder.mech.criticals.iter().position(|c| c == name);
        let index = known.unwrap_or_else(|| {
            self.builder.mech.criticals.push(name.clone());
            self.builder.mech.criticals.len() - 1
        });
        Some(Typed::new(Expr::Query(Query::Critical(index)), ty))
    }

    /// `frictionless(Mb)`
    pub(crate) fn frictionless(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 1)?;
        let t = self.read(args[0])?;
        if t.value().is_some() || t.pending {
            return Some(t);
        }
        let expr = self.inline(&t.expr, call.span)?;
        let expr = Expr::Frictionless(Box::new(self.frictionless_over_sweep(&expr, call)));
        Some(Typed { expr, ..t })
    }
}
