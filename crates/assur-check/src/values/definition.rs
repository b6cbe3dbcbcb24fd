//! Definitions, `given`, `let` and `find NAME =`: what they come to.

use crate::values::typed::{Type, Typed};
use assur_model::model::{self, QuantityId};
use indexmap::IndexMap;

/// A definition that has been read.
#[derive(Clone, Debug)]
pub enum Settled {
    Constant(Typed),
    /// One value per pose.
    Result(QuantityId, Type),
    /// It cannot be solved yet.
    Pending(Type),
    /// It has an error.
    Failed,
}

/// Definitions and what they depend on.
#[derive(Debug, Default)]
pub struct Definitions {
    /// Each after those it depends on.
    pub order: Vec<String>,
    /// For each that depends on results: on which, in words.
    pub results: IndexMap<String, String>,
    /// Those that have been read.
    pub settled: IndexMap<String, Settled>,
    /// For each quantity of the mechanism, whether it needs no pose, and its size with all it depends on written out.
    pub kept: Vec<(bool, usize)>,
}

impl Definitions {
    /// What depends on no value: the order, and what depends on results.
    pub fn into_names(self) -> (Vec<String>, IndexMap<String, String>) {
        (self.order, self.results)
    }

    /// Definitions of which none has been read.
    pub fn of_names(order: Vec<String>, results: IndexMap<String, String>) -> Self {
        Self { order, results, ..Self::default() }
    }

    /// What a definition is, once it has been read.
    pub fn settled(&self, name: &str) -> Option<&Settled> {
        self.settled.get(name)
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

    pub fn needs_no_pose(&self, id: QuantityId) -> bool {
        self.kept.get(id.index()).is_some_and(|(poseless, _)| *poseless)
    }

    /// How many parts the expression has with all that it depends on written out.
    pub fn size(&self, expr: &model::Expr) -> usize {
        let mut size = 0_usize;
        expr.parts(&mut |part| {
            let of_part = match part {
                model::Expr::Quantity(id) => self.kept.get(id.index()).map_or(1, |(_, size)| *size),
                _ => 1,
            };
            size = size.saturating_add(of_part);
        });
        size
    }
}
