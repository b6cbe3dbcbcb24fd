//! What to write in place of a quantity of another dimension than the one due.

use crate::expr::context::Context;
use crate::expr::number::without_units;
use crate::names::declared::QuantityKind;
use crate::statements::walk;
use crate::statements::written::written;
use crate::values::definition::Settled;
use crate::values::typed::{Type, correction};
use assur_syntax::document::{BinaryOp, Expr, ExprKind, Number, Statement, UnaryOp};
use assur_text::units::{Dimension, Kind, lookup};

/// Most names that a help lists.
const NAMES: usize = 4;

impl Context<'_> {
    /// What to write in place of the expression.
    pub(crate) fn in_its_place(
        &self,
        want: Dimension,
        found: Dimension,
        what: &str,
        expr: &Expr,
    ) -> Option<String> {
        let argument = what.starts_with("the argument of");
        if want == Dimension::NUMBER {
            let angle = found.is_dimensionless() && found.kind == Kind::Angle;
            if angle && what.contains("friction") {
                let tangent = format!("tan({})", written(expr)?);
                return Some(format!(
                    "write `{tangent}`: a coefficient of friction is the tangent of its angle"
                ));
            }
            let bare = without_units(expr).filter(|_| !(angle && argument));
            return bare.map(|text| format!("write `{text}`")).or_else(|| correction(want, found));
        }
        if want == Dimension::VELOCITY && found == Dimension::ANGULAR_VELOCITY {
            let lines = [in_unit(expr, "mm/s")?, in_unit(expr, "m/s")?];
            return Some(format!("write `{}` or `{}`: this moves along a line", lines[0], lines[1]));
        }
        let angles = || self.names_of(want).map(|names| format!("write an angle, as {names}"));
        weight(expr, want)
            .or_else(|| self.mass_of_weight(want, found, expr))
            .or_else(|| {
                fraction(expr, want)
                    .map(|text| format!("write `{text}`: the unit belongs to the last number"))
            })
            .or_else(|| self.same_number(want, expr).map(|text| format!("write `{text}`")))
            .or_else(|| self.definition_of(want, expr))
            .or_else(|| self.completed_number(want, found, expr))
            .or_else(|| if argument && want == Dimension::ANGLE { angles() } else { correction(want, found) })
    }

    /// The number with a unit of the dimension that is due: `9.81 m/s^2` for `9.81 m/s`.
    pub(crate) fn same_number(&self, want: Dimension, expr: &Expr) -> Option<String> {
        let unit = extended(expr, want).unwrap_or_else(|| self.values.usual_unit(want));
        in_unit(expr, &unit).filter(|_| !unit.is_empty())
    }

    /// `0.02 N*m*s^2*omega(fan)^2`: the product with what the unit of its first number lacks.
    fn completed_number(&self, want: Dimension, found: Dimension, expr: &Expr) -> Option<String> {
        let ExprKind::Chain(first, rest) = &expr.kind else { return None };
        let lacks = want.over(found).si_text();
        let positive = match &first.kind {
            ExprKind::Unary(op, inner) if op.node != UnaryOp::Not => inner,
            _ => first,
        };
        let given = match &positive.kind {
            ExprKind::Name(name) => self.given_as_written(name).map(|value| (Some(name), value)),
            _ => None,
        };
        let (name, literal) = given.unwrap_or((None, positive));
        let ExprKind::Number(Number { text, unit: Some(unit), .. }) = &literal.kind else { return None };
        let product = rest.iter().all(|(op, _)| matches!(op.node, BinaryOp::Multiply | BinaryOp::Divide));
        if !product || correction(want, found).is_some() || lacks.is_empty() || lacks.contains(['/', '(']) {
            return None;
        }
        let completed = format!("{text} {}*{lacks}", unit.node);
        if let Some(name) = name {
            return Some(format!("write `given {name} = {completed}`"));
        }
        let whole = written(expr)?.replacen(&written(positive)?, &completed, 1);
        let whole = whole.replace(" * ", "*").replace(" / ", "/");
        Some(format!("write `{whole}`"))
    }

    /// `2 N` for a mass, in a file with gravity.
    fn mass_of_weight(&self, want: Dimension, found: Dimension, expr: &Expr) -> Option<String> {
        let gravity = self.doc.statements.iter().any(|s| matches!(s.node, Statement::Gravity(_)));
        if want != Dimension::MASS || found != Dimension::FORCE || !gravity {
            return None;
        }
        let (mass, weight) = (self.same_number(want, expr)?, written(expr)?);
        Some(format!("write `{mass}`, or `weight {weight}` in place of `mass {weight}`"))
    }

    /// The line of a `given` that is used nowhere else, with what its unit lacks.
    fn definition_of(&self, want: Dimension, expr: &Expr) -> Option<String> {
        let ExprKind::Name(name) = &expr.kind else { return None };
        if self.values.outside.row.find(name).is_some() || self.uses(name) != 1 {
            return None;
        }
        Some(format!("write `{}`", self.completed_given(name, want)?))
    }

    /// The line of a `given` with what its unit lacks: `given M = 500 N*m` for `500 N`.
    pub(crate) fn completed_given(&self, name: &str, want: Dimension) -> Option<String> {
        let value = self.given_as_written(name)?;
        Some(format!("given {name} = {}", in_unit(value, &extended(value, want)?)?))
    }

    fn uses(&self, name: &str) -> usize {
        let mut count = 0;
        for statement in &self.doc.statements {
            walk::expressions(&statement.node, &mut |expr| {
                walk::parts(expr, &mut |part| {
                    count += usize::from(matches!(&part.kind, ExprKind::Name(n) if n == name));
                });
            });
        }
        count
    }

    /// The constants of the file of this dimension: `` `psi` or `phi` ``.
    pub(crate) fn names_of(&self, want: Dimension) -> Option<String> {
        let is = |name: &&String| match self.values.definitions.settled.get(*name) {
            Some(Settled::Constant(t)) => matches!(t.ty, Type::Number(_)) && t.ty.dimension() == want,
            _ => false,
        };
        let declared = self.names.quantities.iter();
        let constants = declared
            .filter(|(_, d)| matches!(d.what, QuantityKind::Given(_) | QuantityKind::Let(_)))
            .map(|(name, _)| name);
        let names = constants.filter(is).take(NAMES).map(|n| format!("`{n}`")).collect::<Vec<_>>();
        (!names.is_empty()).then(|| names.join(" or "))
    }
}

