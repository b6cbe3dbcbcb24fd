//! Diagrams: panels with axes, curves in them, areas.

mod area;
mod axis;
mod curve;
mod panel;

pub use area::hatched;
pub use axis::Axis;
pub use curve::{Curve, Line, over_poses};
pub use curve::{drive_axis, drive_label, printed, scaled, with_unit};
pub use panel::{LETTERS, Panel, thinned};
