//! Positions made into columns.

use super::columns::{Column, Columns, PoseFailure, Residuals, Values, WrittenUnit};
use super::in_order::{each, in_order};
use super::workers::Workers;
use crate::pipeline::Sink;
use crate::report::rows::AnswerColumns;
use crate::report::{Answers, NumberField, NumberRows};
use assur_solve::message::failure;
use assur_solve::solve::{
    BLOCK, Block, FreeSweep, IntegrationOptions, Model, Pose, PoseOutputs, Progress, finite,
};
use miette::Diagnostic;
use std::sync::{Arc, Mutex, PoisonError};

/// Positions there is room for at first.
const FIRST: usize = 16;
/// Residuals and condition.
const OWN: usize = 4;
/// Blocks of positions that a thread works on at a time; then the workers are asked whether to go on.
const BLOCKS: usize = 64;

/// The columns of a text without a position yet.
#[derive(Clone, Debug)]
pub(super) struct Blank {
    columns: Columns,
    rows: NumberRows,
    /// They show angles.
    angles: bool,
}

/// Takes positions and makes columns of them.
pub(super) struct Filling<'w> {
    columns: Columns,
    rows: NumberRows,
    angles: bool,
    /// The numbers of one column after another, of the answers first.
    memory: Vec<f64>,
    /// How many positions there is room for.
    room: usize,
    row: Vec<f64>,
    workers: &'w dyn Workers,
    watch: &'w Progress<'w>,
    /// The workers wanted to go on so far.
    pub goes_on: bool,
}

impl Blank {
    pub fn of(model: &Model<'_>) -> Self {
        let written = AnswerColumns::of_file(model).each_once();
        let in_units = written.fields(model.mechanism);
        let si = written.in_si();
        let column = |(si, written): (NumberField, NumberField)| Column {
            name: si.name,
            unit: si.display.unit,
            written: WrittenUnit::of(written.display),
            condition: si.condition,
            values: Values::default(),
        };
        let columns = si.fields(model.mechanism).into_iter().zip(in_units).map(column).collect();
        let columns = Columns { pose_header: si.pose_header().to_owned(), columns, ..Columns::default() };
        let rows = NumberRows::of(si);
        let angles = rows.reads_angles(model);
        Self { columns, rows, angles }
    }
}

impl<'w> Filling<'w> {
    pub fn of(blank: Blank, workers: &'w dyn Workers, watch: &'w Progress<'w>) -> Self {
        let Blank { columns, rows, angles } = blank;
        let (memory, row) = (Vec::new(), Vec::new());
        Self { columns, rows, angles, memory, room: 0, row, workers, watch, goes_on: true }
    }

    /// Makes room for positions: fresh memory comes from the system when it is written.
    pub fn make_room(&mut self, count: usize) {
        if count <= self.room {
            return;
        }
        let (len, width) = (self.columns.len, self.columns.columns.len() + OWN);
        let mut memory = vec![0.0; count * width];
        if len > 0 {
            let old = self.memory.chunks(self.room);
            memory.chunks_mut(count).zip(old).for_each(|(new, old)| new[..len].copy_from_slice(&old[..len]));
        }
        (self.memory, self.room) = (memory, count);
    }

    /// Adds the one row of a text without positions.
    pub fn add_without_pose(&mut self, answers: &Answers<'_>) {
        self.rows.read_without_pose(answers, &mut self.row);
        self.push([f64::NAN; OWN]);
        self.columns.names.push((0, String::new()));
    }

    pub fn end(self) -> Columns {
        let Self { mut columns, memory, room, .. } = self;
        let (memory, len) = (Arc::new(memory), columns.len);
        let mut each = (0..).map(|i| Values::of(Arc::clone(&memory), i * room, len));
        let mut next = || each.next().unwrap_or_default();
        columns.columns.iter_mut().for_each(|column| column.values = next());
        columns.residuals = Residuals { closure: next(), equilibrium: next(), power: next() };
        columns.condition = next();
        columns
    }

    pub const fn is_empty(&self) -> bool {
        self.columns.len == 0
    }

