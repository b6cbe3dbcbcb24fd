//! Whether the sign of an expression matters.

/// Whether the sign of a value matters where it stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    Matters,
    /// Only the magnitude is asked: within `mag()` and `abs()`.
    Free,
}
