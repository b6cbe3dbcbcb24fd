//! The clock of this machine, for what is measured.

/// Seconds that this thread has had on a processor: others that run on the machine do not count. Where the system has no such clock,
/// those that pass.
#[cfg(unix)]
pub fn processor_seconds() -> f64 {
    let now = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
    #[allow(clippy::cast_precision_loss)] // seconds and less than a thousand million
    let [seconds, parts] = [now.tv_sec as f64, now.tv_nsec as f64];
    seconds + 1e-9 * parts
}

#[cfg(not(unix))]
pub fn processor_seconds() -> f64 {
    static BEGIN: std::sync::LazyLock<std::time::Instant> = std::sync::LazyLock::new(std::time::Instant::now);
    BEGIN.elapsed().as_secs_f64()
}
