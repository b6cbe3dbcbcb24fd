//! What an expression should be against what it is.

use super::number::with_unit;
use super::typed::{Dim, Type, Typed, mend, phrase};
use crate::check::context::Context;
use crate::check::error::UnitsError;
use crate::check::names::QuantityKind;
use crate::source::Span;
use crate::syntax::document::{BinaryOp, Expr, ExprKind};
use crate::units::Dimension;

/// Numbers from here on are speeds in rpm rather than in rad/s.
const FAST: f64 = 100.0;

impl Context<'_> {
    /// The expression, if it is a number of this dimension.
    pub(in crate::check) fn fit(
        &mut self,
        t: Typed,
        want: Dimension,
        what: &str,
        expr: &Expr,
    ) -> Option<Typed> {
        match t.ty {
            Type::Number(dim) => self.fits(dim, want, what, expr).then_some(t),
            Type::Vector(_) => {
                let help = Some("take a component, `.x` or `.y`, or `mag(…)`".to_owned());
                self.shape(what, "a number", t.ty, expr.span, help);
                None
            }
            Type::Truth => {
                self.shape(what, "a number", t.ty, expr.span, None);
                None
            }
        }
    }

    /// The expression, if it is a vector of this dimension.
    pub(in crate::check) fn fit_vector(
        &mut self,
        t: Typed,
        want: Dimension,
        what: &str,
        expr: &Expr,
    ) -> Option<Typed> {
        match t.ty {
            Type::Vector(dim) => self.fits(dim, want, what, expr).then_some(t),
            Type::Number(Dim::Any) if t.pending => Some(t),
            ty => {
                let help = matches!(ty, Type::Number(_))
                    .then(|| "write `(x, y)`, or a magnitude and its direction: `… @ 90 deg`".to_owned());
                self.shape(what, "a vector", ty, expr.span, help);
                None
            }
        }
    }

    /// The expression, if it is a truth.
    pub(in crate::check) fn fit_truth(&mut self, t: Typed, what: &str, expr: &Expr) -> Option<Typed> {
        if t.ty == Type::Truth || (t.pending && t.ty == Type::Number(Dim::Any)) {
            return Some(t);
        }
        let help = Some("compare it with something: `a < b`".to_owned());
        self.shape(what, "a truth", t.ty, expr.span, help);
        None
    }

    fn fits(&mut self, dim: Dim, want: Dimension, what: &str, expr: &Expr) -> bool {
        if dim.unify(Dim::Of(want)).is_some() {
            return true;
        }
        let (found, what, span) = (dim.known(), what.to_owned(), expr.span);
        if want == Dimension::ANGULAR_VELOCITY && found == Dimension::FREQUENCY {
            self.error(UnitsError::Hertz { what, span });
            return false;
        }
        if found == Dimension::NUMBER
            && let Some(example) = with_unit(expr, &self.unit_of_bare(want, expr))
        {
            self.error(UnitsError::Missing { what, want, span, example: format!("`{example}`") });
            return false;
        }
        if let Some((name, help)) = self.bare_definition(want, expr) {
            if self.reported.insert(("without unit", name)) {
                let (want, found) = (phrase(want), phrase(found));
                self.error(UnitsError::Mismatch { what, want, found, span, help: Some(help) });
            }
            return false;
        }
        let help = mend(want, found);
        self.error(UnitsError::Mismatch { what, want: phrase(want), found: phrase(found), span, help });
        false
    }

    /// The name in an expression that was given a number without its unit, and the definition with it.
    fn bare_definition(&self, want: Dimension, expr: &Expr) -> Option<(String, String)> {
        let name = match &expr.kind {
            ExprKind::Name(name) => name,
            ExprKind::Unary(_, inner) | ExprKind::Polar(inner, _) => {
                return self.bare_definition(want, inner);
            }
            ExprKind::Vector(x, y) => {
                return self.bare_definition(want, x).or_else(|| self.bare_definition(want, y));
            }
            // a multiple: the unit is that of the one factor with a name
            ExprKind::Chain(first, rest) => {
                let multiplies = |op: BinaryOp| matches!(op, BinaryOp::Multiply | BinaryOp::Divide);
                let number = |e: &Expr| matches!(&e.kind, ExprKind::Number(n) if n.unit.is_none());
                let mut factors = std::iter::once((BinaryOp::Multiply, first.as_ref()))
                    .chain(rest.iter().map(|(op, e)| (op.node, e)))
                    .filter(|(_, e)| !number(e));
                let (Some((BinaryOp::Multiply, only)), None) = (factors.next(), factors.next()) else {
                    return None;
                };
                return rest
                    .iter()
                    .all(|(op, _)| multiplies(op.node))
                    .then(|| self.bare_definition(want, only))?;
            }
            _ => return None,
        };
        let (word, value) = match self.names.quantities.get(name)?.what {
            QuantityKind::Given(value) => ("given", value),
            QuantityKind::Let(value) => ("let", value),
            _ => return None,
        };
        let example = with_unit(value, &self.unit_of_bare(want, value))?;
        Some((name.clone(), format!("write the unit where `{name}` is defined: `{word} {name} = {example}`")))
    }

    /// The unit that a bare number most likely lacks.
    fn unit_of_bare(&self, want: Dimension, value: &Expr) -> String {
        let usual = self.usual_unit(want);
        let fast = matches!(&value.kind, ExprKind::Number(n) if n.value.abs() >= FAST);
        if want == Dimension::ANGULAR_VELOCITY && usual == "rad/s" && fast { "rpm".into() } else { usual }
    }

    /// Reports a vector where a number is due, and the like.
    pub(in crate::check) fn shape(
        &mut self,
        what: &str,
        want: &'static str,
        ty: Type,
        span: Span,
        help: Option<String>,
    ) {
        self.error(UnitsError::Shape { what: what.to_owned(), want, found: ty.shape(), span, help });
    }

    /// What would make two quantities fit each other.
    pub(super) fn mend_operands(&mut self, a: Type, b: Type, left: &Expr, right: &Expr) -> Option<String> {
        let (Type::Number(x), Type::Number(y)) = (a, b) else {
            return match (a, b) {
                (Type::Vector(_), Type::Number(_)) | (Type::Number(_), Type::Vector(_)) => {
                    Some("take a component, `.x` or `.y`, or `mag(…)` of the vector".into())
                }
                _ => None,
            };
        };
        let (x, y) = (x.known(), y.known());
        let bare = |d: Dimension, expr: &Expr, other: Dimension| {
            (d == Dimension::NUMBER).then(|| with_unit(expr, &self.usual_unit(other))).flatten()
        };
        if let Some(text) = bare(y, right, x).or_else(|| bare(x, left, y)) {
            return Some(format!("did you mean `{text}`?"));
        }
        mend(x, y).map(|text| text.replacen("by", "the second by", 1))
    }
}
