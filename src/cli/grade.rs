//! `assur grade`

use std::fs::File;
use std::io::BufReader;

use super::args::{Grade, GradeFormat};
use super::error::CliError;
use super::reply::{Status, complaint};
use super::screen::Screen;
use crate::exercise::grade::{Sheet, grade};
use crate::exercise::table::Fault;
use crate::report;
use assur_text::diagnostic::Problems;

/// Holds answers against a key: 0 where all are right, 1 where one is not.
pub fn run(args: &Grade, screen: &Screen) -> Status {
    match graded(args, screen) {
        Ok(status) => status,
        Err(error) => {
            screen.complain(&complaint(error, screen));
            Status::Unusable
        }
    }
}

fn graded(args: &Grade, screen: &Screen) -> Result<Status, CliError> {
    let Some(key) = sheet(&args.key, None, screen)? else { return Ok(Status::Unusable) };
    let Some(answers) = sheet(&args.answers, Some(&key), screen)? else { return Ok(Status::Unusable) };
    let graded = match grade(&key, &answers, args.within) {
        Ok(graded) => graded,
        Err(fault) => {
            tell(fault, screen);
            return Ok(Status::Unusable);
        }
    };
    let text = match args.format {
        GradeFormat::Table => report::text::render(&report::grade::report(&graded), screen.look()),
        GradeFormat::Csv => report::grade::csv(&graded),
        GradeFormat::Json => report::grade::json(&graded) + "\n",
    };
    let printed = Status::printed(screen.print(&text));
    let (right, all) = graded.totals();
    let whole = right == all && graded.unanswered.is_empty();
    Ok(printed.max(if whole { Status::Fine } else { Status::Wrong }))
}

/// A sheet; `None` if it has an error, which is reported.
fn sheet(name: &str, key: Option<&Sheet>, screen: &Screen) -> Result<Option<Sheet>, CliError> {
    let fail = |error: std::io::Error| match error.kind() {
        std::io::ErrorKind::NotFound => CliError::Missing { name: name.to_owned() },
        _ => CliError::Unreadable { name: name.to_owned(), why: error.to_string() },
    };
    let file = File::open(name).map_err(fail)?;
    match Sheet::read(name, BufReader::new(file), key).map_err(fail)? {
        Ok(sheet) => Ok(Some(sheet)),
        Err(fault) => {
            tell(fault, screen);
            Ok(None)
        }
    }
}

fn tell((source, error): Fault, screen: &Screen) {
    let mut problems = Problems::new();
    problems.push(*error);
    screen.complain(&screen.diagnostics(&problems, &source));
}
