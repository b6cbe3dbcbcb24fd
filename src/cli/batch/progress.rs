//! How far a batch is: on a terminal, and only where it takes its time.

use std::io::IsTerminal;
use std::time::{Duration, Instant};

use assur_text::source::shown_in_line;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Before this nothing is shown.
const PATIENCE: Duration = Duration::from_secs(1);

/// A line on standard error that counts rows.
pub struct Progress {
    started: Instant,
    name: String,
    total: Option<u64>,
    terminal: bool,
    bar: Option<ProgressBar>,
}

impl Progress {
    /// Counts the rows of a file; `total` where that is known.
    pub fn new(name: &str, total: Option<usize>) -> Self {
        Self {
            started: Instant::now(),
            name: name.to_owned(),
            total: total.and_then(|n| u64::try_from(n).ok()),
            terminal: std::io::stderr().is_terminal(),
            bar: None,
        }
    }

    /// Says how many rows are done.
    pub fn rows(&mut self, done: usize) {
        if !self.terminal || self.started.elapsed() < PATIENCE {
            return;
        }
        let bar = self.bar.get_or_insert_with(|| bar(&self.name, self.total));
        bar.set_position(u64::try_from(done).unwrap_or(u64::MAX));
    }

    /// Calls `print`, which writes on standard error, without disturbing the line.
    pub fn aside(&self, print: impl FnOnce()) {
        match &self.bar {
            Some(bar) => bar.suspend(print),
            None => print(),
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

fn bar(name: &str, total: Option<u64>) -> ProgressBar {
    let (bar, template) = match total {
        Some(total) => (ProgressBar::new(total), "{msg}: {pos} of {len} rows {wide_bar} {eta}"),
        None => (ProgressBar::new_spinner(), "{msg}: {pos} rows, {per_sec}"),
    };
    bar.set_draw_target(ProgressDrawTarget::stderr());
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style);
    }
    bar.set_message(shown_in_line(name).into_owned());
    bar
}
