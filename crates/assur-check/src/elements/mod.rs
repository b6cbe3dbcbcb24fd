//! Machine elements: cams, flywheels, Geneva wheels.

pub mod cam;
pub mod cam_contact;
pub mod cam_fault;
pub mod cam_program;
pub mod flywheel;
pub mod geneva;
