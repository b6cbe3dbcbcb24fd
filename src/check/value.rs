//! `given`, `let` and `find NAME =`: in which order they hang on one another, and what they are.

use super::context::Context;
use super::error::{NameError, RequestError};
use super::expr::typed::{Type, Typed};
use super::names::QuantityKind;
use super::unit_choice::display_in;
use super::walk;
use crate::diagnostic::did_you_mean;
use crate::model::{self, Display, NamedValue, Quantity, QuantityId};
use crate::source::Span;
use crate::syntax::document::{Column, Expr, ExprKind, LoadKind, Name, Site, Statement};
use crate::units::{Dimension, Kind};
use indexmap::IndexMap;
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
    order: Vec<String>,
    /// For each that hangs on results: on which, in words.
    results: IndexMap<String, String>,
    /// Those that have been read.
    settled: IndexMap<String, Settled>,
    /// For each quantity of the mechanism, whether it needs no pose.
    poseless: Vec<bool>,
}

/// Finds the order of the definitions; reports those that hang on themselves.
pub fn order(cx: &mut Context<'_>) {
    let mut uses = IndexMap::new();
    for (name, declared) in &cx.names.quantities {
        if let Some(expr) = definition(declared.what) {
            uses.insert(name.clone(), names_in(cx, expr));
        }
    }
    let mut state: IndexMap<String, bool> = IndexMap::new(); // false: under way; true: done
    for start in uses.keys() {
        let mut path = vec![(start.clone(), 0)];
        while let Some((name, next)) = path.pop() {
            if next == 0 && state.insert(name.clone(), false).is_some() {
                state.insert(name, true);
                continue;
            }
            let Some(used) = uses[&name].get(next) else {
                state.insert(name.clone(), true);
                cx.definitions.order.push(name);
                continue;
            };
            path.push((name, next + 1));
            match state.get(used) {
                None => path.push((used.clone(), 0)),
                Some(false) => cycle(cx, &path, used),
                Some(true) => {}
            }
        }
    }
    for name in cx.definitions.order.clone() {
        let Some(declared) = cx.names.quantities.get(&name) else { continue };
        let found = definition(declared.what).and_then(|e| cx.first_result(e)).map(|(_, result)| result);
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
        | QuantityKind::Flywheel
        | QuantityKind::Column(_) => None,
    }
}

/// The definitions whose values an expression uses.
fn names_in(cx: &Context<'_>, expr: &Expr) -> Vec<String> {
    let mut found = Vec::new();
    values(expr, &mut |part| {
        if let ExprKind::Name(name) = &part.kind
            && cx.names.quantities.get(name).is_some_and(|d| definition(d.what).is_some())
            && !found.contains(name)
        {
            found.push(name.clone());
        }
    });
    found
}

/// Calls `visit` on all parts that stand for values: the arguments of `velocity(C)` are names of things.
fn values<'a>(expr: &'a Expr, visit: &mut dyn FnMut(&'a Expr)) {
    if let ExprKind::Call { function, args } = &expr.kind {
        visit(expr);
        if super::query::takes_values(&function.node) {
            args.iter().for_each(|a| values(&a.value, visit));
        }
        return;
    }
    visit(expr);
    walk::children(expr, &mut |child| values(child, visit));
}

fn cycle(cx: &mut Context<'_>, path: &[(String, usize)], again: &str) {
    let from = path.iter().position(|(name, _)| name == again).unwrap_or(0);
    let names = path[from..].iter().map(|(name, _)| name.clone()).collect::<Vec<_>>();
    let place = |name: &String| cx.names.quantities.get(name).map_or_else(Span::default, |d| d.span);
    let label = |name: &String| LabeledSpan::at(place(name).start..place(name).end, "hangs on the next");
    let others = names.iter().skip(1).map(label).collect();
    let span = names.first().map_or_else(Span::default, place);
    let chain = names.iter().map(|n| format!("`{n}`")).chain([format!("`{again}`")]).collect::<Vec<_>>();
    for name in &names {
        cx.definitions.settled.insert(name.clone(), Settled::Failed);
    }
    cx.error(NameError::Cycle { name: again.to_owned(), chain: chain.join(" → "), span, others });
}

/// Reads the definitions that need no results, and the values from outside.
pub fn constants(cx: &mut Context<'_>) {
    super::overrides::apply(cx);
    for name in cx.definitions.order.clone() {
        let Some(kind) = cx.names.quantities.get(&name).map(|d| d.what) else { continue };
        if cx.definitions.settled.contains_key(&name) {
            continue;
        }
        let results = cx.definitions.results.contains_key(&name);
        let settled = match kind {
            QuantityKind::Given(expr) if results => {
                let result = cx.first_result(expr);
                if let Some((span, result)) = result {
                    cx.error(RequestError::NotConstant { what: format!("`given {name}`"), result, span });
                }
                Settled::Failed
            }
            QuantityKind::Given(expr) | QuantityKind::Let(expr) if !results => match cx.read(expr) {
                Some(t) if t.pending => Settled::Pending(t.ty),
                Some(t) => Settled::Constant(t),
                None => Settled::Failed,
            },
            _ => continue,
        };
        cx.definitions.settled.insert(name, settled);
    }
    list(cx);
}

