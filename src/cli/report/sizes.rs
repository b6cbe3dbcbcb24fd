//! The sizes that a file works out from its given values, `let l = H/(2*sin(psi/2))`, as formulas.

use assur_formula::{Expr, Function, Quantity, Unit};
use assur_model::model::{Mechanism, NamedValue, Value};
use assur_syntax::document::{BinaryOp, Document, Expr as Written, ExprKind, Statement, UnaryOp};
use assur_worked::{Size, quantity_name};
use std::sync::Arc;

/// A formula that comes to something else than the value is of a kind that is not written here.
const SAME: f64 = 1e-9;

/// All that has a formula, in the order of the file.
pub fn sizes(document: &Document, mechanism: &Mechanism) -> Vec<Size> {
    let given = |name: &str| {
        document
            .statements
            .iter()
            .any(|s| matches!(&s.node, Statement::Given(definition) if definition.name.node == name))
    };
    let known = Known { values: &mechanism.values, given: &given };
    let size = |name: &str, expr: &Written| {
        if matches!(expr.kind, ExprKind::Number(_) | ExprKind::Name(_)) {
            return None;
        }
        let (value, unit) = known.value(name)?;
        let right = known.formula(expr)?;
        let same = (right.value() - value).abs() <= SAME * right.scale().max(value.abs());
        same.then(|| Size { name: quantity_name(name), value, unit, right })
    };
    let lets = document.statements.iter().filter_map(|s| match &s.node {
        Statement::Let(definition) => size(&definition.name.node, &definition.value),
        _ => None,
    });
    lets.collect()
}

/// The values that formulas are of.
struct Known<'a> {
    values: &'a [NamedValue],
    given: &'a dyn Fn(&str) -> bool,
}

impl Known<'_> {
    fn value(&self, name: &str) -> Option<(f64, Unit)> {
        let found = self.values.iter().find(|v| v.name == name)?;
        let Value::Scalar(x) = found.value else { return None };
        let unit = unit(found.display.dimension)?;
        Some((if unit == Unit::Angle { x.to_degrees() } else { x }, unit))
    }

    fn formula(&self, expr: &Written) -> Option<Expr> {
        match &expr.kind {
            ExprKind::Number(number) => {
                let degrees = number.unit.as_ref().is_some_and(|unit| unit.node == "deg");
                #[allow(clippy::cast_possible_truncation, reason = "it is whole and small")]
                let whole =
                    (number.value.fract() == 0.0 && number.value.abs() < 1e9).then_some(number.value as i64);
                match (&number.unit, whole) {
                    (Some(_), Some(whole)) if degrees => Some(Expr::Degrees(whole)),
                    (Some(_), _) => None,
                    (None, Some(whole)) => Some(Expr::Int(whole)),
                    (None, None) => Some(Expr::Number(number.value)),
                }
            }
            ExprKind::Name(name) => match self.value(name) {
                Some((value, unit)) => {
                    let (name, given) = (quantity_name(name), (self.given)(name));
                    let scale = value.abs();
                    Some(Expr::Leaf(Arc::new(Quantity { name, value, unit, scale, given, rounding: 0.0 })))
                }
                None if name == "pi" => Some(Expr::Pi),
                None => None,
            },
            ExprKind::Call { function, args } => match args.as_slice() {
                [one] if one.name.is_none() => self.call(&function.node, &one.value),
                _ => None,
            },
            ExprKind::Unary(sign, inner) => match sign.node {
                UnaryOp::Minus => Some(-self.formula(inner)?),
                UnaryOp::Plus => self.formula(inner),
                UnaryOp::Not => None,
            },
            ExprKind::Chain(first, rest) => {
                let mut value = self.formula(first)?;
                for (operator, other) in rest {
                    let other = self.formula(other)?;
                    value = match operator.node {
                        BinaryOp::Add => value + other,
                        BinaryOp::Subtract => value - other,
                        BinaryOp::Multiply => value * other,
                        BinaryOp::Divide => value / other,
                        BinaryOp::And | BinaryOp::Or => return None,
                    };
                }
                Some(value)
            }
            ExprKind::Power(base, exponent) => match &exponent.kind {
                ExprKind::Number(n) if n.value == 2.0 && n.unit.is_none() => {
                    Some(self.formula(base)?.squared())
                }
                _ => None,
            },
            ExprKind::Member(..) | ExprKind::Vector(..) | ExprKind::Polar(..) | ExprKind::Compare(..) => None,
        }
    }

    fn call(&self, function: &str, of: &Written) -> Option<Expr> {
        let of = self.formula(of)?;
        Some(match function {
            "sqrt" => of.root(),
            "abs" => of.abs(),
            "sin" => of.sin(),
            "cos" => of.cos(),
            "tan" => of.of(Function::Tan),
            "asin" => of.of(Function::Arcsin),
            "acos" => of.of(Function::Arccos),
            "atan" => of.of(Function::Arctan),
            _ => return None,
        })
    }
}

/// The unit of equations of a dimension.
const fn unit(dimension: [i8; 4]) -> Option<Unit> {
    Some(match dimension {
        [0, 0, 0, 0] => Unit::One,
        [0, 0, 0, _] => Unit::Angle,
        [1, 0, 0, _] => Unit::Length,
        [2, 0, 0, _] => Unit::Area,
        [1, 0, -1, _] => Unit::Velocity,
        [1, 0, -2, _] => Unit::Acceleration,
        [0, 0, -1, 1] => Unit::AngularVelocity,
        [0, 0, -2, 1] => Unit::AngularAcceleration,
        [0, 1, 0, _] => Unit::Mass,
        [2, 1, 0, _] => Unit::Inertia,
        [1, 1, -2, _] => Unit::Force,
        [2, 1, -2, _] => Unit::Torque,
        [2, 1, -3, _] => Unit::Power,
        [0, 1, -2, _] => Unit::Stiffness,
        _ => return None,
    })
}
