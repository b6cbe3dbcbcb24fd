//! Involute spur gears.

mod check;
mod involute;
mod pair;

pub use check::GearFault;
pub use involute::{inverse_involute, involute};
pub use pair::{Gear, GearPair, NoMesh, Teeth};
