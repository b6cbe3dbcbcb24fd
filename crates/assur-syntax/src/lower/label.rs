//! What a question is called where it has no name: its expression, printed from the tree, so that blanks cannot rename it.

use crate::document::{Arg, BinaryOp, CompareOp, Expr, ExprKind, Number, UnaryOp};

/// An expression as text: words, numbers, units and brackets of the author, blanks by rule. `read` is the text that it was read from.
pub(super) fn label(expr: &Expr, read: &str) -> String {
    let mut label = Label { read, out: String::new() };
    label.expr(expr);
    label.out
}

struct Label<'t> {
    read: &'t str,
    out: String,
}

impl Label<'_> {
    fn expr(&mut self, expr: &Expr) {
        let brackets = self.is_bracketed(expr);
        self.out.push_str(if brackets { "(" } else { "" });
        match &expr.kind {
            ExprKind::Number(number) => self.number(number),
            ExprKind::Name(name) => self.out.push_str(name),
            ExprKind::Member(of, part) => {
                self.expr(of);
                self.joined(if self.ends_with_unit(of) { " ." } else { "." }, &part.node);
            }
            ExprKind::Call { function, args } => self.call(&function.node, args),
            ExprKind::Vector(x, y) => {
                self.out.push('(');
                self.expr(x);
                self.out.push_str(", ");
                self.expr(y);
                self.out.push(')');
            }
            ExprKind::Polar(length, angle) => self.pair(length, " @ ", angle),
            ExprKind::Unary(op, of) => {
                self.out.push_str(match op.node {
                    UnaryOp::Minus => "-",
                    UnaryOp::Plus => "+",
                    UnaryOp::Not => "not ",
                });
                self.expr(of);
            }
            ExprKind::Chain(first, rest) => {
                self.expr(first);
                let mut before = &**first;
                for (op, operand) in rest {
                    self.out.push_str(joint(op.node, self.ends_with_unit(before)));
                    self.expr(operand);
                    before = operand;
                }
            }
            ExprKind::Power(base, exponent) => {
                self.pair(base, if self.ends_with_unit(base) { " ^ " } else { "^" }, exponent);
            }
            ExprKind::Compare(first, rest) => {
                self.expr(first);
                for (op, operand) in rest {
                    self.out.push_str(match op.node {
                        CompareOp::Less => " < ",
                        CompareOp::LessOrEqual => " <= ",
                        CompareOp::Greater => " > ",
                        CompareOp::GreaterOrEqual => " >= ",
                    });
                    self.expr(operand);
                }
            }
        }
        self.out.push_str(if brackets { ")" } else { "" });
    }

    fn number(&mut self, number: &Number) {
        self.out.push_str(&number.text);
        if let Some(unit) = &number.unit {
            let blank = if unit.node.starts_with('°') { "" } else { " " };
            self.joined(blank, &unit.node);
        }
    }

    fn call(&mut self, function: &str, args: &[Arg]) {
        self.joined(function, "(");
        for (i, arg) in args.iter().enumerate() {
            self.out.push_str(if i > 0 { ", " } else { "" });
            if let Some(name) = &arg.name {
                self.joined(&name.node, " = ");
            }
            self.expr(&arg.value);
        }
        self.out.push(')');
    }

    fn pair(&mut self, a: &Expr, between: &str, b: &Expr) {
        self.expr(a);
        self.out.push_str(between);
        self.expr(b);
    }

    fn joined(&mut self, a: &str, b: &str) {
        self.out.push_str(a);
        self.out.push_str(b);
    }

    /// Brackets leave no node, but the place of what they enclose includes them.
    fn is_bracketed(&self, expr: &Expr) -> bool {
        let is_open = self.read.get(expr.span.start..).is_some_and(|rest| rest.starts_with('('));
        let first = match &expr.kind {
            ExprKind::Vector(..) => return false,
            ExprKind::Member(first, _)
            | ExprKind::Polar(first, _)
            | ExprKind::Chain(first, _)
            | ExprKind::Power(first, _)
            | ExprKind::Compare(first, _) => Some(first),
            ExprKind::Number(_) | ExprKind::Name(_) | ExprKind::Call { .. } | ExprKind::Unary(..) => None,
        };
        is_open && first.is_none_or(|first| first.span.start > expr.span.start)
    }

    /// Whether an expression ends with a unit, which a sign directly behind it would be a part of.
    fn ends_with_unit(&self, expr: &Expr) -> bool {
        let unit = match &expr.kind {
            ExprKind::Number(number) => number.unit.is_some(),
            ExprKind::Unary(_, of) => self.ends_with_unit(of),
            _ => false,
        };
        unit && !self.is_bracketed(expr)
    }
}

/// An operator with the blanks around it.
const fn joint(op: BinaryOp, behind_unit: bool) -> &'static str {
    match op {
        BinaryOp::Add => " + ",
        BinaryOp::Subtract => " - ",
        BinaryOp::Multiply if behind_unit => " * ",
        BinaryOp::Multiply => "*",
        BinaryOp::Divide if behind_unit => " / ",
        BinaryOp::Divide => "/",
        BinaryOp::And => " and ",
        BinaryOp::Or => " or ",
    }
}
