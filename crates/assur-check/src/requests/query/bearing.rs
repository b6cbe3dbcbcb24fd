//! Friction torques of bearings by formula: `journal_torque(…)`, `thrust_torque(…)`.

use crate::expr::context::Context;
use crate::expr::results::Call;
use crate::pairs::friction::factor_of_fit;
use crate::values::fold::binary;
use crate::values::typed::{Type, Typed};
use assur_model::model::{BinaryOp, Expr as ModelExpr};
use assur_syntax::document::{Arg, Expr, ExprKind, Name};
use assur_text::language::{Argument, Function, Takes};
use assur_text::units::Dimension;

/// What turns.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Bearing {
    Journal,
    Thrust,
}

impl Bearing {
    /// The arguments it takes.
    fn arguments(self) -> impl Iterator<Item = &'static Argument> {
        let function = match self {
            Self::Journal => Function::JournalTorque,
            Self::Thrust => Function::ThrustTorque,
        };
        function.row().forms.iter().flat_map(|form| form.takes)
    }
}

/// How the pressure is spread.
enum Fit {
    Word(&'static str),
    Factor(ModelExpr),
}

/// The arguments, as far as they are given.
#[derive(Default)]
struct Given {
    values: Vec<(&'static str, ModelExpr)>,
    fit: Option<Fit>,
    pending: bool,
}

impl Given {
    fn take(&mut self, name: &str) -> Option<ModelExpr> {
        let at = self.values.iter().position(|(n, _)| *n == name)?;
        Some(self.values.swap_remove(at).1)
    }
}

fn times(a: ModelExpr, b: ModelExpr) -> ModelExpr {
    binary(BinaryOp::Mul, a, b)
}

fn plus(a: ModelExpr, b: ModelExpr) -> ModelExpr {
    binary(BinaryOp::Add, a, b)
}

impl Context<'_> {
    /// `journal_torque(load, radius, friction, fit)` = k f load radius;
    /// `thrust_torque(load, outer, inner, friction, fit)`: new, even pressure (default): 2/3 f load (R² + R r + r²)/(R + r);
    /// run in, `fit = worn`, p r constant: f load (R + r)/2.
    pub(crate) fn bearing(&mut self, call: Call<'_>, bearing: Bearing) -> Option<Typed> {
        let mut given = Given::default();
        for arg in call.args {
            let Some(name) = &arg.name else {
                self.wrong_argument(call, "an argument with a name", arg.value.span);
                return None;
            };
            self.bearing_argument(call, bearing, (arg, name), &mut given)?;
        }
        let mut value = |name: &'static str| {
            let value = given.take(name);
            if value.is_none() {
                self.wrong_argument(call, &format!("also `{name} = …`"), call.span);
            }
            value
        };
        let (load, friction) = (value("load")?, value("friction")?);
        let pull = times(friction, load);
        let torque = if bearing == Bearing::Journal {
            let radius = value("radius")?;
            let factor = match given.fit {
                Some(Fit::Factor(k)) => k,
                Some(Fit::Word(word)) => ModelExpr::number(factor_of_fit(word)),
                None => ModelExpr::number(1.0),
            };
            times(times(factor, pull), radius)
        } else {
            let outer = value("outer")?;
            let inner = given.take("inner").unwrap_or(ModelExpr::number(0.0));
            let sum = plus(outer.clone(), inner.clone());
            match given.fit {
                Some(Fit::Word("worn")) => binary(BinaryOp::Div, times(pull, sum), ModelExpr::number(2.0)),
                _ => {
                    // (R³ − r³)/(R² − r²) without its cancellation at r = R
                    let squares = plus(
                        times(outer.clone(), outer.clone()),
                        plus(times(outer, inner.clone()), times(inner.clone(), inner)),
                    );
                    let arm = binary(BinaryOp::Div, squares, sum);
                    times(
                        binary(BinaryOp::Div, times(ModelExpr::number(2.0), pull), ModelExpr::number(3.0)),
                        arm,
                    )
                }
            }
        };
        let typed = Typed { expr: torque, ty: Type::number(Dimension::TORQUE), pending: given.pending };
        if given.pending {
            Some(Typed::pending(typed.ty))
        } else {
            self.finite(typed, "this torque is not defined", call.span)
        }
    }

    fn bearing_argument(
        &mut self,
        call: Call<'_>,
        bearing: Bearing,
        (arg, name): (&Arg, &Name),
        given: &mut Given,
    ) -> Option<()> {
        let Some(known) = bearing.arguments().find(|a| a.name == name.node) else {
            self.wrong_argument(call, "another argument", name.span);
            return None;
        };
        let key = known.name;
        let Takes::Value(Some(dimension)) = known.takes else {
            return self.fit_argument(call, bearing, &arg.value, given);
        };
        let t = self.read(&arg.value)?;
        let t = self.fit(t, dimension, &format!("`{}`", name.node), &arg.value)?;
        given.pending |= t.pending;
        if given.take(key).is_some() {
            self.wrong_argument(call, &format!("`{key}` only once"), name.span);
            return None;
        }
        given.values.push((key, t.expr));
        Some(())
    }

    fn fit_argument(
        &mut self,
        call: Call<'_>,
        bearing: Bearing,
        expr: &Expr,
        given: &mut Given,
    ) -> Option<()> {
        let journal = bearing == Bearing::Journal;
        let word = match &expr.kind {
            ExprKind::Name(name) => match name.as_str() {
                "line" if journal => Some("line"),
                "even" => Some("even"),
                "worn" => Some("worn"),
                _ => None,
            },
            _ => None,
        };
        given.fit = Some(match word {
            Some(word) => Fit::Word(word),
            None if journal => {
                let t = self.read(expr)?;
                let t = self.fit(t, Dimension::NUMBER, "`fit`", expr)?;
                given.pending |= t.pending;
                Fit::Factor(t.expr)
            }
            None => {
                self.wrong_argument(call, "`even` or `worn`", expr.span);
                return None;
            }
        });
        Some(())
    }
}
