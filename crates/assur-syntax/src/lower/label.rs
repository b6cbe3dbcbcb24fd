//! What a question is called where it has no name: its expression, printed from the tree, so that blanks cannot rename it.

use super::simulation::Lower;
use crate::comma;
use crate::document::{Arg, BinaryOp, CompareOp, Expr, ExprKind, Number, UnaryOp};
use crate::recover::comma_in_number;
use crate::trivia::corrected;
use assur_text::source::Span;

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
                    UnaryOp::Plus if matches!(of.kind, ExprKind::Unary(..)) => "+ ",
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

// Lists that are numbers with decimal commas.

impl Lower<'_> {
    /// `0,5 m` reads as the list `0` and `5 m`, which nobody means: it is reported, and read as one number. Says whether
    /// that was so.
    pub(super) fn decimal_comma(&mut self, left: &mut Expr, right: &Expr, alone: bool) -> bool {
        let at = Span::new(left.span.end, right.span.start);
        let whole_at = left.span.to(right.span);
        let (Some(whole), ExprKind::Number(tenths)) = (unsigned(left), &right.kind) else { return false };
        let plain = |n: &Number| n.text.bytes().all(|b| b.is_ascii_digit());
        let glued = self.read.get(at.start..at.end) == Some(",");
        let alone = alone || tenths.unit.is_some();
        if !(glued && whole.unit.is_none() && plain(whole) && plain(tenths) && alone) {
            return false;
        }
        whole.text = format!("{}.{}", whole.text, tenths.text);
        whole.value = whole.text.parse().unwrap_or(whole.value);
        whole.unit.clone_from(&tenths.unit);
        left.span = whole_at;
        let number = self.text.get(whole_at.start..whole_at.end).unwrap_or_default();
        let lines = comma::readings(number, &comma::between_digits(number));
        let lines = lines.iter().map(|new| corrected(self.text, whole_at, new));
        self.problems.push(comma_in_number(at, lines.collect()));
        true
    }

    /// As [`Self::decimal_comma`], for every two neighbours of a list.
    pub(super) fn decimal_commas(&mut self, values: Vec<Expr>) -> Vec<Expr> {
        let alone = values.len() == 2;
        let mut kept = Vec::<Expr>::with_capacity(values.len());
        for value in values {
            let merged = kept.last_mut().is_some_and(|last| self.decimal_comma(last, &value, alone));
            if !merged {
                kept.push(value);
            }
        }
        kept
    }
}

/// A number after its sign.
fn unsigned(value: &mut Expr) -> Option<&mut Number> {
    match &mut value.kind {
        ExprKind::Unary(_, inner) => unsigned(inner),
        ExprKind::Number(number) => Some(number),
        _ => None,
    }
}
