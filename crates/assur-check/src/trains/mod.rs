//! Shafts, wheels, sliders and what runs between them.

pub mod at_rest;
pub mod bevel;
pub mod carrier;
pub mod ends;
pub mod friction_torque;
pub mod gear;
pub mod grip;
pub mod losses;
pub mod planet;
pub mod rack;
pub mod rack_distance;
pub mod rope;
pub mod shaft;
pub mod size;
pub mod thread;
pub mod transmission;
