//! Involute spur gears.

mod pair;

pub use pair::GearFault;
pub use pair::{Gear, GearPair, NoMesh, STANDARD_RACK, Teeth};
pub use pair::{inverse_involute, involute};
