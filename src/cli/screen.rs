//! The streams of the program.

use std::io::{self, BufWriter, ErrorKind, IsTerminal, Write};
use std::sync::atomic::{AtomicBool, Ordering};

use anstream::{AutoStream, ColorChoice};
use terminal_size::{Height, Width, terminal_size_of};

use super::args::Args;
use super::args::Color;
use super::error::CliError;
use super::reply::complaint;
use crate::report::text::Look;
use assur_text::diagnostic::{Problems, Style, render_most};
use assur_text::source::Source;

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
