//! Ctrl-C: the rows under way are finished, complete rows are kept. A second one ends at once.

use std::sync::atomic::{AtomicBool, Ordering};

static WANTED: AtomicBool = AtomicBool::new(false);

/// Exit status of a program that Ctrl-C ends.
const INTERRUPTED: i32 = 130;

/// Listens for Ctrl-C from now on.
pub fn install() {
    // where nothing can listen, Ctrl-C ends the program as usual
    let _ = ctrlc::set_handler(|| {
        if WANTED.swap(true, Ordering::Relaxed) {
            std::process::exit(INTERRUPTED);
        }
    });
}

/// Whether Ctrl-C was pressed.
pub fn wanted() -> bool {
    WANTED.load(Ordering::Relaxed)
}
