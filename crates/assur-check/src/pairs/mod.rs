//! Pairs of the linkage.

pub mod contact;
pub mod friction;
pub mod meant;
pub mod pair;
pub mod prismatic;
pub mod property;
pub mod transmission;
pub mod weld;
