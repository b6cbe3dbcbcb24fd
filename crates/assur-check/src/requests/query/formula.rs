//! Functions that are formulas of their named arguments: belts and screws.

use crate::expr::context::Context;
use crate::expr::results::Call;
use crate::values::fold;
use crate::values::typed::{Type, Typed};
use assur_model::model::{BinaryOp, Expr, Function as Math};
use assur_text::language::{Function, Takes};
use assur_text::units::Dimension;
use std::f64::consts::{E, PI};

/// The arguments given, by name.
struct Given {
    values: Vec<(&'static str, Expr)>,
    pending: bool,
}

impl Given {
    fn value(&self, name: &str) -> Option<Expr> {
        self.values.iter().find(|(n, _)| *n == name).map(|(_, value)| value.clone())
    }

    /// One that is there: optional ones are asked for by [`Given::value`].
    fn must(&self, name: &str) -> Expr {
        self.value(name).unwrap_or(Expr::number(f64::NAN))
    }

    fn function(&self, function: Math, name: &str) -> Option<Expr> {
        self.value(name).map(|angle| fold::call(function, vec![angle]))
    }
}

fn op(op: BinaryOp, a: Expr, b: Expr) -> Expr {
    fold::binary(op, a, b)
}

fn times(a: Expr, b: Expr) -> Expr {
    op(BinaryOp::Mul, a, b)
}

fn over(a: Expr, b: Expr) -> Expr {
    op(BinaryOp::Div, a, b)
}

/// Itself where it is positive, and not a value elsewhere.
fn positive(x: Expr) -> Expr {
    let root = fold::call(Math::Sqrt, vec![x]);
    times(root.clone(), root)
}

impl Context<'_> {
    /// `belt_ratio(friction = μ, wrap = θ, groove = γ)`: T₁/T₂ = e^(μ θ / sin γ) of a belt or rope that is about to slip, for
    /// the half-angle γ of a V-groove. Euler and Eytelwein.
    pub(super) fn belt_ratio(&mut self, call: Call<'_>) -> Option<Typed> {
        let given = self.formula(call, Function::BeltRatio)?;
        let mut exponent = times(given.must("friction"), given.must("wrap"));
        if let Some(sine) = given.function(Math::Sin, "groove") {
            exponent = over(exponent, sine);
        }
        self.formula_value(
            call,
            &given,
            fold::power(Expr::number(E), exponent),
            Dimension::NUMBER,
            "the ratio is not a finite number",
        )
    }

    /// `raising_torque(load = F, diameter = d, lead = h, friction = μ, flank = β)`: F d/2 tan(λ + ρ), with tan λ = h/(π d) and
    /// tan ρ = μ/cos β; `lowering_torque(…)`: F d/2 tan(ρ − λ), below zero where the load turns the screw.
    pub(super) fn screw_torque(&mut self, call: Call<'_>, function: Function) -> Option<Typed> {
        let given = self.formula(call, function)?;
        let diameter = given.must("diameter");
        let lead = over(given.must("lead"), times(Expr::number(PI), diameter.clone()));
        let mut friction = given.must("friction");
        if let Some(cosine) = given.function(Math::Cos, "flank") {
            friction = over(friction, cosine);
        }
        let product = times(lead.clone(), friction.clone());
        let one = Expr::number(1.0);
        let tangent = if function == Function::RaisingTorque {
            // at λ + ρ = 90° no torque raises the load
            let rest = positive(op(BinaryOp::Sub, one, product));
            over(op(BinaryOp::Add, lead, friction), rest)
        } else {
            over(op(BinaryOp::Sub, friction, lead), op(BinaryOp::Add, one, product))
        };
        let arm = over(diameter, Expr::number(2.0));
        let torque = times(times(given.must("load"), arm), tangent);
        let why = "the angles of lead and friction add up to 90 deg or more";
        self.formula_value(call, &given, torque, Dimension::TORQUE, why)
    }

    fn formula_value(
        &mut self,
        call: Call<'_>,
        given: &Given,
        expr: Expr,
        dimension: Dimension,
        why: &'static str,
    ) -> Option<Typed> {
        let ty = Type::number(dimension);
        if given.pending {
            return Some(Typed::pending(ty));
        }
        self.finite(Typed::new(expr, ty), why, call.span)
    }

    /// The named arguments of a formula; reports those that are unknown, repeated or missing.
    fn formula(&mut self, call: Call<'_>, function: Function) -> Option<Given> {
        let known = function.row().forms.iter().flat_map(|form| form.takes);
        let mut given = Given { values: Vec::new(), pending: false };
        for arg in call.args {
            let Some(name) = &arg.name else {
                self.wrong_argument(call, "an argument with a name", arg.value.span);
                return None;
            };
            let argument = known.clone().find(|a| a.name == name.node);
            let Some((key, Takes::Value(Some(dimension)))) = argument.map(|a| (a.name, a.takes)) else {
                self.wrong_argument(call, "another argument", name.span);
                return None;
            };
            if given.value(key).is_some() {
                self.wrong_argument(call, &format!("`{key}` only once"), name.span);
                return None;
            }
            let t = self.read(&arg.value)?;
            let t = self.fit(t, dimension, &format!("`{key}`"), &arg.value)?;
            given.pending |= t.pending;
            given.values.push((key, t.expr));
        }
        if let Some(missing) = known.clone().find(|a| !a.optional && given.value(a.name).is_none()) {
            self.wrong_argument(call, &format!("also `{} = …`", missing.name), call.span);
            return None;
        }
        Some(given)
    }
}