/// The unit of the first number with what it lacks: `kg*m^2` for `kg*m`.
fn extended(expr: &Expr, want: Dimension) -> Option<String> {
    let word = first_unit(expr)?;
    // `5 deg/s` is no velocity times a length
    let turns = lookup(word).is_ok_and(|u| u.dimension.kind == Kind::Angle);
    let units = ["^2", "*m", "/s"].map(|rest| format!("{word}{rest}"));
    // `N/mm^2` for `N/mm`
    let without = word.strip_suffix("^2").filter(|unit| lookup(unit).is_ok_and(|u| u.dimension == want));
    if let Some(unit) = without {
        return Some(unit.to_owned());
    }
    units.into_iter().filter(|_| !turns).find(|unit| lookup(unit).is_ok_and(|u| u.dimension == want))
}

/// The unit of the first number of what consists of numbers alone.
fn first_unit(expr: &Expr) -> Option<&str> {
    match &expr.kind {
        ExprKind::Number(number) => number.unit.as_ref().map(|u| u.node.as_str()),
        ExprKind::Unary(_, inner) => first_unit(inner),
        ExprKind::Polar(length, _) => first_unit(length),
        ExprKind::Vector(x, y) => first_unit(x).or_else(|| first_unit(y)),
        _ => None,
    }
}

/// What consists of numbers alone, in another unit.
fn in_unit(expr: &Expr, unit: &str) -> Option<String> {
    match &expr.kind {
        ExprKind::Number(Number { text, unit: Some(_), .. }) => Some(format!("{text} {unit}")),
        ExprKind::Number(Number { text, value, .. }) => (*value == 0.0).then(|| text.clone()),
        ExprKind::Unary(op, inner) => match op.node {
            UnaryOp::Minus => Some(format!("-{}", in_unit(inner, unit)?)),
            UnaryOp::Plus => in_unit(inner, unit),
            UnaryOp::Not => None,
        },
        ExprKind::Vector(x, y) => Some(format!("({}, {})", in_unit(x, unit)?, in_unit(y, unit)?)),
        ExprKind::Polar(length, phi) => Some(format!("{} @ {}", in_unit(length, unit)?, written(phi)?)),
        _ => None,
    }
}

/// `1 kg*m^2 / 12` for `1/12 kg*m^2`, which divides by the unit.
fn fraction(expr: &Expr, want: Dimension) -> Option<String> {
    let ExprKind::Chain(first, rest) = &expr.kind else { return None };
    let (ExprKind::Number(Number { text, unit: None, .. }), [(op, last)]) = (&first.kind, rest.as_slice())
    else {
        return None;
    };
    let ExprKind::Number(Number { text: below, unit: Some(unit), .. }) = &last.kind else { return None };
    let fits = op.node == BinaryOp::Divide && lookup(&unit.node).is_ok_and(|unit| unit.dimension.fits(want));
    fits.then(|| format!("{text} {} / {below}", unit.node))
}

/// `8 lb*ft`, `20 kg @ 270 deg`: a mass where its weight is meant.
fn weight(expr: &Expr, want: Dimension) -> Option<String> {
    let (number, behind) = match &expr.kind {
        ExprKind::Number(number) => (number, ""),
        ExprKind::Polar(length, _) => match &length.kind {
            ExprKind::Number(number) => (number, " @ …"),
            _ => return None,
        },
        _ => return None,
    };
    let word = &number.unit.as_ref()?.node;
    let force = [("lb", "lbf"), ("kg", "kgf")].into_iter().find_map(|(mass, force)| {
        let rest = word.strip_prefix(mass).filter(|rest| !rest.starts_with(|c: char| c.is_alphanumeric()))?;
        Some(format!("{force}{rest}"))
    })?;
    let fits = lookup(&force).is_ok_and(|unit| unit.dimension.fits(want));
    fits.then(|| match behind {
        "" => format!("write `{} {force}`", number.text),
        _ => format!("write the force in `{force}`: {} {force}{behind}", number.text),
    })
}