/// Enters the values into the mechanism, in the order of the file.
fn list(cx: &mut Context<'_>) {
    for (name, declared) in &cx.names.quantities {
        let (QuantityKind::Given(expr) | QuantityKind::Let(expr)) = declared.what else { continue };
        let Some(Settled::Constant(t)) = cx.definitions.settled.get(name) else { continue };
        let Some(value) = t.value() else { continue };
        let display = own_unit(cx, expr).unwrap_or_else(|| cx.display(t.ty.dimension()));
        cx.mech.values.push(NamedValue { name: name.clone(), value, display });
    }
}

/// The unit of a value that is a number as written.
fn own_unit(cx: &Context<'_>, expr: &Expr) -> Option<Display> {
    match &expr.kind {
        ExprKind::Number(n) => cx.units.get(&n.unit.as_ref()?.node).map(|(unit, _)| display_in(unit)),
        ExprKind::Unary(_, inner) => own_unit(cx, inner),
        _ => None,
    }
}

/// Reads the definitions that hang on results. Only once the pairs are in the mechanism.
pub fn results(cx: &mut Context<'_>) {
    for name in cx.definitions.order.clone() {
        let Some((kind, span)) = cx.names.quantities.get(&name).map(|d| (d.what, d.span)) else { continue };
        if cx.definitions.settled.contains_key(&name) {
            continue;
        }
        let settled = match kind {
            QuantityKind::Let(expr) => {
                let read = cx.read(expr);
                let read = read.map(|t| {
                    let display = cx.display(t.ty.dimension());
                    (t, display)
                });
                keep(cx, name.clone(), span, read)
            }
            QuantityKind::Find(item) => {
                let read = cx.read_item(item);
                keep(cx, name.clone(), span, read)
            }
            _ => continue,
        };
        cx.settle(&name, settled);
    }
}

fn keep(cx: &mut Context<'_>, name: String, span: Span, read: Option<(Typed, Display)>) -> Settled {
    let Some((t, display)) = read else { return Settled::Failed };
    if t.pending {
        return Settled::Pending(t.ty);
    }
    let id = QuantityId::at(cx.mech.quantities.len());
    let poseless = cx.is_poseless(&t.expr);
    cx.definitions.poseless.push(poseless);
    cx.mech.quantities.push(Quantity { name, span, expr: t.expr, display });
    Settled::Result(id, t.ty)
}

