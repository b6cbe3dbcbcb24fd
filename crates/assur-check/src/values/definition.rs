//! Definitions, `given`, `let` and `find NAME =`: in which order they hang on one another, and on what.

use crate::error::NameError;
use crate::expr::context::Context;
use crate::names::declare::QuantityKind;
use crate::statements::walk;
use crate::values::typed::{Type, Typed};
use assur_model::model::QuantityId;
use assur_syntax::document::{Expr, ExprKind};
use assur_text::source::Span;
use indexmap::{IndexMap, IndexSet};
use miette::LabeledSpan;

/// A definition that has been read.
#[derive(Clone, Debug)]
pub enum Settled {
    /// A value.
    Constant(Typed),
    /// One value per pose.
    Result(QuantityId, Type),
    /// It cannot be solved yet.
    Pending(Type),
    /// It has an error.
    Failed,
}

/// Definitions and what they hang on.
#[derive(Debug, Default)]
pub struct Definitions {
    /// Each after those it hangs on.
    pub(crate) order: Vec<String>,
    /// For each that hangs on results: on which, in words.
    pub(crate) results: IndexMap<String, String>,
    /// Those that have been read.
    pub(crate) settled: IndexMap<String, Settled>,
    /// For each quantity of the mechanism, whether it needs no pose, and its size with all it hangs on written out.
    pub(crate) kept: Vec<(bool, usize)>,
}

impl Definitions {
    /// What hangs on no value: the order, and what hangs on results.
    pub(crate) fn into_names(self) -> (Vec<String>, IndexMap<String, String>) {
        (self.order, self.results)
    }

    /// Definitions of which none has been read.
    pub(crate) fn of_names(order: Vec<String>, results: IndexMap<String, String>) -> Self {
        Self { order, results, ..Self::default() }
    }
}

/// Finds the order of the definitions; reports those that hang on themselves.
pub fn order(cx: &mut Context<'_>) {
    // By the place of a name among the quantities; nothing where it is no definition.
    let expressions = cx.names.quantities.values().map(|d| definition(d.what));
    let uses = expressions.map(|e| e.map(|e| names_in(cx, e))).collect::<Vec<_>>();
    let mut state = vec![None; uses.len()]; // false: under way; true: done
    for start in (0..uses.len()).filter(|i| uses[*i].is_some()) {
        let mut path = vec![(start, 0)];
        while let Some((name, next)) = path.pop() {
            if next == 0 && state[name].replace(false).is_some() {
                state[name] = Some(true);
                continue;
            }
            let Some(&used) = uses[name].as_ref().and_then(|used| used.get(next)) else {
                state[name] = Some(true);
                let name = cx.names.quantities.get_index(name).map(|(name, _)| name.clone());
                cx.definitions.order.extend(name);
                continue;
            };
            path.push((name, next + 1));
            match state[used] {
                None => path.push((used, 0)),
                Some(false) => cycle(cx, &path, used),
                Some(true) => {}
            }
        }
    }
    for name in cx.definitions.order.clone() {
        let Some(declared) = cx.names.quantities.get(&name) else { continue };
        let found = definition(declared.what).and_then(|e| cx.first_root(e)).map(|(_, root, _)| root);
        let found = found.or_else(|| {
            matches!(declared.what, QuantityKind::Find(_)).then(|| "what is to be found".to_owned())
        });
        if let Some(result) = found {
            cx.definitions.results.insert(name, result);
        }
    }
}

fn definition(kind: QuantityKind<'_>) -> Option<&Expr> {
    match kind {
        QuantityKind::Given(e) | QuantityKind::Let(e) => Some(e),
        QuantityKind::Find(item) => Some(&item.value),
        QuantityKind::Load(..)
        | QuantityKind::Balance(..)
        | QuantityKind::Flywheel(_)
        | QuantityKind::Column(_) => None,
    }
}

/// The definitions whose values an expression uses, as places among the quantities.
fn names_in(cx: &Context<'_>, expr: &Expr) -> Vec<usize> {
    let mut found = IndexSet::new();
    values(expr, &mut |part| {
        if let ExprKind::Name(name) = &part.kind
            && let Some((index, _, declared)) = cx.names.quantities.get_full(name)
            && definition(declared.what).is_some()
        {
            found.insert(index);
        }
    });
    found.into_iter().collect()
}

