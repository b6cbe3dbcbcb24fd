//! Arithmetic on trees: what is nothing for every value is left out, signs go before terms.

use crate::expr::{Expr, Sign};
use std::ops::{Add, Div, Mul, Neg, Sub};

impl Neg for Expr {
    type Output = Self;

    fn neg(self) -> Self {
        match self {
            Self::Int(n) => Self::Int(-n),
            Self::Degrees(n) => Self::Degrees(-n),
            Self::Neg(x) => *x,
            other => Self::Neg(Box::new(other)),
        }
    }
}

impl Add for Expr {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        match (self, other) {
            (a, b) if b.is_zero() => a,
            (a, b) if a.is_zero() => b,
            (Self::Int(a), Self::Int(b)) => Self::Int(a + b),
            (Self::Degrees(a), Self::Degrees(b)) => Self::Degrees(a + b),
            (a, b) => {
                let mut terms = terms(a);
                for (sign, x) in self::terms(b) {
                    // what is added and taken off again is not there
                    match terms.iter().position(|(s, y)| *s != sign && *y == x) {
                        Some(at) => {
                            terms.remove(at);
                        }
                        None => terms.push((sign, x)),
                    }
                }
                collected(terms)
            }
        }
    }
}

/// A sum of terms: nothing of none, and one alone is itself.
fn collected(mut terms: Vec<(Sign, Expr)>) -> Expr {
    match terms.len() {
        0 => Expr::ZERO,
        1 => match terms.remove(0) {
            (Sign::Plus, x) => x,
            (Sign::Minus, x) => -x,
        },
        _ => Expr::Sum(terms),
    }
}

/// The terms of a sum, with their signs.
fn terms(x: Expr) -> Vec<(Sign, Expr)> {
    match x {
        Expr::Sum(terms) => terms,
        Expr::Neg(x) => match *x {
            Expr::Sum(terms) => terms.into_iter().map(|(s, x)| (s.other(), x)).collect(),
            x => vec![(Sign::Minus, x)],
        },
        Expr::Int(n) if n < 0 => vec![(Sign::Minus, Expr::Int(-n))],
        Expr::Degrees(n) if n < 0 => vec![(Sign::Minus, Expr::Degrees(-n))],
        x => vec![(Sign::Plus, x)],
    }
}

impl Sign {
    const fn other(self) -> Self {
        match self {
            Self::Plus => Self::Minus,
            Self::Minus => Self::Plus,
        }
    }
}

impl Sub for Expr {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        if self == other { Self::ZERO } else { self + -other }
    }
}

impl Mul for Expr {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        match (self, other) {
            (a, b) if a.is_zero() || b.is_zero() => Self::ZERO,
            (Self::Int(1), x) | (x, Self::Int(1)) => x,
            (Self::Int(-1), x) | (x, Self::Int(-1)) => -x,
            (Self::Int(a), Self::Int(b)) => Self::Int(a * b),
            (Self::Neg(a), b) => -(*a * b),
            (a, Self::Neg(b)) => -(a * *b),
            (a, b) => {
                let mut factors = factors(a);
                factors.extend(self::factors(b));
                Self::Product(factors)
            }
        }
    }
}

fn factors(x: Expr) -> Vec<Expr> {
    match x {
        Expr::Product(factors) => factors,
        x => vec![x],
    }
}

impl Div for Expr {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        match (self, other) {
            (a, _) if a.is_zero() => Self::ZERO,
            (a, Self::Int(1)) => a,
            (a, Self::Int(-1)) => -a,
            (Self::Neg(a), Self::Neg(b)) => *a / *b,
            (a, Self::Sum(terms)) if terms.iter().all(|(sign, _)| *sign == Sign::Minus) => {
                let terms = terms.into_iter().map(|(_, x)| (Sign::Plus, x)).collect();
                -(a / Self::Sum(terms))
            }
            (Self::Neg(a), b) => -(*a / b),
            (a, Self::Neg(b)) => -(a / *b),
            (a, b) => Self::Ratio(Box::new(a), Box::new(b)),
        }
    }
}

impl Add<&Self> for Expr {
    type Output = Self;

    fn add(self, other: &Self) -> Self {
        self + other.clone()
    }
}

impl Mul<&Self> for Expr {
    type Output = Self;

    fn mul(self, other: &Self) -> Self {
        self * other.clone()
    }
}
