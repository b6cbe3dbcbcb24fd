//! Dimensions, and units as data.
//!
//! Inside, everything is SI and radians; a [`Unit`] stands at the border, where numbers come in and answers go out.

mod dimension;
mod error;
mod factors;
mod lookup;
mod number;
mod spelling;
#[doc(hidden)]
pub mod table;
mod unit;

pub use dimension::{Dimension, Kind};
pub use error::UnitError;
pub use factors::{Factor, factors};
pub use lookup::{is_unit, lookup};
pub use number::{significant, write_significant};
pub use spelling::meant;
pub use unit::Unit;
