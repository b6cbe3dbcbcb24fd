//! `assur solve` position by position: each is written and forgotten. Where none depends on another they are solved and written
//! on several threads, in their order.

use super::args::Format;
use super::motion::MotionProgress;
use super::reply::{Printer, Reply, Status};
use super::screen::Screen;
use super::threads::Threads;
use crate::front::stages::{InOrder, Stages, work};
use crate::pipeline::{Compiled, Sink, Solved, is_long};
use crate::report::json::JsonLines;
use crate::report::lines::{CsvLines, LineMemory};
use crate::report::{Answers, PrintedDigits};
use assur_solve::solve::{BLOCK, Block, IntegrationOptions, Method, Pose, UpcomingPositions};
use assur_text::diagnostic::Problems;
use assur_text::source::Source;

/// Text is written in pieces of this size.
const PIECE: usize = 1 << 16;
/// What is held back at the most while no position has closed yet: where none does, the file has no answers.
const HELD: usize = 1 << 25;
/// Positions that a thread solves, or writes, at once: what they hold stays in its cache.
const PIECES: usize = 2 * BLOCK;

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
    let lines = match format {
        Format::Csv => Lines::Csv(CsvLines::of(&compiled.model(), file)),
        _ => Lines::Json(JsonLines::of(source.name.clone())),
    };
    // of few positions nothing is printed where one makes all of them meaningless
    let held = (format == Format::Csv && !is_long(&compiled.model())).then(Vec::new);
    let text = if let Lines::Csv(lines) = &lines { lines.header() } else { String::new() }.into_bytes();
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

    /// Whether all of it is found that is looked for.
    const fn have_begun(&self) -> bool {
        match self {
            Self::Csv(lines) => lines.has_begun(),
            Self::Json(lines) => lines.has_begun(),
        }
    }

    /// Whether they show angles.
    fn show_angles(&self, answers: &Answers<'_>) -> bool {
        match self {
            Self::Csv(lines) => lines.reads_angles(&answers.model),
            Self::Json(lines) => lines.shows_angles(),
        }
    }

    /// Adds the line of a position.
    fn add(&self, answers: &Answers<'_>, pose: &Pose, memory: &mut LineMemory, text: &mut Vec<u8>) {
        match self {
            Self::Csv(lines) => lines.add(answers, pose, memory, text),
            Self::Json(lines) => lines.add(answers, pose, memory, text),
        }
    }

    /// Adds the lines of positions side by side from their numbers alone; `false`, and nothing, where that is not all.
    fn add_block(&self, block: &Block, memory: &mut LineMemory, text: &mut Vec<u8>) -> bool {
        match self {
            Self::Csv(lines) => lines.add_block(block, memory, text),
            Self::Json(lines) => lines.add_block(block, memory, text),
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
        self.lines.add(answers, pose, &mut LineMemory::default(), &mut self.text);
        if self.text.len() >= if self.begun { PIECE } else { HELD } {
            self.flush();
        }
        !self.failed
    }

    fn forgets(&self) -> bool {
        true
    }

    fn add_side_by_side(
        &mut self,
        answers: &Answers<'_>,
        ahead: &UpcomingPositions<'_>,
        take: &mut dyn FnMut(&mut Block) -> bool,
    ) -> bool {
        // CSV shows no residuals
        let ahead = if matches!(self.lines, Lines::Csv(_)) { ahead.without_residuals() } else { *ahead };
        (self.any, self.begun) = (true, true);
        self.flush();
        let (mut from, mut block) = (0, Block::default());
        while from < ahead.count() && !self.lines.have_begun() {
            ahead.solve(&mut block, from);
            let whole = take(&mut block);
            ahead.answer(&mut block, true);
            self.lines.begin(answers, block.poses().first());
            write(&self.lines, answers, &block, (&mut LineMemory::default(), &mut self.text));
            if !whole {
                return !self.failed;
            }
            from += BLOCK;
        }
        self.flush();
        let ahead = ahead.behind(from);
        let Self { lines, printer, held, .. } = self;
        let stages = Writing { lines, answers, ahead, angles: lines.show_angles(answers) };
        let goes_on = work(
            self.threads,
            ahead.count().div_ceil(PIECES),
            &stages,
            &mut Printing { take, held, printer },
        );
        self.failed |= !goes_on;
        goes_on
    }
}

/// Positions that are solved, and then written.
struct Writing<'w> {
    lines: &'w Lines,
    answers: &'w Answers<'w>,
    ahead: UpcomingPositions<'w>,
    angles: bool,
}

/// Positions with their lines.
#[derive(Default)]
struct Piece {
    blocks: Vec<Block>,
    text: Vec<u8>,
    /// The text is that of the blocks.
    is_written: bool,
    memory: LineMemory,
}

impl Stages for Writing<'_> {
    type Piece = Piece;

    fn piece(&self) -> Piece {
        Piece::default()
    }

    fn begin(&self, number: usize, piece: &mut Piece) {
        let ahead = self.ahead.behind(number * PIECES);
        piece.text.clear();
        piece.blocks.resize_with(ahead.count().min(PIECES).div_ceil(BLOCK), Block::default);
        piece.is_written = !self.angles;
        for (i, block) in piece.blocks.iter_mut().enumerate() {
            ahead.solve(block, i * BLOCK);
            // angles depend on the positions before: lines that show none are written while the states are at hand
            if piece.is_written {
                self.write(block, &mut piece.memory, &mut piece.text);
            }
        }
    }

    fn is_finished(&self, piece: &Piece) -> bool {
        piece.is_written
    }

    fn finish(&self, piece: &mut Piece) {
        piece.text.clear();
        for block in &mut piece.blocks {
            self.write(block, &mut piece.memory, &mut piece.text);
        }
    }
}

impl Writing<'_> {
    /// Adds the lines of a block.
    fn write(&self, block: &mut Block, memory: &mut LineMemory, text: &mut Vec<u8>) {
        if !self.lines.add_block(block, memory, text) {
            self.ahead.answer(block, self.angles);
            write(self.lines, self.answers, block, (memory, text));
        }
    }
}

/// Takes positions over, and prints their lines.
struct Printing<'t, 'p, 'o> {
    take: &'t mut dyn FnMut(&mut Block) -> bool,
    held: &'t mut Option<Vec<u8>>,
    printer: &'p mut Printer<'o>,
}

impl InOrder<Piece> for Printing<'_, '_, '_> {
    fn between(&mut self, piece: &mut Piece) -> bool {
        for i in 0..piece.blocks.len() {
            let solved = piece.blocks[i].len();
            let whole = (self.take)(&mut piece.blocks[i]);
            let is_last = i + 1 == piece.blocks.len();
            piece.is_written &= piece.blocks[i].len() == solved && (whole || is_last);
            if !whole {
                piece.blocks.truncate(i + 1);
                return false;
            }
        }
        true
    }

    fn end(&mut self, piece: &mut Piece) -> bool {
        print(&piece.text, self.held, self.printer)
    }
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

/// Adds the lines of positions that were answered.
fn write(
    lines: &Lines,
    answers: &Answers<'_>,
    block: &Block,
    (memory, text): (&mut LineMemory, &mut Vec<u8>),
) {
    let poses = block.poses().iter().filter(|pose| pose.is_position());
    poses.for_each(|pose| lines.add(answers, pose, memory, text));
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
