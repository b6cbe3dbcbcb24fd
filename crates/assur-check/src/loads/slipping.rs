//! Clutches that slip: a load against the relative motion of two shafts, in place of a law.

use super::load::no_forces;
use crate::expr::{context::Context, positive::Want};
use crate::trains::friction_torque::varying;
use assur_model::model::{Expr, FrictionLimit, Function, Load, LoadKind, PairId, PairKind};
use assur_syntax::document::Statement;
use assur_text::units::Dimension;

/// Enters the loads of all clutches that slip into the mechanism, after those that are counted as they are written.
pub(crate) fn loads(cx: &mut Context<'_>) {
    for index in 0..cx.builder.mech.pairs.len() {
        let id = PairId::at(index);
        let pair = cx.builder.mech.pair(id);
        if pair.kind.slipping().is_none() {
            continue;
        }
        let (name, span) = (Some(pair.name.clone()), pair.span);
        let value = capacity(cx, id).unwrap_or(Expr::number(constant(cx, id).unwrap_or(f64::NAN)));
        let kind = LoadKind::InPair { pair: id, value, against_motion: true };
        cx.builder.mech.loads.push(Load { name, span, kind, pin: None, spread: None, when: None });
    }
}

/// The capacity of a clutch that slips, where it is not a constant; below zero it is nothing.
pub(crate) fn capacity(cx: &mut Context<'_>, pair: PairId) -> Option<Expr> {
    constant(cx, pair).filter(|capacity| capacity.is_nan())?;
    let (doc, declared) = (cx.doc, cx.builder.mech.pair(pair));
    let (name, span) = (declared.name.clone(), declared.span);
    let value = doc.statements.iter().find_map(|statement| match &statement.node {
        Statement::Joint(joint) if joint.name.span == span => varying(cx, joint)?.values.first(),
        _ => None,
    })?;
    let what = format!("the capacity of `{name}`");
    let capacity = cx.scalar(value, &Want(Dimension::TORQUE), &what)?;
    let fits = no_forces(cx, &capacity, &what, value.span);
    fits.then(|| Expr::Call(Function::Max, vec![capacity, Expr::number(0.0)]))
}

/// The constant capacity of a clutch that slips, N m; NaN where it varies.
fn constant(cx: &Context<'_>, pair: PairId) -> Option<f64> {
    let PairKind::Transmission(clutch) = &cx.builder.mech.pair(pair).kind else { return None };
    clutch.slipping().and(clutch.grip).map(FrictionLimit::capacity)
}
