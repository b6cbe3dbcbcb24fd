//! The place of a link: a point of it counts as two coordinates, x and y in the axes of the ground.

use crate::expr::context::Context;
use assur_math::math::Vec2;
use assur_model::model::{Axis, Drive, DriveTarget, Expr, LinkId, PairKind, Positions, Value};
use assur_syntax::document::{Path, Statement};

/// Whether a driven point counts as two coordinates: another drive or start gives the angle of its link, or a pair joins the link
/// elsewhere. Else its link is an outer one, whose rotation is not known.
pub(crate) fn is_place(cx: &Context<'_>, point: &Path) -> bool {
    let Some(tail) = &point.tail else { return false };
    let gives_angle = cx.doc.statements.iter().any(|statement| {
        let target = match &statement.node {
            Statement::Drive(drive) => &drive.target,
            Statement::Start(start) => &start.target,
            _ => return false,
        };
        target.tail.is_none() && target.head.node == point.head.node
    });
    let link = cx.find_link(&point.head.node);
    let at = link.and_then(|link| cx.builder.mech.link(link).points.iter().find(|p| p.name == tail.node));
    gives_angle || link.zip(at).is_some_and(|(link, point)| is_joined_elsewhere(cx, link, point.at))
}

fn is_joined_elsewhere(cx: &Context<'_>, link: LinkId, at: Vec2) -> bool {
    cx.builder.mech.pairs.iter().any(|pair| match &pair.kind {
        PairKind::Revolute(pins) => pins.iter().any(|pin| pin.link == link && pin.at != at),
        PairKind::Cylinder { from, to, .. } => [from, to].iter().any(|pin| pin.link == link && pin.at != at),
        kind => kind.links().contains(&link),
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
