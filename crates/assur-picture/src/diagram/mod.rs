//! Diagrams: panels with axes, curves in them, areas.

mod area;
mod axis;
mod panel;

pub use area::hatched;
pub use axis::Axis;
pub use panel::{LETTERS, Line, PARTS, Panel, clipped, thinned};
pub use panel::{drive_axis, drive_label, printed, scaled, with_unit};
