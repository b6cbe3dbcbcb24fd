//! The answers of many positions as columns of numbers.

use super::diagnostics::Diagnostics;
use super::solution::Expectation;
use super::workers::{Workers, each_of};
use crate::pipeline::Sink;
use crate::report::rows::AnswerColumns;
use crate::report::{Answers, NumberField, NumberRows};
use assur_solve::message::failure;
use assur_solve::solve::{self, Ahead, BLOCK, Block, Conduct, Model, Pose, Watch};
use miette::Diagnostic;

/// The answers of all positions, column by column, SI and radians. NaN where a position has no answer.
#[derive(Clone, Debug, Default)]
pub struct Columns {
    /// What heads the names of positions: `pose`, or that of instants.
    pub pose_header: String,
    /// How many positions there are.
    pub len: usize,
    /// Names of positions that are not their number, counted from 1, with the index of the position.
    pub names: Vec<(usize, String)>,
    /// The columns: drives, what is asked for, reactions.
    pub columns: Vec<Column>,
    /// The residuals of independent equations.
    pub residuals: Residuals,
    /// The least condition figure of all groups, in (0, 1].
    pub condition: Vec<f64>,
    /// The positions without a solution.
    pub failures: Vec<PoseFailure>,
    /// The expectations of the text, if the positions are its own.
    pub expectations: Vec<Expectation>,
    /// Warnings and errors.
    pub diagnostics: Diagnostics,
}

/// A column of numbers.
#[derive(Clone, Debug)]
pub struct Column {
    /// Its name, with `.x` or `.y` for a component of a vector.
    pub name: String,
    /// Its SI unit; empty for plain numbers.
    pub unit: String,
    /// The author's unit.
    pub written: WrittenUnit,
    /// It shows a condition: 1 is true, 0 false.
    pub condition: bool,
    /// Its numbers in SI.
    pub values: Vec<f64>,
}

/// A unit of the author.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WrittenUnit(assur_model::model::Display);

impl WrittenUnit {
    pub(super) const fn of(display: assur_model::model::Display) -> Self {
        Self(display)
    }

    /// Its spelling; empty for plain numbers.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.0.unit
    }

    /// A number of SI units in this unit.
    #[must_use]
    pub fn of_si(&self, si: f64) -> f64 {
        self.0.of_si(si)
    }
}

/// Residuals, position by position. NaN where there are none: without forces, without speeds.
#[derive(Clone, Debug, Default)]
pub struct Residuals {
    /// Worst mismatch of the pairs over the size of the mechanism.
    pub closure: Vec<f64>,
    /// Worst equilibrium of a link over the greatest force.
    pub equilibrium: Vec<f64>,
    /// Sum of the powers over the greatest force times the greatest velocity.
    pub power: Vec<f64>,
}

/// A position without a solution.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PoseFailure {
    /// Its index, from 0.
    pub index: usize,
    /// `mech::<stage>::<what_is_wrong>`
    pub code: Option<String>,
    /// The reason.
    pub message: String,
}

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
    row: Vec<f64>,
    pieces: Vec<Piece>,
    workers: &'w dyn Workers,
    watch: &'w Watch<'w>,
    /// The workers wanted to go on so far.
    pub goes_on: bool,
}

/// The numbers of a block of positions.
#[derive(Default)]
struct Piece {
    /// The index of its first position.
    first: usize,
    row: Vec<f64>,
    /// Column by column.
    cells: Vec<Vec<f64>>,
    quality: Vec<[f64; 4]>,
    /// Names of positions that are not their number.
    names: Vec<(usize, String)>,
}

impl Blank {
    pub fn of(model: &Model<'_>) -> Self {
        let written = AnswerColumns::of_file(model).each_once();
        let in_units = written.fields(model.mechanism);
        let si = written.in_si();
        let column = |(si, written): (NumberField, NumberField)| Column {
            name: si.name,
            unit: si.display.unit,
            written: WrittenUnit(written.display),
            condition: si.condition,
            values: Vec::new(),
        };
        let columns = si.fields(model.mechanism).into_iter().zip(in_units).map(column).collect();
        let columns = Columns { pose_header: si.pose_header().to_owned(), columns, ..Columns::default() };
        let rows = NumberRows::of(si);
        let angles = rows.reads_angles(model);
        Self { columns, rows, angles }
    }
}

impl<'w> Filling<'w> {
    pub fn of(blank: Blank, workers: &'w dyn Workers, watch: &'w Watch<'w>) -> Self {
        let Blank { columns, rows, angles } = blank;
        Self { columns, rows, angles, row: Vec::new(), pieces: Vec::new(), workers, watch, goes_on: true }
    }

    /// Makes room for positions.
    pub fn reserve(&mut self, count: usize) {
        let Residuals { closure, equilibrium, power } = &mut self.columns.residuals;
        let own = [closure, equilibrium, power, &mut self.columns.condition];
        let all = self.columns.columns.iter_mut().map(|column| &mut column.values).chain(own);
        all.for_each(|values| values.reserve_exact(count));
    }

    /// Adds the one row of a text without positions.
    pub fn add_without_pose(&mut self, answers: &Answers<'_>) {
        self.rows.read_without_pose(answers, &mut self.row);
        self.push_row();
        self.push_quality(&[f64::NAN; 4]);
        self.columns.names.push((0, String::new()));
        self.columns.len = 1;
    }

