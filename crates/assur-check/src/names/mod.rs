//! Names: all that a document declares, found before anything is resolved.

pub mod declare;
pub mod declared;
pub mod lookalikes;
pub mod suggestion;
pub mod taken;
pub mod uses;
