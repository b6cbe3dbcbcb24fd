//! The type and value of an expression that has been read.

use assur_model::model;
use assur_model::model::Value;
use assur_text::units::{Dimension, Kind};

/// The dimension of an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dim {
    /// The literal `0`, or what is not known because it cannot be solved yet: fits anything.
    Any,
    Of(Dimension),
}

impl Dim {
    /// The common type, if they fit.
    pub fn unify(self, other: Self) -> Option<Self> {
        match (self, other) {
            (Self::Any, d) | (d, Self::Any) => Some(d),
            (Self::Of(a), Self::Of(b)) => a.unify(b).map(Self::Of),
        }
    }

    /// The dimension of the product.
    pub fn times(self, other: Self) -> Self {
        match (self, other) {
            (Self::Of(a), Self::Of(b)) => Self::Of(a.times(b)),
            _ => Self::Any,
        }
    }

    /// The dimension of the quotient.
    pub fn over(self, other: Self) -> Self {
        match (self, other) {
            (Self::Of(a), Self::Of(b)) => Self::Of(a.over(b)),
            _ => Self::Any,
        }
    }

    /// The dimension; a plain number where anything fits.
    pub fn known(self) -> Dimension {
        match self {
            Self::Any => Dimension::NUMBER,
            Self::Of(d) => d,
        }
    }
}

/// The type of an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Type {
    Number(Dim),
    Vector(Dim),
    /// A condition: true or false.
    Bool,
}

impl Type {
    /// A number of this dimension.
    pub const fn number(d: Dimension) -> Self {
        Self::Number(Dim::Of(d))
    }

    /// A vector of this dimension.
    pub const fn vector(d: Dimension) -> Self {
        Self::Vector(Dim::Of(d))
    }

    /// `a number`, `a vector`, `a condition`
    pub const fn shape(self) -> &'static str {
        match self {
            Self::Number(_) => "a number",
            Self::Vector(_) => "a vector",
            Self::Bool => "a condition",
        }
    }

    /// The dimension of the number, or of the vector's components; a plain number for a condition.
    pub fn dimension(self) -> Dimension {
        match self {
            Self::Number(d) | Self::Vector(d) => d.known(),
            Self::Bool => Dimension::NUMBER,
        }
    }

    /// What it is in words, with the SI unit: `a velocity (m/s)`.
    pub fn phrase(self) -> String {
        match self {
            Self::Number(d) => phrase(d.known()),
            Self::Vector(d) if d.known() == Dimension::NUMBER => "a vector of plain numbers".into(),
            Self::Vector(d) => format!("a vector in {}", d.known().si_text()),
            Self::Bool => "a condition".into(),
        }
    }
}

/// A dimension in words, with its SI unit.
pub fn phrase(d: Dimension) -> String {
    let unit = d.si_text();
    match d.name() {
        Some(name) if unit.is_empty() => name.to_owned(),
        Some("an angle") => "an angle".to_owned(),
        Some(name) => format!("{name} ({unit})"),
        None => d.to_string(),
    }
}

/// An expression that has been read.
#[derive(Clone, Debug, PartialEq)]
pub struct Typed {
    /// The expression in SI.
    pub expr: model::Expr,
    pub ty: Type,
    /// Something in it cannot be solved yet; the expression stands for nothing.
    pub pending: bool,
}

impl Typed {
    /// An expression of a type.
    pub const fn new(expr: model::Expr, ty: Type) -> Self {
        Self { expr, ty, pending: false }
    }

    /// A part that cannot be solved yet.
    pub const fn pending(ty: Type) -> Self {
        Self { expr: model::Expr::Constant(Value::Scalar(0.0)), ty, pending: true }
    }

    pub const fn constant(x: f64, d: Dimension) -> Self {
        Self::new(model::Expr::number(x), Type::number(d))
    }

    /// The value, where it is known already.
    pub fn value(&self) -> Option<Value> {
        match self.expr {
            model::Expr::Constant(value) if !self.pending => Some(value),
            _ => None,
        }
    }
}

/// The factor between two dimensions: `multiply by a length`.
pub fn correction(want: Dimension, found: Dimension) -> Option<String> {
    let exponents = |d: Dimension| (d.length, d.mass, d.time);
    if exponents(want) == exponents(found) {
        return match (want.kind, found.kind) {
            (Kind::Angle, Kind::Plain) => Some("multiply by 1 rad, or write the unit: `deg` or `rad`".into()),
            (Kind::Plain, Kind::Angle) => Some("divide by 1 rad".into()),
            _ => None,
        };
    }
    if exponents(Dimension::NUMBER.over(found)) == exponents(want) {
        return Some("invert it: `1/(…)`".into());
    }
    const FACTORS: [Dimension; 8] = [
        Dimension::LENGTH,
        Dimension::TIME,
        Dimension::MASS,
        Dimension::ACCELERATION,
        Dimension::VELOCITY,
        Dimension::FORCE,
        Dimension::AREA,
        Dimension::ANGULAR_VELOCITY,
    ];
    FACTORS.into_iter().find_map(|f| {
        let name = f.name()?;
        if exponents(found.times(f)) == exponents(want) {
            Some(format!("multiply by {name}"))
        } else if exponents(found.over(f)) == exponents(want) {
            Some(format!("divide by {name}"))
        } else {
            None
        }
    })
}
