//! The program of the system that opens an address.

use std::process::{Command, Stdio};
use std::thread;

/// Opens an address in the browser. Where nothing can open it, the address was printed.
pub fn open(address: &str) {
    let mut command = if cfg!(target_os = "macos") {
        Command::new("open")
    } else if cfg!(windows) {
        Command::new("explorer")
    } else {
        Command::new("xdg-open")
    };
    let quiet = command.arg(address).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    if let Ok(mut child) = quiet.spawn() {
        // it is over at once, or stays for as long as the browser
        thread::spawn(move || child.wait());
    }
}
