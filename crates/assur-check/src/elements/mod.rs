//! Machine elements: cams, springs, flywheels.

pub mod cam;
pub mod cam_contact;
pub mod cam_fault;
pub mod flywheel;
pub mod spring;
