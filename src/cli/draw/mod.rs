//! `assur draw`

#[cfg(feature = "gif")]
mod apng;
#[cfg(feature = "gif")]
mod film;
mod fitting;
#[cfg(feature = "gif")]
mod gif;
mod output;
pub use output::file_name;
mod pages;
#[cfg(feature = "pdf")]
mod pdf;
#[cfg(feature = "png")]
mod png;
#[cfg(feature = "png")]
pub use png::png_of_width;

use super::args::{Draw, DrawFormat, Picture};
use super::error::CliError;
use super::files;
use super::motion::MotionProgress;
use super::reply::{Printer, Reply, Status, complaint, for_each_input};
use super::screen::Screen;
use super::variant_rows::{ChosenRow, Refused, RowsWanted, chosen_rows};
use crate::pipeline;
use assur_check::Overrides;
use assur_picture::{ArrowKind, Kind};
use assur_solve::solve::IntegrationOptions;
use assur_syntax as syntax;
use assur_syntax::document::Document;
use assur_text::diagnostic::Problems;
use assur_text::source::Source;
use output::Output;
use pages::{Page, Pages};
use std::sync::Arc;

/// Draws pictures of solved problems.
pub fn run(args: &Draw, screen: &Screen) -> Status {
    let (pictures, names) = args.pictures();
    if let Some(error) = args.without_effect(&pictures) {
        screen.complain(&complaint(error, screen));
        return Status::Unusable;
    }
    let inputs = files::expand(&names);
    let one = inputs.len() == 1 && pictures.len() == 1;
    let output = match Output::of(args, &pictures, one) {
        Ok(output) => output,
        Err(error) => {
            screen.complain(&complaint(error, screen));
            return Status::Unusable;
        }
    };
    if let Some(error) = output.without_effect(args) {
        screen.complain(&complaint(error, screen));
        return Status::Unusable;
    }
    let overrides = args.overrides();
    let drawing = Drawing { args, screen, pictures, overrides, output, several: inputs.len() > 1 };
    let status = for_each_input(inputs, &mut Printer::new(screen, ""), |source, _| drawing.of_file(source));
    let all = status != Status::Unusable;
    match drawing.output.finish(args.language.into(), args.theme.into(), all) {
        Ok(()) => status,
        Err(error) => {
            screen.complain(&complaint(error, screen));
            Status::Unusable
        }
    }
}

/// Pictures that are wanted.
struct Drawing<'a> {
    args: &'a Draw,
    screen: &'a Screen,
    pictures: Vec<Picture>,
    overrides: Overrides,
    output: Output,
    /// The command line names several files.
    several: bool,
}

impl Drawing<'_> {
    fn of_file(&self, source: &Source) -> Reply {
        let extended = pages::extended(source, &self.overrides, &self.pictures);
        let source = extended.as_ref().unwrap_or(source);
        let (document, mut found) = syntax::parse(source);
        let document = Arc::new(document);
        let rows = if found.has_errors() {
            Ok(vec![ChosenRow::as_written(self.overrides.clone(), std::mem::take(&mut found))])
        } else {
            {
                let args = self.args;
                let wanted = RowsWanted { variants: args.variants.as_deref(), row: &args.row, all: false };
                chosen_rows(wanted, &self.overrides, source, &document)
            }
        };
        let rows = match rows {
            Ok(rows) => rows,
            Err(Refused::Table(source, found)) => {
                return Reply::new(String::new(), &found, &source, self.screen);
            }
            Err(Refused::Cli(error)) => return self.unusable(Reply::default(), error),
        };
        let (mut pages, mut problems) = (Vec::new(), found);
        for row in rows {
            let (drawn, found) = self.of_row(source, &document, row);
            pages.extend(drawn);
            problems.append(found);
        }
        if self.several
            && self.args.pose.is_empty()
            && problems.errors() == 1
            && problems.has("mech::picture::no_position")
        {
            // among several files one without positions, such as a design of gears, is no mistake
            let diagnostics = format!("{} has no position to draw\n", source.name);
            return Reply { diagnostics, ..Reply::default() };
        }
        match self.output.write(&pages, self.args) {
            Ok(results) => Reply::new(results, &problems, source, self.screen),
            Err(error) => self.unusable(Reply::new(String::new(), &problems, source, self.screen), error),
        }
    }

    /// The pictures of a file with a row of variants, and what was found.
    fn of_row(&self, source: &Source, document: &Arc<Document>, mut row: ChosenRow) -> (Vec<Page>, Problems) {
        let mut kinds: Vec<Kind> = self.pictures.iter().map(|picture| picture.kind).collect();
        kinds.extend(self.args.arrows.map(|arrows| ArrowKind::from(arrows).kind()));
        if self.args.numbers {
            // with the numbers of unknown efforts
            kinds.push(Kind::Forces);
        }
        let found = std::mem::take(&mut row.problems);
        let way = MotionProgress::shown(&source.name);
        let watch = |reached: f64, last: f64| way.goes_on(reached, last);
        let conduct = IntegrationOptions { watch: Some(&watch), ..IntegrationOptions::default() };
        let overrides = &row.overrides;
        let (solved, mut problems) =
            pipeline::solve_drawn_conducted(source, document, found, overrides, &kinds, &conduct);
        drop(way);
        let pages = solved.map_or_else(Vec::new, |solved| {
            Pages { drawing: self, source, document, solved: &solved, row: &row }.all(&mut problems)
        });
        (pages, row.reported(problems))
    }

    /// With an error of the command line or of the output.
    fn unusable(&self, reply: Reply, error: CliError) -> Reply {
        let diagnostics = reply.diagnostics + &complaint(error, self.screen);
        Reply { results: String::new(), diagnostics, status: Status::Unusable }
    }
}

/// An output that cannot hold several pictures.
fn one_only(name: &str, format: Option<DrawFormat>) -> CliError {
    let other = format.filter(|format| *format != DrawFormat::Svg);
    let format = other.map(|format| format!(" --format {}", format.ending().trim_start_matches('.')));
    CliError::OnePicture { name: name.to_owned(), format: format.unwrap_or_default() }
}
