//! Directions: an angle that may be known as quarter turns.

use assur_formula::Expr;
use assur_math::math::Vec2;

/// A direction: an angle and a number of quarter turns more.
#[derive(Clone, Debug)]
pub struct Angle {
    /// The angle; none where it is 0.
    pub part: Option<Expr>,
    pub quarters: i64,
}

/// Angles nearer to a whole number of degrees than this are whole.
const WHOLE: f64 = 1e-9;

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
        if (degrees - whole).abs() > WHOLE {
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
