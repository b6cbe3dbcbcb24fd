//! The numbers of a mechanism, one after another: what a row of variants may change without changing the mechanism.

use super::{
    BalanceKind, Drive, DriveTarget, Expect, Expr, Friction, Guide, HintKind, Link, LoadKind, Mechanism,
    PairId, PairKind, Place, PointRef, Positions, Query, Relation, Tolerance, Value,
};
use crate::math::Vec2;
use std::sync::Arc;

/// The statements of a mechanism that have numbers, in the order in which these are visited.
const STATEMENTS: [Statement; 14] = [
    Statement::Link,
    Statement::Pair,
    Statement::Drive,
    Statement::Pose,
    Statement::Hint,
    Statement::Gravity,
    Statement::Load,
    Statement::Spring,
    Statement::Balance,
    Statement::Quantity,
    Statement::Find,
    Statement::Expect,
    Statement::Cycle,
    Statement::Value,
];

/// A kind of statement.
#[derive(Clone, Copy, Debug)]
enum Statement {
    Link,
    Pair,
    Drive,
    Pose,
    Hint,
    Gravity,
    Load,
    Spring,
    Balance,
    Quantity,
    Find,
    Expect,
    Cycle,
    Value,
}

/// Where some numbers of a mechanism are.
#[derive(Clone, Debug, Default)]
pub struct NumberPlaces {
    /// Statements, and where those of each end in `within`.
    statements: Vec<(Statement, usize, usize)>,
    /// The places of these among the numbers of their statements.
    within: Vec<usize>,
}

impl NumberPlaces {
    /// The pairs that have some of these numbers.
    pub fn pairs(&self) -> impl Iterator<Item = PairId> {
        let pairs = self.statements.iter().filter(|(statement, ..)| matches!(statement, Statement::Pair));
        pairs.map(|&(_, index, _)| PairId::at(index))
    }
}

impl Mechanism {
    /// Calls `visit` on the numbers that statements of a linkage, its drives, loads and questions give, always in the same
    /// order. What cams, wheels, transmissions and flywheels are is left out.
    pub fn each_number(&mut self, visit: &mut impl FnMut(&mut f64)) {
        for statement in STATEMENTS {
            (0..self.count(statement)).for_each(|index| self.numbers_of(statement, index, visit));
        }
    }

    /// Where numbers are, by their places in the order of [`Mechanism::each_number`], the first ones first.
    pub fn number_places(&mut self, numbers: impl IntoIterator<Item = usize>) -> NumberPlaces {
        let (mut found, mut first) = (NumberPlaces::default(), 0);
        let mut wanted = numbers.into_iter().peekable();
        for statement in STATEMENTS {
            for index in 0..self.count(statement) {
                let mut end = first;
                self.numbers_of(statement, index, &mut |_| end += 1);
                let before = found.within.len();
                found.within.extend(
                    std::iter::from_fn(|| wanted.next_if(|place| *place < end)).map(|place| place - first),
                );
                if found.within.len() > before {
                    found.statements.push((statement, index, found.within.len()));
                }
                first = end;
            }
        }
        found
    }

    /// Puts numbers in their places.
    pub fn put_numbers(&mut self, places: &NumberPlaces, numbers: &[f64]) {
        let mut first = 0;
        for &(statement, index, end) in &places.statements {
            let within = &places.within[first..end];
            let numbers = &numbers[first..end];
            let (mut done, mut place) = (0, 0);
            self.numbers_of(statement, index, &mut |x| {
                if within.get(done) == Some(&place) {
                    *x = numbers[done];
                    done += 1;
                }
                place += 1;
            });
            first = end;
        }
    }

    fn count(&self, statement: Statement) -> usize {
        match statement {
            Statement::Link => self.links.len(),
            Statement::Pair => self.pairs.len(),
            Statement::Drive => self.drives.len(),
            Statement::Pose => self.poses.len(),
            Statement::Hint => self.hints.len(),
            Statement::Gravity => usize::from(self.gravity.is_some()),
            Statement::Load => self.loads.len(),
            Statement::Spring => self.springs.len(),
            Statement::Balance => self.balances.len(),
            Statement::Quantity => self.quantities.len(),
            Statement::Find => self.finds.len(),
            Statement::Expect => self.expects.len(),
            Statement::Cycle => self.cycles.len(),
            Statement::Value => self.values.len(),
        }
    }

    fn numbers_of(&mut self, statement: Statement, index: usize, visit: &mut impl FnMut(&mut f64)) {
        match statement {
            Statement::Link => self.links[index].each_number(visit),
            Statement::Pair => {
                let pair = &mut self.pairs[index];
                of_pair(&mut pair.kind, visit);
                match &mut pair.friction {
                    Some(Friction::Circle(x) | Friction::Coefficient(x) | Friction::BothEnds(x)) => visit(x),
                    None => {}
                }
            }
            Statement::Drive => of_drive(&mut self.drives[index], visit),
            Statement::Pose => {
                self.poses[index].at.iter_mut().for_each(|(_, value)| value.each_number(visit))
            }
            Statement::Hint => of_hint(&mut self.hints[index].kind, visit),
            Statement::Gravity => {
                self.gravity.iter_mut().for_each(|gravity| of_vector(&mut gravity.acceleration, visit));
            }
            Statement::Load => {
                let load = &mut self.loads[index];
                of_load(&mut load.kind, visit);
                load.when.iter_mut().for_each(|e| e.each_number(visit));
            }
            Statement::Spring => {
                let spring = &mut self.springs[index];
                [&mut spring.from.1, &mut spring.to.1].into_iter().for_each(|at| of_vector(at, visit));
                [&mut spring.stiffness, &mut spring.free_length, &mut spring.damping]
                    .into_iter()
                    .for_each(visit);
            }
            Statement::Balance => of_balance(&mut self.balances[index].kind, visit),
            Statement::Quantity => self.quantities[index].expr.each_number(visit),
            Statement::Find => {
                if let super::FindKind::Value { expr, .. } = &mut self.finds[index].kind {
                    expr.each_number(visit);
                }
            }
            Statement::Expect => of_expect(&mut self.expects[index], visit),
            Statement::Cycle => self.cycles[index].expr.each_number(visit),
            Statement::Value => of_value(&mut self.values[index].value, visit),
        }
    }
}

fn of_drive(drive: &mut Drive, visit: &mut impl FnMut(&mut f64)) {
    if let DriveTarget::Point(_, at) = &mut drive.target {
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
        if let Some(mass) = &mut self.mass {
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
    match query {
        Query::Position(p) | Query::Velocity(p) | Query::Acceleration(p) => match p {
            PointRef::Fixed(_, at) | PointRef::Under(_, (_, at)) => of_vector(at, visit),
        },
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
        PairKind::Contact { .. } | PairKind::Transmission(_) => {}
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
