//! The place of a link that stands freely: a point of it counts as two coordinates, x and y in the axes of the ground.

use crate::expr::context::Context;
use assur_model::model::{Axis, Drive, DriveTarget, Expr, Positions, Value};
use assur_syntax::document::{Path, Statement};

/// Whether another drive or start gives the angle of the link of this point: the two are the place of the link.
pub(crate) fn is_place(cx: &Context<'_>, point: &Path) -> bool {
    point.tail.is_some()
        && cx.doc.statements.iter().any(|statement| {
            let target = match &statement.node {
                Statement::Drive(drive) => &drive.target,
                Statement::Start(start) => &start.target,
                _ => return false,
            };
            target.tail.is_none() && target.head.node == point.head.node
        })
}

/// The drives of the two coordinates.
pub(crate) fn coordinates(drive: &Drive) -> Vec<Drive> {
    let DriveTarget::Point(link, at) = drive.target else { return vec![drive.clone()] };
    let of = |axis: Axis| Drive {
        name: format!("{}.{}", drive.name, axis.name()),
        target: DriveTarget::Place(link, at, axis),
        positions: positions(&drive.positions, axis),
        written: None,
        speed: drive.speed.as_ref().map(|speed| component(speed, axis)),
        acceleration: drive.acceleration.as_ref().map(|a| component(a, axis)),
        ..drive.clone()
    };
    Axis::BOTH.map(of).to_vec()
}

fn positions(positions: &Positions, axis: Axis) -> Positions {
    match positions {
        Positions::List(all) => Positions::List(all.iter().map(|at| component(at, axis)).collect()),
        Positions::Range { from, to, steps } => {
            Positions::Range { from: component(from, axis), to: component(to, axis), steps: *steps }
        }
        Positions::None | Positions::Numbers(_) => positions.clone(),
    }
}

pub(crate) fn component(vector: &Expr, axis: Axis) -> Expr {
    match vector {
        Expr::Constant(Value::Vector(v)) => Expr::number(v.dot(axis.unit())),
        other => Expr::Component(Box::new(other.clone()), axis),
    }
}

/// Whether a drive gives this already, or a coordinate of it.
pub(crate) fn is_given(drive: &Drive, target: DriveTarget) -> bool {
    match (drive.target, target) {
        (DriveTarget::Place(link, at, _), DriveTarget::Point(other, point)) => (link, at) == (other, point),
        (given, target) => given == target,
    }
}
