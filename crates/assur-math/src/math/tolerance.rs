//! What counts as one number and as nothing. A limit that belongs to one solver, one figure or one kind of data is beside it,
//! with its unit and its reason.

/// Numbers of a file, lengths and angles (rad) that differ by less than this part of their size are one: a file has at most nine
/// digits of them, and what is computed from these has more.
pub const SAME: f64 = 1e-9;
/// Computed terms below this part of the greatest in their sum are zero but for rounding: some thousand operations in `f64`
/// leave no more.
pub const ROUNDING: f64 = 1e-12;
