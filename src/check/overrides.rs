//! Values from outside the file.

/// Values that replace those of `given` statements, in the order given; a later one wins.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Overrides {
    /// Name and value as text, as in `--set r=120mm`.
    pub values: Vec<(String, String)>,
}

impl Overrides {
    /// No value is replaced.
    #[must_use]
    pub fn none() -> Self {
        Self::default()
    }
}
