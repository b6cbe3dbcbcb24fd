//! The sizes that a file works out from its given values, `let l = H/(2*sin(psi/2))`, and what it asks for by formulas of results,
//! `find M = M_A + M_B`.

use assur_formula::{Expr, Function as Maths, Name, Quantity, Unit, quantity};
use assur_model::model::{Expr as Model, FindKind, Function, Mechanism, NamedValue, QuantityId, Value};
use assur_syntax::document::{Arg, BinaryOp, Document, Expr as Written, ExprKind, Statement, UnaryOp};
use assur_text::source::Spanned;
use assur_worked::{Formula, Size, quantity_name, unit_of as unit};
use std::cell::RefCell;
use std::collections::VecDeque;
use std::sync::Arc;

/// Functions of one number.
const MATHS: [&str; 8] = ["sqrt", "abs", "sin", "cos", "tan", "asin", "acos", "atan"];
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
    let known = Known { values: &mechanism.values, given: &given, results: None };
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

/// What a file asks for by formulas of results, and the named quantities that these use, which come first.
pub fn formulas(document: &Document, mechanism: &Mechanism) -> Vec<Formula> {
    let given = |name: &str| {
        let own = |s: &Spanned<Statement>| matches!(&s.node, Statement::Given(d) if d.name.node == name);
        document.statements.iter().any(own)
    };
    let of = |name: &str, written: &Written, of: &Model, dimension| {
        if matches!(of, Model::Query(_) | Model::Component(..) | Model::Quantity(_)) {
            return None;
        }
        let results = Some(Results::of(of, mechanism));
        let known = Known { values: &mechanism.values, given: &given, results };
        let right = known.formula(written)?;
        let results = known.results?.taken.into_inner();
        let name = quantity_name(name);
        (!results.is_empty())
            .then(|| Some(Formula { name, unit: unit(dimension)?, of: of.clone(), right, results }))?
    };
    let mut found = Vec::new();
    for statement in &document.statements {
        if let Statement::Let(d) = &statement.node
            && let Some(quantity) = mechanism.quantities.iter().find(|q| q.name == d.name.node)
        {
            found.extend(of(&quantity.name, &d.value, &quantity.expr, quantity.display.dimension));
        }
    }
    let items = document.statements.iter().filter_map(|s| match &s.node {
        Statement::Find(find) => Some(&find.items),
        _ => None,
    });
    for item in items.flatten().filter(|item| item.name.is_some()) {
        let Some(name) = &item.name else { continue };
        let asked = mechanism.finds.iter().find(|find| find.name == name.node);
        let Some(FindKind::Value { expr, display, .. }) = asked.map(|find| &find.kind) else { continue };
        let own = match expr {
            Model::Quantity(id) => mechanism.quantities.get(id.index()).filter(|q| q.name == name.node),
            _ => None,
        };
        found.extend(of(&name.node, &item.value, own.map_or(expr, |q| &q.expr), display.dimension));
    }
    used(found, mechanism)
}

/// Without named quantities that nothing asked for uses.
fn used(formulas: Vec<Formula>, mechanism: &Mechanism) -> Vec<Formula> {
    let mut wanted: Vec<Name> = mechanism.finds.iter().map(|find| quantity_name(&find.name)).collect();
    let mut kept: Vec<Formula> = Vec::new();
    for formula in formulas.into_iter().rev().filter(|f| f.unit != Unit::Angle) {
        if wanted.contains(&formula.name) {
            wanted.extend(formula.results.iter().map(|(name, _)| name.clone()));
            kept.push(formula);
        }
    }
    kept.reverse();
    kept
}

/// The results in an expression of the model, in their order: those that a written expression has are taken one by one.
struct Results<'a> {
    left: RefCell<VecDeque<Model>>,
    taken: RefCell<Vec<(Name, Model)>>,
    mechanism: &'a Mechanism,
}

impl<'a> Results<'a> {
    fn of(expr: &Model, mechanism: &'a Mechanism) -> Self {
        let mut left = VecDeque::new();
        collect(expr, &mut left);
        Self { left: RefCell::new(left), taken: RefCell::default(), mechanism }
    }

    /// The next result, if it is of this kind, as letters of its own.
    fn next(&self, is: impl Fn(&Model) -> bool) -> Option<Expr> {
        if !self.left.borrow().front().is_some_and(is) {
            return None;
        }
        let result = self.left.borrow_mut().pop_front()?;
        let name = Name::new("result", &self.taken.borrow().len().to_string());
        self.taken.borrow_mut().push((name.clone(), result));
        Some(quantity(name, 1.0, Unit::One))
    }

    fn named(&self, name: &str) -> Option<Expr> {
        let index = self.mechanism.quantities.iter().position(|q| q.name == name)?;
        let name = quantity_name(name);
        self.taken.borrow_mut().push((name.clone(), Model::Quantity(QuantityId::at(index))));
        Some(quantity(name, 1.0, Unit::One))
    }
}

fn collect(expr: &Model, found: &mut VecDeque<Model>) {
    match expr {
        Model::Query(_) | Model::Component(..) => found.push_back(expr.clone()),
        Model::Call(Function::Mag, args) if matches!(args.as_slice(), [Model::Query(_)]) => {
            found.push_back(expr.clone());
        }
        other => other.children(&mut |part| collect(part, found)),
    }
}

/// The values that formulas are of.
struct Known<'a> {
    values: &'a [NamedValue],
    given: &'a dyn Fn(&str) -> bool,
    results: Option<Results<'a>>,
}

