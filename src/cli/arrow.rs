//! `assur solve --format arrow`: positions as a stream of columns.

use super::error::CliError;
use super::motion::MotionProgress;
use super::reply::{Printer, Reply, Status, complaint};
use super::screen::Screen;
use super::threads::Threads;
use crate::front::in_order::{each, in_order};
use crate::pipeline::{Compiled, Sink};
use crate::report::Answers;
use crate::report::arrow::ArrowRows;
use assur_solve::solve::{Block, FreeSweep, IntegrationOptions, Method, Model, Pose, PoseOutputs};
use assur_text::diagnostic::Problems;
use assur_text::source::Source;
use std::io::IsTerminal;

/// Why no stream can be written.
pub fn refusal(several: bool) -> Option<CliError> {
    match several {
        true => Some(CliError::OneStream),
        false => std::io::stdout()
            .is_terminal()
            .then_some(CliError::OnScreen { how: "`assur solve FILE --format arrow > answers.arrows`" }),
    }
}

/// Writes all positions of a file.
pub fn positions(
    source: &Source,
    compiled: Compiled,
    mut problems: Problems,
    screen: &Screen,
    (printer, threads): (&mut Printer<'_>, &Threads),
    method: Option<Method>,
) -> Reply {
    let unprinted = |why: String| {
        let diagnostics = complaint(CliError::Unprinted { why }, screen);
        Reply { diagnostics, status: Status::Unusable, ..Reply::default() }
    };
    let rows = match ArrowRows::of(&compiled.model()) {
        Ok(rows) => rows,
        Err(error) => return unprinted(error.to_string()),
    };
    let way = MotionProgress::of(&source.name, &compiled.mechanism);
    let watch = |reached: f64, last: f64| way.as_ref().is_none_or(|w| w.goes_on(reached, last));
    let conduct = IntegrationOptions { watch: Some(&watch), method, ..IntegrationOptions::default() };
    let mut out = Out { rows, error: None, failed: false, printer, threads, conduct };
    let (_, found) = crate::pipeline::solve_each(compiled, &mut out);
    problems.append(found);
    let ended = out.rows.end();
    out.error = out.error.take().or(ended.err().map(|error| error.to_string()));
    out.print();
    match out.error {
        Some(why) => unprinted(why),
        None if out.failed => Reply { status: Status::Unusable, ..Reply::default() },
        None => Reply::new(String::new(), &problems, source, screen),
    }
}

struct Out<'p, 'o, 'w> {
    rows: ArrowRows,
    error: Option<String>,
    failed: bool,
    printer: &'p mut Printer<'o>,
    threads: &'p Threads,
    conduct: IntegrationOptions<'w>,
}

impl Sink for Out<'_, '_, '_> {
    fn conduct(&self) -> IntegrationOptions<'_> {
        self.conduct
    }

    fn add(&mut self, answers: &Answers<'_>, pose: &Pose) -> bool {
        self.error = self.rows.add(answers, pose).err().map(|error| error.to_string());
        self.print();
        self.error.is_none() && !self.failed
    }

    fn forgets(&self) -> bool {
        true
    }

    fn reads(&self, model: &Model<'_>) -> PoseOutputs {
        PoseOutputs { residuals: false, angles: self.rows.reads_angles(model) }
    }

    fn each(&self, count: usize, work: &(dyn Fn(usize) + Sync)) {
        each(self.threads, count, work);
    }

    fn add_sweep(&mut self, answers: &Answers<'_>, sweep: &FreeSweep<'_>) -> bool {
        let solve = |number: usize, block: &mut Block| sweep.solve(number, block);
        in_order(self.threads, sweep.blocks(), &Block::default, solve, |block| {
            block.poses().iter().filter(|pose| pose.is_position()).all(|pose| self.add(answers, pose))
        })
    }
}

impl Out<'_, '_, '_> {
    fn print(&mut self) {
        let written = self.rows.take();
        self.failed |= !written.is_empty() && !self.printer.print(written);
    }
}
