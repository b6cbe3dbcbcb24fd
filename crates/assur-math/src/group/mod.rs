//! Structural groups: the closed forms of the dyads, and Newton's method for everything else.
//!
//! Pure mathematics, one file per kind of group. Every file has its derivation at the head and the same functions:
//! position, velocity, acceleration, reactions, each for a group whose outer pairs sit on bodies of known motion.
//!
//! Conventions, the same in every file:
//! - Vectors stand in ground axes, x to the right, y up; counter-clockwise is positive; SI units and radians.
//! - A direction is the pair (cos, sin); no function here takes or returns an angle.
//! - `perp(v)` is v turned by +90°, so ω × r = ω perp(r), and n = perp(d) is the left normal of a guide d.
//! - `F_i`, `M_i` are the sum of all applied forces on body i, inertia forces among them, and their moment about the
//!   point that the file names.
//! - `sine` is the signed condition figure of the group, in [−1, 1]: its magnitude σ is |sin| of the transmission
//!   angle or what stands for it, its sign tells the two assemblies apart. With ε the unit roundoff the position is
//!   good to about ε/σ, the velocity to ε/σ², the acceleration to ε/σ³. σ = 0 is a dead position.
//! - `closure` ≥ 0 when the group closes; it is the length by which the lengths suffice. Where it is negative the
//!   position returned is the nearest stretched or folded one and `gap` tells how far it is from closing. At a dead
//!   centre rounding alone may leave a few units in the last place of the longest length on either side of zero.
//! - Kernels have no branches: they run on one number or on several lanes at once. No input makes them panic.
#![allow(non_snake_case, reason = "names carry the notation of the field: p_B, v_B, M_1")]

pub mod general;
pub mod pp;
pub mod prp;
pub mod rpp;
pub mod rpr;
pub mod rrp;
pub mod rrr;
pub mod triad;
mod watch;

pub use watch::{IterationLog, NewtonStep};

/// Why a group does not close, and by how much.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Gap {
    /// The outer elements are farther apart than the links reach, m.
    TooFar(f64),
    /// The outer elements are nearer than the links can fold, m.
    TooNear(f64),
}
