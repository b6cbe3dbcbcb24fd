//! The numbers of a mechanism, one after another: what a row of variants may change without changing the mechanism.

use super::{
    BalanceKind, Drive, DriveTarget, Expect, Expr, Friction, Guide, HintKind, Link, LoadKind, Mechanism,
    PairKind, Place, PointRef, Positions, Query, Relation, Tolerance, Value,
};
use crate::math::Vec2;
use std::sync::Arc;

impl Mechanism {
    /// Calls `visit` on the numbers that statements of a linkage, its drives, loads and questions give, always in the same
    /// order. What cams, wheels, transmissions and flywheels are is left out.
    pub fn each_number(&mut self, visit: &mut impl FnMut(&mut f64)) {
        self.links.iter_mut().for_each(|link| link.each_number(visit));
        for pair in &mut self.pairs {
            of_pair(&mut pair.kind, visit);
            match &mut pair.friction {
                Some(Friction::Circle(x) | Friction::Coefficient(x) | Friction::BothEnds(x)) => visit(x),
                Some(Friction::Rolling { coefficient, arm }) => {
                    [coefficient, arm].into_iter().for_each(&mut *visit)
                }
                None => {}
            }
        }
        self.drives.iter_mut().for_each(|drive| of_drive(drive, visit));
        let places = self.poses.iter_mut().flat_map(|pose| &mut pose.at);
        places.for_each(|(_, value)| value.each_number(visit));
        self.hints.iter_mut().for_each(|hint| of_hint(&mut hint.kind, visit));
        self.gravity.iter_mut().for_each(|gravity| of_vector(&mut gravity.acceleration, visit));
        for load in &mut self.loads {
            of_load(&mut load.kind, visit);
            load.when.iter_mut().for_each(|e| e.each_number(visit));
        }
        for spring in &mut self.springs {
            of_vector(&mut spring.from.1, visit);
            of_vector(&mut spring.to.1, visit);
            let numbers = [&mut spring.stiffness, &mut spring.free_length, &mut spring.damping];
            numbers.into_iter().for_each(&mut *visit);
        }
        self.balances.iter_mut().for_each(|balance| of_balance(&mut balance.kind, visit));
        self.quantities.iter_mut().for_each(|quantity| quantity.expr.each_number(visit));
        for find in &mut self.finds {
            if let super::FindKind::Value { expr, .. } = &mut find.kind {
                expr.each_number(visit);
            }
        }
        self.expects.iter_mut().for_each(|expect| of_expect(expect, visit));
        self.cycles.iter_mut().for_each(|cycle| cycle.expr.each_number(visit));
        self.values.iter_mut().for_each(|value| of_value(&mut value.value, visit));
    }
}

fn of_drive(drive: &mut Drive, visit: &mut impl FnMut(&mut f64)) {
    if let DriveTarget::Point(_, at) | DriveTarget::Place(_, at, _) = &mut drive.target {
        of_vector(at, visit);
    }
    match &mut drive.positions {
        Positions::None => {}
        Positions::List(list) => list.iter_mut().for_each(|e| e.each_number(visit)),
        Positions::Numbers(numbers) => Arc::make_mut(numbers).iter_mut().for_each(&mut *visit),
        Positions::Range { from, to, .. } => [from, to].into_iter().for_each(|e| e.each_number(visit)),
    }
    drive.speed.iter_mut().chain(&mut drive.acceleration).for_each(|e| e.each_number(visit));
}

fn of_expect(expect: &mut Expect, visit: &mut impl FnMut(&mut f64)) {
    expect.expr.each_number(visit);
    match &mut expect.relation {
        Relation::Equal(values) => values.iter_mut().for_each(|e| e.each_number(visit)),
        Relation::Compare(_, bound) => bound.each_number(visit),
        Relation::Condition => {}
    }
    match &mut expect.tolerance {
        Tolerance::Relative(x) | Tolerance::Absolute(x) => visit(x),
        Tolerance::Written(all) => all.iter_mut().for_each(&mut *visit),
        Tolerance::None => {}
    }
    if let Some(super::At::Drives(list)) = &mut expect.at {
        list.iter_mut().for_each(|(_, e)| e.each_number(visit));
    }
}

impl Link {
    fn each_number(&mut self, visit: &mut impl FnMut(&mut f64)) {
        self.points.iter_mut().for_each(|point| of_vector(&mut point.at, visit));
        for line in &mut self.lines {
            of_vector(&mut line.through, visit);
            of_vector(&mut line.along, visit);
        }
        for circle in &mut self.circles {
            of_vector(&mut circle.centre, visit);
            visit(&mut circle.radius);
        }
        for mass in self.mass.iter_mut().chain(self.mass_parts.iter_mut().map(|part| &mut part.own)) {
            visit(&mut mass.mass);
            of_vector(&mut mass.centre, visit);
            visit(&mut mass.inertia);
        }
    }
}

