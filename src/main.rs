//! The command line program.

use std::process::ExitCode;

fn main() -> ExitCode {
    assur::internals::cli::run(std::env::args_os())
}
