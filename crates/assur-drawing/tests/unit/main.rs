//! Unit tests of the drawing floor.

mod dxf;
mod palette;
mod placement;
mod scale;
mod svg;
mod text;
mod tikz;
