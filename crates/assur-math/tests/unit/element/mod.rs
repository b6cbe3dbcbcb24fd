//! Machine elements.

mod involute;
mod law;
