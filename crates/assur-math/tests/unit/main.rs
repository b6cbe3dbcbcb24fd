//! Unit tests, one module per source file.

mod element;
mod force;
mod group;
mod math;
