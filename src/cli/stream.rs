//! `assur solve` position by position: each is written and forgotten.

use super::args::Format;
use super::reply::{Printer, Reply, Status};
use super::screen::Screen;
use crate::pipeline::{Compiled, Solved};
use crate::report::lines::CsvLines;
use crate::report::{Answers, Precision, json};
use assur_solve::solve::Pose;
use assur_text::diagnostic::Problems;
use assur_text::source::Source;

/// Text is written in pieces of this size.
const PIECE: usize = 1 << 16;
/// What is held back at the most while no position has closed yet: where none does, the file has no answers.
const HELD: usize = 1 << 25;

/// Writes all positions of a file; in CSV after its name, if one is given.
pub fn positions(
    (format, file): (Format, Option<&str>),
    source: &Source,
    compiled: Compiled,
    mut problems: Problems,
    screen: &Screen,
    printer: &mut Printer<'_>,
) -> Reply {
    let mut out = Out::new(format, source, CsvLines::of(&compiled.model(), file), printer);
    let (solved, found) = crate::pipeline::solve_each(compiled, &mut |answers, pose| out.add(answers, pose));
    problems.append(found);
    if let Ok(solved) = &solved {
        out.end(solved);
    }
    if out.failed {
        return Reply { status: Status::Unusable, ..Reply::default() };
    }
    Reply::new(String::new(), &problems, source, screen)
}

struct Out<'p, 's, 'o> {
    format: Format,
    file: &'s str,
    csv: CsvLines,
    text: String,
    /// A position has a meaning.
    begun: bool,
    any: bool,
    failed: bool,
    printer: &'p mut Printer<'o>,
}

impl<'p, 's, 'o> Out<'p, 's, 'o> {
    fn new(format: Format, source: &'s Source, csv: CsvLines, printer: &'p mut Printer<'o>) -> Self {
        let text = if format == Format::Csv { csv.header() } else { String::new() };
        Self { format, file: &source.name, csv, text, begun: false, any: false, failed: false, printer }
    }

    /// Adds a position; `false` where nothing more can be written.
    fn add(&mut self, answers: &Answers<'_>, pose: &Pose) -> bool {
        self.any = true;
        self.begun |= pose.outcome.is_ok() || pose.failure().is_some();
        match self.format {
            Format::Csv => self.csv.add(answers, pose, &mut self.text),
            _ => {
                self.text += &json::render_position(self.file, None, answers, Some(pose));
                self.text.push('\n');
            }
        }
        if self.text.len() >= if self.begun { PIECE } else { HELD } {
            self.flush();
        }
        !self.failed
    }

    /// Writes what is left; what needs no pose where there is none.
    fn end(&mut self, solved: &Solved) {
        let answers = solved.answers(Precision::READABLE);
        match self.format {
            _ if self.any => {}
            Format::Csv => self.csv.add_without_pose(&answers, &mut self.text),
            _ => {
                self.text += &json::render_position(self.file, None, &answers, None);
                self.text.push('\n');
            }
        }
        self.flush();
    }

    fn flush(&mut self) {
        self.failed |= !self.printer.print(&self.text);
        self.text.clear();
    }
}
