//! Machine elements.

mod involute;
mod law;
mod outline;
