//! What acts on the machine: weights, forces, springs, unknown efforts.

pub mod balance;
pub mod gravity;
pub mod load;
pub mod load_cycle;
pub mod mass;
pub mod spring;
