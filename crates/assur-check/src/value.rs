//! What `given`, `let` and `find NAME =` are.

use super::context::Context;
use super::definition::Settled;
use super::error::{NameError, RequestError, UnitsError};
use super::expr::typed::{Type, Typed};
use super::names::QuantityKind;
use super::overrides;
use super::row::ColumnUse;
use super::unit_choice::display_in;
use super::walk;
use crate::model::{self, Display, NamedValue, Quantity, QuantityId};
use crate::source::Span;
use crate::syntax::document::{Column, Expr, ExprKind, LoadKind, Name, Site, Statement};
use crate::units::{Dimension, Kind};
use indexmap::IndexSet;

/// The largest expression of a drive, in parts.
const LARGEST: usize = 2000;

/// Reads the definitions that need no results, and the values from outside.
pub fn constants(cx: &mut Context<'_>) {
    overrides::unknown_names(cx);
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
                Some(t) => overrides::replaced(cx, &name, t).map_or(Settled::Failed, Settled::Constant),
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
        cx.definitions.settled.insert(name, settled);
    }
}

fn keep(cx: &mut Context<'_>, name: String, span: Span, read: Option<(Typed, Display)>) -> Settled {
    let Some((t, display)) = read else { return Settled::Failed };
    if t.pending {
        return Settled::Pending(t.ty);
    }
    let id = QuantityId::at(cx.mech.quantities.len());
    let kept = (cx.is_poseless(&t.expr), cx.size(&t.expr));
    cx.definitions.kept.push(kept);
    cx.mech.quantities.push(Quantity { name, span, expr: t.expr, display });
    Settled::Result(id, t.ty)
}

impl Context<'_> {
    /// What a definition is, once it has been read.
    pub fn settled(&self, name: &str) -> Option<&Settled> {
        self.definitions.settled.get(name)
    }

    /// The value a name stands for.
    pub(super) fn named(&mut self, name: &Name) -> Option<Typed> {
        let Some(declared) = self.names.quantities.get(&name.node) else {
            return self.key(&name.node).or_else(|| self.undeclared(name));
        };
        match declared.what {
            QuantityKind::Load(id, load) => {
                let dimension = dimension_of(load.kind.node);
                let vector = load.kind.node == LoadKind::Force && matches!(load.site, Site::Link { .. });
                let ty = if vector { Type::vector(dimension) } else { Type::number(dimension) };
                Some(Typed::new(model::Expr::Query(model::Query::Load(id)), ty))
            }
            QuantityKind::Balance(id, balance) => {
                if self.is_wrong_effort(balance) {
                    return None;
                }
                let ty = Type::number(dimension_of(balance.kind.node));
                Some(Typed::new(model::Expr::Query(model::Query::Balance(id)), ty))
            }
            QuantityKind::Column(column) => self.column(column, name),
            QuantityKind::Flywheel(index) => {
                let query = model::Query::Flywheel(index, model::FlywheelPart::Inertia);
                Some(Typed::new(model::Expr::Query(query), Type::number(Dimension::INERTIA)))
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
        if let Some(value) = self.key(&name.node) {
            return Some(value);
        }
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

    /// What the row of variants says of a name that has its values there alone.
    fn key(&self, name: &str) -> Option<Typed> {
        let (column, cell) = self.row.find(name).filter(|(c, _)| c.what == ColumnUse::Key)?;
        Some(Typed::constant(cell.value, column.dimension))
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

    /// Whether the expression needs no pose.
    pub fn is_poseless(&self, expr: &model::Expr) -> bool {
        let mut poseless = true;
        expr.parts(&mut |part| {
            poseless &= match part {
                model::Expr::Quantity(id) => self.needs_no_pose(*id),
                model::Expr::Query(query) => query.facts().poseless,
                _ => true,
            };
        });
        poseless
    }

    fn needs_no_pose(&self, id: QuantityId) -> bool {
        self.definitions.kept.get(id.index()).is_some_and(|(poseless, _)| *poseless)
    }

    /// How many parts the expression has with all that it hangs on written out.
    fn size(&self, expr: &model::Expr) -> usize {
        let mut size = 0_usize;
        expr.parts(&mut |part| {
            let of_part = match part {
                model::Expr::Quantity(id) => {
                    self.definitions.kept.get(id.index()).map_or(1, |(_, size)| *size)
                }
                _ => 1,
            };
            size = size.saturating_add(of_part);
        });
        size
    }

    /// Calls `visit` on every result the expression hangs on, those behind other quantities included.
    pub fn queries_behind(&self, expr: &model::Expr, visit: &mut dyn FnMut(&model::Query)) {
        let mut found = Behind::default();
        found.look(expr, visit);
        let (mut quantities, mut cycles) = (0, 0);
        loop {
            let quantity = found.quantities.get_index(quantities).map(|id| id.index());
            let cycle = found.cycles.get_index(cycles).copied();
            let next = match (quantity, cycle) {
                (Some(index), _) => {
                    quantities += 1;
                    self.mech.quantities.get(index).map(|q| &q.expr)
                }
                (None, Some(index)) => {
                    cycles += 1;
                    self.mech.cycles.get(index).map(|c| &c.expr)
                }
                (None, None) => return,
            };
            if let Some(next) = next {
                found.look(next, visit);
            }
        }
    }

    /// The expression with quantities that need no pose written out. Reports one that grows too large.
    pub(super) fn inline(&mut self, expr: &model::Expr, span: Span) -> Option<model::Expr> {
        if self.size(expr) > LARGEST {
            self.error(UnitsError::NoValue { why: "written out it is too long", span, help: None });
            return None;
        }
        Some(self.written_out(expr))
    }

    fn written_out(&self, expr: &model::Expr) -> model::Expr {
        expr.map_leaves(&mut |leaf| match leaf {
            model::Expr::Quantity(id) if self.needs_no_pose(*id) => {
                self.written_out(&self.mech.quantities[id.index()].expr)
            }
            other => other.clone(),
        })
    }

    /// The definition of a `given`, where nothing replaces it.
    pub(super) fn given_as_written(&self, name: &str) -> Option<&Expr> {
        match self.names.quantities.get(name)?.what {
            QuantityKind::Given(e) if !self.is_set(name) => Some(e),
            _ => None,
        }
    }

    fn is_set(&self, name: &str) -> bool {
        self.overrides.values.iter().any(|(n, _)| n == name)
    }

    /// One unit in the last digit of a name in the row of variants, SI, where nothing replaces it.
    pub(super) fn digit_in_row(&self, name: &str) -> Option<f64> {
        self.row.find(name).filter(|_| !self.is_set(name)).map(|(_, cell)| cell.digit)
    }
}

/// What an expression hangs on: quantities and functions over the sweep.
#[derive(Default)]
struct Behind {
    quantities: IndexSet<QuantityId>,
    cycles: IndexSet<usize>,
}

impl Behind {
    fn look(&mut self, expr: &model::Expr, visit: &mut dyn FnMut(&model::Query)) {
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

const fn dimension_of(kind: LoadKind) -> Dimension {
    match kind {
        LoadKind::Force => Dimension::FORCE,
        LoadKind::Torque => Dimension::TORQUE,
    }
}
