//! The clock of this machine, for what is measured.

use std::sync::LazyLock;
use std::time::Instant;

static BEGIN: LazyLock<Instant> = LazyLock::new(Instant::now);

/// Seconds since it was first asked.
pub fn seconds() -> f64 {
    BEGIN.elapsed().as_secs_f64()
}
