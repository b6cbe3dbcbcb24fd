//! Factors after a unit that look like units and are none: `5 rad/sec`, `0.2 kg*m2`.

use crate::expr::context::Context;
use crate::values::replace::revolutions_or_radians;
use assur_syntax::document::{BinaryOp, Expr, ExprKind, Number};
use assur_text::diagnostic::{Diagnosis, Help};
use assur_text::source::{Span, Spanned};
use assur_text::units::{Dimension, is_unit, lookup, suggestions};

impl Context<'_> {
    /// Whether the factors from this operand on were meant as a part of the unit before them, which is reported.
    pub(crate) fn unit_goes_on(&mut self, left: &Expr, rest: &[(Spanned<BinaryOp>, Expr)]) -> bool {
        let ExprKind::Number(number) = &left.kind else { return false };
        if self.hyphen_in_unit(left, rest) || self.per_unit(left, rest) {
            return true;
        }
        let Some(unit) = &number.unit else { return false };
        let (mut word, mut end) = (unit.node.clone(), left.span.end);
        let mut foreign = None;
        for (op, operand) in rest {
            let glued = op.span.start == end && op.span.end == operand.span.start;
            let sign = match op.node {
                BinaryOp::Multiply => '*',
                BinaryOp::Divide => '/',
                _ => break,
            };
            let Some((name, power)) = factor(operand).filter(|_| glued) else { break };
            if self.names.quantities.contains_key(name) {
                break;
            }
            foreign = foreign.or(Some(name.to_owned()));
            word = format!("{word}{sign}{name}{power}");
            end = operand.span.end;
        }
        let Some(foreign) = foreign else { return false };
        let units = suggestions(&word);
        if units.is_empty() {
            return false;
        }
        if self.problems.reported.insert(("unit", word)) {
            let span = Span::new(unit.span.start, end);
            let why = format!("`{foreign}` is not a unit");
            self.error(
                Diagnosis::error("mech::unit::unknown", why)
                    .primary(span, "not a unit")
                    .help(Help::write(span, &units)),
            );
        }
        true
    }
}

impl Context<'_> {
    /// `120 min-1`, `8 N-m`
    fn hyphen_in_unit(&mut self, left: &Expr, rest: &[(Spanned<BinaryOp>, Expr)]) -> bool {
        let (ExprKind::Number(Number { text, unit: Some(unit), .. }), [(op, right), ..]) = (&left.kind, rest)
        else {
            return false;
        };
        let glued = op.span.start == left.span.end && op.span.end == right.span.start;
        let (word, part) = match &right.kind {
            ExprKind::Number(n) if n.unit.is_none() && matches!(n.text.as_str(), "1" | "2" | "3") => {
                (format!("{}^-{}", unit.node, n.text), &n.text)
            }
            ExprKind::Name(name) if is_unit(name) && !self.names.quantities.contains_key(name) => {
                (format!("{}*{name}", unit.node), name)
            }
            _ => return false,
        };
        if op.node != BinaryOp::Subtract || !glued {
            return false;
        }
        self.meant_quantity(text, &word, &format!("{}-{part}", unit.node), left.span.to(right.span))
    }

    /// `120 /min`
    fn per_unit(&mut self, left: &Expr, rest: &[(Spanned<BinaryOp>, Expr)]) -> bool {
        let (ExprKind::Number(Number { text, unit: None, .. }), [(op, right), ..]) = (&left.kind, rest)
        else {
            return false;
        };
        let ExprKind::Name(name) = &right.kind else { return false };
        let unit = is_unit(name) && !self.names.quantities.contains_key(name);
        let per = op.node == BinaryOp::Divide && op.span.end == right.span.start && unit;
        per && self.meant_quantity(text, &format!("1/{name}"), &format!("/{name}"), left.span.to(right.span))
    }

    /// Reports a quantity whose unit is written otherwise.
    fn meant_quantity(&mut self, number: &str, word: &str, written: &str, span: Span) -> bool {
        let Ok(unit) = lookup(word) else { return false };
        let quantities = if unit.dimension == Dimension::FREQUENCY {
            revolutions_or_radians(number, &unit).to_vec()
        } else {
            vec![format!("{number} {word}")]
        };
        let why = format!("`{written}` is not a unit");
        self.error(
            Diagnosis::error("mech::unit::unknown", why)
                .primary(span, "not a unit")
                .help(Help::write(span, &quantities).certain()),
        );
        true
    }
}

/// A name and its power.
fn factor(expr: &Expr) -> Option<(&str, String)> {
    match &expr.kind {
        ExprKind::Name(name) => Some((name, String::new())),
        ExprKind::Power(base, exponent) => match (&base.kind, &exponent.kind) {
            (ExprKind::Name(name), ExprKind::Number(n)) if n.unit.is_none() => {
                Some((name, format!("^{}", n.text)))
            }
            _ => None,
        },
        _ => None,
    }
}
