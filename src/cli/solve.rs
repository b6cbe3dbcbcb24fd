//! `assur solve`

use super::args::{Format, Solve};
use super::reply::{Reply, Status, for_each_file};
use super::screen::Screen;
use crate::diagnostic::Problems;
use crate::report::{self, Precision};
use crate::source::Source;
use crate::{Compiled, Solved};

/// Prints the answers.
pub fn run(args: &Solve, screen: &Screen) -> Status {
    let overrides = args.problem.overrides();
    let apart = match args.format {
        Format::Json => "",
        Format::Csv => "\r\n",
        Format::Table | Format::Markdown => "\n",
    };
    for_each_file(&args.problem.files, screen, apart, |source| {
        let (compiled, mut problems) = crate::compile(source, &overrides);
        let solved = match compiled {
            Some(compiled) if !problems.has_errors() => {
                let (solved, found) = crate::solve(compiled);
                problems.append(found);
                solved.map_err(Some)
            }
            compiled => Err(compiled),
        };
        let results = match (args.format, &solved) {
            (Format::Json, Ok(solved)) => json(source, Ok(solved), &problems),
            (Format::Json, Err(compiled)) => json(source, Err(compiled.as_ref()), &problems),
            (format, Ok(solved)) => answers(format, source, solved, screen),
            (_, Err(_)) => String::new(),
        };
        Reply::new(results, &problems, source, screen)
    })
}

fn answers(format: Format, source: &Source, solved: &Solved, screen: &Screen) -> String {
    let answers = solved.answers(Precision::READABLE);
    match format {
        Format::Csv => report::csv::render(&report::table_of_poses(&answers)),
        Format::Markdown => report::markdown::render(&report::of_answers(&source.name, &answers)),
        Format::Table | Format::Json => {
            report::text::render(&report::of_answers(&source.name, &answers), screen.look())
        }
    }
}

/// One line, whatever was reached.
fn json(source: &Source, solved: Result<&Solved, Option<&Compiled>>, problems: &Problems) -> String {
    let diagnostics = problems.views(source);
    let line = match solved {
        Ok(solved) => {
            let answers = solved.answers(Precision::READABLE);
            report::json::render(&source.name, Some(&answers.scene), Some(&answers), &diagnostics)
        }
        Err(compiled) => {
            let scene = compiled.map(Compiled::scene);
            report::json::render(&source.name, scene.as_ref(), None, &diagnostics)
        }
    };
    line + "\n"
}
