//! What the stage makes: a mechanism and a list of problems.

pub mod behind;
pub mod hinges;
pub mod problems;
