//! What acts on the machine: weights, forces, springs, brakes, unknown efforts.

pub mod balance;
pub mod counterweight;
pub mod gravity;
pub mod load;
pub mod load_cycle;
pub mod mass;
mod mass_shape;
mod mass_sum;
mod pin;
pub mod slipping;
mod spread;
pub mod spring;
