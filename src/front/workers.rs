//! Who does work that can be divided.

use std::sync::{Mutex, PoisonError};

/// Who solves positions and rows that do not depend on one another: the caller alone, or several threads of its own.
///
/// The results are the same, bit by bit, whoever does the work.
pub trait Workers: Sync {
    /// How many pieces of work are wanted at a time.
    fn pieces(&self) -> usize {
        1
    }

    /// On how many threads positions are solved, with the caller's: see [`Workers::beside`].
    fn threads(&self) -> usize {
        1
    }

    /// Calls `help` on every other thread, while `own` runs on the caller's; comes back when all have ended. Fewer threads are
    /// enough: what nobody helps with is done by `own`.
    fn beside(&self, _help: &(dyn Fn() + Sync), own: &mut dyn FnMut()) {
        own();
    }

    /// Calls `work` once with every number below `count`.
    fn each(&self, count: usize, work: &(dyn Fn(usize) + Sync)) {
        (0..count).for_each(work);
    }

    /// Whether to go on. It is asked now and then, on the caller's thread.
    fn goes_on(&self) -> bool {
        true
    }

    /// Whether [`Workers::goes_on`] was denied, for work on any thread.
    fn is_stopped(&self) -> bool {
        false
    }
}

/// The caller alone.
#[derive(Clone, Copy, Debug, Default)]
pub struct Alone;

impl Workers for Alone {}

/// Does the work on every item, with its number.
pub(super) fn each_of<T: Send>(workers: &dyn Workers, items: &mut [T], work: impl Fn(usize, &mut T) + Sync) {
    let items: Vec<Mutex<&mut T>> = items.iter_mut().map(Mutex::new).collect();
    workers.each(items.len(), &|i| {
        if let Some(item) = items.get(i) {
            work(i, &mut item.lock().unwrap_or_else(PoisonError::into_inner));
        }
    });
}
