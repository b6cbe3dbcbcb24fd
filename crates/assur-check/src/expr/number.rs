//! Numbers as written, with their units.

use crate::expr::context::Context;
use crate::values::typed::{Dim, Type, Typed};
use assur_model::model;
use assur_syntax::document::{BinaryOp, Expr, ExprKind, Number, UnaryOp};
use assur_text::diagnostic::{Diagnosis, Help};
use assur_text::source::{Span, Spanned};
use assur_text::units::{Dimension, Unit, factors, lookup};

/// What is counted has no unit.
const COUNTED: &[&str] = &["teeth", "tooth", "steps", "slots", "pieces", "pcs", "times"];

impl Context<'_> {
    /// A number with its unit.
    pub(crate) fn literal(&mut self, number: &Number) -> Option<Typed> {
        let Some(word) = &number.unit else {
            let dim = if number.value == 0.0 { Dim::Any } else { Dim::Of(Dimension::NUMBER) };
            return Some(Typed::new(model::Expr::number(number.value), Type::Number(dim)));
        };
        let unit = self.unit(word)?;
        self.warn_of_names(word);
        Some(Typed::constant(unit.to_si(number.value), unit.dimension))
    }

    /// The unit a word means. Reports a word that means none, once.
    pub fn unit(&mut self, word: &Spanned<String>) -> Option<Unit> {
        if let Some((unit, _)) = self.values.units.get(&word.node) {
            return Some(unit.clone());
        }
        match lookup(&word.node) {
            Ok(unit) => Some(unit),
            Err(error) => {
                if self.problems.reported.insert(("unit", word.node.clone())) {
                    let (start, end) = error.range();
                    let part = Span::new(word.span.start + start, word.span.start + end.max(start + 1));
                    let why = error.to_string();
                    let nearest = error.nearest();
                    let counted = COUNTED.contains(&word.node.as_str());
                    let help = (!nearest.is_empty()).then(|| Help::write(word.span, nearest));
                    let help =
                        if counted { Some("write the number alone: it is counted".into()) } else { help };
                    // `mn` may be `MN` or `mN`, `Nm` is `N*m`
                    let plain = |unit: &str| unit.chars().filter(|c| c.is_alphanumeric()).collect::<String>();
                    let is_meant = nearest.iter().all(|unit| plain(unit) == plain(&word.node));
                    let help = if is_meant { help.map(Help::certain) } else { help };
                    // what is proposed replaces the whole word
                    let span = if help.is_some() { word.span } else { part };
                    self.error(
                        Diagnosis::error("mech::unit::unknown", why)
                            .primary(span, "not a unit")
                            .help_if(help),
                    );
                }
                None
            }
        }
    }

    /// Warns of a part of a unit that is a name of the file as well, once.
    fn warn_of_names(&mut self, word: &Spanned<String>) {
        if word.node.bytes().all(|b| b.is_ascii_alphabetic()) {
            return; // one factor
        }
        for factor in factors(&word.node).into_iter().skip(1) {
            let Some(declared) = self.names.quantities.get(factor.symbol).map(|d| d.span) else { continue };
            if self.problems.reported.insert(("unit and name", factor.symbol.to_owned())) {
                let span = Span::new(word.span.start + factor.start, word.span.start + factor.end);
                let name = factor.symbol.to_owned();
                self.error(
                    Diagnosis::warning(
                        "mech::unit::also_a_name",
                        format!("`{name}` is read as a unit here, but it is also a name of this file"),
                    )
                    .primary(span, "read as a unit")
                    .label(declared, "declared here")
                    .help(format!(
                        "put blanks around the operator to use the name, as in `… * {name}` or `… \
                         / {name}`; or rename `{name}`"
                    )),
                );
            }
        }
    }
}

/// The expression with a unit after its bare numbers, where it consists of nothing else: `40 mm`, `(1 mm, 2 mm)`.
pub fn with_unit(expr: &Expr, unit: &str) -> Option<String> {
    match &expr.kind {
        ExprKind::Number(Number { text, unit: None, .. }) => Some(format!("{text} {unit}")),
        ExprKind::Unary(op, inner) => match op.node {
            UnaryOp::Minus => Some(format!("-{}", with_unit(inner, unit)?)),
            UnaryOp::Plus => with_unit(inner, unit),
            UnaryOp::Not => None,
        },
        ExprKind::Vector(x, y) => Some(format!("({}, {})", with_unit(x, unit)?, with_unit(y, unit)?)),
        ExprKind::Polar(r, phi) => Some(format!("{} @ {}", with_unit(r, unit)?, in_words(phi))),
        // `180/6`: the unit belongs to the first number
        ExprKind::Chain(first, rest) => {
            rest.iter().try_fold(with_unit(first, unit)?, |text, (op, operand)| {
                let sign = match op.node {
                    BinaryOp::Multiply => "*",
                    BinaryOp::Divide => "/",
                    _ => return None,
                };
                let ExprKind::Number(Number { text: number, unit: None, .. }) = &operand.kind else {
                    return None;
                };
                Some(format!("{text}{sign}{number}"))
            })
        }
        _ => None,
    }
}

/// A number, or numbers multiplied and divided, without their units: `1/60` for `1/60 kg`.
pub fn without_units(expr: &Expr) -> Option<String> {
    match &expr.kind {
        ExprKind::Number(number) => Some(number.text.clone()),
        ExprKind::Chain(first, rest) => rest.iter().try_fold(without_units(first)?, |text, (op, operand)| {
            let sign = match op.node {
                BinaryOp::Multiply => "*",
                BinaryOp::Divide => "/",
                _ => return None,
            };
            Some(format!("{text}{sign}{}", without_units(operand)?))
        }),
        _ => None,
    }
}

/// A number or a name as it is written.
fn in_words(expr: &Expr) -> String {
    match &expr.kind {
        ExprKind::Number(Number { text, unit: Some(unit), .. }) => format!("{text} {}", unit.node),
        ExprKind::Name(name) => name.clone(),
        _ => "…".to_owned(),
    }
}
