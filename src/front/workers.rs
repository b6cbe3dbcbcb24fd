//! Who does work that can be divided.

/// Who solves positions and rows that do not depend on one another: the caller alone, or several threads of its own.
///
/// The results are the same, bit by bit, whoever does the work.
pub trait Workers: Sync {
    /// On how many threads positions and rows are solved, with the caller's: see [`Workers::beside`].
    fn threads(&self) -> usize {
        1
    }

    /// Calls `help` on every other thread, while `own` runs on the caller's; comes back when all have ended. Fewer threads are
    /// enough: what nobody helps with is done by `own`.
    fn beside(&self, _help: &(dyn Fn() + Sync), own: &mut dyn FnMut()) {
        own();
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
