//! Who works for Python: the threads of the program, which an interrupt stops.

use assur::Workers;
use assur::internals::cli::threads::Threads;
use pyo3::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

/// Threads that are kept for the next call.
struct Kept {
    /// The process that started them.
    process: u32,
    /// How many were wanted.
    wanted: Option<usize>,
    threads: Arc<Threads>,
}

/// The threads of this process: a forked one starts its own.
static KEPT: Mutex<Option<Kept>> = Mutex::new(None);

fn threads(wanted: Option<usize>) -> Arc<Threads> {
    let process = std::process::id();
    let mut kept = KEPT.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(kept) = kept.as_ref().filter(|kept| (kept.process, kept.wanted) == (process, wanted)) {
        return Arc::clone(&kept.threads);
    }
    let threads = Arc::new(Threads::new(wanted));
    let old = kept.replace(Kept { process, wanted, threads: Arc::clone(&threads) });
    if let Some(old) = old.filter(|old| old.process != process) {
        // its threads are those of the parent: there is nobody to end
        std::mem::forget(old);
    }
    threads
}

/// Threads that work until Python has a signal to handle.
pub struct Crew {
    threads: Arc<Threads>,
    stopped: AtomicBool,
    error: Mutex<Option<PyErr>>,
}

impl Crew {
    /// That many threads, or one for every processor.
    pub fn of(count: Option<usize>) -> Self {
        Self { threads: threads(count), stopped: AtomicBool::new(false), error: Mutex::new(None) }
    }

    /// The exception that stopped the work.
    pub fn error(&self) -> Option<PyErr> {
        self.error.lock().unwrap_or_else(PoisonError::into_inner).take()
    }
}

impl Workers for Crew {
    fn threads(&self) -> usize {
        self.threads.count()
    }

    fn beside(&self, help: &(dyn Fn() + Sync), own: &mut dyn FnMut()) {
        self.threads.beside(help, own);
    }

    fn goes_on(&self) -> bool {
        if self.is_stopped() {
            return false;
        }
        let Some(Err(error)) = Python::try_attach(|py| py.check_signals()) else { return true };
        *self.error.lock().unwrap_or_else(PoisonError::into_inner) = Some(error);
        self.stopped.store(true, Ordering::Relaxed);
        false
    }

    fn is_stopped(&self) -> bool {
        self.stopped.load(Ordering::Relaxed)
    }
}
