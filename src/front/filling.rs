//! Positions made into columns.

use super::columns::{Column, Columns, PoseFailure, WrittenUnit};
use super::side_by_side::SideBySide;
use super::workers::Workers;
use crate::pipeline::Sink;
use crate::report::rows::AnswerColumns;
use crate::report::{Answers, NumberField, NumberRows};
use assur_solve::message::failure;
use assur_solve::solve::{Ahead, BLOCK, Block, Conduct, Model, Pose, Watch, finite};
use miette::Diagnostic;

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
    workers: &'w dyn Workers,
    watch: &'w Watch<'w>,
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
        Self { columns, rows, angles, row: Vec::new(), workers, watch, goes_on: true }
    }

    /// Makes room for positions.
    pub fn reserve(&mut self, count: usize) {
        self.columns.all().for_each(|values| values.reserve_exact(count));
    }

    /// Adds the one row of a text without positions.
    pub fn add_without_pose(&mut self, answers: &Answers<'_>) {
        self.rows.read_without_pose(answers, &mut self.row);
        self.push([f64::NAN; 4]);
        self.columns.names.push((0, String::new()));
    }

    pub fn end(mut self) -> Columns {
        let len = self.columns.len;
        self.columns.all().for_each(|values| values.truncate(len));
        self.columns
    }

    pub const fn is_empty(&self) -> bool {
        self.columns.len == 0
    }

    /// Adds the row that was read.
    fn push(&mut self, quality: [f64; 4]) {
        let len = self.columns.len;
        let all = self.row.iter().copied().chain(quality).map(finite);
        for (values, x) in self.columns.all().zip(all) {
            match values.get_mut(len) {
                Some(place) => *place = x,
                None => values.push(x),
            }
        }
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

    /// Makes every column so long: fresh memory comes from the system when it is written.
    fn lay_out(&mut self, count: usize) {
        let len = self.columns.len;
        for values in self.columns.all().filter(|values| values.len() < count) {
            let mut longer = vec![0.0; count];
            longer[..len].copy_from_slice(&values[..len]);
            *values = longer;
        }
    }
}

/// Residuals and condition of a position.
fn quality(pose: &Pose) -> [f64; 4] {
    let Ok(solved) = &pose.outcome else { return [f64::NAN; 4] };
    let or_none = |x: Option<f64>| x.unwrap_or(f64::NAN);
    let residuals = &solved.residuals;
    [residuals.closure, or_none(residuals.equilibrium), or_none(residuals.power), solved.condition]
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
        self.push_pose(&answers.model, pose);
        self.push(quality(pose));
        self.goes_on = !self.columns.len.is_multiple_of(BLOCK) || self.workers.goes_on();
        self.goes_on
    }

    fn forgets(&self) -> bool {
        true
    }

    fn add_side_by_side(
        &mut self,
        answers: &Answers<'_>,
        ahead: &Ahead<'_>,
        take: &mut dyn FnMut(&mut Block) -> bool,
    ) -> bool {
        self.rows.begin(answers);
        let first = self.columns.len;
        // the last position of a sweep is solved by itself
        self.lay_out(first + ahead.count() + 1);
        let Self { columns, rows, angles, workers, .. } = self;
        let places = columns.all().map(|values| &mut values[first..]).collect();
        let positions = SideBySide { answers, ahead: *ahead, rows, angles: *angles, workers: *workers };
        let (taken, goes_on) = positions.write(places, take);
        columns.len += taken;
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
