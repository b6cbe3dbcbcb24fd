//! Expressions.

use super::Name;
use assur_text::source::{Span, Spanned};

/// An expression and its place. Brackets leave no node; the place of what they enclose includes them.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    pub kind: ExprKind,
    pub span: Span,
}

/// The parts of an expression.
#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// `100`, `100 mm`
    Number(Number),
    /// `r`
    Name(String),
    /// `reaction(B, rod).x`, `ram.F`: the part of a thing.
    Member(Box<Expr>, Name),
    /// `velocity(C)`, `journal_torque(load = 5 N)`
    Call {
        function: Name,
        /// Its arguments in the order written.
        args: Vec<Arg>,
    },
    /// `(x, y)`
    Vector(Box<Expr>, Box<Expr>),
    /// `r @ phi`: length and direction.
    Polar(Box<Expr>, Box<Expr>),
    /// `-x`, `+x`, `not x`
    Unary(Spanned<UnaryOp>, Box<Expr>),
    /// Operators of one precedence, from left to right: `a + b - c`, `a * b / c`, `a and b`, `a or b`.
    Chain(Box<Expr>, Vec<(Spanned<BinaryOp>, Expr)>),
    /// `a ^ b`
    Power(Box<Expr>, Box<Expr>),
    /// `a < b`, `a < b <= c`
    Compare(Box<Expr>, Vec<(Spanned<CompareOp>, Expr)>),
}

/// A number as written, with its unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Number {
    /// Its value in the unit written.
    pub value: f64,
    /// Its digits as written, without the unit.
    pub text: String,
    /// The unit as written, not looked up.
    pub unit: Option<Spanned<String>>,
}

/// An argument of a call.
#[derive(Clone, Debug, PartialEq)]
pub struct Arg {
    /// `load` in `load = 5 N`.
    pub name: Option<Name>,
    pub value: Expr,
}

/// An operator before its operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnaryOp {
    /// `-`
    Minus,
    /// `+`
    Plus,
    /// `not`
    Not,
}

/// An operator of a [`ExprKind::Chain`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BinaryOp {
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `/`
    Divide,
    /// `and`
    And,
    /// `or`
    Or,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CompareOp {
    /// `<`
    Less,
    /// `<=`
    LessOrEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterOrEqual,
}

/// Calls `visit` on the direct parts of an expression, left to right.
pub fn children<'a>(expr: &'a Expr, visit: &mut dyn FnMut(&'a Expr)) {
    match &expr.kind {
        ExprKind::Number(_) | ExprKind::Name(_) => {}
        ExprKind::Member(base, _) => visit(base),
        ExprKind::Unary(_, inner) => visit(inner),
        ExprKind::Call { args, .. } => args.iter().for_each(|a| visit(&a.value)),
        ExprKind::Vector(a, b) | ExprKind::Polar(a, b) | ExprKind::Power(a, b) => {
            visit(a);
            visit(b);
        }
        ExprKind::Chain(first, rest) => {
            visit(first);
            rest.iter().for_each(|(_, e)| visit(e));
        }
        ExprKind::Compare(first, rest) => {
            visit(first);
            rest.iter().for_each(|(_, e)| visit(e));
        }
    }
}

/// Calls `visit` on the expression and all its parts, left to right.
pub fn parts<'a>(expr: &'a Expr, visit: &mut dyn FnMut(&'a Expr)) {
    visit(expr);
    children(expr, &mut |child| parts(child, visit));
}
