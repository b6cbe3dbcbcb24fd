//! Directions: an angle that may be known as quarter turns.

use crate::course::{Derivation, joined};
use assur_formula::{Expr, Name, Quantity, Unit};
use assur_math::math::{SAME, Vec2};
use std::sync::Arc;

/// A direction: an angle and a number of quarter turns more.
#[derive(Clone, Debug)]
pub struct Angle {
    /// The angle; none where it is 0.
    pub part: Option<Expr>,
    pub quarters: i64,
}

impl Angle {
    /// Along the x axis.
    pub const ZERO: Self = Self { part: None, quarters: 0 };

    pub fn of(part: Expr) -> Self {
        Self { part: Some(part).filter(|p| !p.is_zero()), quarters: 0 }
    }

    /// A direction that is a whole number of degrees; none where it is not.
    pub fn whole_degrees(direction: Vec2) -> Result<Self, f64> {
        let degrees = libm::atan2(direction.y, direction.x).to_degrees();
        let whole = degrees.round();
        if (degrees - whole).abs() > SAME {
            return Err(degrees);
        }
        let whole = whole as i64;
        if whole.rem_euclid(90) == 0 {
            return Ok(Self { part: None, quarters: whole.rem_euclid(360) / 90 });
        }
        Ok(Self::of(Expr::Degrees(whole)))
    }

    /// The sum of two.
    pub fn plus(&self, other: &Self) -> Self {
        let part = match (self.part.clone(), other.part.clone()) {
            (None, part) | (part, None) => part,
            (Some(a), Some(b)) => Some(a + b),
        };
        Self { part: part.filter(|p| !p.is_zero()), quarters: (self.quarters + other.quarters).rem_euclid(4) }
    }

    /// The difference of two.
    pub fn minus(&self, other: &Self) -> Self {
        let part = match (self.part.clone(), other.part.clone()) {
            (part, None) => part,
            (None, Some(b)) => Some(-b),
            (Some(a), Some(b)) => Some(a - b),
        };
        Self { part: part.filter(|p| !p.is_zero()), quarters: (self.quarters - other.quarters).rem_euclid(4) }
    }

    /// The angle as one formula.
    pub fn whole(&self) -> Expr {
        let quarters = Expr::Degrees(90 * if self.quarters == 3 { -1 } else { self.quarters });
        match &self.part {
            None => quarters,
            Some(part) => part.clone() + quarters,
        }
    }

    pub fn cos(&self) -> Expr {
        let Some(part) = &self.part else { return Expr::Int([1, 0, -1, 0][self.index()]) };
        match self.index() {
            0 => part.clone().cos(),
            1 => -part.clone().sin(),
            2 => -part.clone().cos(),
            _ => part.clone().sin(),
        }
    }

    pub fn sin(&self) -> Expr {
        let Some(part) = &self.part else { return Expr::Int([0, 1, 0, -1][self.index()]) };
        match self.index() {
            0 => part.clone().sin(),
            1 => part.clone().cos(),
            2 => -part.clone().sin(),
            _ => -part.clone().cos(),
        }
    }

    fn index(&self) -> usize {
        usize::try_from(self.quarters.rem_euclid(4)).unwrap_or(0)
    }

    /// The part of a vector along the direction.
    pub fn along(&self, [x, y]: &[Expr; 2]) -> Expr {
        x.clone() * self.cos() + y.clone() * self.sin()
    }

    /// The part of a vector across the direction, to its left.
    pub fn across(&self, [x, y]: &[Expr; 2]) -> Expr {
        y.clone() * self.cos() - x.clone() * self.sin()
    }
}

// Values of the file: lengths, directions, and the letters under which they are kept.

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
