//! Links: points, lines, circles, and the way from a name to them.

pub mod link;
pub mod lookup;
pub mod missing_mesh;
pub mod point;