impl Known<'_> {
    fn value(&self, name: &str) -> Option<(f64, Unit)> {
        let found = self.values.iter().find(|v| v.name == name)?;
        let Value::Scalar(x) = found.value else { return None };
        let unit = unit(found.display.dimension)?;
        Some((if unit == Unit::Angle { x.to_degrees() } else { x }, unit))
    }

    /// A value that is given in revolutions per minute, in these.
    fn speed(&self, name: &str) -> Option<(f64, Unit)> {
        let found = self.values.iter().find(|v| v.name == name && v.display.unit == "rpm")?;
        let Value::Scalar(x) = found.value else { return None };
        (self.given)(name).then(|| (found.display.of_si(x), Unit::Speed))
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
            ExprKind::Name(name) => match self.speed(name).or_else(|| self.value(name)) {
                Some((value, Unit::Speed)) => {
                    let (name, given) = (quantity_name(name), (self.given)(name));
                    let scale = value.abs();
                    let unit = Unit::Speed;
                    let speed = Quantity { name, value, unit, scale, given, rounding: 0.0 };
                    Some(Expr::Pi * Expr::Leaf(Arc::new(speed)) / Expr::Int(30))
                }
                Some((value, unit)) => {
                    let (name, given) = (quantity_name(name), (self.given)(name));
                    let scale = value.abs();
                    Some(Expr::Leaf(Arc::new(Quantity { name, value, unit, scale, given, rounding: 0.0 })))
                }
                None if name == "pi" => Some(Expr::Pi),
                None => self.results.as_ref()?.named(name),
            },
            ExprKind::Call { function, args } => match args.as_slice() {
                [one] if one.name.is_none() && MATHS.contains(&&*function.node) => {
                    self.call(&function.node, &one.value)
                }
                [one] if function.node == "radius" => self.radius(&one.value),
                _ if function.node == "journal_torque" => self.journal(args),
                _ if function.node == "thrust_torque" => self.thrust(args),
                _ if function.node == "mag" => {
                    self.results.as_ref()?.next(|m| matches!(m, Model::Call(Function::Mag, _)))
                }
                _ => self.results.as_ref()?.next(|m| matches!(m, Model::Query(_))),
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
            ExprKind::Member(..) => {
                self.results.as_ref()?.next(|m| matches!(m, Model::Component(..) | Model::Query(_)))
            }
            ExprKind::Vector(..) | ExprKind::Polar(..) | ExprKind::Compare(..) => None,
        }
    }

    /// The radius of a wheel.
    fn radius(&self, wheel: &Written) -> Option<Expr> {
        let ExprKind::Name(name) = &wheel.kind else { return None };
        let wheel = self.results.as_ref()?.mechanism.wheels.iter().find(|own| own.name == *name)?;
        let (name, value) = (Name::new("r", name), wheel.radius);
        let radius = Quantity { name, value, unit: Unit::Length, scale: value, given: true, rounding: 0.0 };
        Some(Expr::Leaf(Arc::new(radius)))
    }

    /// k f F r of a journal.
    fn journal(&self, args: &[Arg]) -> Option<Expr> {
        let fit = match named(args, "fit").map(|fit| &fit.kind) {
            None => Expr::Int(1),
            Some(ExprKind::Name(word)) if word == "line" => Expr::Int(1),
            Some(ExprKind::Name(word)) if word == "even" => Expr::Pi / Expr::Int(2),
            Some(ExprKind::Name(word)) if word == "worn" => Expr::Int(4) / Expr::Pi,
            Some(_) => return None,
        };
        let of = |name| self.formula(named(args, name)?);
        Some(fit * of("friction")? * of("load")? * of("radius")?)
    }

    /// The torque of a thrust bearing: of a new one with even pressure, or of one that is worn.
    fn thrust(&self, args: &[Arg]) -> Option<Expr> {
        let of = |name| self.formula(named(args, name)?);
        let pull = of("friction")? * of("load")?;
        let outer = of("outer")?;
        let inner = match named(args, "inner") {
            Some(inner) => self.formula(inner)?,
            None => Expr::ZERO,
        };
        let is_worn =
            named(args, "fit").is_some_and(|fit| matches!(&fit.kind, ExprKind::Name(w) if w == "worn"));
        Some(if is_worn {
            pull * (outer + inner) / Expr::Int(2)
        } else if inner.is_zero() {
            Expr::Int(2) * pull * outer / Expr::Int(3)
        } else {
            let squares = outer.clone().squared() + outer.clone() * inner.clone() + inner.clone().squared();
            Expr::Int(2) * pull * squares / (Expr::Int(3) * (outer + inner))
        })
    }

    fn call(&self, function: &str, of: &Written) -> Option<Expr> {
        let of = self.formula(of)?;
        Some(match function {
            "sqrt" => of.root(),
            "abs" => of.abs(),
            "sin" => of.sin(),
            "cos" => of.cos(),
            "tan" => of.of(Maths::Tan),
            "asin" => of.of(Maths::Arcsin),
            "acos" => of.of(Maths::Arccos),
            "atan" => of.of(Maths::Arctan),
            _ => return None,
        })
    }
}

/// The argument of a name.
fn named<'a>(args: &'a [Arg], name: &str) -> Option<&'a Written> {
    args.iter().find(|arg| arg.name.as_ref().is_some_and(|own| own.node == name)).map(|arg| &arg.value)
}
