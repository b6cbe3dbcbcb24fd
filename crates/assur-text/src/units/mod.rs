//! Dimensions, and units as data.
//!
//! Inside, everything is SI and radians; a [`Unit`] stands at the border, where numbers come in and answers go out.

mod number;
mod spelling;
mod template;
mod unit;

pub use crate::language::{Dimension, Kind};
pub use number::{push_significant, significant, write_significant};
pub use spelling::suggestions;
pub use template::Template;
pub use unit::UnitError;
pub use unit::{Conversion, Unit};
pub use unit::{Factor, factors};
pub use unit::{is_unit, lookup};
