//! `assur preview`

mod board;
mod file;
#[cfg(feature = "lsp")]
mod pages;
mod site;

use super::args::Preview;
use super::error::CliError;
use super::reply::{Status, complaint, quiet_panics};
use super::screen::Screen;
use super::stop::listen;
use board::Board;
use file::Followed;
#[cfg(feature = "lsp")]
pub use pages::{Moves, Pages};
use site::Site;
use std::sync::Arc;

/// Shows a file in the browser until a signal ends it.
pub fn run(args: &Preview, screen: &Screen) -> Status {
    match shown(args, screen) {
        Ok(status) => status,
        Err(error) => {
            screen.complain(&complaint(error, screen));
            Status::Unusable
        }
    }
}

fn shown(args: &Preview, screen: &Screen) -> Result<Status, CliError> {
    let (file, source) = Followed::open(&args.file)?;
    quiet_panics();
    listen();
    let board = Arc::new(Board::new(&source.name));
    let address = Site::start(args.port.unwrap_or(0)).and_then(|site| site.add(&board));
    let address = address.map_err(|error| CliError::NotServed {
        port: args.port.map_or_else(String::new, |port| format!(" on port {port}")),
        why: error.to_string(),
    })?;
    if !screen.print(format!("{address}\n")) {
        return Ok(Status::Unusable);
    }
    if !args.no_open {
        site::open(&address);
    }
    file.show(source, &board, screen)
}
