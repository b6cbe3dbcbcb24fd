//! Functions that are formulas of their named arguments: belts and screws.

use super::named::Given;
use crate::expr::context::Context;
use crate::expr::results::Call;
use crate::values::fold;
use crate::values::typed::{Type, Typed};
use assur_model::model::{BinaryOp, Expr, Function as Math};
use assur_text::language::Function;
use assur_text::units::Dimension;
use std::f64::consts::{E, PI};

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
        let given = self.named_arguments(call, Function::BeltRatio)?;
        let mut exponent = times(given.must("friction"), given.must("wrap"));
        if let Some(sine) = given.value("groove").map(|angle| fold::call(Math::Sin, vec![angle])) {
            exponent = over(exponent, sine);
        }
        self.formula_value(
            (call, Function::BeltRatio),
            &given,
            fold::power(Expr::number(E), exponent),
            Dimension::NUMBER,
            "the ratio is not a finite number",
        )
    }

    /// `raising_torque(load = F, diameter = d, lead = h, friction = μ, flank = β)`: F d/2 tan(λ + ρ), with tan λ = h/(π d) and
    /// tan ρ = μ/cos β; `lowering_torque(…)`: F d/2 tan(ρ − λ), below zero where the load turns the screw.
    pub(super) fn screw_torque(&mut self, call: Call<'_>, function: Function) -> Option<Typed> {
        let given = self.named_arguments(call, function)?;
        let diameter = given.must("diameter");
        let lead = over(given.must("lead"), times(Expr::number(PI), diameter.clone()));
        let mut friction = given.must("friction");
        if let Some(cosine) = given.value("flank").map(|angle| fold::call(Math::Cos, vec![angle])) {
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
        self.formula_value((call, function), &given, torque, Dimension::TORQUE, why)
    }

    fn formula_value(
        &mut self,
        (call, function): (Call<'_>, Function),
        given: &Given<'_>,
        expr: Expr,
        dimension: Dimension,
        why: &'static str,
    ) -> Option<Typed> {
        let ty = Type::number(dimension);
        if given.pending {
            return Some(Typed::pending(ty));
        }
        let typed = Typed::new(expr, ty);
        self.keep_formula(function, given, &typed);
        self.finite(typed, why, call.span)
    }
}
