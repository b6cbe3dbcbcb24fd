//! Unit tests of the drawing floor.

mod palette;
mod placement;
mod scale;
mod svg;
mod text;
