//! An equation: a quantity, what it is in letters, in numbers, and its value.

use crate::expr::Expr;
use crate::lay::{letters, name_node, numbers};
use crate::lines::Lines;
use crate::node::Node;
use crate::number::Figures;
use crate::quantity::{self, Name, Quantity};
use crate::unit::Unit;
use std::sync::Arc;

/// An equation whose left side has its value from outside.
#[derive(Clone, Debug, PartialEq)]
pub struct Equation {
    pub left: Arc<Quantity>,
    pub right: Expr,
}

/// An equation with its digits chosen.
#[derive(Clone, Debug, PartialEq)]
pub struct Set {
    pub left: Node,
    /// The right side in letters; none where it has numbers alone.
    pub letters: Option<Node>,
    /// In numbers; none where there is but one.
    pub numbers: Option<Node>,
    pub result: Figures,
    pub unit: Unit,
    /// It misses what is printed: the sign before the result is "≈".
    pub approximate: bool,
}

/// How often the rounding of its leaves a tree may differ from its value.
const DISAGREES: f64 = 64.0;

/// What is less than this is rounding, whatever it is of.
const TINY: f64 = 1e-14;

impl Equation {
    /// A quantity of this value and what it is in other quantities.
    #[must_use]
    pub fn new(name: Name, value: f64, unit: Unit, right: Expr) -> Self {
        let least = if unit == Unit::Angle { 180.0 } else { 0.0 };
        let scale = right.scale().max(value.abs()).max(least);
        let rounding = right.rounding();
        Self { left: Arc::new(Quantity { name, value, unit, scale, given: false, rounding }), right }
    }

    /// The quantity that is found, as a leaf of others.
    #[must_use]
    pub fn found(&self) -> Expr {
        Expr::Leaf(Arc::clone(&self.left))
    }

    /// By how much the tree differs from the value, over what its terms are large against, where rounding does not explain it.
    #[must_use]
    pub fn disagrees(&self) -> Option<f64> {
        let off = (self.right.value() - self.left.value).abs();
        let rounding = DISAGREES * self.left.rounding;
        if off <= rounding || off <= TINY {
            return None;
        }
        let scale = self.right.scale();
        if off <= rounding + DISAGREES * f64::EPSILON * scale { None } else { Some(off / scale) }
    }

    #[must_use]
    pub fn set(&self) -> Set {
        let (result, count, balances) = quantity::of(self.left.value, &self.right);
        let mut quantities = 0;
        self.right.visit(&mut |_| quantities += 1);
        // one number is not written twice
        let alone = match &self.right {
            Expr::Leaf(q) => q.figures(count).value() == result.value(),
            Expr::Neg(x) => {
                matches!(&**x, Expr::Leaf(q) if q.value > 0.0 && q.figures(count).value() == -result.value())
            }
            Expr::Degrees(_) => true,
            _ => false,
        };
        let in_numbers = numbers(&self.right, count);
        Set {
            left: name_node(&self.left.name),
            letters: (quantities > 0).then(|| letters(&self.right)),
            numbers: (!alone).then_some(in_numbers),
            result,
            unit: self.left.unit,
            approximate: !balances,
        }
    }

    /// As lines to print.
    #[must_use]
    pub fn lines(&self) -> Lines {
        self.set().lines()
    }
}

impl Set {
    /// As lines to print.
    #[must_use]
    pub fn lines(self) -> Lines {
        let equals = if self.approximate { "≈" } else { "=" };
        let mut result = vec![Node::Operator(equals)];
        match self.unit {
            Unit::Angle => result.push(Node::Degrees(self.result)),
            Unit::One => result.push(Node::Number(self.result)),
            unit => result.extend([Node::Number(self.result), Node::Unit(unit.text().to_owned())]),
        }
        let side = |node: Node| Node::Row(vec![Node::Operator("="), node]);
        let mut sides: Vec<Node> = self.letters.into_iter().chain(self.numbers).map(side).collect();
        sides.push(Node::Row(result));
        Lines::broken(self.left, sides)
    }
}
