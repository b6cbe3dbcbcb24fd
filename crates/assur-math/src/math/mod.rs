//! 2-vectors, the scalar trait, exact ratios, small linear solves with their condition, integrals and integrators.

pub mod chebyshev;
mod dense;
mod double;
mod factors;
mod lanes;
pub mod lobatto;
#[doc(hidden)]
pub mod magnitudes;
pub mod ode;
pub mod quadrature;
pub mod ratio;
mod root;
mod scalar;
mod sparse;
mod table_function;
mod tolerance;
mod vec2;

pub use dense::{Dense, Lu};
pub use double::Double;
pub use factors::Factors;
pub use lanes::Lanes;
pub use magnitudes::{AbsLinearSystem, Part, Solutions};
pub use ratio::Ratio;
pub use root::{root, root_within};
pub use scalar::Real;
pub use scalar::{LaneMask, Scalar};
pub use sparse::Sparse;
pub use table_function::{Between, Beyond, Piece, TableFault, TableFunction};
pub use tolerance::{ROUNDING, SAME};
pub use vec2::Angular;
pub use vec2::{V2, Vec2};
pub use vec2::{acceleration_at, velocity_at};
