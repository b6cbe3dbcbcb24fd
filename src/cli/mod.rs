//! The command line: one file per subcommand, [`args`] is the manual.

mod accuracy;
pub mod args;
#[cfg(feature = "arrow")]
mod arrow;
mod batch;
mod card;
mod check;
mod course;
mod draw;
mod error;
mod explain;
mod files;
mod fmt;
mod folder_sink;
mod grade;
mod help;
mod info;
#[cfg(feature = "lsp")]
mod lsp;
mod mcp;
mod motion;
mod new;
mod preview;
mod profile;
#[doc(hidden)]
pub mod reply;
#[doc(hidden)]
pub mod report;
#[doc(hidden)]
pub mod screen;
mod sink;
mod solve;
mod stop;
mod stream;
mod test;
#[doc(hidden)]
pub mod threads;
mod variant_rows;

use std::ffi::OsString;
use std::process::ExitCode;

use args::{Args, Command};
use reply::Status;
use screen::Screen;

/// Runs the program: results on standard output, diagnostics on standard error.
pub fn run(args: impl IntoIterator<Item = OsString>) -> ExitCode {
    ExitCode::from(status(args))
}

/// As [`run`]; the exit status. 0: success; 1: a problem has errors; 2: the command line or a file cannot be used, or not all could be
/// written; 128 + n: signal n ended it.
pub fn status(args: impl IntoIterator<Item = OsString>) -> u8 {
    let args = match Args::of(args) {
        Ok(args) => args,
        Err(error) => {
            // help goes to standard output; there is nobody to tell where that cannot be written
            let status = error.print().map_or(2, |()| error.exit_code());
            return u8::try_from(status).unwrap_or(2);
        }
    };
    let screen = Screen::new(&args);
    stop::outlive_limits();
    let status = match args.command {
        Command::Check(args) => check::run(&args, &screen),
        Command::Solve(args) => solve::run(&args, &screen),
        Command::Test(args) => test::run(&args, &screen),
        Command::Batch(args) => batch::run(&args, &screen),
        Command::Course(args) => course::run(&args, &screen),
        Command::Grade(args) => grade::run(&args, &screen),
        Command::Accuracy(args) => accuracy::run(&args, &screen),
        Command::Profile(args) => profile::run(&args, &screen),
        Command::Draw(args) => draw::run(&args, &screen),
        Command::Preview(args) => preview::run(&args, &screen),
        Command::Report(args) => report::run(&args, &screen),
        Command::Explain(args) => explain::run(&args, &screen),
        Command::Fmt(args) => fmt::run(&args, &screen),
        Command::New(args) => new::run(&args, &screen),
        #[cfg(feature = "lsp")]
        Command::Lsp(_) => lsp::run(&screen),
        Command::Mcp(_) => mcp::run(&screen),
        Command::Card(args) => card::run(&args, &screen),
        Command::Completions(args) => info::completions(&args, &screen),
        Command::Man(args) => info::manual(&args, &screen),
        Command::Info(args) => info::run(&args, &screen),
        Command::Help(args) => help::run(&args, &screen),
    };
    let status = if screen.is_heard() { status } else { Status::Unusable };
    stop::signal().map_or(status as u8, |signal| 128 + signal)
}
