//! What the file asks for by formulas of its own, from the results of the position.

use crate::course::Derivation;
use crate::document::Block;
use crate::forces::quantity_name;
use crate::words::{Message, say};
use assur_formula::{Expr, Name, Unit};
use assur_model::model::{self, Axis, Function, PointRef, Query, Value};
use assur_model::structure::EffortSource;
use std::collections::BTreeMap;

/// A formula that comes to something else than the value is of a kind that is not written here.
const SAME: f64 = 1e-9;

/// A quantity that the file works out from results of a position.
#[derive(Clone, Debug)]
pub struct Formula {
    pub name: Name,
    pub unit: Unit,
    /// What it is, for its value.
    pub of: model::Expr,
    /// What it is, with letters of their own for results.
    pub right: Expr,
    /// These letters, and the results.
    pub results: Vec<(Name, model::Expr)>,
}

impl Derivation<'_> {
    /// The formulas whose results are derived, in order.
    pub fn formulas(&mut self, formulas: &[Formula]) {
        let before = self.blocks.len();
        for formula in formulas {
            self.by_formula(formula);
        }
        if self.blocks.len() > before {
            let words = say(self.language, Message::ByFormulas, &[]);
            self.insert(before, vec![Block::Paragraph(words)]);
        }
    }

    fn by_formula(&mut self, formula: &Formula) -> Option<()> {
        let value = self.value_in(formula.unit, &formula.of)?;
        let mut known = BTreeMap::new();
        for (name, result) in &formula.results {
            known.insert(name.clone(), self.result(result)?);
        }
        let right = formula.right.replaced(&|q| known.get(&q.name).cloned());
        let same = (right.value() - value).abs() <= SAME * right.scale().max(value.abs());
        if same && self.found.get(&formula.name).is_none_or(|own| own.value() != value) {
            self.asked.insert(formula.name.clone());
            self.equate(formula.name.clone(), value, formula.unit, right);
        }
        same.then_some(())
    }

    fn value_in(&self, unit: Unit, expr: &model::Expr) -> Option<f64> {
        match self.scene.view().value(expr) {
            Value::Scalar(x) if x.is_finite() => Some(if unit == Unit::Angle { x.to_degrees() } else { x }),
            _ => None,
        }
    }

    /// A result in the letters in which it was found; none where no step has it.
    pub(crate) fn result(&mut self, of: &model::Expr) -> Option<Expr> {
        use model::Expr as E;
        match of {
            E::Quantity(id) => {
                let quantity = self.scene.mechanism().quantities.get(id.index())?;
                let name = quantity_name(&quantity.name);
                match &quantity.expr {
                    E::Query(_) | E::Component(..) => self.result(&quantity.expr),
                    _ => self.found.get(&name).cloned(),
                }
            }
            E::Component(inner, axis) => {
                let quantity = match &**inner {
                    E::Quantity(id) => &self.scene.mechanism().quantities.get(id.index())?.expr,
                    other => other,
                };
                let E::Query(query) = quantity else { return None };
                self.component_of(query, *axis)
            }
            E::Call(Function::Mag, args) => match args.as_slice() {
                [E::Query(query)] => self.magnitude_of(query),
                _ => None,
            },
            E::Query(query) => self.number_of(query).or_else(|| self.scalar_symbol(query)),
            _ => None,
        }
    }

    pub(crate) fn number_of(&self, query: &Query) -> Option<Expr> {
        let body = |link: &model::LinkId| self.bodies[link.index()].as_ref();
        match query {
            Query::Omega(link) => Some(body(link)?.rates[0].clone()),
            Query::Alpha(link) => Some(body(link)?.rates[1].clone()),
            Query::Angle(link) => Some(body(link)?.angle.whole()),
            Query::Balance(id) => self.effort_of(EffortSource::Balance(*id)),
            Query::Effort(id) => self.effort_of(EffortSource::Drive(*id)),
            _ => None,
        }
    }

    fn effort_of(&self, source: EffortSource) -> Option<Expr> {
        let slot = self.structure().efforts.iter().position(|effort| effort.source == source)?;
        self.found.get(&self.effort_name(slot, self.is_force(slot))).cloned()
    }

    fn component_of(&mut self, query: &Query, axis: Axis) -> Option<Expr> {
        let i = usize::from(axis == Axis::Y);
        let parts = match query {
            Query::Position(PointRef::Fixed(link, at)) => self.position(link.index(), *at),
            Query::Velocity(PointRef::Fixed(link, at)) => self.velocity(link.index(), *at),
            Query::Acceleration(PointRef::Fixed(link, at)) => self.acceleration(link.index(), *at),
            Query::InertiaForce(link) => {
                let Value::Vector(force) = self.scene.view().query(query) else { return None };
                let index = format!("{}{}", self.language.letters().inertia, self.label(link.index()));
                let name = Name::new("F", &index);
                return self.with_value([name.and(["x", "y"][i]), name].into_iter(), [force.x, force.y][i]);
            }
            Query::Reaction(pair, _) => {
                let Value::Vector(force) = self.scene.view().query(query) else { return None };
                let value = [force.x, force.y][i];
                let names = self.reactions_of(*pair).into_iter();
                let names = names.flat_map(|name| [name.and(["x", "y"][i]), name]);
                return self.with_value(names.collect::<Vec<_>>().into_iter(), value);
            }
            _ => return None,
        };
        Some(parts[i].clone())
    }

    pub(crate) fn magnitude_of(&mut self, query: &Query) -> Option<Expr> {
        let Value::Vector(vector) = self.scene.view().query(query) else { return None };
        match query {
            Query::Reaction(pair, _) => {
                let found = self.with_value(self.reactions_of(*pair).into_iter(), vector.norm())?;
                Some(if found.value() < 0.0 { found.abs() } else { found })
            }
            Query::InertiaForce(link) => {
                let index = format!("{}{}", self.language.letters().inertia, self.label(link.index()));
                self.found.get(&Name::new("F", &index)).cloned()
            }
            _ => None,
        }
    }

    /// The letters of the reactions in a pair.
    pub(crate) fn reactions_of(&self, pair: model::PairId) -> Vec<Name> {
        let joints: Vec<_> = self.structure().replaced.joints_of(pair).collect();
        let slots = self.scene.model.plan.reactions.iter().enumerate();
        slots
            .filter(|(_, r)| joints.contains(&r.joint))
            .filter_map(|(slot, _)| self.free.reactions[slot].clone())
            .collect()
    }

    /// What was found by one of these letters with a value, or with its opposite.
    pub(crate) fn with_value(&self, names: impl Iterator<Item = Name>, value: f64) -> Option<Expr> {
        let mut found = names.filter_map(|name| self.found.get(&name).cloned());
        let near = |x: f64| (x - value).abs() <= SAME * value.abs();
        found.find_map(|x| if near(x.value()) { Some(x) } else { near(-x.value()).then(|| -x) })
    }
}
