//! Values as text, in the unit of the file.

use crate::names::declared::{Names, QuantityKind};
use crate::values::{
    definition::{Definitions, Settled},
    fold,
};
use assur_syntax::document::{Expr, ExprKind};
use assur_text::source::{Span, Spanned};
use assur_text::units::{Dimension, Unit, lookup};

/// How many parts of expressions are looked at to find a unit.
const PARTS: usize = 200;

/// A value in SI as text, in the unit that the expression it comes from is written in.
pub fn format_value_like(names: &Names<'_>, value: f64, dimension: Dimension, like: &Expr) -> String {
    let unit = unit_in(names, like, dimension, &mut { PARTS }).unwrap_or_else(|| usual(dimension));
    in_unit(value, &unit)
}

/// The first unit of that dimension in an expression or in what it is made of.
fn unit_in(names: &Names<'_>, expr: &Expr, dimension: Dimension, parts: &mut usize) -> Option<Unit> {
    *parts = parts.checked_sub(1)?;
    let mut first = |these: &[&Expr]| these.iter().find_map(|e| unit_in(names, e, dimension, parts));
    match &expr.kind {
        ExprKind::Number(number) => {
            let unit = lookup(&number.unit.as_ref()?.node).ok()?;
            unit.dimension.fits(dimension).then_some(unit)
        }
        ExprKind::Name(name) => match names.quantities.get(name)?.what {
            QuantityKind::Given(value) | QuantityKind::Let(value) => first(&[value]),
            _ => None,
        },
        ExprKind::Member(a, _) | ExprKind::Unary(_, a) => first(&[a]),
        ExprKind::Vector(a, b) | ExprKind::Polar(a, b) | ExprKind::Power(a, b) => first(&[a, b]),
        ExprKind::Chain(a, rest) => {
            let mut all = vec![a.as_ref()];
            all.extend(rest.iter().map(|(_, e)| e));
            first(&all)
        }
        ExprKind::Call { .. } | ExprKind::Compare(..) => None,
    }
}

/// The unit in which such values are shown where the file has none.
fn usual(dimension: Dimension) -> Unit {
    let word = if dimension == Dimension::LENGTH {
        "mm"
    } else if dimension == Dimension::ANGLE {
        "deg"
    } else {
        return Unit::si(dimension);
    };
    lookup(word).unwrap_or_else(|_| Unit::si(dimension))
}

/// A value in SI as text, in a usual unit.
pub fn format_value(value: f64, dimension: Dimension) -> String {
    in_unit(value, &usual(dimension))
}

fn in_unit(value: f64, unit: &Unit) -> String {
    let number = digits(unit.from_si(value));
    if unit.text.is_empty() { number } else { format!("{number} {}", unit.text) }
}

/// Six significant digits, without the zeros at the end.
pub fn digits(x: f64) -> String {
    let rounded = format!("{x:.5e}").parse().unwrap_or(x);
    if rounded == 0.0 {
        return "0".into();
    }
    if (1e-5..1e9).contains(&rounded.abs()) { format!("{rounded}") } else { format!("{rounded:e}") }
}

// Values in the title and the problem's text: `A crank of {r}`.

/// The text with the value in place of every `{name}` of a `given` or a constant `let`, in the unit it is written in. Other
/// braces stay as they are. The names are noted as used at the place of the text.
pub fn filled(text: &str, at: Span, names: &mut Names<'_>, definitions: &Definitions) -> String {
    with_names(text, |name| value(name, at, names, definitions))
}

/// A text with other words in place of some of its `{name}`.
pub fn with_names(text: &str, mut words: impl FnMut(&str) -> Option<String>) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((before, after)) = rest.split_once('{') {
        out.push_str(before);
        let found = after.split_once('}').and_then(|(name, behind)| Some((words(name.trim())?, behind)));
        match found {
            Some((words, behind)) => {
                out.push_str(&words);
                rest = behind;
            }
            None => {
                out.push('{');
                rest = after;
            }
        }
    }
    out + rest
}

/// All definitions that are constant numbers, with their values.
pub fn constants(names: &Names<'_>, definitions: &Definitions) -> Vec<(String, String)> {
    let all = definitions.order.iter();
    all.filter_map(|name| Some((name.clone(), constant(name, names, definitions)?))).collect()
}

fn value(name: &str, at: Span, names: &mut Names<'_>, definitions: &Definitions) -> Option<String> {
    if let QuantityKind::Given(_) | QuantityKind::Let(_) = names.quantities.get(name)?.what {
        names.note_quantity(&Spanned::new(name.to_owned(), at));
    }
    constant(name, names, definitions)
}

fn constant(name: &str, names: &Names<'_>, definitions: &Definitions) -> Option<String> {
    let (QuantityKind::Given(like) | QuantityKind::Let(like)) = names.quantities.get(name)?.what else {
        return None;
    };
    let Settled::Constant(t) = definitions.settled(name)? else { return None };
    let value = fold::scalar(&t.expr)?;
    Some(format_value_like(names, value, t.ty.dimension(), like))
}
