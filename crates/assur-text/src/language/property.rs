//! Rows of the tables of properties.

use super::Dimension;
use std::fmt;

/// A property that a statement may have in its braces.
#[derive(Clone, Copy, Debug)]
pub struct Property {
    pub name: &'static str,
    /// The values after it.
    pub takes: PropertyValue,
    pub example: &'static str,
    /// Its meaning, in one sentence without its full stop.
    pub means: &'static str,
}

/// The values of a property.
#[derive(Clone, Copy, Debug)]
pub enum PropertyValue {
    Flag,
    /// A value of this dimension.
    Any(Dimension),
    /// A value greater than zero.
    Positive(Dimension),
    /// A value not less than zero.
    NotNegative(Dimension),
    Two(Dimension),
    /// One of these words, or a value greater than zero.
    Word(&'static [&'static str], Dimension),
    /// Properties of its own.
    Block(&'static [Property]),
}

impl fmt::Display for PropertyValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Flag => f.write_str("no value"),
            Self::Any(dimension) => write!(f, "{dimension}"),
            Self::Positive(dimension) => write!(f, "{dimension} > 0"),
            Self::NotNegative(dimension) => write!(f, "{dimension} ≥ 0"),
            Self::Two(dimension) => write!(f, "two values, each {dimension}"),
            Self::Word(words, dimension) => {
                let words = words.iter().map(|w| format!("`{w}`")).collect::<Vec<_>>().join(", ");
                write!(f, "{words} or {dimension} > 0")
            }
            Self::Block(_) => f.write_str("properties of its own"),
        }
    }
}
