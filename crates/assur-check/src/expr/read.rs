//! From the tree to typed expressions.

use crate::expr::{
    context::{Context, undefined},
    fit::{direction_of_two, unit_mismatch},
    results::Sign,
};
use crate::statements::{walk::parts, written::written};
use crate::values::{
    fold,
    typed::{Dim, Type, Typed, phrase},
};
use assur_model::model::{self, Axis, Comparison, Value};
use assur_syntax::document::{BinaryOp, CompareOp, Expr, ExprKind, Name, UnaryOp};
use assur_text::diagnostic::{Diagnosis, Help};
use assur_text::language::Function;
use assur_text::source::{Span, Spanned};
use assur_text::units::{self, Dimension, Kind};

/// The most operands in a row.
const MOST: usize = 500;

/// The largest number that is computed with, SI: products of three are numbers, and so are they in any unit.
pub(crate) const LARGEST: f64 = 1e100;
/// Why a larger one is an error.
pub(crate) const TOO_LARGE: &str = "nothing can be computed with numbers beyond 1e100 in SI units";

impl Context<'_> {
    /// Reads an expression. Everything wrong with it is reported.
    pub(crate) fn read(&mut self, expr: &Expr) -> Option<Typed> {
        self.read_signed(expr, Sign::Matters)
    }

    pub(crate) fn read_signed(&mut self, expr: &Expr, sign: Sign) -> Option<Typed> {
        match &expr.kind {
            ExprKind::Number(number) if self.implied_product(number, expr.span) => None,
            ExprKind::Number(number) => {
                let read = self.literal(number)?;
                self.finite(read, TOO_LARGE, expr.span)
            }
            ExprKind::Name(name) => self.named(&Spanned::new(name.clone(), expr.span)),
            ExprKind::Member(base, part) => self.part(expr, base, part, sign),
            ExprKind::Call { function, args } => self.call(function, args, expr.span, sign),
            ExprKind::Vector(x, y) => self.components(expr, x, y),
            ExprKind::Polar(r, phi) => self.polar(r, phi),
            ExprKind::Unary(op, inner) => self.unary(op.node, inner, sign),
            ExprKind::Chain(_, rest) if rest.len() >= MOST => self.too_long(rest.len(), expr.span),
            ExprKind::Compare(_, rest) if rest.len() >= MOST => self.too_long(rest.len(), expr.span),
            ExprKind::Chain(..) | ExprKind::Power(..) if self.unit_alone(expr) => None,
            ExprKind::Chain(first, rest) => self.chain(first, rest, expr.span, sign),
            ExprKind::Power(base, exponent) => self.raised(base, exponent, expr.span),
            ExprKind::Compare(first, rest) => self.comparison(first, rest),
        }
    }

    /// Reports `kg*m^2` without a number before it.
    fn unit_alone(&mut self, expr: &Expr) -> bool {
        let Some(unit) = written(expr).filter(|text| units::lookup(&text.replace(' ', "")).is_ok()) else {
            return false;
        };
        let mut names = Vec::new();
        parts(expr, &mut |part| {
            if let ExprKind::Name(name) = &part.kind {
                names.push(name.clone());
            }
        });
        let known = |name: &String| {
            self.names.quantities.contains_key(name) || self.names.bad.contains(name) || !units::is_unit(name)
        };
        if names.is_empty() || names.iter().any(known) {
            return false;
        }
        let unit = unit.replace(' ', "");
        self.error(
            Diagnosis::error("mech::unit::no_number", format!("a number is missing before `{unit}`"))
                .primary(expr.span, "a unit alone")
                .help(format!("write `1 {unit}`, with its own number")),
        );
        true
    }

    fn too_long(&mut self, count: usize, span: Span) -> Option<Typed> {
        self.error(
            Diagnosis::error(
                "mech::request::too_long",
                format!("this expression has {} parts in a row; at most {} can be read", count + 1, MOST),
            )
            .primary(span, "too long")
            .help("divide it among several `let` statements"),
        );
        None
    }

    /// A part that is neither `.x` nor `.y` of something without other parts.
    fn no_part(&mut self, base: &Typed, part: &Name) -> Option<Typed> {
        if base.pending && base.ty == Type::Number(Dim::Any) {
            return Some(base.clone());
        }
        let help = match base.ty {
            Type::Vector(_) => Some("the parts of a vector are `.x` and `.y`".to_owned()),
            _ => None,
        };
        self.error(no_part(&part.node, part.span, help));
        None
    }

    /// `.x` and `.y` of vectors, and the parts of a mass substitution.
    /// Reports `C.velocity`: a quantity of a thing is a function of it.
    fn function_as_part(&mut self, base: &Expr, part: &Name) -> Option<()> {
        let ExprKind::Name(thing) = &base.kind else { return Some(()) };
        let asks = Function::named(&part.node).is_some_and(|f| f.row().is_result());
        let is_thing = self.names.things.contains_key(thing) && !self.names.quantities.contains_key(thing);
        if !asks || !is_thing {
            return Some(());
        }
        let at = base.span.to(part.span);
        let message = format!("`{thing}` has no part `{}`: a quantity is a function", part.node);
        let help = Help::write(at, &[format!("{}({thing})", part.node)]);
        self.error(Diagnosis::error("mech::request::part", message).primary(at, "not a part").help(help));
        None
    }

    fn part(&mut self, whole: &Expr, base: &Expr, part: &Name, sign: Sign) -> Option<Typed> {
        self.function_as_part(base, part)?;
        if let Some(result) = (self.results.part)(self, whole, base, part) {
            return result;
        }
        let axis = match part.node.as_str() {
            "x" => Axis::X,
            "y" => Axis::Y,
            _ => {
                let base = self.read_signed(base, sign)?;
                return self.no_part(&base, part);
            }
        };
        let v = self.read_signed(base, sign)?;
        let Type::Vector(dim) = v.ty else {
            if v.pending {
                return Some(v);
            }
            self.shape(&format!("the expression before `.{}`", part.node), "a vector", v.ty, base.span, None);
            return None;
        };
        Some(Typed { expr: fold::component(v.expr, axis), ty: Type::Number(dim), pending: v.pending })
    }

    fn components(&mut self, vector: &Expr, x: &Expr, y: &Expr) -> Option<Typed> {
        let (a, b) = (self.read(x), self.read(y));
        let (a, b) = (a?, b?);
        let (Type::Number(da), Type::Number(db)) = (a.ty, b.ty) else {
            for (t, span) in [(&a, x.span), (&b, y.span)] {
                if !matches!(t.ty, Type::Number(_)) {
                    self.shape("a component of a vector", "a number", t.ty, span, None);
                }
            }
            return None;
        };
        let Some(dim) = da.unify(db) else {
            // a size and a direction
            if let (Dimension::ANGLE, Some(size), Some(angle)) = (db.known(), written(x), written(y)) {
                let (want, found) = (phrase(da.known()), phrase(Dimension::ANGLE));
                let help = Some(format!("write `{size} @ {angle}`"));
                let what = "the second component of this vector".to_owned();
                self.error(unit_mismatch(&what, &want, &found, vector.span, help));
                return None;
            }
            self.operands("the components of one vector", &a, &b, x, y);
            return None;
        };
        let pending = a.pending || b.pending;
        Some(Typed { expr: fold::pair(a.expr, b.expr), ty: Type::Vector(dim), pending })
    }

    fn polar(&mut self, r: &Expr, phi: &Expr) -> Option<Typed> {
        let magnitude = self.read(r);
        let angle =
            self.read(phi).and_then(|t| self.fit(t, Dimension::ANGLE, "the direction after `@`", phi));
        let (magnitude, angle) = (magnitude?, angle?);
        let Type::Number(dim) = magnitude.ty else {
            self.shape("the magnitude before `@`", "a number", magnitude.ty, r.span, None);
            return None;
        };
        let pending = magnitude.pending || angle.pending;
        Some(Typed { expr: fold::polar(magnitude.expr, angle.expr), ty: Type::Vector(dim), pending })
    }

    fn unary(&mut self, op: UnaryOp, inner: &Expr, sign: Sign) -> Option<Typed> {
        let t = self.read_signed(inner, sign)?;
        match (op, t.ty) {
            (UnaryOp::Not, Type::Bool) => Some(Typed { expr: fold::not(t.expr), ..t }),
            (UnaryOp::Not, _) => {
                let help = Some("compare it with something: `not (a < b)`".to_owned());
                self.shape("the operand of `not`", "a condition", t.ty, inner.span, help);
                None
            }
            (_, Type::Bool) => {
                self.shape("the operand of a sign", "a number or a vector", t.ty, inner.span, None);
                None
            }
            (UnaryOp::Minus, _) => Some(Typed { expr: fold::negate(t.expr), ..t }),
            (UnaryOp::Plus, _) => Some(t),
        }
    }

    fn chain(
        &mut self,
        first: &Expr,
        rest: &[(Spanned<BinaryOp>, Expr)],
        span: Span,
        sign: Sign,
    ) -> Option<Typed> {
        // A factor changes the sign of a product as the sign of the whole; a sum's sign depends on its terms.
        let product = rest.iter().all(|(op, _)| matches!(op.node, BinaryOp::Multiply | BinaryOp::Divide));
        let sign = if product { sign } else { Sign::Matters };
        let mut left = self.read_signed(first, sign);
        let mut left_span = first.span;
        let mut before = first;
        for (i, (op, operand)) in rest.iter().enumerate() {
            if self.unit_goes_on(before, &rest[i..]) {
                return None;
            }
            before = operand;
            let right = self.read_signed(operand, sign);
            let whole = Span::new(span.start.min(left_span.start), operand.span.end);
            left = match (left, right) {
                (Some(a), Some(b)) => {
                    self.operate(op.node, (a, left_span), (b, operand.span), first, operand)
                }
                _ => None,
            };
            left_span = whole;
        }
        left
    }

    fn operate(
        &mut self,
        op: BinaryOp,
        (a, a_span): (Typed, Span),
        (b, b_span): (Typed, Span),
        first: &Expr,
        operand: &Expr,
    ) -> Option<Typed> {
        let pending = a.pending || b.pending;
        let whole = a_span.to(b_span);
        let ty = match op {
            BinaryOp::And | BinaryOp::Or => {
                for (t, span) in [(&a, a_span), (&b, b_span)] {
                    if t.ty != Type::Bool {
                        self.shape("an operand of `and` or `or`", "a condition", t.ty, span, None);
                        return None;
                    }
                }
                let join = if op == BinaryOp::And { fold::and } else { fold::or };
                return Some(Typed { expr: join(a.expr, b.expr), ty: Type::Bool, pending });
            }
            BinaryOp::Add | BinaryOp::Subtract => {
                let verb = if op == BinaryOp::Add { "added" } else { "subtracted" };
                self.sum_type(verb, (&a, a_span), (&b, b_span), first, operand)?
            }
            BinaryOp::Multiply => match (a.ty, b.ty) {
                (Type::Number(x), Type::Number(y)) => Type::Number(x.times(y)),
                (Type::Vector(x), Type::Number(y)) | (Type::Number(x), Type::Vector(y)) => {
                    Type::Vector(x.times(y))
                }
                _ => return self.no_product("multiplied", (&a, a_span), (&b, b_span)),
            },
            BinaryOp::Divide => match (a.ty, b.ty) {
                (Type::Number(x), Type::Number(y)) => Type::Number(x.over(y)),
                (Type::Vector(x), Type::Number(y)) => Type::Vector(x.over(y)),
                _ => return self.no_product("divided", (&a, a_span), (&b, b_span)),
            },
        };
        if op == BinaryOp::Divide && b.value() == Some(Value::Scalar(0.0)) {
            self.without_value("division by zero", b_span, &b, operand);
            return None;
        }
        let op = match op {
            BinaryOp::Add => model::BinaryOp::Add,
            BinaryOp::Subtract => model::BinaryOp::Sub,
            BinaryOp::Multiply => model::BinaryOp::Mul,
            _ => model::BinaryOp::Div,
        };
        self.finite(Typed { expr: fold::binary(op, a.expr, b.expr), ty, pending }, "too large", whole)
    }

    fn sum_type(
        &mut self,
        verb: &'static str,
        (a, a_span): (&Typed, Span),
        (b, b_span): (&Typed, Span),
        first: &Expr,
        operand: &Expr,
    ) -> Option<Type> {
        let unified = match (a.ty, b.ty) {
            (Type::Number(x), Type::Number(y)) => x.unify(y).map(Type::Number),
            (Type::Vector(x), Type::Vector(y)) => x.unify(y).map(Type::Vector),
            _ => None,
        };
        if unified.is_none() {
            let left = if a_span == first.span { first } else { operand };
            let help = direction_of_two(verb, (left, a.ty), (operand, b.ty))
                .or_else(|| self.correct_operands(a.ty, b.ty, left, operand));
            self.error(wrong_operands(verb, &a.ty.phrase(), &b.ty.phrase(), a_span, b_span, help));
        }
        unified
    }

    fn no_product(
        &mut self,
        verb: &'static str,
        (a, a_span): (&Typed, Span),
        (b, b_span): (&Typed, Span),
    ) -> Option<Typed> {
        let vectors = matches!((a.ty, b.ty), (Type::Vector(_), Type::Vector(_))) && verb == "multiplied";
        let help = vectors.then(|| "write `dot(a, b)` or `cross(a, b)`".to_owned());
        let (left, right) = (a.ty.phrase(), b.ty.phrase());
        self.error(wrong_operands(verb, &left, &right, a_span, b_span, help));
        None
    }

    fn raised(&mut self, base: &Expr, exponent: &Expr, span: Span) -> Option<Typed> {
        let b = self.read(base);
        let n = self.read(exponent).and_then(|t| self.fit(t, Dimension::NUMBER, "an exponent", exponent));
        let (b, n) = (b?, n?);
        let Type::Number(dim) = b.ty else {
            self.shape("the base of a power", "a number", b.ty, base.span, Some("write `dot(v, v)`".into()));
            return None;
        };
        let pending = b.pending || n.pending;
        let dimension = dim.known();
        let raised = match n.value() {
            _ if dimension == Dimension::NUMBER => Some(Dimension::NUMBER),
            Some(Value::Scalar(n)) => {
                // a ratio of lengths has any power
                let ratio =
                    (dimension.is_dimensionless() && dimension.kind == Kind::Free).then_some(dimension);
                power_of(dimension, n).or(ratio)
            }
            _ => dimension.is_number().then_some(Dimension::NUMBER),
        };
        let Some(raised) = raised else {
            let help = Some("a base with a unit takes a whole exponent".to_owned());
            let what = format!("this power of {}", phrase(dimension));
            self.error(no_power(&what, base.span, dimension, help));
            return None;
        };
        let ty = if dim == Dim::Any { Type::Number(Dim::Any) } else { Type::number(raised) };
        let why = "this power is not defined";
        self.finite(Typed { expr: fold::power(b.expr, n.expr), ty, pending }, why, span)
    }

    fn comparison(&mut self, first: &Expr, rest: &[(Spanned<CompareOp>, Expr)]) -> Option<Typed> {
        let mut all = Some(Typed::new(model::Expr::Constant(Value::Bool(true)), Type::Bool));
        let mut left = self.read(first);
        let mut left_expr = first;
        for (op, operand) in rest {
            let right = self.read(operand);
            let holds = match (&left, &right) {
                (Some(a), Some(b)) => self.compared(op.node, a, b, left_expr, operand),
                _ => None,
            };
            all = match (all, holds) {
                (Some(a), Some(b)) => Some(Typed {
                    expr: fold::and(a.expr, b.expr),
                    ty: Type::Bool,
                    pending: a.pending || b.pending,
                }),
                _ => None,
            };
            (left, left_expr) = (right, operand);
        }
        all
    }

    fn compared(&mut self, op: CompareOp, a: &Typed, b: &Typed, left: &Expr, right: &Expr) -> Option<Typed> {
        if let (Type::Number(x), Type::Number(y)) = (a.ty, b.ty)
            && x.unify(y).is_some()
        {
            let expr = fold::compare(comparison_of(op), a.expr.clone(), b.expr.clone());
            return Some(Typed { expr, ty: Type::Bool, pending: a.pending || b.pending });
        }
        self.operands("compared", a, b, left, right);
        None
    }

    pub(crate) fn operands(&mut self, verb: &'static str, a: &Typed, b: &Typed, left: &Expr, right: &Expr) {
        let help = self.correct_operands(a.ty, b.ty, left, right);
        self.error(wrong_operands(verb, &a.ty.phrase(), &b.ty.phrase(), left.span, right.span, help));
    }

    /// Reports a constant that is no number, or too large for its powers to be some.
    pub(crate) fn finite(&mut self, t: Typed, why: &'static str, span: Span) -> Option<Typed> {
        let greatest = match t.value() {
            Some(Value::Scalar(x)) => x.abs(),
            Some(Value::Vector(v)) => v.x.abs() + v.y.abs(),
            _ => 0.0,
        };
        if greatest <= LARGEST {
            return Some(t);
        }
        let why = if greatest.is_finite() { TOO_LARGE } else { why };
        self.error(undefined(why, span, None));
        None
    }
}