    pub fn end(self) -> Columns {
        self.columns
    }

    pub const fn is_empty(&self) -> bool {
        self.columns.len == 0
    }

    fn push_row(&mut self) {
        for (column, x) in self.columns.columns.iter_mut().zip(&self.row) {
            column.values.push(finite(*x));
        }
    }

    /// Adds name, residuals and condition of a position, or why it has none.
    fn push_pose(&mut self, model: &Model<'_>, pose: &Pose) {
        let index = self.columns.len;
        self.columns.names.extend(other_name(pose, index));
        self.push_quality(&pose_quality(pose));
        if let Err(why) = &pose.outcome {
            let why = failure(model, why);
            let (code, message) = (why.code().map(|code| code.to_string()), why.to_string());
            self.columns.failures.push(PoseFailure { index, code, message });
        }
        self.columns.len += 1;
    }

    fn push_quality(&mut self, [closure, equilibrium, power, condition]: &[f64; 4]) {
        let residuals = &mut self.columns.residuals;
        residuals.closure.push(*closure);
        residuals.equilibrium.push(*equilibrium);
        residuals.power.push(*power);
        self.columns.condition.push(*condition);
    }

    /// Adds what was found of a block.
    fn push_piece(&mut self, piece: &mut Piece) {
        for (column, cells) in self.columns.columns.iter_mut().zip(&piece.cells) {
            column.values.extend_from_slice(cells);
        }
        piece.quality.iter().for_each(|quality| self.push_quality(quality));
        self.columns.names.append(&mut piece.names);
        self.columns.len += piece.quality.len();
    }
}

/// Residuals and condition of a position.
fn pose_quality(pose: &Pose) -> [f64; 4] {
    let Ok(solved) = &pose.outcome else { return [f64::NAN; 4] };
    quality(&solved.residuals, solved.condition)
}

fn quality(residuals: &solve::Residuals, condition: f64) -> [f64; 4] {
    let or_none = |x: Option<f64>| x.unwrap_or(f64::NAN);
    let all = [residuals.closure, or_none(residuals.equilibrium), or_none(residuals.power), condition];
    all.map(finite)
}

/// The name of a position where it is not its number, with its index.
fn other_name(pose: &Pose, index: usize) -> Option<(usize, String)> {
    (!is_number(&pose.name, index + 1)).then(|| (index, pose.name.clone()))
}

impl Sink for Filling<'_> {
    fn conduct(&self) -> Conduct<'_> {
        Conduct { watch: Some(self.watch), ..Conduct::default() }
    }

    fn add(&mut self, answers: &Answers<'_>, pose: &Pose) -> bool {
        if !pose.is_position() {
            return true;
        }
        self.rows.begin(answers);
        self.rows.read(answers, pose, &mut self.row);
        self.push_row();
        self.push_pose(&answers.model, pose);
        self.goes_on = !self.columns.len.is_multiple_of(BLOCK) || self.workers.goes_on();
        self.goes_on
    }

    fn forgets(&self) -> bool {
        true
    }

    fn blocks(&self) -> usize {
        self.workers.pieces()
    }

    fn solve(&mut self, ahead: &Ahead<'_>, blocks: &mut [Block]) {
        each_of(self.workers, blocks, |i, block| ahead.solve(block, i * BLOCK));
    }

    fn add_blocks(&mut self, answers: &Answers<'_>, ahead: &Ahead<'_>, blocks: &mut [Block]) -> bool {
        self.rows.begin(answers);
        let (rows, angles, width) = (&self.rows, self.angles, self.columns.columns.len());
        let mut pieces = std::mem::take(&mut self.pieces);
        pieces.resize_with(blocks.len(), Piece::default);
        let mut first = self.columns.len;
        for (piece, block) in pieces.iter_mut().zip(&*blocks) {
            piece.first = first;
            first += block.len();
        }
        let mut work: Vec<(&mut Block, &mut Piece)> = blocks.iter_mut().zip(&mut pieces).collect();
        each_of(self.workers, &mut work, |_, (block, piece)| {
            piece.clear(width);
            if let Some(columns) = rows.wide() {
                block.read(columns, &mut piece.cells);
                piece
                    .quality
                    .extend(block.quality(&answers.model).map(|(r, condition)| quality(&r, condition)));
            } else {
                ahead.answer(block, angles);
                piece.fill(answers, rows, block.poses());
            }
        });
        pieces.iter_mut().for_each(|piece| self.push_piece(piece));
        self.pieces = pieces;
        self.goes_on = self.workers.goes_on();
        self.goes_on
    }
}

impl Piece {
    fn clear(&mut self, width: usize) {
        self.cells.resize_with(width, Vec::new);
        self.cells.iter_mut().for_each(Vec::clear);
        self.quality.clear();
    }

    fn fill(&mut self, answers: &Answers<'_>, rows: &NumberRows, poses: &[Pose]) {
        for (i, pose) in poses.iter().enumerate() {
            rows.read(answers, pose, &mut self.row);
            self.cells.iter_mut().zip(&self.row).for_each(|(cells, x)| cells.push(finite(*x)));
            self.quality.push(pose_quality(pose));
            self.names.extend(other_name(pose, self.first + i));
        }
    }
}

/// An answer that is not a number does not exist.
const fn finite(x: f64) -> f64 {
    if x.is_finite() { x } else { f64::NAN }
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
