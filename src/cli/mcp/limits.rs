//! When a call ends that takes too long.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// How long a call may take.
pub const TIME: Duration = Duration::from_secs(5);

/// Says whether a call goes on: until its time is over, or nobody waits for it.
#[derive(Debug)]
pub struct Alarm {
    end: Instant,
    cancelled: AtomicBool,
}

impl Alarm {
    /// For a call that begins now.
    pub fn of_call() -> Self {
        Self { end: Instant::now() + TIME, cancelled: AtomicBool::new(false) }
    }

    /// Nobody waits for the answer.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    pub fn goes_on(&self) -> bool {
        !self.cancelled.load(Ordering::Relaxed) && Instant::now() < self.end
    }
}
