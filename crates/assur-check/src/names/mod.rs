//! Names: all that a document declares, found before anything is resolved.

pub mod declare;
pub mod declared;
pub mod functions;
pub mod head;
pub mod lookalikes;
pub mod result;
pub mod scope;
pub mod suggestion;
pub mod taken;
pub mod uses;
