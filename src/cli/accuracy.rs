//! `assur accuracy`

use super::args::Problem;
use super::error::CliError;
use super::reply::{Status, complaint};
use super::screen::Screen;

/// Not supported yet.
pub fn run(_: &Problem, screen: &Screen) -> Status {
    let help = "`assur solve` prints the residuals and the condition of every pose";
    screen.complain(&complaint(CliError::NotSupportedYet { command: "accuracy", help }, screen));
    Status::Unusable
}
