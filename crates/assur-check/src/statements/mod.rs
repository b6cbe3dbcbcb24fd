//! What is read off the statements themselves: their expressions, and how they are written.

pub mod comma;
pub mod walk;
pub mod written;
