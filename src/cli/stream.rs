//! `assur solve` position by position: each is written and forgotten. Where none depends on another they are solved and written
//! on several threads, in their order.

use super::args::Format;
use super::motion::MotionProgress;
use super::reply::{Printer, Reply, Status};
use super::screen::Screen;
use super::threads::Threads;
use crate::front::in_order::{each, in_order};
use crate::pipeline::{Compiled, Sink, Solved, is_long};
use crate::report::json::JsonLines;
use crate::report::lines::{CsvLines, PoseLines};
use crate::report::{Answers, PrintedDigits};
use assur_solve::solve::{Block, FreeSweep, IntegrationOptions, Method, Model, Pose, PoseOutputs};
use assur_text::diagnostic::Problems;
use assur_text::source::Source;

/// Text is written in pieces of this size.
const PIECE: usize = 1 << 16;
/// What is held back at the most while no position has closed yet: where none does, the file has no answers.
const HELD: usize = 1 << 25;
/// Blocks of positions that a thread solves and writes at once.
const BLOCKS: usize = 4;

/// Writes all positions of a file; in CSV after its name, if one is given.
pub fn positions(
    (format, file): (Format, Option<&str>),
    source: &Source,
    compiled: Compiled,
    mut problems: Problems,
    screen: &Screen,
    (printer, threads): (&mut Printer<'_>, &Threads),
    method: Option<Method>,
) -> Reply {
    let lines: Box<dyn PoseLines> = match format {
        Format::Csv => Box::new(CsvLines::of(&compiled.model(), file)),
        _ => Box::new(JsonLines::of(source.name.clone())),
    };
    // of few positions nothing is printed where one makes all of them meaningless
    let held = (format == Format::Csv && !is_long(&compiled.model())).then(Vec::new);
    let text = lines.header().into_bytes();
    let way = MotionProgress::of(&source.name, &compiled.mechanism);
    let watch = |reached: f64, last: f64| way.as_ref().is_none_or(|w| w.goes_on(reached, last));
    let conduct = IntegrationOptions { watch: Some(&watch), method, ..IntegrationOptions::default() };
    let (begun, any, failed) = (false, false, false);
    let mut out = Out { lines, text, held, begun, any, failed, printer, threads, conduct };
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

struct Out<'p, 'o, 'w> {
    lines: Box<dyn PoseLines>,
    text: Vec<u8>,
    /// What is printed once all is known, where that is wanted.
    held: Option<Vec<u8>>,
    /// A position has a meaning.
    begun: bool,
    any: bool,
    failed: bool,
    printer: &'p mut Printer<'o>,
    threads: &'p Threads,
    conduct: IntegrationOptions<'w>,
}

impl Sink for Out<'_, '_, '_> {
    fn conduct(&self) -> IntegrationOptions<'_> {
        self.conduct
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

    fn reads(&self, model: &Model<'_>) -> PoseOutputs {
        self.lines.reads(model)
    }

    fn each(&self, count: usize, work: &(dyn Fn(usize) + Sync)) {
        each(self.threads, count, work);
    }

    fn add_sweep(&mut self, answers: &Answers<'_>, sweep: &FreeSweep<'_>) -> bool {
        (self.any, self.begun) = (true, true);
        self.flush();
        let mut block = Block::default();
        sweep.solve(0, &mut block);
        block.poses().iter().for_each(|pose| self.lines.begin(answers, Some(pose)));
        let Self { lines, printer, held, threads, .. } = self;
        let lines = &*lines;
        let work = |number: usize, piece: &mut Piece| {
            piece.text.clear();
            for block in number * BLOCKS..((number + 1) * BLOCKS).min(sweep.blocks()) {
                sweep.solve(block, &mut piece.block);
                let poses = piece.block.poses().iter().filter(|pose| pose.is_position());
                poses.for_each(|pose| lines.add(answers, pose, &mut piece.row, &mut piece.text));
            }
        };
        let pieces = sweep.blocks().div_ceil(BLOCKS);
        let hand_out = |piece: &mut Piece| print(&piece.text, held, printer);
        let goes_on = in_order(*threads, pieces, &Piece::default, work, hand_out);
        self.failed |= !goes_on;
        goes_on
    }
}

/// Positions with their lines.
#[derive(Default)]
struct Piece {
    block: Block,
    text: Vec<u8>,
    row: Vec<f64>,
}

/// Prints lines, or holds them back.
fn print(text: &[u8], held: &mut Option<Vec<u8>>, printer: &mut Printer<'_>) -> bool {
    match held {
        Some(held) => {
            held.extend_from_slice(text);
            true
        }
        None => printer.print(text),
    }
}

impl Out<'_, '_, '_> {
    /// Writes what is left; what needs no pose where there is none.
    fn end(&mut self, solved: &Solved) {
        if !self.any {
            let answers = solved.answers(PrintedDigits::READABLE);
            self.lines.begin(&answers, None);
            self.lines.add_without_pose(&answers, &mut self.text);
        }
        self.flush();
        if let Some(held) = self.held.take() {
            self.failed |= !self.printer.print(held);
        }
    }

    fn flush(&mut self) {
        self.failed |= !print(&self.text, &mut self.held, self.printer);
        self.text.clear();
    }
}
