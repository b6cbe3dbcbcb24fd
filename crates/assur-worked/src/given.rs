//! Values of the file: lengths, directions, and the letters under which they are kept.

use crate::angle::Angle;
use crate::course::{Derivation, joined};
use assur_formula::{Expr, Name, Quantity, Unit};
use assur_math::math::Vec2;
use std::sync::Arc;

impl Derivation<'_> {
    /// A direction of the file; `name` where it is no whole number of degrees.
    pub fn direction_given(&self, direction: Vec2, name: impl FnOnce() -> Name) -> Angle {
        Angle::whole_degrees(direction)
            .unwrap_or_else(|degrees| Angle::of(self.given(name(), degrees, Unit::Angle)))
    }

    /// A value of the file. Letters that another value has get a prime.
    pub fn given(&self, mut name: Name, value: f64, unit: Unit) -> Expr {
        if value.abs() == 0.0 {
            return Expr::ZERO;
        }
        let found = self.found.get(&name).filter(|own| (own.value() - value).abs() <= 1e-12 * value.abs());
        if let Some(found) = found {
            return found.clone();
        }
        let mut known = self.given.borrow_mut();
        while let Some(other) = known.get(&name) {
            if (*other - value).abs() <= 1e-12 * value.abs() {
                break;
            }
            name.letter.push('′');
        }
        known.insert(name.clone(), value);
        Expr::Leaf(Arc::new(Quantity { name, value, unit, scale: value.abs(), given: true, rounding: 0.0 }))
    }

    /// Whether letters are a value of the file.
    pub fn is_given(&self, name: &Name) -> bool {
        self.given.borrow().contains_key(name)
    }

    /// A length of the file between two named points of a body.
    pub fn length(&self, from: &str, to: &str, value: f64) -> Expr {
        if value <= self.tiny {
            return Expr::ZERO;
        }
        let name = |from, to| Name::new("l", &joined(from, to));
        let other = name(to, from);
        let is_known =
            self.given.borrow().get(&other).is_some_and(|known| (known - value).abs() <= 1e-12 * value);
        self.given(if is_known { other } else { name(from, to) }, value, Unit::Length)
    }
}
