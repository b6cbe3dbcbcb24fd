//! Values and maps of JSON.

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use assur_math::math::Vec2;
use assur_model::model::Value;

/// A finite number; zero has no sign.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(super) struct Number(f64);

impl Number {
    /// `None` for what is not finite.
    pub fn of(x: f64) -> Option<Self> {
        x.is_finite().then_some(Self(x + 0.0))
    }
}

/// A vector of finite numbers.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(super) struct Pair([Number; 2]);

impl Pair {
    /// `None` for what is not finite.
    pub fn of(v: Vec2) -> Option<Self> {
        Some(Self([Number::of(v.x)?, Number::of(v.y)?]))
    }
}

/// A value of the language.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub(super) enum Reading {
    Number(Number),
    Pair(Pair),
    Bool(bool),
}

impl Reading {
    /// `None` for what is not finite.
    pub fn of(value: Value) -> Option<Self> {
        match value {
            Value::Scalar(x) => Number::of(x).map(Self::Number),
            Value::Vector(v) => Pair::of(v).map(Self::Pair),
            Value::Bool(truth) => Some(Self::Bool(truth)),
        }
    }
}

/// A map in the order of its entries.
#[derive(Clone, Debug)]
pub(super) struct Entries<T>(pub Vec<(String, T)>);

impl<T> Entries<T> {
    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl<T: Serialize> Serialize for Entries<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (key, value) in &self.0 {
            map.serialize_entry(key, value)?;
        }
        map.end()
    }
}
