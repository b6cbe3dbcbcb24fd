//! Names: all that a document declares, found before anything is resolved.

pub mod declare;
pub mod functions;
pub mod head;
pub mod lookalikes;
pub mod taken;
