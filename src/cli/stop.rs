//! Signals that end the program. In a batch the rows under way are finished and complete rows are kept: a second one ends at once, and
//! so does the first where rows take too long; no temporary file stays.

use std::sync::atomic::{AtomicBool, AtomicU8, AtomicUsize, Ordering};

static SIGNAL: AtomicU8 = AtomicU8::new(0);
/// What is under way looks for the signal by itself.
static LOOKS: AtomicBool = AtomicBool::new(false);

/// Documents that are in their place, and how many are wanted, where that is known.
static WRITTEN: AtomicUsize = AtomicUsize::new(0);
static WANTED: AtomicUsize = AtomicUsize::new(0);

/// One more document of several is in its place.
pub fn count_written() {
    WRITTEN.fetch_add(1, Ordering::Relaxed);
}

/// This number of documents is going to be written as well.
pub fn want_written(count: usize) {
    WANTED.fetch_add(count, Ordering::Relaxed);
}

/// Whether what is under way now looks for the signal by itself; else the first one ends the program.
pub fn looks(looks: bool) {
    LOOKS.store(looks, Ordering::Relaxed);
}

/// The signal that came, if any.
pub fn signal() -> Option<u8> {
    Some(SIGNAL.load(Ordering::Relaxed)).filter(|signal| *signal > 0)
}

/// Whether the program is to end.
pub fn wanted() -> bool {
    signal().is_some()
}

#[cfg(unix)]
pub use unix::{install, listen, outlive_limits};

#[cfg(unix)]
mod unix {
    use super::{LOOKS, Ordering, SIGNAL, WANTED, WRITTEN};
    use crate::cli::sink;
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM, SIGXFSZ};
    use signal_hook::iterator::Signals;
    use std::io::Write;
    use std::sync::mpsc::channel;
    use std::sync::{Arc, Once};
    use std::thread::Builder;
    use std::time::Duration;

    /// What a program may take to end that was asked to by another.
    const GRACE: Duration = Duration::from_secs(3);

    /// Listens from now on, for what looks for the signal by itself.
    pub fn install() {
        super::looks(true);
        listen();
    }

    /// Listens from now on: where nothing looks for the signal, the first one ends the program.
    pub fn listen() {
        static LISTENS: Once = Once::new();
        LISTENS.call_once(|| each_signal(hear));
    }

    fn hear(signal: u8) {
        if !LOOKS.load(Ordering::Relaxed) || SIGNAL.swap(signal, Ordering::Relaxed) != 0 {
            end(signal);
        }
        if i32::from(signal) != SIGINT {
            let later = Builder::new().spawn(move || {
                std::thread::sleep(GRACE);
                end(signal);
            });
            if later.is_err() {
                end(signal);
            }
        }
    }

    /// A file that grows beyond the limit of the system is an error of writing it, and does not end the program.
    pub fn outlive_limits() {
        // where nothing can listen, a signal ends the program as usual
        let _ = signal_hook::flag::register(SIGXFSZ, Arc::default());
    }

    fn each_signal(hear: fn(u8)) {
        let mut heard = vec![SIGINT, SIGTERM];
        if !is_ignored(SIGHUP) {
            heard.push(SIGHUP);
        }
        let (sender, receiver) = channel::<Signals>();
        let listening = Builder::new().spawn(move || {
            if let Ok(mut signals) = receiver.recv() {
                signals.forever().filter_map(|s| u8::try_from(s).ok()).for_each(hear);
            }
        });
        // where nothing can listen, a signal ends the program as usual
        if listening.is_ok()
            && let Ok(signals) = Signals::new(heard)
        {
            let _ = sender.send(signals);
        }
    }

    fn end(signal: u8) {
        let _nothing_begins = sink::remove_unfinished();
        let (written, wanted) = (WRITTEN.load(Ordering::Relaxed), WANTED.load(Ordering::Relaxed));
        let of = if wanted > 0 { format!(" of {wanted}") } else { String::new() };
        if written + wanted > 0 {
            // nobody waits for who does not read
            let (said, heard) = channel();
            let speaking = Builder::new().spawn(move || {
                let _ = writeln!(std::io::stderr(), "interrupted: {written}{of} files written");
                said.send(())
            });
            let _ = speaking.is_ok() && heard.recv_timeout(GRACE).is_ok();
        }
        std::process::exit(128 + i32::from(signal));
    }

    /// Whether the program was started with a signal ignored, as `nohup` does.
    fn is_ignored(signal: i32) -> bool {
        let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
        let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
        let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0);
        mask >> (signal - 1) & 1 == 1
    }
}

#[cfg(not(unix))]
mod others {
    /// A signal ends the program as usual.
    pub fn install() {}
    /// A signal ends the program as usual.
    pub fn listen() {}
    /// There is no such signal.
    pub fn outlive_limits() {}
}

#[cfg(not(unix))]
pub use others::{install, listen, outlive_limits};
