//! Forces on links: wrenches, inertia, springs, substitute masses. Pure mathematics, as in `group`.
//!
//! The force on a link is the pair of a force F and its moment M about a named point, in ground axes; the sign of a
//! moment is counter-clockwise. Inertia forces are d'Alembert's: they enter the balance of a link like applied ones.
#![allow(non_snake_case, reason = "names carry the notation of the field: a_S, F, M")]

pub mod inertia;
pub mod mass_substitution;
pub mod spring;
mod wrench;

pub use wrench::Wrench;
