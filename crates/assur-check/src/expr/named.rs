//! The value a name stands for.

use crate::expr::context::Context;
use crate::names::declared::{QuantityKind, ThingKind};
use crate::names::suggestion::not_declared;
use crate::statements::walk;
use crate::values::definition::Settled;
use crate::values::typed::{Type, Typed};
use assur_model::model;
use assur_syntax::document::{Balance, Column, Expr, ExprKind, JointKind, LoadKind, Name, Site, Statement};
use assur_text::units::{Dimension, Kind};

impl Context<'_> {
    /// The value a name stands for.
    pub(crate) fn named(&mut self, name: &Name) -> Option<Typed> {
        self.names.note_quantity(name);
        let Some(declared) = self.names.quantities.get(&name.node) else {
            return self.values.outside.key(&name.node).or_else(|| self.undeclared(name));
        };
        match declared.what {
            QuantityKind::Load(id, load) => {
                let dimension = dimension_of(load.kind.node);
                let vector = load.kind.node == LoadKind::Force && !matches!(load.site, Site::Pair(_));
                let ty = if vector { Type::vector(dimension) } else { Type::number(dimension) };
                Some(Typed::new(model::Expr::Query(model::Query::Load(id)), ty))
            }
            QuantityKind::Brake(id) => {
                let torque = model::Expr::Query(model::Query::Load(id));
                Some(Typed::new(torque, Type::number(Dimension::TORQUE)))
            }
            QuantityKind::Balance(id, balance) => {
                if self.is_wrong_effort(balance) {
                    return None;
                }
                let ty = Type::number(dimension_of(balance.kind.node));
                Some(Typed::new(model::Expr::Query(model::Query::Balance(id)), ty))
            }
            QuantityKind::Column(column) => self.column(column, name),
            QuantityKind::Curve(curve) => {
                self.uncalled(&name.node, curve, name.span);
                None
            }
            QuantityKind::Flywheel(index) => {
                let query = model::Query::Flywheel(index, model::FlywheelPart::Inertia);
                Some(Typed::new(model::Expr::Query(query), Type::number(Dimension::INERTIA)))
            }
            QuantityKind::Given(_) | QuantityKind::Let(_) | QuantityKind::Find(_) => {
                match self.values.definitions.settled.get(&name.node)? {
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
        if let Some(value) = self.values.outside.key(&name.node) {
            return Some(value);
        }
        let dimension = match &column.unit {
            Some(word) => self.unit(word)?.dimension,
            None => Dimension::NUMBER,
        };
        if self.used_by_expect(&column.name.node) {
            return Some(Typed::pending(Type::number(dimension)));
        }
        if self.problems.reported.insert(("quantity", name.node.clone())) {
            let words = format!(
                "a column of variants replaces the value of a `given`: add `given {} = …`",
                name.node
            );
            let help = Some(words.into());
            let (name, span) = (name.node.clone(), name.span);
            self.error(not_declared("quantity", &name, None, span, help));
        }
        None
    }

    /// Whether nothing but expectations use this name.
    pub(crate) fn used_by_expect(&self, name: &str) -> bool {
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

    /// Whether it acts in a pair that does not move that way, which is reported where it is declared.
    pub(crate) fn is_wrong_effort(&self, balance: &Balance) -> bool {
        let Site::Pair(pair) = &balance.site else { return false };
        let Some(ThingKind::Joint(kind)) = self.names.things.get(&pair.node).map(|d| d.what) else {
            return false;
        };
        (kind == JointKind::Revolute) != (balance.kind.node == LoadKind::Torque)
    }

    fn undeclared(&mut self, name: &Name) -> Option<Typed> {
        match name.node.as_str() {
            "pi" => {
                let free = Dimension { kind: Kind::Free, ..Dimension::NUMBER };
                Some(Typed::constant(std::f64::consts::PI, free))
            }
            "time" if self.names.simulates => {
                Some(Typed::new(model::Expr::Query(model::Query::Time), Type::number(Dimension::TIME)))
            }
            _ => {
                (self.results.unknown)(self, name);
                None
            }
        }
    }

    /// The definition of a `given`, where nothing replaces it.
    pub(crate) fn given_as_written(&self, name: &str) -> Option<&Expr> {
        match self.names.quantities.get(name)?.what {
            QuantityKind::Given(e) if !self.values.outside.is_set(name) => Some(e),
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
