//! Numbers of values: their figures and units.

use crate::sheet::printed_unit;
use assur_syntax::document::{Definition, Expr, ExprKind, Number, UnaryOp};
use std::collections::BTreeMap;

/// The side of the page that a direction is.
pub(super) fn right_angle(direction: &Expr) -> Option<&'static str> {
    let (value, number) = match &direction.kind {
        ExprKind::Number(number) => (number.value, number),
        ExprKind::Unary(op, of) => match &of.kind {
            ExprKind::Number(number) if op.node == UnaryOp::Minus => (-number.value, number),
            _ => return None,
        },
        _ => return None,
    };
    if number.unit.as_ref().is_none_or(|unit| unit.node != "deg") {
        return None;
    }
    let turned = value.rem_euclid(360.0);
    [("0", 0.0), ("90", 90.0), ("180", 180.0), ("270", 270.0)]
        .into_iter()
        .find_map(|(key, angle)| (angle == turned).then_some(key))
}

/// A number with its unit as the file has them.
pub(super) fn figures(number: &Number) -> String {
    let unit = number.unit.as_ref().map_or_else(String::new, |unit| printed_unit(&unit.node));
    spaced(&format!("{}{unit}", digits(&number.text)))
}

/// The digits of a number as they are set: `1.5e-2` is 1.5·10⁻².
pub(crate) fn digits(written: &str) -> String {
    let (digits, power) = written.split_once(['e', 'E']).unwrap_or((written, ""));
    let digits = digits.replace('-', "−");
    match raised(power.trim_start_matches('+')) {
        Some(power) if !power.is_empty() => format!("{digits}·10{power}"),
        Some(_) | None => digits,
    }
}

/// With blanks that no line breaks at.
pub(super) fn spaced(words: &str) -> String {
    words.replace(' ', "\u{a0}")
}

/// A whole number above the line.
pub(super) fn raised(power: &str) -> Option<String> {
    let digit = |c: char| match c {
        '-' | '−' => Some('⁻'),
        c => "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(usize::try_from(c.to_digit(10)?).ok()?),
    };
    power.chars().map(digit).collect()
}

/// The unit of the first number of an expression, that of a definition where it is a name.
pub(super) fn first_unit<'a>(
    expr: &'a Expr,
    definitions: &BTreeMap<&str, &'a Definition>,
) -> Option<&'a str> {
    match &expr.kind {
        ExprKind::Number(number) => number.unit.as_ref().map(|unit| unit.node.as_str()),
        ExprKind::Name(name) => first_unit(&definitions.get(name.as_str())?.value, definitions),
        ExprKind::Member(of, _) | ExprKind::Unary(_, of) | ExprKind::Power(of, _) => {
            first_unit(of, definitions)
        }
        ExprKind::Vector(a, b) | ExprKind::Polar(a, b) => {
            first_unit(a, definitions).or_else(|| first_unit(b, definitions))
        }
        ExprKind::Chain(first, rest) => {
            let rest = rest.iter().map(|(_, next)| next);
            std::iter::once(&**first).chain(rest).find_map(|part| first_unit(part, definitions))
        }
        ExprKind::Call { .. } | ExprKind::Compare(..) => None,
    }
}
