//! Where a quantity over the sweep is not smooth: the places where a condition switches, where a magnitude or a
//! difference under `max` passes through zero, where a load or friction changes its sense. Each is a root of a known
//! function.

use super::depends::every_part;
use super::roots::roots;
use super::sampler::Sampler;
use crate::answer::{Undefined, WholeCycle};
use crate::model::{
    BinaryOp, Curve, Expr, Function, GenevaPair, LinkId, LoadKind, Mechanism, PairId, PairKind, Place,
    PointRef, QuantityId, Query, Value,
};
use crate::position::Model;
use std::sync::Arc;

/// Roots nearer than this to the sweep's ends, or to one another, are one with them.
pub(super) const APART: f64 = 1e-13;

/// Places of the sweep, between its ends, where the quantity is not smooth, in order.
pub(super) fn breaks(
    model: &Model<'_>,
    statics: &WholeCycle,
    sampler: &mut Sampler<'_>,
    expr: &Expr,
) -> Result<Vec<f64>, Undefined> {
    let mut switches = Switches::of(model);
    switches.expr(expr);
    model.mechanism.genevas.iter().for_each(|pair| switches.add(entry(pair)));
    let mut all = places(statics, sampler, &switches.found)?;
    all.retain(|s| *s > APART && *s < 1.0 - APART);
    Ok(all)
}

/// Places of the sweep where a denominator of the quantity is zero; none where it has no value on the whole of it.
pub(super) fn zeros(
    model: &Model<'_>,
    statics: &WholeCycle,
    sampler: &mut Sampler<'_>,
    expr: &Expr,
) -> Vec<f64> {
    let of = |expr| Switch { expr, curve: None };
    let all: Vec<Switch> = denominators(model.mechanism, expr).into_iter().map(of).collect();
    places(statics, sampler, &all).unwrap_or_default()
}

/// What a number is divided by, or the logarithm of: where one of these is zero it may have no bound.
pub(crate) fn denominators(mechanism: &Mechanism, expr: &Expr) -> Vec<Expr> {
    let mut all: Vec<Expr> = Vec::new();
    every_part(mechanism, expr, &mut |part| {
        let divides = match part {
            Expr::Binary(BinaryOp::Div, _, by) => (**by).clone(),
            Expr::Power(base, exponent) if matches!(**exponent, Expr::Constant(Value::Scalar(x)) if x < 0.0) => {
                (**base).clone()
            }
            Expr::Call(Function::Log, of) => of.first().cloned().unwrap_or_else(|| Expr::number(1.0)),
            Expr::Call(Function::Tan, of) => Expr::Call(Function::Cos, of.clone()),
            Expr::Query(Query::CurvatureRadius(point)) => {
                let motion = [Query::Velocity(*point), Query::Acceleration(*point)].map(number);
                Expr::Call(Function::Cross, motion.to_vec())
            }
            _ => return,
        };
        if !matches!(divides, Expr::Constant(_)) && !all.contains(&divides) {
            all.push(divides);
        }
    });
    all
}

/// Roots of functions over the sweep, in order.
fn places(statics: &WholeCycle, sampler: &mut Sampler<'_>, wanted: &[Switch]) -> Result<Vec<f64>, Undefined> {
    let is_known = |switch: &&Switch| sampler.switched.iter().any(|known| known.0 == **switch);
    let new: Vec<Switch> = wanted.iter().filter(|s| !is_known(s)).cloned().collect();
    if !new.is_empty() {
        let found = roots(statics, sampler, &new)?;
        sampler.switched.extend(new.into_iter().zip(found));
    }
    let known = sampler.switched.iter().filter(|known| wanted.contains(&known.0));
    let mut all: Vec<f64> = known.flat_map(|known| known.1.iter().copied()).collect();
    all.sort_by(f64::total_cmp);
    all.dedup_by(|a, b| *a - *b <= APART);
    Ok(all)
}

/// A number, or a vector, whose roots count; with a curve, where the number passes a point of its table.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Switch {
    pub expr: Expr,
    pub curve: Option<Arc<Curve>>,
}

/// The functions whose roots count: numbers, and vectors that pass through zero.
struct Switches<'a> {
    mechanism: &'a Mechanism,
    friction: bool,
    found: Vec<Switch>,
    quantities: Vec<QuantityId>,
    loads: Vec<usize>,
    forces: bool,
}

fn number(query: Query) -> Expr {
    Expr::Query(query)
}

fn difference(a: &Expr, b: &Expr) -> Expr {
    Expr::Binary(BinaryOp::Sub, Box::new(a.clone()), Box::new(b.clone()))
}