/// Calls `visit` on all parts that stand for values: the arguments of `velocity(C)` are names of things.
fn values<'a>(expr: &'a Expr, visit: &mut dyn FnMut(&'a Expr)) {
    if let ExprKind::Call { function, args } = &expr.kind {
        visit(expr);
        if crate::names::functions::takes_values(&function.node) {
            args.iter().for_each(|a| values(&a.value, visit));
        }
        return;
    }
    visit(expr);
    walk::children(expr, &mut |child| values(child, visit));
}

/// How many names of a way round are shown.
const SHOWN: usize = 6;

/// `a` → `b` → `a`, the middle left out where it is long.
pub(crate) fn way_round(names: &[String]) -> String {
    let mut quoted = names.iter().take(SHOWN).map(|n| format!("`{n}`")).collect::<Vec<_>>();
    if names.len() > SHOWN {
        quoted.push(format!("{} more", names.len() - SHOWN));
    }
    quoted.extend(names.first().map(|n| format!("`{n}`")));
    quoted.join(" → ")
}

fn cycle(cx: &mut Context<'_>, path: &[(usize, usize)], again: usize) {
    let from = path.iter().position(|(name, _)| *name == again).unwrap_or(0);
    let named = |index: usize| cx.names.quantities.get_index(index).map(|(name, _)| name.clone());
    let names = path[from..].iter().filter_map(|(name, _)| named(*name)).collect::<Vec<_>>();
    let again = named(again).unwrap_or_default();
    let place = |name: &String| cx.names.quantities.get(name).map_or_else(Span::default, |d| d.span);
    let label = |name: &String| LabeledSpan::at(place(name).start..place(name).end, "hangs on the next");
    let others = names.iter().skip(1).take(SHOWN).map(label).collect();
    let span = names.first().map_or_else(Span::default, place);
    let chain = way_round(&names);
    for name in &names {
        cx.definitions.settled.insert(name.clone(), Settled::Failed);
    }
    cx.error(NameError::Cycle { name: again, chain, span, others });
}

impl Context<'_> {
    /// The first part of an expression that is known only once the mechanism is solved, in words.
    pub fn first_result(&self, expr: &Expr) -> Option<(Span, String)> {
        self.first_root(expr).map(|(span, root, via)| match via {
            Some(name) => (span, format!("`{name}`, which depends on {root}")),
            None => (span, root),
        })
    }

    /// As [`Context::first_result`], but calls of this function are no such part.
    pub fn first_result_beside(&self, expr: &Expr, function: &str) -> Option<(Span, String)> {
        let mut first = None;
        values(expr, &mut |part| {
            let call = matches!(&part.kind, ExprKind::Call { function: f, .. } if f.node == function);
            let plain = matches!(&part.kind, ExprKind::Call { .. } | ExprKind::Name(_));
            if first.is_none() && !call && plain {
                first = match &part.kind {
                    ExprKind::Call { function, args } if self.is_result(&function.node, args) => {
                        Some((part.span, format!("`{}(…)`", function.node)))
                    }
                    ExprKind::Name(name) => self.root_of(name).map(|(root, via)| {
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

    /// The first such part, what it comes down to, and the name it is hidden behind.
    fn first_root(&self, expr: &Expr) -> Option<(Span, String, Option<String>)> {
        let mut first = None;
        values(expr, &mut |part| {
            if first.is_some() {
                return;
            }
            first = match &part.kind {
                ExprKind::Call { function, args } if self.is_result(&function.node, args) => {
                    Some((part.span, format!("`{}(…)`", function.node), None))
                }
                ExprKind::Name(name) => self.root_of(name).map(|(root, via)| (part.span, root, via)),
                _ => None,
            };
        });
        first
    }

    fn root_of(&self, name: &str) -> Option<(String, Option<String>)> {
        match self.names.quantities.get(name).map(|d| d.what) {
            Some(QuantityKind::Load(..) | QuantityKind::Balance(..) | QuantityKind::Flywheel(_)) => {
                Some((format!("`{name}`"), None))
            }
            Some(_) => self.definitions.results.get(name).map(|root| (root.clone(), Some(name.to_owned()))),
            None => (name == "time").then(|| ("`time`".to_owned(), None)),
        }
    }
}
