//! The reply about a file, and the loop over all files.

use std::panic::{AssertUnwindSafe, catch_unwind};

use super::error::CliError;
use super::files::{self, Input};
use super::screen::Screen;
use assur_text::diagnostic::{Problem, Problems};
use assur_text::source::Source;

/// Errors of `--set`.
const SET_UNKNOWN: &str = "mech::request::set_unknown";
const SET_VALUE: &str = "mech::request::set_value";

/// Exit status; the worst of all files counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Status {
    #[default]
    Fine = 0,
    /// A problem is wrong.
    Wrong = 1,
    /// The command line or a file cannot be used.
    Unusable = 2,
}

impl Status {
    /// Wrong where there is an error; unusable where it is one of the command line.
    pub fn of(problems: &Problems) -> Self {
        if [SET_UNKNOWN, SET_VALUE].iter().any(|code| problems.has(code)) {
            Self::Unusable
        } else if problems.has_errors() {
            Self::Wrong
        } else {
            Self::Fine
        }
    }

    /// Wrong where an answer of a folder is missing.
    pub const fn after(error: &CliError) -> Self {
        if error.is_in_folder() { Self::Wrong } else { Self::Unusable }
    }

    /// Fine where all was written.
    pub const fn printed(whole: bool) -> Self {
        if whole { Self::Fine } else { Self::Unusable }
    }
}

/// The reply about one file.
#[derive(Debug, Default)]
pub struct Reply {
    pub results: String,
    pub diagnostics: String,
    pub status: Status,
}

impl Reply {
    /// A reply with the status of its problems.
    #[must_use]
    pub fn new(results: String, problems: &Problems, source: &Source, screen: &Screen) -> Self {
        Self { results, diagnostics: screen.diagnostics(problems, source), status: Status::of(problems) }
    }

    /// A reply about what cannot be used.
    pub fn unusable(error: CliError, screen: &Screen) -> Self {
        let status = Status::after(&error);
        Self { results: String::new(), diagnostics: complaint(error, screen), status }
    }
}

/// An error that has no place in a text.
pub fn complaint(error: impl Problem, screen: &Screen) -> String {
    let mut problems = Problems::new();
    problems.push(error);
    screen.diagnostics(&problems, &Source::new("", ""))
}

/// Writes the results of files, with separators.
#[derive(Debug)]
pub struct Printer<'s> {
    screen: &'s Screen,
    apart: &'s str,
    /// A file before this one has results.
    before: bool,
    begun: bool,
    whole: bool,
}

impl<'s> Printer<'s> {
    /// Nothing is written yet; `apart` separates the results of two files.
    #[must_use]
    pub const fn new(screen: &'s Screen, apart: &'s str) -> Self {
        Self { screen, apart, before: false, begun: false, whole: true }
    }

    /// Whether there are results of any file.
    #[must_use]
    pub const fn has_results(&self) -> bool {
        self.before
    }

    /// Writes results of the present file; `false` where that cannot be done.
    pub fn print(&mut self, text: impl AsRef<[u8]>) -> bool {
        let text = text.as_ref();
        if text.is_empty() || !self.whole {
            return self.whole;
        }
        if self.before && !self.begun {
            self.whole = self.screen.print(self.apart);
        }
        self.begun = true;
        self.whole = self.whole && self.screen.print(text);
        self.whole
    }
}

/// Works through all files that the command line names; one that cannot be used does not affect the others. `apart`
/// separates the results of two files.
pub fn for_each_file(
    names: &[String],
    screen: &Screen,
    apart: &str,
    work: impl Fn(&Source, &mut Printer<'_>) -> Reply,
) -> Status {
    for_each_input(files::expand(names), &mut Printer::new(screen, apart), work)
}

/// As [`for_each_file`], of inputs that are known.
pub fn for_each_input(
    inputs: Vec<Result<Input, CliError>>,
    printer: &mut Printer<'_>,
    work: impl Fn(&Source, &mut Printer<'_>) -> Reply,
) -> Status {
    let mut status = Status::Fine;
    let screen = printer.screen;
    quiet_panics();
    for input in inputs {
        let reply = match input.and_then(Input::read) {
            Ok(source) => guarded(&source, screen, |source| work(source, printer)),
            Err(error) => Reply::unusable(error, screen),
        };
        screen.complain(&reply.diagnostics);
        status = status.max(reply.status);
        if !printer.print(&reply.results) {
            return Status::Unusable;
        }
        printer.before |= printer.begun;
        printer.begun = false;
        // a motion was ended by it
        if super::stop::signal().is_some() {
            break;
        }
    }
    status
}

/// An error of our own ends one file, not the program.
pub fn guarded(source: &Source, screen: &Screen, work: impl FnOnce(&Source) -> Reply) -> Reply {
    match catch_unwind(AssertUnwindSafe(|| work(source))) {
        Ok(reply) => reply,
        Err(payload) => {
            let words = payload.downcast_ref::<String>().map(String::as_str);
            let what = words.or(payload.downcast_ref::<&str>().copied()).unwrap_or("no message");
            let (file, what) = (source.name.clone(), what.to_owned());
            Reply::unusable(CliError::Internal { file, what, version: env!("CARGO_PKG_VERSION") }, screen)
        }
    }
}

/// An internal error is reported once, as a diagnostic.
pub fn quiet_panics() {
    if std::env::var_os("RUST_BACKTRACE").is_none() {
        std::panic::set_hook(Box::new(|_| {}));
    }
}
