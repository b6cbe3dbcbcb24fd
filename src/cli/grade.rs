//! `assur grade`

use super::args::{Format, Grade};
use super::error::CliError;
use super::files;
use super::reply::{Status, complaint};
use super::screen::Screen;
use crate::exercise::grade::{Credit, Points, Rules, Sheet, grade};
use crate::exercise::table::Fault;
use crate::report;
use assur_text::diagnostic::{Diagnosis, Problems};

const BUFFER: usize = 1 << 16;

/// Marks answers by a key: 0 where all are right, 1 where one is not.
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
    let rules = rules(args);
    let Some(key) = sheet(&args.key, None, screen)? else { return Ok(Status::Unusable) };
    if let Some((name, help)) = rules.points.unknown(&key) {
        return Err(CliError::NoQuantity { name: name.to_owned(), help });
    }
    let Some(answers) = sheet(&args.answers, Some(&key), screen)? else { return Ok(Status::Unusable) };
    let left_out = answers.left_out.clone();
    let graded = match grade(&key, answers, &rules) {
        Ok(graded) => graded,
        Err(fault) => {
            warn((&left_out, 0), screen);
            report(fault, screen);
            return Ok(Status::Unusable);
        }
    };
    warn((&graded.left_out, graded.more_left_out), screen);
    let printed = Status::printed(match args.format {
        Format::Csv => screen.write(|out| report::grade::write_csv(&graded, out)),
        Format::Json | Format::Jsonl => screen.write(|out| {
            report::grade::write_json(&graded, out)?;
            out.write_all(b"\n")
        }),
        format => {
            let page = format.page(screen.look());
            report::grade::reports(&graded).all(|report| screen.print(page.render(&report)))
        }
    });
    Ok(printed.max(if graded.is_all_right() { Status::Fine } else { Status::Wrong }))
}

fn rules(args: &Grade) -> Rules {
    Rules {
        within: args.within,
        only_answered: args.only_answered,
        submissions: args.submissions.into(),
        points: args.points.iter().cloned().fold(Points::default(), Points::and),
        credit: args.credit.iter().cloned().fold(Credit::default(), Credit::and),
    }
}

/// A sheet; `None` where it has an error, which is reported.
fn sheet(name: &str, key: Option<&Sheet>, screen: &Screen) -> Result<Option<Sheet>, CliError> {
    let reader = files::table(name, BUFFER)?;
    match Sheet::read(name, reader, key).map_err(|error| files::unread_table(name, &error))? {
        Ok(sheet) => Ok(Some(sheet)),
        Err(fault) => {
            report(fault, screen);
            Ok(None)
        }
    }
}

fn report((source, error): Fault, screen: &Screen) {
    screen.complain(&screen.diagnostics(&Problems::of([*error]), &source));
}

/// Columns and lines that are not marked, as many as are wanted.
fn warn((left_out, more): (&[Fault], usize), screen: &Screen) {
    for (source, error) in left_out.iter().take(screen.most()) {
        screen.complain(
            &screen.diagnostics(&Problems::of([Diagnosis::copied(error.as_ref()).as_warning()]), source),
        );
        screen.complain("\n");
    }
    let more = left_out.len().saturating_sub(screen.most()) + more;
    if more > 0 {
        screen.complain(&format!("and {more} more\n"));
    }
}
