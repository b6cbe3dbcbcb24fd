//! `assur card`

use super::args::{Card, CardFormat};
use super::reply::Status;
use super::screen::Screen;
use crate::report::card;

/// Prints the language on one page.
pub fn run(args: &Card, screen: &Screen) -> Status {
    let page = match (args.llms, args.format) {
        (true, _) => card::llms(),
        (false, CardFormat::Markdown) => card::page(),
        (false, CardFormat::Json) => card::data().to_string() + "\n",
    };
    Status::printed(screen.print(page))
}
