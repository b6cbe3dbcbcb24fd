//! A motion under loads on its way: how far it is, on a terminal, and the signal that ends it. What it did until then is kept.

use std::io::IsTerminal;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use super::stop::{install, looks, signal};
use assur_model::model::Mechanism;
use assur_text::source::shown_in_line;
use assur_text::units::significant;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Before this nothing is shown.
const PATIENCE: Duration = Duration::from_secs(1);
/// Nor more often than this.
const PAUSE: Duration = Duration::from_millis(50);
/// Parts of the bar.
const PARTS: f64 = 1000.0;

/// A motion on its way.
pub struct MotionProgress {
    name: String,
    terminal: bool,
    started: Instant,
    shown: Mutex<BarState>,
}

/// What is shown of it.
struct BarState {
    bar: Option<ProgressBar>,
    drawn: Instant,
    /// The instant that was reached when it was last looked at, s.
    before: f64,
    /// The first one, s, as far as it is known.
    first: f64,
    /// Runs go one after another.
    run: u32,
}

impl MotionProgress {
    /// Of a file that follows a motion; none of others.
    pub fn of(file: &str, mechanism: &Mechanism) -> Option<Self> {
        let simulation = mechanism.simulation.as_ref()?;
        install();
        Some(Self::from(file, simulation.from))
    }

    /// Of a file that may follow a motion: a signal ends the program.
    pub fn shown(file: &str) -> Self {
        Self::from(file, f64::INFINITY)
    }

    fn from(file: &str, first: f64) -> Self {
        let started = Instant::now();
        let shown = BarState { bar: None, drawn: started, before: f64::NEG_INFINITY, first, run: 1 };
        Self {
            name: shown_in_line(file).to_string(),
            terminal: std::io::stderr().is_terminal(),
            started,
            shown: Mutex::new(shown),
        }
    }

    /// Says how far it is; `false` where it is to end.
    pub fn goes_on(&self, reached: f64, last: f64) -> bool {
        if self.terminal {
            self.shown.lock().unwrap_or_else(PoisonError::into_inner).update(self, reached, last);
        }
        signal().is_none()
    }
}

impl BarState {
    fn update(&mut self, way: &MotionProgress, reached: f64, last: f64) {
        self.run += u32::from(reached < self.before);
        self.before = reached;
        self.first = self.first.min(reached);
        if way.started.elapsed() < PATIENCE || self.drawn.elapsed() < PAUSE {
            return;
        }
        self.drawn = Instant::now();
        let bar = self.bar.get_or_insert_with(bar);
        let part = PARTS * (reached - self.first) / (last - self.first);
        let (reached, last) = (significant(reached, 4), significant(last, 4));
        bar.set_message(format!("{}: {reached} of {last} s, run {}", way.name, self.run));
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "it is between 0 and 1000"
        )]
        bar.set_position(part.clamp(0.0, PARTS) as u64);
    }
}

impl Drop for MotionProgress {
    fn drop(&mut self) {
        looks(false);
    }
}

impl Drop for BarState {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

fn bar() -> ProgressBar {
    let bar = ProgressBar::new(1000);
    bar.set_draw_target(ProgressDrawTarget::stderr());
    if let Ok(style) = ProgressStyle::with_template("{msg} {wide_bar}") {
        bar.set_style(style);
    }
    bar
}