    /// Adds the row that was read.
    fn push(&mut self, quality: [f64; OWN]) {
        let len = self.columns.len;
        if len == self.room {
            self.make_room((2 * len).max(FIRST));
        }
        let all = self.row.iter().copied().chain(quality).map(finite);
        self.memory.chunks_mut(self.room).zip(all).for_each(|(values, x)| values[len] = x);
        self.columns.len += 1;
    }

    /// Adds the name of a position, or why it has none.
    fn push_pose(&mut self, model: &Model<'_>, pose: &Pose) {
        let index = self.columns.len;
        if !is_number(&pose.name, index + 1) {
            self.columns.names.push((index, pose.name.clone()));
        }
        if let Err(why) = &pose.outcome {
            let why = failure(model, why);
            let (code, message) = (why.code().map(|code| code.to_string()), why.to_string());
            self.columns.failures.push(PoseFailure { index, code, message });
        }
    }
}

/// Residuals and condition of a position.
fn quality(pose: &Pose) -> [f64; OWN] {
    let Ok(solved) = &pose.outcome else { return [f64::NAN; OWN] };
    let or_none = |x: Option<f64>| x.unwrap_or(f64::NAN);
    let residuals = &solved.residuals;
    [residuals.closure, or_none(residuals.equilibrium), or_none(residuals.power), solved.condition]
}

impl Sink for Filling<'_> {
    fn conduct(&self) -> IntegrationOptions<'_> {
        IntegrationOptions { watch: Some(self.watch), ..IntegrationOptions::default() }
    }

    fn add(&mut self, answers: &Answers<'_>, pose: &Pose) -> bool {
        if !pose.is_position() {
            return true;
        }
        self.rows.begin(answers);
        self.rows.read(answers, pose, &mut self.row);
        self.push_pose(&answers.model, pose);
        self.push(quality(pose));
        self.goes_on = !self.columns.len.is_multiple_of(BLOCK) || self.workers.goes_on();
        self.goes_on
    }

    fn forgets(&self) -> bool {
        true
    }

    fn reads(&self, _: &Model<'_>) -> PoseOutputs {
        PoseOutputs { residuals: true, angles: self.angles }
    }

    fn each(&self, count: usize, work: &(dyn Fn(usize) + Sync)) {
        each(self.workers, count, work);
    }

    fn add_sweep(&mut self, answers: &Answers<'_>, sweep: &FreeSweep<'_>) -> bool {
        self.rows.begin(answers);
        let first = self.columns.len;
        self.make_room(first + sweep.count());
        let Self { columns, rows, memory, room, workers, .. } = self;
        let (size, pieces) = (BLOCKS * BLOCK, sweep.blocks().div_ceil(BLOCKS));
        // where the numbers of each piece go, column by column
        let mut places: Vec<Vec<&mut [f64]>> = (0..pieces).map(|_| Vec::new()).collect();
        for column in memory.chunks_mut(*room) {
            let parts = column[first..first + sweep.count()].chunks_mut(size);
            places.iter_mut().zip(parts).for_each(|(places, part)| places.push(part));
        }
        let places: Vec<_> = places.into_iter().map(Mutex::new).collect();
        let work = |number: usize, (block, row): &mut (Block, Vec<f64>)| {
            let mut places = places[number].lock().unwrap_or_else(PoisonError::into_inner);
            let blocks = number * BLOCKS..((number + 1) * BLOCKS).min(sweep.blocks());
            for (i, number) in blocks.enumerate() {
                sweep.solve(number, block);
                for (j, pose) in block.poses().iter().enumerate() {
                    rows.read(answers, pose, row);
                    let cells = row.iter().copied().chain(quality(pose)).map(finite);
                    places.iter_mut().zip(cells).for_each(|(column, x)| column[i * BLOCK + j] = x);
                }
            }
        };
        let goes_on = in_order(*workers, pieces, &Default::default, work, |_| workers.goes_on());
        columns.len += sweep.count();
        self.goes_on = goes_on;
        goes_on
    }
}

/// Whether a name is a number in figures.
fn is_number(name: &str, number: usize) -> bool {
    let mut rest = number;
    let figures = name.bytes().rev().all(|figure| {
        let same = rest > 0 && figure == b'0' + u8::try_from(rest % 10).unwrap_or(u8::MAX);
        rest /= 10;
        same
    });
    figures && rest == 0
}
