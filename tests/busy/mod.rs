//! How long a thread computes.

use std::time::{Duration, Instant};

/// The time that this thread computes from a start on, whatever else the machine does; the time that goes by where the
/// system does not count it.
pub struct Busy {
    start: Instant,
    computed: Option<Duration>,
}

impl Busy {
    /// From now on.
    pub fn start() -> Self {
        Self { start: Instant::now(), computed: computed() }
    }

    /// So far.
    pub fn elapsed(&self) -> Duration {
        match (self.computed, computed()) {
            (Some(then), Some(now)) => now.saturating_sub(then),
            _ => self.start.elapsed(),
        }
    }
}

/// What the thread has computed in all.
fn computed() -> Option<Duration> {
    let counts = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    counts.split(' ').next()?.parse().ok().map(Duration::from_nanos)
}
