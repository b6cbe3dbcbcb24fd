//! Questions and expectations.

use super::{
    Answer, BinaryOp, Display, DriveId, Expr, Function, LinkId, Load, Mechanism, PairId, Query, Table, Value,
};
use crate::source::Span;

/// One item of `find`.
#[derive(Clone, Debug)]
pub struct Find {
    /// Its name, or its own text with single blanks: column, JSON key, and what `expect` may use.
    pub name: String,
    /// Place of the item.
    pub span: Span,
    pub kind: FindKind,
}

/// The question of a `find` item.
#[derive(Clone, Debug)]
pub enum FindKind {
    /// A value at every pose.
    Value {
        expr: Expr,
        /// How it is printed.
        display: Display,
        /// Needs no pose: given values, `dead`, `stroke`, `time_ratio`.
        poseless: bool,
    },
    /// All reactions in all pairs.
    Reactions,
    /// A table that needs no pose.
    Table(Table),
}

/// One `expect`.
#[derive(Clone, Debug)]
pub struct Expect {
    /// The left side's own text with single blanks.
    pub text: String,
    /// Place of the statement.
    pub span: Span,
    pub expr: Expr,
    pub relation: Relation,
    pub tolerance: Tolerance,
    /// Its pose; `None`: the only pose of the file, all poses for a list, or no pose needed.
    pub at: Option<At>,
    /// Compared modulo one turn.
    pub angle: bool,
    /// How it is printed.
    pub display: Display,
    pub poseless: bool,
}

/// The expectation of a value.
#[derive(Clone, Debug)]
pub enum Relation {
    /// Equal: one value, or one value per pose.
    Equal(Vec<Expr>),
    /// Stands in this relation to a bound.
    Compare(super::Comparison, Expr),
    /// A condition that is true.
    Condition,
}

/// The tolerance of an equality, all in SI.
#[derive(Clone, Debug, PartialEq)]
pub enum Tolerance {
    /// Relative to the expected value.
    Relative(f64),
    Absolute(f64),
    /// Inferred from the digits written, one per expected value: absolute, SI.
    Written(Vec<f64>),
    /// Comparisons and conditions have none.
    None,
}

/// The poses of an `expect`.
#[derive(Clone, Debug)]
pub enum At {
    /// A pose by name: of the sweep (`4`), or one of its own (`4'`).
    Pose(String, Span),
    /// Drive values: solved in addition to the sweep.
    Drives(Vec<(DriveId, Expr)>),
    /// An instant of a motion under loads, s.
    Time(f64),
    /// Its first or last instant, or an event.
    Occasion(super::Occasion),
}

/// A construct that parses and checks but cannot be solved yet.
#[derive(Clone, Debug)]
pub struct Unsupported {
    /// Its name, as in "friction in a pair".
    pub what: String,
    pub span: Span,
}

// Numbers or vectors: what the value of an expression is, whatever it is.

impl Mechanism {
    /// For each quantity, whether it is a vector.
    #[must_use]
    pub fn vector_quantities(&self) -> Vec<bool> {
        // they stand in the order in which one depends on another
        let mut known = Vec::with_capacity(self.quantities.len());
        for quantity in &self.quantities {
            let vector = self.is_vector(&quantity.expr, &known);
            known.push(vector);
        }
        known
    }

