//! Where a quantity over the sweep is not smooth: the places where a condition switches, where a magnitude or a
//! difference under `max` passes through zero, where a load or friction changes its sense. Each is a root of a known
//! function.

use super::sampler::Sampler;
use crate::answer::{Undefined, WholeCycle};
use crate::math::{TableFunction, Vec2, root_within};
use crate::model::{
    Axis, BinaryOp, Expr, Function, GenevaPair, LinkId, LoadKind, Mechanism, PairId, PairKind, Place,
    PointRef, QuantityId, Query, Value,
};
use crate::position::Model;

/// Roots nearer than this to the sweep's ends, or to one another, are one with them.
pub(super) const APART: f64 = 1e-13;
/// A vector below this part of its greatest magnitude passes through zero.
const NULL: f64 = 1e-9;
/// A function that changes its sign in more than this part of all intervals is rounding noise.
const NOISE: f64 = 0.25;

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
    let mut all = Vec::new();
    let known =
        |sampler: &Sampler<'_>, e: &Expr| sampler.switched.iter().find(|k| k.0 == *e).map(|k| k.1.clone());
    let new: Vec<Expr> = switches.found.iter().filter(|e| known(sampler, e).is_none()).cloned().collect();
    if !new.is_empty() {
        let found = roots(statics, sampler, &new)?;
        sampler.switched.extend(new.into_iter().zip(found));
    }
    for expr in &switches.found {
        all.extend(known(sampler, expr).unwrap_or_default());
    }
    all.sort_by(f64::total_cmp);
    all.retain(|s| *s > APART && *s < 1.0 - APART);
    all.dedup_by(|a, b| *a - *b <= APART);
    Ok(all)
}

/// The functions whose roots count: numbers, and vectors that pass through zero.
struct Switches<'a> {
    mechanism: &'a Mechanism,
    friction: bool,
    found: Vec<Expr>,
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

/// Numbers that change their sign where the argument of a curve passes a point of its table.
fn knots<'e>(table: &'e TableFunction, x: &'e Expr) -> impl Iterator<Item = Expr> + 'e {
    table.arguments().iter().map(move |knot| {
        let apart = difference(x, &Expr::number(*knot));
        match table.period() {
            None => apart,
            Some(period) => {
                let half_turns = Expr::number(std::f64::consts::PI / period);
                Expr::Call(
                    Function::Sin,
                    vec![Expr::Binary(BinaryOp::Mul, Box::new(apart), Box::new(half_turns))],
                )
            }
        }
    })
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
        let constant = matches!(expr, Expr::Constant(_));
        if !constant && !self.found.contains(&expr) {
            self.found.push(expr);
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
                Expr::Curve(curve, _, x) => knots(&curve.function, &x).for_each(|e| self.add(e)),
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
            LoadKind::Force { value, .. } | LoadKind::InPair { value, .. } => self.expr(value),
            LoadKind::Torque { on, value, against_motion } => {
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
            PairKind::Contact { .. } | PairKind::Transmission(_) => {}
        }
    }
}

/// The roots of each function over the sweep. A vector counts where it is null.
fn roots(statics: &WholeCycle, sampler: &mut Sampler<'_>, all: &[Expr]) -> Result<Vec<Vec<f64>>, Undefined> {
    let intervals = sampler.intervals();
    let tolerance = sampler.settings().root;
    let mut table: Vec<Vec<Vec2>> = vec![Vec::new(); all.len()];
    let mut places = Vec::new();
    let mut index = 0.0;
    while index <= intervals {
        let s = index / intervals;
        places.push(s);
        for (values, expr) in table.iter_mut().zip(all) {
            values.push(as_vector(sampler.value(statics, s, expr)?));
        }
        index += 1.0;
    }
    let mut found = vec![Vec::new(); all.len()];
    for ((expr, values), found) in all.iter().zip(&table).zip(&mut found) {
        let greatest = values.iter().map(|v| v.norm()).filter(|x| x.is_finite()).fold(0.0, f64::max);
        for axis in [Axis::X, Axis::Y] {
            let of = |v: Vec2| if axis == Axis::X { v.x } else { v.y };
            let changes = |i: &usize| of(values[i - 1]) * of(values[*i]) < 0.0 || of(values[*i]) == 0.0;
            let crossed: Vec<usize> = (1..values.len()).filter(changes).collect();
            #[allow(clippy::cast_precision_loss)] // at most 20,000
            if crossed.len() as f64 > NOISE * intervals {
                continue;
            }
            for i in crossed {
                let (f_a, f_b) = (of(values[i - 1]), of(values[i]));
                let mut failed = None;
                let mut at = |s: f64| match sampler.value(statics, s, expr) {
                    Ok(value) => as_vector(value),
                    Err(why) => {
                        failed = Some(why);
                        Vec2::zero()
                    }
                };
                let s = if f_b == 0.0 {
                    places[i]
                } else {
                    root_within(tolerance, (places[i - 1], places[i]), (f_a, f_b), |s| of(at(s)))
                };
                let here = at(s);
                if let Some(why) = failed {
                    return Err(why);
                }
                let other = if axis == Axis::X { here.y } else { here.x };
                if other.abs() <= NULL * greatest {
                    found.push(s);
                }
            }
        }
    }
    Ok(found)
}

/// A number as a vector whose second component is null, and never changes its sign.
const fn as_vector(value: Value) -> Vec2 {
    match value {
        Value::Scalar(x) => Vec2::new(x, 0.0),
        Value::Vector(v) => v,
        Value::Bool(_) => Vec2::new(f64::NAN, f64::NAN),
    }
}
