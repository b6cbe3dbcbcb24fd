//! Pictures without mechanics: marks in millimetres of paper, x to the right and y down, labels that never overlap, SVG.

mod board;
mod clearance;
mod drawing;
mod geometry;
mod grid;
mod ground;
mod label;
mod mark;
mod number;
mod outside;
mod placement;
mod places;
mod rules;
mod scale;
mod style;
mod svg;
mod text;
mod widths;
mod wrap;

pub use drawing::{Caption, Drawing, Group, Placed, Sheet};
pub use geometry::{Rect, Segment};
pub use grid::touches;
pub use label::{Anchor, Label};
pub use label::{Palette, Role, Theme};
pub use mark::{Mark, Obstacle, Shape, on_circle};
pub use number::{Number, number};
pub use placement::Later;
pub use rules::{FAMILIES, page_rules};
pub use scale::{SERIES, Scale, plain, round_length};
pub use style::{CURVES, Paint, STYLES, Style};
pub use svg::{escaped, in_light, mark_svg};
pub use text::{Level, Run, Set, Text};
