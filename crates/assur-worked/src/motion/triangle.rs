//! Angles from coordinates and sides.

use crate::course::Course;
use assur_formula::{Expr, Function, Name, Unit};

/// Where one part of a vector is less than this of the other, its angle comes from the arc cosine.
const STEEP: f64 = 0.02;

/// An angle in degrees, above −180° and up to 180°.
pub fn wrapped(degrees: f64) -> f64 {
    let turns = (degrees / 360.0).round();
    let angle = degrees - 360.0 * turns;
    if angle <= -180.0 { angle + 360.0 } else { angle }
}

impl Course<'_> {
    /// The distance of two points.
    pub fn distance(&mut self, name: Name, parts: &[Expr; 2]) -> Expr {
        self.length_of(name, Unit::Length, parts)
    }

    /// √(x² + y²), or the one component that is not zero.
    pub fn length_of(&mut self, name: Name, unit: Unit, [x, y]: &[Expr; 2]) -> Expr {
        let value = libm::hypot(x.value(), y.value());
        let right = if x.is_zero() {
            y.clone().abs()
        } else if y.is_zero() {
            x.clone().abs()
        } else {
            (x.clone().squared() + y.clone().squared()).root()
        };
        self.equate(name, value, unit, right)
    }

    /// The direction of a vector; `length` is found where that is needed.
    pub fn direction_of(&mut self, name: Name, [x, y]: &[Expr; 2], length: &str) -> Expr {
        let (vx, vy) = (x.value(), y.value());
        let value = libm::atan2(vy, vx).to_degrees();
        let right = if x.is_zero() {
            Expr::Degrees(if vy < 0.0 { -90 } else { 90 })
        } else if y.is_zero() {
            Expr::Degrees(if vx < 0.0 { 180 } else { 0 })
        } else if vx.abs() < STEEP * vy.abs() {
            let length = self.distance(Name::new("l", length), &[x.clone(), y.clone()]);
            let angle = (x.clone() / length).of(Function::Arccos);
            if vy < 0.0 { -angle } else { angle }
        } else {
            let half = if vx > 0.0 {
                0
            } else if vy < 0.0 {
                -180
            } else {
                180
            };
            (y.clone() / x.clone()).of(Function::Arctan) + Expr::Degrees(half)
        };
        self.equate(name, value, Unit::Angle, right)
    }

    /// An angle that comes out as a sum: whole turns are taken off.
    pub fn angle_sum(&mut self, name: Name, right: Expr) -> Expr {
        let value = wrapped(right.value());
        let turns = ((value - right.value()) / 360.0).round() as i64;
        self.equate(name, value, Unit::Angle, right + Expr::Degrees(360 * turns))
    }
}
