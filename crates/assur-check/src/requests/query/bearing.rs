//! Friction torques of bearings by formula: `journal_torque(…)`, `thrust_torque(…)`.

use super::named::Given;
use crate::expr::context::Context;
use crate::expr::results::Call;
use crate::pairs::friction::factor_of_fit;
use crate::values::fold::binary;
use crate::values::typed::{Type, Typed};
use assur_model::model::{BinaryOp, Expr as ModelExpr};
use assur_syntax::document::{Expr, ExprKind};
use assur_text::language::Function;
use assur_text::units::Dimension;

#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Bearing {
    Journal,
    Thrust,
}

impl Bearing {
    const fn function(self) -> Function {
        match self {
            Self::Journal => Function::JournalTorque,
            Self::Thrust => Function::ThrustTorque,
        }
    }
}

/// How the pressure is spread.
enum Fit {
    Word(&'static str),
    Factor(ModelExpr),
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
        let mut given = self.named_arguments(call, bearing.function())?;
        let fit = match given.other("fit") {
            Some(expr) => Some(self.fit_argument(call, bearing, expr, &mut given)?),
            None => None,
        };
        let pull = times(given.must("friction"), given.must("load"));
        let torque = if bearing == Bearing::Journal {
            let factor = match fit {
                Some(Fit::Factor(k)) => k,
                Some(Fit::Word(word)) => ModelExpr::number(factor_of_fit(word)),
                None => ModelExpr::number(1.0),
            };
            times(times(factor, pull), given.must("radius"))
        } else {
            let outer = given.must("outer");
            let inner = given.value("inner").unwrap_or(ModelExpr::number(0.0));
            let sum = plus(outer.clone(), inner.clone());
            match fit {
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
            self.keep_formula(bearing.function(), &given, &typed);
            self.finite(typed, "this torque is not defined", call.span)
        }
    }

    fn fit_argument(
        &mut self,
        call: Call<'_>,
        bearing: Bearing,
        expr: &Expr,
        given: &mut Given<'_>,
    ) -> Option<Fit> {
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
        Some(match word {
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
        })
    }
}
