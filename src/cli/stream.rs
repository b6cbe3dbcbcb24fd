//! `assur solve` position by position: each is written and forgotten. Where none depends on another they are solved and written
//! on several threads, in their order.

use super::args::Format;
use super::motion::OnTheWay;
use super::reply::{Printer, Reply, Status};
use super::screen::Screen;
use super::threads::Threads;
use crate::pipeline::{Compiled, Sink, Solved};
use crate::report::json::JsonLines;
use crate::report::lines::CsvLines;
use crate::report::{Answers, Precision};
use assur_solve::solve::{Ahead, Block, Conduct, Pose, Watch};
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
    (printer, threads): (&mut Printer<'_>, &Threads),
) -> Reply {
    let lines = match format {
        Format::Csv => Lines::Csv(CsvLines::of(&compiled.model(), file)),
        _ => Lines::Json(JsonLines::of(source.name.clone())),
    };
    let angles = match &lines {
        Lines::Csv(lines) => lines.reads_angles(&compiled.model()),
        Lines::Json(_) => true,
    };
    let text = if let Lines::Csv(lines) = &lines { lines.header() } else { String::new() }.into_bytes();
    let way = OnTheWay::of(&source.name, &compiled.mechanism);
    let watch = |reached: f64, last: f64| way.as_ref().is_none_or(|w| w.goes_on(reached, last));
    let (begun, any, failed, texts) = (false, false, false, Vec::new());
    let mut out = Out { lines, angles, text, texts, begun, any, failed, printer, threads, watch: &watch };
    let (solved, found) = crate::pipeline::solve_each(compiled, &mut out);
    problems.append(found);
    if let Ok(solved) = &solved {
        out.end(solved);
    }
    if out.failed {
        return Reply { status: Status::Unusable, ..Reply::default() };
    }
    Reply::new(String::new(), &problems, source, screen)
}

/// The lines of one form.
enum Lines {
    Csv(CsvLines),
    Json(JsonLines),
}

impl Lines {
    /// What is found once: of a position, where there is one.
    fn begin(&mut self, answers: &Answers<'_>, pose: Option<&Pose>) {
        match (self, pose) {
            (Self::Csv(lines), _) => lines.begin(answers),
            (Self::Json(lines), Some(pose)) => lines.begin(answers, pose),
            (Self::Json(_), None) => {}
        }
    }

    /// Adds the line of a position.
    fn add(&self, answers: &Answers<'_>, pose: &Pose, row: &mut Vec<f64>, text: &mut Vec<u8>) {
        match self {
            Self::Csv(lines) => lines.add(answers, pose, row, text),
            Self::Json(lines) => lines.add(answers, pose, row, text),
        }
    }

    /// Adds the line of a file without positions.
    fn add_without_pose(&self, answers: &Answers<'_>, text: &mut Vec<u8>) {
        match self {
            Self::Csv(lines) => lines.add_without_pose(answers, text),
            Self::Json(lines) => lines.add_without_pose(answers, text),
        }
    }
}

struct Out<'p, 'o, 'w> {
    lines: Lines,
    /// The lines show angles.
    angles: bool,
    text: Vec<u8>,
    /// Of blocks, until they are written: while the next ones are solved.
    texts: Vec<Vec<u8>>,
    /// A position has a meaning.
    begun: bool,
    any: bool,
    failed: bool,
    printer: &'p mut Printer<'o>,
    threads: &'p Threads,
    watch: &'w Watch<'w>,
}

impl Sink for Out<'_, '_, '_> {
    fn conduct(&self) -> Conduct<'_> {
        Conduct { watch: Some(self.watch), ..Conduct::default() }
    }

    /// `false` where nothing more can be written.
    fn add(&mut self, answers: &Answers<'_>, pose: &Pose) -> bool {
        self.any = true;
        self.begun |= pose.outcome.is_ok() || pose.failure().is_some();
        self.lines.begin(answers, Some(pose));
        self.lines.add(answers, pose, &mut Vec::new(), &mut self.text);
        if self.text.len() >= if self.begun { PIECE } else { HELD } {
            self.flush();
        }
        !self.failed
    }

    fn forgets(&self) -> bool {
        true
    }

    fn blocks(&self) -> usize {
        self.threads.blocks()
    }

    fn solve(&mut self, ahead: &Ahead<'_>, blocks: &mut [Block]) {
        // CSV shows no residuals
        let ahead = if matches!(self.lines, Lines::Csv(_)) { ahead.without_residuals() } else { *ahead };
        let threads = self.threads;
        threads.solve_while(&ahead, blocks, || self.print_texts());
    }

    fn add_blocks(&mut self, answers: &Answers<'_>, ahead: &Ahead<'_>, blocks: &mut [Block]) -> bool {
        (self.any, self.begun) = (true, true);
        if let Some(first) = blocks.first_mut() {
            ahead.answer(first, self.angles);
            self.lines.begin(answers, first.poses().first());
        }
        self.flush();
        self.texts.resize_with(blocks.len(), Vec::new);
        let (lines, angles) = (&self.lines, self.angles);
        let mut work: Vec<(&mut Block, &mut Vec<u8>)> = blocks.iter_mut().zip(&mut self.texts).collect();
        self.threads.each(&mut work, |(_, (block, text))| {
            ahead.answer(block, angles);
            let mut row = Vec::new();
            let poses = block.poses().iter().filter(|pose| pose.is_position());
            poses.for_each(|pose| lines.add(answers, pose, &mut row, text));
        });
        !self.failed
    }
}

impl Out<'_, '_, '_> {
    /// Writes what is left; what needs no pose where there is none.
    fn end(&mut self, solved: &Solved) {
        if !self.any {
            let answers = solved.answers(Precision::READABLE);
            self.lines.begin(&answers, None);
            self.lines.add_without_pose(&answers, &mut self.text);
        }
        self.flush();
    }

    fn flush(&mut self) {
        self.print_texts();
        self.failed |= !self.printer.print(&self.text);
        self.text.clear();
    }

    /// Writes the texts of blocks that are not written yet.
    fn print_texts(&mut self) {
        for text in &mut self.texts {
            self.failed |= !self.printer.print(&*text);
            text.clear();
        }
    }
}
