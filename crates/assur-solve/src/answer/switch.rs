//! The parts of loads that are not smooth, with the sides on which they are taken.

use crate::math::Piece;
use crate::model::{Expr, Function, Level, Mechanism, Positions};

/// A part of an expression that is not smooth, and how it is taken.
#[derive(Clone, Copy, Debug)]
pub struct Switch<'m> {
    pub(super) expr: &'m Expr,
    pub(super) side: Side,
    /// It depends on speeds: at rest, and where something turns, these say nothing.
    pub(crate) of_speeds: bool,
}

/// A side of a corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Side {
    Free,
    /// A comparison that is so.
    Truth(bool),
    /// A piece of a curve.
    Piece(Piece),
    /// One of the numbers of `max` or `min`.
    Argument(usize),
    /// The sign of a number.
    Sign(f64),
}

/// The side on which a part of an expression is taken, if it is one that is not smooth.
pub(crate) fn side_of(switches: &[Switch<'_>], expr: &Expr) -> Option<Side> {
    let found = switches.iter().find(|switch| std::ptr::eq(switch.expr, expr));
    found.map(|switch| switch.side)
}

/// The parts of expressions of loads, and of drives by the instant, that are not smooth.
pub(crate) fn switches<'m>(mechanism: &'m Mechanism, loads: Vec<&'m Expr>) -> Vec<Switch<'m>> {
    let (mut found, mut quantities) = (Vec::new(), vec![false; mechanism.quantities.len()]);
    let mut waiting = loads;
    for drive in mechanism.drives.iter().filter(|drive| drive.of_time) {
        if let Positions::List(list) = &drive.positions {
            waiting.extend(list);
        }
    }
    while let Some(expr) = waiting.pop() {
        match expr {
            Expr::Compare(..)
            | Expr::Curve(..)
            | Expr::Call(Function::Abs | Function::Max | Function::Min, _) => {
                found.push(Switch { expr, side: Side::Free, of_speeds: is_of_speeds(mechanism, expr) });
            }
            Expr::Quantity(id) if !std::mem::replace(&mut quantities[id.index()], true) => {
                waiting.push(&mechanism.quantities[id.index()].expr);
            }
            _ => {}
        }
        expr.children(&mut |part| waiting.push(part));
    }
    found
}

/// Whether a value depends on speeds.
fn is_of_speeds(mechanism: &Mechanism, expr: &Expr) -> bool {
    let mut found = false;
    expr.parts(&mut |part| match part {
        Expr::Query(query) => found |= query.facts().level > Level::Positions,
        Expr::Quantity(id) => found |= is_of_speeds(mechanism, &mechanism.quantities[id.index()].expr),
        _ => {}
    });
    found
}

impl<'m> Switch<'m> {
    /// The part of a load.
    pub(crate) const fn expr(&self) -> &'m Expr {
        self.expr
    }

    /// Whether it is taken on a side.
    pub(crate) fn is_held(&self) -> bool {
        self.side != Side::Free
    }

    /// As it is, on no side.
    pub(crate) const fn release(&mut self) {
        self.side = Side::Free;
    }
}
