//! The results that an expression depends on, through definitions.

use crate::names::declared::{Names, QuantityKind, takes_values};
use crate::statements::walk;
use crate::values::definition::Definitions;
use assur_syntax::document::{Expr, ExprKind};
use assur_text::source::Span;

impl Definitions {
    /// The first part of an expression that is known only once the mechanism is solved, in words.
    pub fn first_result(&self, names: &Names<'_>, expr: &Expr) -> Option<(Span, String)> {
        self.first_root(names, expr).map(|(span, root, via)| match via {
            Some(name) => (span, format!("`{name}`, which depends on {root}")),
            None => (span, root),
        })
    }

    /// As [`Definitions::first_result`], but calls of this function are no such part.
    pub fn first_result_beside(
        &self,
        names: &Names<'_>,
        expr: &Expr,
        function: &str,
    ) -> Option<(Span, String)> {
        let mut first = None;
        values(expr, &mut |part| {
            let call = matches!(&part.kind, ExprKind::Call { function: f, .. } if f.node == function);
            let plain = matches!(&part.kind, ExprKind::Call { .. } | ExprKind::Name(_));
            if first.is_none() && !call && plain {
                first = match &part.kind {
                    ExprKind::Call { function, args } if names.is_result(&function.node, args) => {
                        Some((part.span, format!("`{}(…)`", function.node)))
                    }
                    ExprKind::Name(name) => self.root_of(names, name).map(|(root, via)| {
                        let text =
                            via.map_or(root.clone(), |via| format!("`{via}`, which depends on {root}"));
                        (part.span, text)
                    }),
                    _ => None,
                };
            }
        });
        first
    }

    /// The first such part, the result it depends on, and the name that contains it.
    pub fn first_root(&self, names: &Names<'_>, expr: &Expr) -> Option<(Span, String, Option<String>)> {
        let mut first = None;
        values(expr, &mut |part| {
            if first.is_some() {
                return;
            }
            first = match &part.kind {
                ExprKind::Call { function, args } if names.is_result(&function.node, args) => {
                    Some((part.span, format!("`{}(…)`", function.node), None))
                }
                ExprKind::Name(name) => self.root_of(names, name).map(|(root, via)| (part.span, root, via)),
                _ => None,
            };
        });
        first
    }

    fn root_of(&self, names: &Names<'_>, name: &str) -> Option<(String, Option<String>)> {
        match names.quantities.get(name).map(|d| d.what) {
            Some(
                QuantityKind::Load(..)
                | QuantityKind::Brake(_)
                | QuantityKind::Balance(..)
                | QuantityKind::Flywheel(_),
            ) => Some((format!("`{name}`"), None)),
            Some(_) => self.results.get(name).map(|root| (root.clone(), Some(name.to_owned()))),
            None => (name == "time").then(|| ("`time`".to_owned(), None)),
        }
    }
}

/// Calls `visit` on all parts that stand for values: the arguments of `velocity(C)` are names of things.
pub fn values<'a>(expr: &'a Expr, visit: &mut dyn FnMut(&'a Expr)) {
    if let ExprKind::Call { function, args } = &expr.kind {
        visit(expr);
        if takes_values(&function.node) {
            args.iter().for_each(|a| values(&a.value, visit));
        }
        return;
    }
    visit(expr);
    walk::children(expr, &mut |child| values(child, visit));
}
