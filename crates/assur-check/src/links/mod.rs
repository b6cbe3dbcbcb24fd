//! Links: points, lines, circles, and the way from a name to them.

pub mod fitting;
pub mod link;
pub mod lookup;
pub mod point;