pub const fn comparison_of(op: CompareOp) -> Comparison {
    match op {
        CompareOp::Less => Comparison::Less,
        CompareOp::LessOrEqual => Comparison::LessEqual,
        CompareOp::Greater => Comparison::Greater,
        CompareOp::GreaterOrEqual => Comparison::GreaterEqual,
    }
}

/// The dimension of a power: whole exponents, halves where they come out even.
fn power_of(base: Dimension, exponent: f64) -> Option<Dimension> {
    let whole = |x: f64| (x == x.round() && x.abs() <= 20.0).then_some(x as i8);
    match whole(exponent) {
        Some(n) => Some(base.powi(n)),
        None => base.powi(whole(2.0 * exponent)?).sqrt(),
    }
}

/// A part that this result does not have.
pub fn no_part(part: &str, span: Span, help: Option<String>) -> Diagnosis {
    Diagnosis::error("mech::request::part", format!("there is no part `.{part}` here"))
        .primary(span, "no such part")
        .help_if(help)
}

/// Two quantities that cannot be added or compared.
fn wrong_operands(
    verb: &'static str,
    left: &str,
    right: &str,
    left_span: Span,
    right_span: Span,
    help: Option<String>,
) -> Diagnosis {
    Diagnosis::error("mech::unit::operands", format!("{left} and {right} cannot be {verb}"))
        .label(left_span, left)
        .primary(right_span, right)
        .fixes(crate::expr::fit::written_here(help.as_deref(), right_span))
        .help_if(help)
}

/// A power or root that has no dimension.
pub fn no_power(what: &str, span: Span, base: Dimension, help: Option<String>) -> Diagnosis {
    Diagnosis::error("mech::unit::power", format!("{what} has no dimension"))
        .primary(span, format!("{base}"))
        .help_if(help)
}