/// How far the pin of a Geneva wheel is from the wheel's centre, less what it is where it enters and leaves a slot.
fn entry(pair: &GenevaPair) -> Expr {
    let point = |link, at| number(Query::Position(PointRef::Fixed(link, at)));
    let apart = difference(&point(pair.crank, pair.pin), &point(pair.wheel, pair.hub));
    let (r, k) = ((pair.pin - pair.crank_centre).norm(), pair.law.ratio);
    let entering = r / k * (1.0 - 2.0 * k * libm::cos(pair.law.half()) + k * k).sqrt();
    difference(&Expr::Call(Function::Mag, vec![apart]), &Expr::number(entering))
}

impl<'a> Switches<'a> {
    fn of(model: &Model<'a>) -> Self {
        Self {
            mechanism: model.mechanism,
            friction: model.plan.effects.friction,
            found: Vec::new(),
            quantities: Vec::new(),
            loads: Vec::new(),
            forces: false,
        }
    }

    fn add(&mut self, expr: Expr) {
        self.add_switch(Switch { expr, curve: None });
    }

    fn add_switch(&mut self, switch: Switch) {
        let constant = matches!(switch.expr, Expr::Constant(_));
        if !constant && !self.found.contains(&switch) {
            self.found.push(switch);
        }
    }

    fn expr(&mut self, expr: &Expr) {
        let mechanism = self.mechanism;
        let mut parts = Vec::new();
        expr.parts(&mut |part| parts.push(part.clone()));
        for part in parts {
            match part {
                Expr::Call(Function::Abs | Function::Mag | Function::Unit | Function::Direction, args) => {
                    args.into_iter().for_each(|a| self.add(a));
                }
                Expr::Call(Function::Max | Function::Min, args) => {
                    for (i, a) in args.iter().enumerate() {
                        args[..i].iter().for_each(|b| self.add(difference(a, b)));
                    }
                }
                Expr::Curve(curve, _, x) => self.add_switch(Switch { expr: *x, curve: Some(curve) }),
                Expr::Compare(_, a, b) => self.add(difference(&a, &b)),
                Expr::Quantity(id) if !self.quantities.contains(&id) => {
                    self.quantities.push(id);
                    if let Some(quantity) = mechanism.quantities.get(id.index()) {
                        self.expr(&quantity.expr);
                    }
                }
                Expr::Query(query) => self.query(&query),
                _ => {}
            }
        }
    }

    fn query(&mut self, query: &Query) {
        match query {
            Query::Load(id) | Query::LoadPower(id) => self.load(id.index()),
            Query::InertiaArm(link) => self.add(number(Query::InertiaTorque(*link))),
            _ => {}
        }
        if query.facts().forces && !self.forces {
            self.forces = true;
            (0..self.mechanism.loads.len()).for_each(|i| self.load(i));
            if self.friction {
                (0..self.mechanism.pairs.len()).for_each(|i| self.pair(PairId::at(i)));
            }
        }
    }

    fn load(&mut self, index: usize) {
        if self.loads.contains(&index) {
            return;
        }
        self.loads.push(index);
        let Some(load) = self.mechanism.loads.get(index) else { return };
        load.when.iter().for_each(|when| self.expr(when));
        match &load.kind {
            LoadKind::Force { value, .. } => self.expr(value),
            LoadKind::InPair { pair, value, .. } => {
                self.expr(value);
                if let Some([first, second]) = self.mechanism.pair(*pair).kind.slipping() {
                    self.add(difference(&number(Query::Omega(second)), &number(Query::Omega(first))));
                }
            }
            LoadKind::Torque { on, value, against_motion, .. } => {
                self.expr(value);
                if *against_motion {
                    self.add(number(Query::Omega(*on)));
                }
            }
            LoadKind::ForceAgainstMotion { on, at, value } => {
                self.expr(value);
                if let Place::Local(at) = at {
                    self.add(number(Query::Velocity(PointRef::Fixed(*on, *at))));
                }
            }
        }
    }

    /// What rubs in a pair changes where the relative motion turns and where the normal force does.
    fn pair(&mut self, id: PairId) {
        let pair = self.mechanism.pair(id);
        if !pair.friction.is_some_and(|f| f.is_some()) {
            return;
        }
        match &pair.kind {
            PairKind::Revolute(pins) => {
                let omega = |link: LinkId| number(Query::Omega(link));
                let Some(first) = pins.first() else { return };
                for pin in &pins[1..] {
                    self.add(difference(&omega(pin.link), &omega(first.link)));
                }
            }
            PairKind::Prismatic(guide) => {
                self.add(number(Query::RelativeVelocity(id)));
                if guide.contacts.is_some() {
                    self.add(number(Query::ContactForce(id, 1)));
                    self.add(number(Query::ContactForce(id, 2)));
                } else {
                    self.add(number(Query::Normal(id, guide.slider)));
                }
            }
            PairKind::Slot(_) | PairKind::Cylinder { .. } => self.add(number(Query::RelativeVelocity(id))),
            PairKind::Contact { .. } | PairKind::Weld { .. } | PairKind::Transmission(_) => {}
        }
    }
}
