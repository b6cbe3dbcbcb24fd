//! Trees as lines: letters, or numbers, with brackets where they are needed.

use crate::expr::{Expr, Sign};
use crate::node::Node;
use crate::number::{Figures, shortest, with_digits};
use crate::quantity::{FEWEST, Name, Quantity};
use crate::unit::Unit;

/// The letters of a name.
#[must_use]
pub fn name_node(name: &Name) -> Node {
    Node::Letter {
        letter: name.letter.clone(),
        sub: name.sub.clone(),
        sup: name.sup.clone(),
        arrow: name.vector,
        power: 1,
    }
}

/// A formula in letters.
#[must_use]
pub fn letters(expr: &Expr) -> Node {
    Layer { digits: None }.lay(expr, true)
}

/// A formula in numbers, with this number of digits where a quantity does not keep its own.
pub(crate) fn numbers(expr: &Expr, digits: usize) -> Node {
    Layer { digits: Some(digits) }.lay(expr, true)
}

/// Letters, or numbers.
#[derive(Clone, Copy)]
struct Layer {
    digits: Option<usize>,
}

impl Layer {
    /// `first`: nothing is before it, so that a minus sign needs no brackets.
    fn lay(self, expr: &Expr, first: bool) -> Node {
        match expr {
            Expr::Int(n) => in_brackets_if(Node::Number(Figures::whole(*n)), *n < 0 && !first),
            Expr::Degrees(n) => in_brackets_if(Node::Degrees(Figures::whole(*n)), *n < 0 && !first),
            Expr::Number(x) => {
                let figures = shortest(*x, 11).unwrap_or_else(|| with_digits(*x, 11));
                in_brackets_if(Node::Number(figures), *x < 0.0 && !first)
            }
            Expr::Pi => Node::Pi,
            Expr::Leaf(q) => self.leaf(q, first),
            Expr::Neg(x) => {
                let sum = matches!(**x, Expr::Sum(_));
                let inner = if sum { brackets(self.lay(x, true)) } else { self.lay(x, false) };
                in_brackets_if(Node::Row(vec![Node::Minus, inner]), !first)
            }
            Expr::Sum(terms) => in_brackets_if(self.sum(terms), !first),
            Expr::Product(factors) => self.product(factors, first),
            Expr::Ratio(a, b) => Node::Fraction(Box::new(self.lay(a, true)), Box::new(self.lay(b, true))),
            Expr::Power(x, n) => self.power(x, *n),
            Expr::Root(x) => Node::Root(Box::new(self.lay(x, true))),
            Expr::Abs(x) => Node::Bars(Box::new(self.lay(x, true))),
            Expr::Of(function, x) => {
                let bare = function.is_of_angle() && matches!(**x, Expr::Leaf(_) | Expr::Degrees(_));
                let inner = self.lay(x, !bare);
                let bare = bare && !matches!(&inner, Node::Degrees(f) if f.exponent != 0);
                let inner = if bare { inner } else { brackets(self.lay(x, true)) };
                Node::Function(function.name(), Box::new(inner))
            }
        }
    }

    fn leaf(self, q: &Quantity, first: bool) -> Node {
        let digits = match self.digits {
            Some(digits) => digits,
            // a number among letters
            None if q.name.letter.is_empty() => FEWEST,
            None => return name_node(&q.name),
        };
        let figures = q.figures(digits);
        let negative = figures.negative;
        let node = if q.unit == Unit::Angle { Node::Degrees(figures) } else { Node::Number(figures) };
        in_brackets_if(node, negative && !first)
    }

    fn sum(self, terms: &[(Sign, Expr)]) -> Node {
        let mut row = Vec::new();
        for (i, (sign, x)) in terms.iter().enumerate() {
            match (i, sign) {
                (0, Sign::Plus) => {}
                (0, Sign::Minus) => row.push(Node::Minus),
                (_, Sign::Plus) => row.push(Node::Operator("+")),
                (_, Sign::Minus) => row.push(Node::Operator("−")),
            }
            row.push(self.lay(x, i == 0 && *sign == Sign::Plus));
        }
        Node::Row(row)
    }

    fn product(self, factors: &[Expr], first: bool) -> Node {
        let mut row = Vec::new();
        for (i, x) in factors.iter().enumerate() {
            if i > 0 {
                let whole = |x: &Expr| matches!(x, Expr::Int(_) | Expr::Number(_));
                let apart = self.digits.is_some() || whole(x) || whole(&factors[i - 1]) && i > 1;
                row.push(if apart { Node::Dot } else { Node::Times });
            }
            let sum = matches!(x, Expr::Sum(_));
            row.push(if sum { brackets(self.lay(x, true)) } else { self.lay(x, i == 0 && first) });
        }
        Node::Row(row)
    }

    fn power(self, x: &Expr, power: u8) -> Node {
        let inner = self.lay(x, false);
        match inner {
            Node::Letter { letter, sub, sup, arrow, .. } if sup.is_empty() => {
                Node::Letter { letter, sub, sup, arrow, power }
            }
            Node::Number(_) | Node::Pi | Node::Brackets(_) | Node::Bars(_) => {
                Node::Power(Box::new(inner), power)
            }
            inner => Node::Power(Box::new(brackets(inner)), power),
        }
    }
}

fn brackets(node: Node) -> Node {
    Node::Brackets(Box::new(node))
}

fn in_brackets_if(node: Node, wanted: bool) -> Node {
    if wanted { brackets(node) } else { node }
}
