//! Where the program writes.

use std::io::{self, IsTerminal, Write};

use anstream::{AutoStream, ColorChoice};

use super::args::Color;
use crate::diagnostic::{Problems, Style, render};
use crate::report::text::Look;
use crate::source::Source;

/// Width of what is not written to a terminal.
const WIDTH: usize = 100;

/// Standard output and standard error: with or without colours.
#[derive(Clone, Copy, Debug)]
pub struct Screen {
    out: bool,
    err: bool,
}

impl Screen {
    /// The streams as the command line wants them.
    #[must_use]
    pub fn new(color: Color) -> Self {
        let wanted = match color {
            Color::Auto => ColorChoice::Auto,
            Color::Always => ColorChoice::Always,
            Color::Never => ColorChoice::Never,
        };
        wanted.write_global();
        let coloured = |choice: ColorChoice| choice != ColorChoice::Never;
        Self {
            out: coloured(AutoStream::choice(&io::stdout())),
            err: coloured(AutoStream::choice(&io::stderr())),
        }
    }

    /// How reports are drawn.
    #[must_use]
    pub fn look(&self) -> Look {
        Look { colour: self.out, width: width(io::stdout().is_terminal()) }
    }

    /// How diagnostics are drawn.
    #[must_use]
    pub fn style(&self) -> Style {
        Style::Graphical { colour: self.err, width: width(io::stderr().is_terminal()) }
    }

    /// Diagnostics of a text as they are printed.
    #[must_use]
    pub fn diagnostics(&self, problems: &Problems, source: &Source) -> String {
        render(problems, source, self.style())
    }

    /// Writes results. A reader that has gone away is no mistake: `false` says that nobody listens any more.
    pub fn print(&self, text: &str) -> bool {
        let mut out = io::stdout().lock();
        out.write_all(text.as_bytes()).and_then(|()| out.flush()).is_ok()
    }

    /// Writes diagnostics.
    pub fn complain(&self, text: &str) {
        let mut err = io::stderr().lock();
        // there is no other place to complain
        let _ = err.write_all(text.as_bytes()).and_then(|()| err.flush());
    }
}

/// The width that COLUMNS names, else the usual one.
fn width(terminal: bool) -> usize {
    let columns = std::env::var("COLUMNS").ok().and_then(|c| c.parse().ok());
    columns.filter(|_| terminal).unwrap_or(WIDTH).max(40)
}
