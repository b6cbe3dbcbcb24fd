//! Links: points, lines, circles, and the way from a name to them.

pub mod fitting;
pub mod link;
pub mod lookup;
mod missing_guide;
pub mod point;
