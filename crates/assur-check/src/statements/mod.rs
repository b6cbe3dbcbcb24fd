//! What is read off the statements themselves: their expressions, and how they are written.

pub mod walk;
pub mod written;
