//! What an expression should be against what it is.

use crate::expr::bare::unit_missing;
use crate::expr::context::Context;
use crate::expr::number::with_unit;
use crate::statements::walk::parts;
use crate::statements::written::written;
use crate::values::typed::{Dim, Type, Typed, correction, phrase};
use assur_syntax::document::{Expr, ExprKind};
use assur_text::diagnostic::Diagnosis;
use assur_text::diagnostic::Fix;
use assur_text::language::Function;
use assur_text::source::Span;
use assur_text::units::Dimension;

impl Context<'_> {
    /// The expression, if it is a number of this dimension.
    pub(crate) fn fit(&mut self, t: Typed, want: Dimension, what: &str, expr: &Expr) -> Option<Typed> {
        match t.ty {
            Type::Number(dim) => self.fits(dim, want, what, expr).then_some(t),
            Type::Vector(_) => {
                let help = Some("take a component, `.x` or `.y`, or `mag(…)`".to_owned());
                self.shape(what, "a number", t.ty, expr.span, help);
                None
            }
            Type::Bool => {
                self.shape(what, "a number", t.ty, expr.span, None);
                None
            }
        }
    }

    /// The expression, if it is a vector of this dimension.
    pub(crate) fn fit_vector(&mut self, t: Typed, want: Dimension, what: &str, expr: &Expr) -> Option<Typed> {
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

    /// The expression, if it is a condition.
    pub(crate) fn fit_condition(&mut self, t: Typed, what: &str, expr: &Expr) -> Option<Typed> {
        if t.ty == Type::Bool || (t.pending && t.ty == Type::Number(Dim::Any)) {
            return Some(t);
        }
        let help = Some("compare it with something: `a < b`".to_owned());
        self.shape(what, "a condition", t.ty, expr.span, help);
        None
    }

    fn fits(&mut self, dim: Dim, want: Dimension, what: &str, expr: &Expr) -> bool {
        if dim.unify(Dim::Of(want)).is_some() {
            return true;
        }
        let (found, what, span) = (dim.known(), what.to_owned(), expr.span);
        if want == Dimension::ANGULAR_VELOCITY && found == Dimension::FREQUENCY {
            self.hertz(what, expr);
            return false;
        }
        if found == Dimension::NUMBER
            && let Some(help) = self.example(expr, want)
        {
            self.error(unit_missing(&what, want, span, None, help));
            return false;
        }
        if found == Dimension::NUMBER && self.bare_definition(want, expr) {
            return false;
        }
        let help = self
            .column_without_unit(want, found, expr)
            .or_else(|| self.in_its_place(want, found, &what, expr));
        self.error(unit_mismatch(&what, &phrase(want), &phrase(found), span, help));
        false
    }

    /// The header of a curve in the expression whose values have no unit, with the one that is missing.
    fn column_without_unit(&self, want: Dimension, found: Dimension, expr: &Expr) -> Option<String> {
        let mut bare = None;
        parts(expr, &mut |part| {
            if let ExprKind::Call { function, .. } = &part.kind
                && let Some(curve) = self.values.curves.get(&function.node)
                && curve.value == Dimension::NUMBER
            {
                bare.get_or_insert_with(|| function.node.clone());
            }
        });
        let (name, missing) = (bare?, want.over(found));
        missing.name()?;
        let unit = self.values.usual_unit(missing);
        Some(format!(
            "the values of curve `{name}` have no unit: write it in its header, as in \
             `[{unit}]`"
        ))
    }

    /// Reports a vector where a number is due, and the like.
    pub(crate) fn shape(
        &mut self,
        what: &str,
        want: &'static str,
        ty: Type,
        span: Span,
        help: Option<String>,
    ) {
        let found = ty.shape();
        self.error(
            Diagnosis::error("mech::unit::shape", format!("{what} should be {want}, but this is {found}"))
                .primary(span, found)
                .help_if(help),
        );
    }

    /// What would make two quantities fit each other.
    pub(crate) fn correct_operands(&mut self, a: Type, b: Type, left: &Expr, right: &Expr) -> Option<String> {
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
            let units = self.likely_units(other, expr);
            if d == Dimension::NUMBER { with_unit(expr, units.last()?) } else { None }
        };
        if let Some(text) = bare(y, right, x) {
            let part =
                part_of_stroke(left, right).map(|part| format!(", or `{part}` for a part of the stroke"));
            return Some(format!("write `{text}`{}", part.unwrap_or_default()));
        }
        if let Some(text) = bare(x, left, y) {
            return Some(format!("write `{text}` for the first operand"));
        }
        let name = |d: Dimension, expr: &Expr, other: Dimension| match &expr.kind {
            ExprKind::Name(name) if d == Dimension::NUMBER => {
                let names = self.names_of(other)?;
                Some(format!("write {} in place of `{name}`, as {names}", other.name()?))
            }
            _ => None,
        };
        name(y, right, x)
            .or_else(|| name(x, left, y))
            .or_else(|| correction(x, y).map(|text| text.replacen("by", "the second operand by", 1)))
    }
}

/// `0.9*stroke(G)`, where a travel is compared with a number.
fn part_of_stroke(left: &Expr, right: &Expr) -> Option<String> {
    let (ExprKind::Call { function, args }, ExprKind::Number(number)) = (&left.kind, &right.kind) else {
        return None;
    };
    let is_travel = Function::named(&function.node) == Some(Function::Travel) && number.value < 1.0;
    let pair = args.first().filter(|_| is_travel).and_then(|a| written(&a.value))?;
    Some(format!("{}*stroke({pair})", number.text))
}

/// A quantity of another dimension than expected.
pub fn unit_mismatch(what: &str, want: &str, found: &str, span: Span, help: Option<String>) -> Diagnosis {
    Diagnosis::error("mech::unit::mismatch", format!("{what} should be {want}, but this is {found}"))
        .primary(span, found)
        .fixes(written_here(help.as_deref(), span))
        .help_if(help)
}

/// What a help says to write in this place, unless more than the place changes: in a header, and of two vectors.
pub fn written_here(help: Option<&str>, at: Span) -> Vec<Fix> {
    let is_here = |help: &&str| help.starts_with("write `") && !help.contains(['[', '(']);
    help.filter(is_here).map(|help| Fix::quoted(help, at)).unwrap_or_default()
}
