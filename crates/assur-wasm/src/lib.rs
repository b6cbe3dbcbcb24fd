//! The language server as WebAssembly: messages of the protocol go in as bytes, messages come out. The host has the streams, the clock and
//! the pauses.

#[cfg(target_family = "wasm")]
mod border;
mod panels;
mod session;

pub use session::{Session, Stop};