    /// Whether the value of an expression is a vector; `known` says it of the quantities that it depends on.
    #[must_use]
    pub fn is_vector(&self, expr: &Expr, known: &[bool]) -> bool {
        let is = |e: &Expr| self.is_vector(e, known);
        match expr {
            Expr::Constant(value) => matches!(value, Value::Vector(_)),
            Expr::Vector(..) | Expr::Polar(..) => true,
            Expr::Negate(a) | Expr::Frictionless(a) | Expr::Binary(BinaryOp::Div, a, _) => is(a),
            Expr::Binary(_, a, b) => is(a) || is(b),
            Expr::Call(function, _) => *function == Function::Unit,
            Expr::Quantity(id) => known.get(id.index()).copied().unwrap_or(false),
            Expr::Query(query) => match query.facts().answer {
                Answer::Vector => true,
                Answer::Number | Answer::Condition => false,
                Answer::Load(id) => self.loads.get(id.index()).is_some_and(Load::is_vector),
            },
            Expr::Component(..)
            | Expr::Power(..)
            | Expr::Compare(..)
            | Expr::And(..)
            | Expr::Or(..)
            | Expr::Not(_)
            | Expr::Curve(..) => false,
        }
    }

    /// Whether the value of an expression is a condition.
    #[must_use]
    pub fn is_condition(&self, expr: &Expr) -> bool {
        match expr {
            Expr::Constant(value) => matches!(value, Value::Bool(_)),
            Expr::Compare(..) | Expr::And(..) | Expr::Or(..) | Expr::Not(_) => true,
            Expr::Frictionless(a) => self.is_condition(a),
            Expr::Quantity(id) => self.quantities.get(id.index()).is_some_and(|q| self.is_condition(&q.expr)),
            Expr::Query(query) => query.facts().answer == Answer::Condition,
            Expr::Vector(..)
            | Expr::Polar(..)
            | Expr::Negate(_)
            | Expr::Binary(..)
            | Expr::Call(..)
            | Expr::Component(..)
            | Expr::Power(..)
            | Expr::Curve(..) => false,
        }
    }
}

impl Table {
    /// Those of its numbers that are found.
    pub fn questions(&self) -> impl Iterator<Item = &Expr> {
        self.entries.iter().flat_map(|entry| &entry.found)
    }

    /// Whether it has other numbers at each position.
    #[must_use]
    pub fn is_of_pose(&self) -> bool {
        let mut of_pose = false;
        self.questions().for_each(|expr| expr.queries(&mut |query| of_pose |= !query.facts().poseless));
        of_pose
    }
}

impl Mechanism {
    /// Calls `visit` on everything that the file asks for.
    pub fn each_question<'a>(&'a self, visit: &mut dyn FnMut(&'a Expr)) {
        for find in &self.finds {
            match &find.kind {
                FindKind::Value { expr, .. } => visit(expr),
                FindKind::Table(table) => table.questions().for_each(&mut *visit),
                FindKind::Reactions => {}
            }
        }
    }

    /// The questions of an expression, and of the named quantities in it.
    pub fn each_query(&self, expr: &Expr, see: &mut dyn FnMut(&Query)) {
        expr.queries(&mut |query| see(query));
        let mut named = Vec::new();
        expr.parts(&mut |part| {
            if let Expr::Quantity(id) = part {
                named.push(*id);
            }
        });
        for quantity in named.into_iter().filter_map(|id| self.quantities.get(id.index())) {
            self.each_query(&quantity.expr, see);
        }
    }

    /// Whether the file asks for something of a pair, or says how it rubs: then a reader has to know which one it is.
    #[must_use]
    pub fn speaks_of(&self, pair: PairId) -> bool {
        let mut asked = self.pair(pair).friction.is_some();
        let mut look = |expr: &Expr| {
            self.each_query(expr, &mut |query| asked |= query.pair() == Some(pair));
        };
        self.each_question(&mut look);
        self.cycles.iter().for_each(|cycle| look(&cycle.expr));
        asked
    }

    /// The links inside which the file asks for forces.
    #[must_use]
    pub fn asked_inside(&self) -> Vec<LinkId> {
        let mut links = Vec::new();
        let mut look = |expr: &Expr| {
            expr.queries(&mut |query| match query {
                Query::Internal(asked) if !links.contains(&asked.link) => links.push(asked.link),
                _ => {}
            });
        };
        self.each_question(&mut look);
        self.quantities.iter().for_each(|quantity| look(&quantity.expr));
        links
    }
}