impl Context<'_> {
    /// What a definition is, once it has been read.
    pub fn settled(&self, name: &str) -> Option<&Settled> {
        self.definitions.settled.get(name)
    }

    /// Sets what a `given` is.
    pub(super) fn settle(&mut self, name: &str, settled: Settled) {
        self.definitions.settled.insert(name.to_owned(), settled);
    }

    /// The first part of an expression that is known only once the mechanism is solved, in words.
    pub fn first_result(&self, expr: &Expr) -> Option<(Span, String)> {
        let mut first = None;
        values(expr, &mut |part| {
            if first.is_some() {
                return;
            }
            first = match &part.kind {
                ExprKind::Call { function, args } if self.is_result(&function.node, args) => {
                    Some((part.span, format!("`{}(…)`", function.node)))
                }
                ExprKind::Name(name) => self.result_name(name).map(|why| (part.span, why)),
                _ => None,
            };
        });
        first
    }

    fn result_name(&self, name: &str) -> Option<String> {
        match self.names.quantities.get(name).map(|d| d.what) {
            Some(QuantityKind::Load(..) | QuantityKind::Balance(..) | QuantityKind::Flywheel) => {
                Some(format!("`{name}`"))
            }
            Some(_) => {
                self.definitions.results.get(name).map(|why| format!("`{name}`, which hangs on {why}"))
            }
            None => (name == "time").then(|| "`time`".to_owned()),
        }
    }

    /// The value a name stands for.
    pub(super) fn named(&mut self, name: &Name) -> Option<Typed> {
        let Some(declared) = self.names.quantities.get(&name.node) else {
            return self.undeclared(name);
        };
        match declared.what {
            QuantityKind::Load(id, load) => {
                let dimension = dimension_of(load.kind.node);
                let vector = load.kind.node == LoadKind::Force && matches!(load.site, Site::Link { .. });
                let ty = if vector { Type::vector(dimension) } else { Type::number(dimension) };
                Some(Typed::new(model::Expr::Query(model::Query::Load(id)), ty))
            }
            QuantityKind::Balance(id, balance) => {
                let ty = Type::number(dimension_of(balance.kind.node));
                Some(Typed::new(model::Expr::Query(model::Query::Balance(id)), ty))
            }
            QuantityKind::Column(column) => self.column(column, name),
            QuantityKind::Flywheel => {
                self.unsupported("a flywheel", name.span);
                Some(Typed::pending(Type::number(Dimension::INERTIA)))
            }
            QuantityKind::Given(_) | QuantityKind::Let(_) | QuantityKind::Find(_) => {
                match self.definitions.settled.get(&name.node)? {
                    Settled::Constant(t) => Some(t.clone()),
                    Settled::Result(id, ty) => Some(Typed::new(model::Expr::Quantity(*id), *ty)),
                    Settled::Pending(ty) => Some(Typed::pending(*ty)),
                    Settled::Failed => None,
                }
            }
        }
    }

    /// A name that has its values in a table of variants alone: an answer key per row.
    fn column(&mut self, column: &Column, name: &Name) -> Option<Typed> {
        let dimension = match &column.unit {
            Some(word) => self.unit(word)?.dimension,
            None => Dimension::NUMBER,
        };
        if self.used_by_expect(&column.name.node) {
            return Some(Typed::pending(Type::number(dimension)));
        }
        if self.reported.insert(("quantity", name.node.clone())) {
            let help = Some(format!(
                "a column of variants replaces the value of a `given`: add `given {} = …`",
                name.node
            ));
            let (name, span) = (name.node.clone(), name.span);
            self.error(NameError::Unknown { kind: "quantity", name, place: String::new(), span, help });
        }
        None
    }

    /// Whether nothing but expectations use this name.
    pub(super) fn used_by_expect(&self, name: &str) -> bool {
        let mut expected = false;
        let mut elsewhere = false;
        for statement in &self.doc.statements {
            let expect = matches!(statement.node, Statement::Expect(_));
            walk::expressions(&statement.node, &mut |expr| {
                walk::parts(expr, &mut |part| {
                    if matches!(&part.kind, ExprKind::Name(n) if n == name) {
                        expected |= expect;
                        elsewhere |= !expect;
                    }
                });
            });
        }
        expected && !elsewhere
    }

    fn undeclared(&mut self, name: &Name) -> Option<Typed> {
        match name.node.as_str() {
            "pi" => {
                let free = Dimension { kind: Kind::Free, ..Dimension::NUMBER };
                Some(Typed::constant(std::f64::consts::PI, free))
            }
            "time" => {
                self.unsupported("`time`: motion under loads", name.span);
                Some(Typed::pending(Type::number(Dimension::TIME)))
            }
            _ => {
                self.no_quantity(name);
                None
            }
        }
    }

    fn no_quantity(&mut self, name: &Name) {
        let bad = self.names.bad.contains(&name.node);
        if bad || !self.reported.insert(("quantity", name.node.clone())) {
            return;
        }
        let thing = self.names.things.get(&name.node).map(|d| (d.what.phrase(), Some(d.span), d.what));
        let error = if let Some((is, declared, what)) = thing {
            NameError::WrongKind {
                name: name.node.clone(),
                is,
                wanted: "a quantity".into(),
                span: name.span,
                declared,
                help: super::query::ask_of(what, &name.node),
            }
        } else {
            let all = self.names.quantities.keys().map(String::as_str).collect::<Vec<_>>();
            let near = || did_you_mean(&name.node, ["pi"]).first().map(|_| "did you mean `pi`?".to_owned());
            let help = near().or_else(|| super::lookup::suggestion(&name.node, &all, "quantities"));
            let (name, span) = (name.node.clone(), name.span);
            NameError::Unknown { kind: "quantity", name, place: String::new(), span, help }
        };
        self.error(error);
    }

    /// Whether the expression needs no pose.
    pub fn is_poseless(&self, expr: &model::Expr) -> bool {
        let mut poseless = true;
        expr.parts(&mut |part| {
            poseless &= match part {
                model::Expr::Quantity(id) => self.definitions.poseless.get(id.index()) == Some(&true),
                model::Expr::Query(q) => {
                    matches!(q, model::Query::Stroke(_) | model::Query::TimeRatio(_) | model::Query::Dead(..))
                }
                _ => true,
            };
        });
        poseless
    }

    /// Calls `visit` on every result the expression hangs on, those behind other quantities included.
    pub fn queries_behind(&self, expr: &model::Expr, visit: &mut dyn FnMut(&model::Query)) {
        expr.parts(&mut |part| match part {
            model::Expr::Query(query) => visit(query),
            model::Expr::Quantity(id) => {
                if let Some(quantity) = self.mech.quantities.get(id.index()) {
                    self.queries_behind(&quantity.expr, visit);
                }
            }
            _ => {}
        });
    }

    /// The expression with quantities that need no pose written out.
    pub(super) fn inline(&self, expr: &model::Expr) -> model::Expr {
        expr.map_leaves(&mut |leaf| match leaf {
            model::Expr::Quantity(id) if self.definitions.poseless.get(id.index()) == Some(&true) => {
                self.inline(&self.mech.quantities[id.index()].expr)
            }
            other => other.clone(),
        })
    }

    /// The definition of a `given`, where nothing replaces it.
    pub(super) fn given_as_written(&self, name: &str) -> Option<&Expr> {
        match self.names.quantities.get(name)?.what {
            QuantityKind::Given(e) if self.overrides.values.iter().all(|(n, _)| n != name) => Some(e),
            _ => None,
        }
    }
}

const fn dimension_of(kind: LoadKind) -> Dimension {
    match kind {
        LoadKind::Force => Dimension::FORCE,
        LoadKind::Torque => Dimension::TORQUE,
    }
}
