//! The command line program.

use std::process::ExitCode;

fn main() -> ExitCode {
    assur::cli::run(std::env::args_os())
}
