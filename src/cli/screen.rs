//! The streams of the program.

use super::args::{Args, Color};
use super::error::CliError;
use super::reply::complaint;
use crate::report::text::Look;
use anstream::{AutoStream, ColorChoice};
use assur_text::diagnostic::{Problems, Style, render_most};
use assur_text::source::Source;
use std::io::{self, BufWriter, ErrorKind, IsTerminal, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use terminal_size::{Height, Width, terminal_size_of};

/// Width of what is not written to a terminal.
const WIDTH: usize = 100;
/// A narrower terminal is taken for one of this width.
const NARROWEST: usize = 40;

/// Whether something could not be said.
static UNSAID: AtomicBool = AtomicBool::new(false);

/// Standard output and standard error: with or without colours.
#[derive(Clone, Copy, Debug)]
pub struct Screen {
    out: bool,
    err: bool,
    most: usize,
}

impl Screen {
    /// The streams as the command line wants them.
    #[must_use]
    pub fn new(args: &Args) -> Self {
        let wanted = match args.shared.color {
            Color::Auto => ColorChoice::Auto,
            Color::Always => ColorChoice::Always,
            Color::Never => ColorChoice::Never,
        };
        wanted.write_global();
        let coloured = |choice: ColorChoice| choice != ColorChoice::Never;
        Self {
            out: coloured(AutoStream::choice(&io::stdout())),
            err: coloured(AutoStream::choice(&io::stderr())),
            most: args.shared.max_errors,
        }
    }

    /// How reports are drawn.
    #[must_use]
    pub fn look(&self) -> Look {
        let fill = io::stdout().is_terminal();
        let width = width(columns(fill, || terminal_size_of(io::stdout())));
        Look { colour: self.out, width, fill }
    }

    /// How diagnostics are drawn.
    #[must_use]
    pub fn style(&self) -> Style {
        let columns = columns(io::stderr().is_terminal(), || terminal_size_of(io::stderr()));
        Style::Graphical { colour: self.err, width: width(columns) }
    }

    /// Diagnostics of a text as they are printed: no more than are wanted.
    #[must_use]
    pub fn diagnostics(&self, problems: &Problems, source: &Source) -> String {
        render_most(problems, source, self.style(), self.most)
    }

    /// How many diagnostics are wanted of a file.
    #[must_use]
    pub const fn most(&self) -> usize {
        self.most
    }

    /// Writes results; `false` if that fails. A reader that has closed its pipe is not
    /// reported.
    #[must_use]
    pub fn print(&self, text: impl AsRef<[u8]>) -> bool {
        self.printed(io::stdout().lock().write_all(text.as_ref()))
    }

    /// Lets results be written piece by piece; as [`Screen::print`].
    #[must_use]
    pub fn write(&self, work: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> bool {
        let mut out = BufWriter::new(io::stdout().lock());
        let written = work(&mut out).and_then(|()| out.flush());
        self.printed(written)
    }

    fn printed(&self, written: io::Result<()>) -> bool {
        let done = written.and_then(|()| io::stdout().flush());
        if let Err(error) = &done
            && error.kind() != ErrorKind::BrokenPipe
        {
            self.complain(&complaint(CliError::Unprinted { why: error.to_string() }, self));
        }
        done.is_ok()
    }

    /// Writes diagnostics. There is no other place to complain; the exit status tells, see [`Screen::is_heard`].
    pub fn complain(&self, text: &str) {
        let mut err = io::stderr().lock();
        if err.write_all(text.as_bytes()).and_then(|()| err.flush()).is_err() {
            UNSAID.store(true, Ordering::Relaxed);
        }
    }

    /// Whether all diagnostics could be written.
    #[must_use]
    pub fn is_heard(&self) -> bool {
        !UNSAID.load(Ordering::Relaxed)
    }
}

/// The columns to fill: those that COLUMNS names, else those of the terminal; a file has the usual ones.
fn width(of: Option<usize>) -> usize {
    of.unwrap_or(WIDTH).max(NARROWEST)
}

/// The columns of a terminal.
fn columns(is_terminal: bool, size: impl FnOnce() -> Option<(Width, Height)>) -> Option<usize> {
    let named = || std::env::var("COLUMNS").ok().and_then(|c| c.parse().ok());
    let of_terminal = || Some(usize::from(size()?.0.0)).filter(|columns| *columns > 0);
    is_terminal.then(|| named().or_else(of_terminal)).flatten()
}

// The clock of this machine, for what is measured.

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
