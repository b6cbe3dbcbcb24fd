//! The tree of a formula.

use crate::quantity::Quantity;
use std::sync::Arc;

/// A formula. Angles are in degrees.
#[derive(Clone, Debug, PartialEq)]
pub enum Expr {
    Int(i64),
    /// A whole number of degrees.
    Degrees(i64),
    /// A number as the author writes it.
    Number(f64),
    /// π
    Pi,
    Leaf(Arc<Quantity>),
    Neg(Box<Self>),
    /// Two or more terms; none is a negative but by its value.
    Sum(Vec<(Sign, Self)>),
    /// Two or more factors.
    Product(Vec<Self>),
    Ratio(Box<Self>, Box<Self>),
    /// A power from the second on.
    Power(Box<Self>, u8),
    Root(Box<Self>),
    Abs(Box<Self>),
    /// A function of an angle, an angle, or a power of e.
    Of(Function, Box<Self>),
}

/// The sign before a term.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// +
    Plus,
    /// −
    Minus,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    Sin,
    Cos,
    Tan,
    Arcsin,
    Arccos,
    Arctan,
    /// The power of e.
    Exp,
}

impl Function {
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Sin => "sin",
            Self::Cos => "cos",
            Self::Tan => "tan",
            Self::Arcsin => "arcsin",
            Self::Arccos => "arccos",
            Self::Arctan => "arctan",
            Self::Exp => "exp",
        }
    }

    /// Whether it is a function of an angle.
    #[must_use]
    pub const fn is_of_angle(self) -> bool {
        matches!(self, Self::Sin | Self::Cos | Self::Tan)
    }
}

impl Expr {
    /// 0
    pub const ZERO: Self = Self::Int(0);

    /// Whether it is 0 for every value of its letters.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        matches!(self, Self::Int(0) | Self::Degrees(0))
    }

    /// Whether it has no letters.
    #[must_use]
    pub fn is_constant(&self) -> bool {
        let mut count = 0;
        self.visit(&mut |_| count += 1);
        count == 0
    }

    #[must_use]
    pub fn squared(self) -> Self {
        self.power(2)
    }

    #[must_use]
    pub fn cubed(self) -> Self {
        self.power(3)
    }

    fn power(self, exponent: u8) -> Self {
        match self {
            Self::Int(n) => Self::Int(n.pow(u32::from(exponent))),
            Self::Neg(x) if exponent.is_multiple_of(2) => x.power(exponent),
            Self::Neg(x) => -x.power(exponent),
            Self::Power(x, n) => Self::Power(x, n * exponent),
            other => Self::Power(Box::new(other), exponent),
        }
    }

    #[must_use]
    pub fn root(self) -> Self {
        match self {
            Self::Power(x, 2) => Self::Abs(x),
            other => Self::Root(Box::new(other)),
        }
    }

    #[must_use]
    pub fn abs(self) -> Self {
        match self {
            Self::Int(n) => Self::Int(n.abs()),
            Self::Neg(x) => x.abs(),
            other => Self::Abs(Box::new(other)),
        }
    }

    /// A function of it; of right angles its exact value.
    #[must_use]
    pub fn of(self, function: Function) -> Self {
        let quarter = match &self {
            Self::Int(0) => Some(0),
            Self::Degrees(d) if d.rem_euclid(90) == 0 => Some(d.rem_euclid(360) / 90),
            _ => None,
        };
        match (function, quarter) {
            (Function::Sin, Some(q)) => Self::Int([0, 1, 0, -1][usize::try_from(q).unwrap_or(0)]),
            (Function::Cos, Some(q)) => Self::Int([1, 0, -1, 0][usize::try_from(q).unwrap_or(0)]),
            (Function::Tan | Function::Arcsin | Function::Arctan, Some(0)) => Self::Int(0),
            _ => match (function, self) {
                (Function::Sin | Function::Tan, Self::Neg(x)) => -x.of(function),
                (Function::Cos, Self::Neg(x)) => x.of(function),
                (_, x) => Self::Of(function, Box::new(x)),
            },
        }
    }

    #[must_use]
    pub fn sin(self) -> Self {
        self.of(Function::Sin)
    }

    #[must_use]
    pub fn cos(self) -> Self {
        self.of(Function::Cos)
    }

    /// The sum of these.
    #[must_use]
    pub fn sum(terms: impl IntoIterator<Item = Self>) -> Self {
        terms.into_iter().fold(Self::ZERO, |sum, term| sum + term)
    }

    /// The same with other trees in the places of some quantities.
    #[must_use]
    pub fn replaced(&self, by: &dyn Fn(&Quantity) -> Option<Self>) -> Self {
        match self {
            Self::Leaf(q) => by(q).unwrap_or_else(|| self.clone()),
            Self::Neg(x) => -x.replaced(by),
            Self::Sum(terms) => Self::sum(terms.iter().map(|(sign, x)| match sign {
                Sign::Plus => x.replaced(by),
                Sign::Minus => -x.replaced(by),
            })),
            Self::Product(factors) => {
                factors.iter().fold(Self::Int(1), |product, x| product * x.replaced(by))
            }
            Self::Ratio(a, b) => a.replaced(by) / b.replaced(by),
            Self::Power(x, n) => x.replaced(by).power(*n),
            Self::Root(x) => x.replaced(by).root(),
            Self::Abs(x) => x.replaced(by).abs(),
            Self::Of(function, x) => x.replaced(by).of(*function),
            Self::Int(_) | Self::Degrees(_) | Self::Number(_) | Self::Pi => self.clone(),
        }
    }

    pub fn visit(&self, see: &mut dyn FnMut(&Arc<Quantity>)) {
        match self {
            Self::Int(_) | Self::Degrees(_) | Self::Number(_) | Self::Pi => {}
            Self::Leaf(q) => see(q),
            Self::Neg(x) | Self::Power(x, _) | Self::Root(x) | Self::Abs(x) | Self::Of(_, x) => x.visit(see),
            Self::Sum(terms) => terms.iter().for_each(|(_, x)| x.visit(see)),
            Self::Product(factors) => factors.iter().for_each(|x| x.visit(see)),
            Self::Ratio(a, b) => {
                a.visit(see);
                b.visit(see);
            }
        }
    }
}
