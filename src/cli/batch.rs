//! `assur batch`

use super::args::Batch;
use super::error::CliError;
use super::reply::{Status, complaint};
use super::screen::Screen;

/// Not supported yet.
pub fn run(_: &Batch, screen: &Screen) -> Status {
    let help = "solve one variant at a time, as in `assur solve FILE --set r=120mm`";
    screen.complain(&complaint(CliError::NotSupportedYet { command: "batch", help }, screen));
    Status::Unusable
}
