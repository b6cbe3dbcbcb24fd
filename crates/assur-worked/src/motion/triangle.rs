//! Angles from coordinates and sides.

use crate::course::{Derivation, joined};
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Function, Name, Unit};

/// A triangle of three known sides: two outer corners that are known, and the inner one.
pub struct Triangle<'a> {
    /// The names of the corners, the inner one last.
    pub corners: [&'a str; 3],
    /// Where the outer corners are.
    pub outer: [&'a [Expr; 2]; 2],
    /// From the outer corners to the inner one.
    pub sides: [&'a Expr; 2],
    /// The inner corner is to the left of the line between the outer ones.
    pub left: bool,
}

/// Where one part of a vector is less than this of the other, its angle comes from the arc cosine.
const STEEP: f64 = 0.02;

/// An angle in degrees, above −180° and up to 180°.
pub fn wrapped(degrees: f64) -> f64 {
    let turns = (degrees / 360.0).round();
    let angle = degrees - 360.0 * turns;
    if angle <= -180.0 { angle + 360.0 } else { angle }
}

/// ABC, or the corners with commas where their names are longer.
fn named(corners: [&str; 3]) -> String {
    let short = corners.iter().all(|name| name.chars().filter(|c| c.is_alphabetic()).count() <= 1);
    corners.join(if short { "" } else { ", " })
}

impl Derivation<'_> {
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

    /// The direction of the first side of a triangle.
    pub fn side_of_triangle(&mut self, triangle: &Triangle<'_>) -> Expr {
        let [one, two, inner] = triangle.corners;
        self.say(Message::Triangle, &[vec![text(named([one, inner, two]))]]);
        let [a, b] = triangle.outer;
        let d = [b[0].clone() - a[0].clone(), b[1].clone() - a[1].clone()];
        let third = joined(one, two);
        let base = self.distance(Name::new("l", &third), &d);
        let delta = self.direction_of(Name::new("δ", &third), &d, &third);
        let [l_1, l_2] = triangle.sides.map(Clone::clone);
        let cosine =
            (l_1.clone().squared() + base.clone().squared() - l_2.squared()) / (Expr::Int(2) * l_1 * base);
        let right = cosine.of(Function::Arccos);
        let value = right.value();
        let beta = self.equate(Name::new("β", one), value, Unit::Angle, right);
        let message = if triangle.left { Message::LeftOf } else { Message::RightOf };
        self.say(message, &[inner, one, two].map(|w| vec![text(w)]));
        if triangle.left { delta + beta } else { delta - beta }
    }

    /// An angle that comes out as a sum: whole turns are taken off.
    pub fn angle_sum(&mut self, name: Name, right: Expr) -> Expr {
        let value = wrapped(right.value());
        let turns = ((value - right.value()) / 360.0).round() as i64;
        self.equate(name, value, Unit::Angle, right + Expr::Degrees(360 * turns))
    }
}
