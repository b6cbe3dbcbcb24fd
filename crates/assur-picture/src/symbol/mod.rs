//! Symbols after ISO 3952, GB/T 4460 and GOST 2.770, one file per family. All in millimetres of paper.

pub mod arrow;
pub mod cylinder;
pub mod dimension;
pub mod gear;
pub mod guide;
pub mod hinge;
pub mod mass;
pub mod spring;
pub mod thread;
pub mod wheel;
