//! `find powers`: the power of all that acts on the mechanism: loads, unknown efforts, springs, weights, inertia, friction.

use crate::expr::context::Context;
use assur_math::math::Vec2;
use assur_model::model::{
    BinaryOp, DriveId, DriveTarget, Expr, Find, FindKind, Function, LinkId, Load, LoadId, LoadKind, PairId,
    PointRef, Query, Spring, Value,
};
use assur_syntax::document::FindItem;
use assur_text::language::Collection;
use assur_text::units::Dimension;

/// The answers that the word asks for; `None` for anything else, and where the file has such a name.
pub(crate) fn asked(cx: &Context<'_>, item: &FindItem) -> Option<Vec<Find>> {
    if super::find::collection(cx, item)? != Collection::POWERS {
        return None;
    }
    let display = cx.values.display(Dimension::POWER);
    let all = efforts(cx).into_iter().chain(loads(cx)).chain(bodies(cx)).chain(pairs(cx));
    let find = |(name, expr): (String, Expr)| {
        let kind = FindKind::Value { expr, display: display.clone(), poseless: false };
        Find { name, span: item.span, kind }
    };
    Some(all.map(find).collect())
}

fn efforts(cx: &Context<'_>) -> Vec<(String, Expr)> {
    let mech = &cx.builder.mech;
    if mech.balances.is_empty() {
        let of = |(i, drive): (usize, &assur_model::model::Drive)| {
            (format!("power({})", drive.name), Expr::Query(Query::EffortPower(DriveId::at(i))))
        };
        // a started place has no effort, and may be left out where a contact repeats it
        let is_started =
            |drive: &assur_model::model::Drive| drive.free && matches!(drive.target, DriveTarget::Place(..));
        return mech.drives.iter().enumerate().filter(|(_, drive)| !is_started(drive)).map(of).collect();
    }
    let of = |(i, balance): (usize, &assur_model::model::Balance)| {
        let power = Query::BalancePower(assur_model::model::BalanceId::at(i));
        (format!("power({})", balance.name), Expr::Query(power))
    };
    mech.balances.iter().enumerate().map(of).collect()
}

fn loads(cx: &Context<'_>) -> Vec<(String, Expr)> {
    let mech = &cx.builder.mech;
    let mut all: Vec<(String, Expr)> = Vec::new();
    for (i, load) in mech.loads.iter().enumerate() {
        let name = match &load.name {
            Some(name) => format!("power({name})"),
            None => unnamed(cx, load),
        };
        let count =
            all.iter().filter(|(other, _)| *other == name || other.starts_with(&format!("{name} #"))).count();
        let name = if count > 0 { format!("{name} #{}", count + 1) } else { name };
        all.push((name, Expr::Query(Query::LoadPower(LoadId::at(i)))));
    }
    all.extend(mech.springs.iter().map(|spring| (format!("spring {}", spring.name), of_spring(spring))));
    all
}

/// `force on ram`
fn unnamed(cx: &Context<'_>, load: &Load) -> String {
    let mech = &cx.builder.mech;
    if let Some(pin) = load.pin {
        return format!("force at {}", mech.pair(pin).name);
    }
    match &load.kind {
        LoadKind::Torque { on, .. } => format!("torque on {}", mech.link(*on).name),
        LoadKind::Force { on, .. } | LoadKind::ForceAgainstMotion { on, .. } => {
            format!("force on {}", mech.link(*on).name)
        }
        LoadKind::InPair { pair, .. } => format!("effort in {}", mech.pair(*pair).name),
    }
}

fn binary(op: BinaryOp, a: Expr, b: Expr) -> Expr {
    Expr::Binary(op, Box::new(a), Box::new(b))
}

fn point(of: fn(PointRef) -> Query, (link, at): (LinkId, Vec2)) -> Expr {
    Expr::Query(of(PointRef::Fixed(link, at)))
}

/// −T dl/dt with the pull T = k (l − l₀) + c dl/dt.
fn of_spring(spring: &Spring) -> Expr {
    let between = |of| binary(BinaryOp::Sub, point(of, spring.to), point(of, spring.from));
    let apart = between(Query::Position);
    let along = Expr::Call(Function::Unit, vec![apart.clone()]);
    let rate = Expr::Call(Function::Dot, vec![along, between(Query::Velocity)]);
    let length = Expr::Call(Function::Mag, vec![apart]);
    let elastic = binary(BinaryOp::Sub, length, Expr::number(spring.free_length));
    let elastic = binary(BinaryOp::Mul, Expr::number(spring.stiffness), elastic);
    let viscous = binary(BinaryOp::Mul, Expr::number(spring.damping), rate.clone());
    let pull = if spring.damping > 0.0 { binary(BinaryOp::Add, elastic, viscous) } else { elastic };
    Expr::Negate(Box::new(binary(BinaryOp::Mul, pull, rate)))
}

/// Weights, and inertia where the file computes it.
fn bodies(cx: &Context<'_>) -> Vec<(String, Expr)> {
    let mech = &cx.builder.mech;
    let moves = !mech.ignore_inertia && mech.drives.iter().any(|drive| drive.speed.is_some());
    let heavy =
        mech.links.iter().enumerate().skip(1).filter_map(|(i, link)| Some((LinkId::at(i), link, link.mass?)));
    let heavy: Vec<_> = heavy.collect();
    let mut all = Vec::new();
    if let Some(gravity) = &mech.gravity {
        for (id, link, mass) in heavy.iter().filter(|(_, _, mass)| mass.mass > 0.0) {
            let weight = Expr::Constant(Value::Vector(gravity.acceleration * mass.mass));
            let speed = point(Query::Velocity, (*id, mass.centre));
            all.push((format!("weight of {}", link.name), Expr::Call(Function::Dot, vec![weight, speed])));
        }
    }
    for (id, link, mass) in heavy.into_iter().filter(|_| moves) {
        let speed = point(Query::Velocity, (id, mass.centre));
        let force = Expr::Call(Function::Dot, vec![Expr::Query(Query::InertiaForce(id)), speed]);
        let couple =
            binary(BinaryOp::Mul, Expr::Query(Query::InertiaTorque(id)), Expr::Query(Query::Omega(id)));
        all.push((format!("inertia of {}", link.name), binary(BinaryOp::Add, force, couple)));
    }
    all
}

/// What friction takes in every pair that has any.
fn pairs(cx: &Context<'_>) -> Vec<(String, Expr)> {
    let rubs = |(_, pair): &(usize, &assur_model::model::Pair)| pair.friction.is_some_and(|f| f.is_some());
    let pairs = cx.builder.mech.pairs.iter().enumerate().filter(rubs);
    let lost = |i: usize| Expr::Negate(Box::new(Expr::Query(Query::FrictionPower(PairId::at(i)))));
    pairs.map(|(i, pair)| (format!("friction in {}", pair.name), lost(i))).collect()
}