impl Expr {
    /// Calls `visit` on its constants and on the coordinates of the points that it asks of.
    fn each_number(&mut self, visit: &mut impl FnMut(&mut f64)) {
        match self {
            Self::Constant(value) => of_value(value, visit),
            Self::Quantity(_) => {}
            Self::Query(query) => of_query(query, visit),
            Self::Component(a, _)
            | Self::Negate(a)
            | Self::Not(a)
            | Self::Frictionless(a)
            | Self::Curve(_, _, a) => a.each_number(visit),
            Self::Vector(a, b)
            | Self::Polar(a, b)
            | Self::Binary(_, a, b)
            | Self::Power(a, b)
            | Self::Compare(_, a, b)
            | Self::And(a, b)
            | Self::Or(a, b) => {
                a.each_number(visit);
                b.each_number(visit);
            }
            Self::Call(_, args) => args.iter_mut().for_each(|a| a.each_number(visit)),
        }
    }
}

fn of_vector(v: &mut Vec2, visit: &mut impl FnMut(&mut f64)) {
    visit(&mut v.x);
    visit(&mut v.y);
}

fn of_value(value: &mut Value, visit: &mut impl FnMut(&mut f64)) {
    match value {
        Value::Scalar(x) => visit(x),
        Value::Vector(v) => of_vector(v, visit),
        Value::Bool(_) => {}
    }
}

fn of_query(query: &mut Query, visit: &mut impl FnMut(&mut f64)) {
    if let Some(PointRef::Fixed(_, at) | PointRef::Under(_, (_, at))) = query.point_mut() {
        return of_vector(at, visit);
    }
    match query {
        Query::StaticSubstitution(_, first, second, _) => {
            of_vector(first, visit);
            of_vector(second, visit);
        }
        Query::DynamicSubstitution(_, at, _) => of_vector(at, visit),
        _ => {}
    }
}

fn of_pair(kind: &mut PairKind, visit: &mut impl FnMut(&mut f64)) {
    match kind {
        PairKind::Revolute(pins) => pins.iter_mut().for_each(|pin| of_vector(&mut pin.at, visit)),
        PairKind::Prismatic(guide) | PairKind::Slot(guide) => {
            let Guide { point, direction, through, along, contacts, .. } = guide;
            [point, direction, through, along].into_iter().for_each(|v| of_vector(v, visit));
            contacts.iter_mut().flatten().for_each(visit);
        }
        PairKind::Cylinder { from, to, .. } => {
            [from, to].into_iter().for_each(|pin| of_vector(&mut pin.at, visit));
        }
        PairKind::Contact { .. } | PairKind::Transmission(_) | PairKind::Weld { .. } => {}
    }
}

fn of_hint(kind: &mut HintKind, visit: &mut impl FnMut(&mut f64)) {
    match kind {
        HintKind::Side { point, from, to, .. } => {
            [point, from, to].into_iter().for_each(|p| of_vector(&mut p.1, visit));
        }
        HintKind::Along { point, other, .. } => {
            [point, other].into_iter().for_each(|p| of_vector(&mut p.1, visit));
        }
        HintKind::Coordinate { bound, .. } => visit(bound),
        HintKind::Near { point, place } => {
            of_vector(&mut point.1, visit);
            of_vector(place, visit);
        }
    }
}

fn of_place(place: &mut Place, visit: &mut impl FnMut(&mut f64)) {
    match place {
        Place::Local(at) => of_vector(at, visit),
        Place::Ground(expr) => expr.each_number(visit),
    }
}

fn of_load(kind: &mut LoadKind, visit: &mut impl FnMut(&mut f64)) {
    match kind {
        LoadKind::Force { at, value, .. } | LoadKind::ForceAgainstMotion { at, value, .. } => {
            of_place(at, visit);
            value.each_number(visit);
        }
        LoadKind::Torque { value, .. } | LoadKind::InPair { value, .. } => value.each_number(visit),
    }
}

fn of_balance(kind: &mut BalanceKind, visit: &mut impl FnMut(&mut f64)) {
    match kind {
        BalanceKind::Torque(_) | BalanceKind::InPair(_) => {}
        BalanceKind::Force { at, along, .. } => {
            of_place(at, visit);
            of_vector(along, visit);
        }
        BalanceKind::Several(places) => places.iter_mut().for_each(|place| of_balance(place, visit)),
    }
}
