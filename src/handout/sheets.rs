//! Exercise sheets and their keys.

use super::lacks;
use super::places;
use super::texts::{for_all, names, names_a_column, numbers};
use super::{Handout, KINDS};
use crate::pipeline::{self, Compiled, Solved, VariantSolver};
use crate::report::rows::AnswerColumns;
use crate::report::{AnswerLine, Answers, PrintedDigits};
use assur_check::{self as check, FileRow, Overrides};
use assur_model::model::{Level, Value};
use assur_picture::Scene;
use assur_position::plan::Effects;
use assur_solve::solve::Pose;
use assur_syntax::document;
use assur_syntax::given::Given;
use assur_text::diagnostic::Problems;
use assur_worked::{Document, Exercise, Name, Variants, asks_for_positions, key, sheet};
use std::cell::Cell;
use std::sync::Arc;

/// Sheets of a file.
pub struct Sheets<'a> {
    pub handout: &'a Handout<'a>,
    /// The rows of the file's own table; the file as written where it has none.
    pub rows: Vec<Row>,
    /// What is wrong in the file and in the header of its table. With errors there is no sheet.
    pub problems: Problems,
    /// Numbers that the file gives outside of expectations and tables, SI.
    written: Vec<f64>,
}

/// The name and the unit of a column of variants.
type Column = (String, String);

/// A row of variants: its number, its name and its values.
pub struct Row {
    /// Counted from 1.
    pub number: usize,
    /// Its name where it has one.
    pub label: Option<String>,
    overrides: Overrides,
}

/// A row as an exercise, solved with all that pictures show, and the answers to what it asks.
pub(super) struct Made<'m> {
    pub exercise: &'m Exercise<'m>,
    pub drawn: &'m Solved,
    pub answers: &'m Answers<'m>,
}

impl<'m> Made<'m> {
    /// The position of a question by its name.
    pub fn pose(&self, name: &str) -> Option<&'m Pose> {
        let columns = AnswerColumns::of(&self.answers.model);
        columns.lines(self.answers, true).find(|line| line.name() == name)?.pose
    }
}

/// What a sheet is for: all rows, with their table, or one.
#[derive(Clone, Copy)]
enum Of<'r> {
    All(&'r [Row]),
    Row(Option<&'r Row>),
}

impl Row {
    #[must_use]
    pub const fn new(number: usize, label: Option<String>, overrides: Overrides) -> Self {
        Self { number, label, overrides }
    }

    /// Its name, or its number.
    #[must_use]
    pub fn name(&self) -> String {
        self.label.clone().unwrap_or_else(|| self.number.to_string())
    }

    /// Its number and its name: `2 (A2)`.
    fn words(&self) -> String {
        let number = self.number.to_string();
        match self.label.as_deref().filter(|label| **label != number) {
            Some(label) => format!("{number} ({label})"),
            None => number,
        }
    }
}

impl<'a> Sheets<'a> {
    /// Of a file; `found` is what was wrong in its text.
    #[must_use]
    pub fn of(handout: &'a Handout<'a>, found: Problems) -> Self {
        let written = numbers(&handout.document);
        let mut sheets = Self { handout, rows: Vec::new(), problems: found, written };
        let overrides = &handout.overrides;
        let row = |(i, row): (usize, FileRow)| Row {
            number: i + 1,
            label: row.label,
            overrides: Overrides { values: overrides.values.clone(), row: row.row },
        };
        sheets.rows = match sheets.file_rows() {
            Some(rows) => rows.into_iter().enumerate().map(row).collect(),
            None => vec![Row { number: 1, label: None, overrides: overrides.clone() }],
        };
        sheets
    }

    fn file_rows(&mut self) -> Option<Vec<FileRow>> {
        let table = check::table(&self.handout.document)?;
        let (columns, found) = check::columns(&self.handout.document, &self.handout.overrides, table);
        self.problems.append(found);
        let rows = check::file_rows(table, &columns?.into());
        (!rows.is_empty()).then_some(rows)
    }

    /// Of a file with these rows.
    #[must_use]
    pub fn of_rows(handout: &'a Handout<'a>, rows: Vec<Row>) -> Self {
        let written = numbers(&handout.document);
        Self { handout, rows, problems: Problems::new(), written }
    }

    /// One sheet, with the table of all variants.
    #[must_use]
    pub fn for_all(self) -> (Option<Document>, Problems) {
        let mut problems = self.problems.clone();
        let Some(first) = self.rows.first().filter(|_| !problems.has_errors()) else {
            return (None, problems);
        };
        let (compiled, found) = self.compiled_for_all(first);
        let table = check::table(&self.handout.document);
        let variants = || {
            let (columns, rows) = self.variants()?;
            let in_text = self.handout.document.notes.iter().any(|note| names_a_column(&note.node, table));
            Some(Variants { columns, rows, drawn_for: first.words(), in_text })
        };
        let sheet = |made: &Made<'_>, problems: &mut Problems| {
            let sheet = sheet(made.exercise, self.handout.language, variants());
            lacks::of(made.exercise, &sheet, self.handout.language, problems);
            Some(sheet)
        };
        let document = self.made(compiled, found, &mut problems, Of::All(&self.rows), sheet);
        (document, problems)
    }

    /// The file as its title and text are for all rows, with the values of the first.
    fn compiled_for_all(&self, first: &Row) -> (Option<Compiled>, Problems) {
        let names: Vec<String> = self.rows.iter().map(Row::name).collect();
        let for_all = Arc::new(for_all(&self.handout.document, &names));
        pipeline::compile_document(self.handout.source, &for_all, Problems::new(), &first.overrides)
    }

    /// The title for all rows; none where the file has none, or cannot be compiled.
    #[must_use]
    pub fn title(&self) -> Option<String> {
        let compiled = self.compiled_for_all(self.rows.first()?).0?;
        Some(compiled.mechanism.title).filter(|title| !title.is_empty())
    }

    /// The sheets of rows, one after another, each with what is wrong in it, until `goes_on` says no.
    pub fn each(&self, rows: &[Row], goes_on: impl FnMut(&Row, Option<Document>, Problems) -> bool) {
        // it is the same for all rows
        let is_first = Cell::new(true);
        let sheet = |made: &Made<'_>, problems: &mut Problems| {
            let sheet = sheet(made.exercise, self.handout.language, None);
            if is_first.replace(false) {
                lacks::of(made.exercise, &sheet, self.handout.language, problems);
            }
            Some(sheet)
        };
        self.each_made(rows, sheet, goes_on);
    }

    /// What is made of rows, one after another, each with what is wrong in it, until `goes_on` says no.
    pub(super) fn each_made<T>(
        &self,
        rows: &[Row],
        make: impl Fn(&Made<'_>, &mut Problems) -> Option<T>,
        mut goes_on: impl FnMut(&Row, Option<T>, Problems) -> bool,
    ) {
        let has_table = check::table(&self.handout.document).is_some();
        let values = Overrides { values: self.handout.overrides.values.clone(), ..Overrides::none() };
        let mut solver = VariantSolver::new(&self.handout.document, &values);
        for row in rows {
            let (compiled, found) = match solver.compile(&row.overrides.row) {
                (Some(compiled), found) if !found.has_errors() => (Some(compiled), found),
                // its messages are those of the file as a whole
                _ => self.compiled(&row.overrides),
            };
            let mut problems = Problems::new();
            let of = Of::Row(has_table.then_some(row));
            let made = self.made(compiled, found, &mut problems, of, &make);
            if !goes_on(row, made, problems) {
                break;
            }
        }
    }

    fn compiled(&self, overrides: &Overrides) -> (Option<Compiled>, Problems) {
        pipeline::compile_document(self.handout.source, &self.handout.document, Problems::new(), overrides)
    }

    /// What is made of a compiled row, for all rows or for it alone.
    fn made<T>(
        &self,
        compiled: Option<Compiled>,
        found: Problems,
        problems: &mut Problems,
        of: Of<'_>,
        make: impl FnOnce(&Made<'_>, &mut Problems) -> Option<T>,
    ) -> Option<T> {
        problems.append(found);
        let compiled = compiled.filter(|_| !problems.has_errors())?;
        let drawn = pipeline::planned_to_draw(compiled.clone(), &KINDS);
        let (solved, found) = pipeline::solve(drawn);
        problems.append(found);
        let solved = solved.ok().filter(|_| !problems.has_errors())?;
        let scene = self.scene(&solved, problems).ok()?;
        // pictures may show more than the file asks for
        let asked = Effects::at_least(&solved.compiled.mechanism, Level::Positions, false);
        let own = if asked == solved.compiled.plan.effects {
            None
        } else {
            Some(pipeline::solve(compiled).0.ok()?)
        };
        let asking = own.as_ref().unwrap_or(&solved);
        let answers = asking.answers(PrintedDigits::READABLE);
        let wanted = answers.poses().find(|pose| scene.is_some_and(|scene| scene.pose.name == pose.name));
        let mechanism = &solved.compiled.mechanism;
        let hides = mechanism.simulation.is_none() && asks_for_positions(mechanism);
        let other = scene
            .filter(|_| hides)
            .and_then(|scene| pipeline::elsewhere(&solved.compiled, &solved.solution, scene.pose));
        let shown =
            scene.map(|scene| match other.as_ref().and_then(|p| Some((p, p.outcome.as_ref().ok()?))) {
                Some((pose, solved)) => Scene { pose, solved, ..scene },
                None => scene,
            });
        let table = check::table(&self.handout.document);
        let rows = if let (Of::All(rows), Some(_)) = (of, table) { rows } else { &[] };
        let in_table = |name: &str| {
            !rows.is_empty() && table.is_some_and(|t| t.columns.iter().any(|c| c.name.node == name))
        };
        let replaced = |name: &str| match of {
            Of::Row(Some(row)) => row.overrides.has(name),
            Of::Row(None) | Of::All(_) => self.handout.overrides.has(name),
        };
        let columns = AnswerColumns::of(&answers.model);
        let lines = columns.lines_at(&answers, true, &self.handout.positions);
        let (positions, poses): (Vec<String>, Vec<&Pose>) =
            lines.filter_map(|line| Some((line.name().to_owned(), line.pose?))).unzip();
        let drives = self.drives(&answers, &poses, &in_table);
        let exercise = Exercise {
            mechanism,
            file: &self.handout.source.name,
            text: &self.handout.source.text,
            scene,
            shown,
            asked: columns.asked(&answers, AnswerLine::at(wanted)),
            hidden: Self::hidden(asking),
            positions,
            drives,
            is_one_of_several: self.handout.pose.is_some() && solved.solution.poses.len() > 1,
            document: &self.handout.document,
            in_table: &in_table,
            replaced: &replaced,
            written: &self.written,
            row: if let Of::Row(row) = of { row.map(Row::words) } else { None },
        };
        make(&Made { exercise: &exercise, drawn: &solved, answers: &answers }, problems)
    }

    /// The position that is named, or the first; none where the file has none.
    fn scene<'s>(&'s self, solved: &'s Solved, problems: &mut Problems) -> Result<Option<Scene<'s>>, ()> {
        if solved.solution.poses.is_empty() && self.handout.pose.is_none() {
            return Ok(None);
        }
        let file = (self.handout.source.name.as_str(), self.handout.source.text.as_str());
        let answers = solved.answers(PrintedDigits::READABLE);
        let columns = AnswerColumns::of(&answers.model);
        // the end of a motion has a name of its own
        let own = |name: &str| columns.lines(&answers, true).find(|line| line.name() == name)?.pose;
        let of = |name: Option<&str>| {
            let pose = name.and_then(own).map(|pose| pose.name.as_str()).or(name);
            Scene::of(solved.compiled.model(), &solved.solution, file, pose)
        };
        let all = self.handout.positions.iter().map(|name| of(Some(name)));
        let missing = all.filter_map(Result::err).next();
        let scene = missing.map_or_else(|| of(self.handout.pose), Err);
        scene.map(Some).map_err(|missing| problems.push(missing))
    }

    /// Where the drives are at positions; nothing where that is in the table of variants.
    fn drives(
        &self,
        answers: &Answers<'_>,
        poses: &[&Pose],
        in_table: &dyn Fn(&str) -> bool,
    ) -> Vec<Vec<(Name, String)>> {
        let varies = places::vary(&self.handout.document, in_table);
        let at = |pose: &&Pose| if varies { Vec::new() } else { places::drives_at(answers, pose) };
        poses.iter().map(at).collect()
    }

    /// Expected numbers, SI, each with its unit.
    fn hidden(solved: &Solved) -> Vec<(f64, String)> {
        let numbers = solved.outcomes.iter().flat_map(|outcome| {
            let numbers = match outcome.expected {
                Value::Scalar(x) => vec![x],
                Value::Vector(v) => vec![v.x, v.y],
                Value::Bool(_) => Vec::new(),
            };
            numbers.into_iter().map(|x| (x, outcome.display.unit.clone()))
        });
        numbers.collect()
    }

    /// The answers of all rows, as `assur batch --key` has them.
    #[must_use]
    pub fn key(self) -> (Option<Document>, Problems) {
        let mut problems = self.problems.clone();
        let document = if problems.has_errors() { None } else { self.answers(&mut problems) };
        (document, problems)
    }

    fn answers(&self, problems: &mut Problems) -> Option<Document> {
        let (mut lines, mut last) = (Vec::new(), None);
        for row in &self.rows {
            let Some(solved) = self.answered(&row.overrides, problems) else { continue };
            self.scene(&solved, problems).ok()?;
            let answers = solved.answers(PrintedDigits::READABLE);
            let columns = AnswerColumns::of(&solved.compiled.model());
            for line in columns.lines_at(&answers, true, &self.handout.positions) {
                lines.push(([row.name(), line.name().to_owned()], columns.asked(&answers, line)));
            }
            last = Some(solved);
        }
        let solved = last?;
        let named = self.compiled_for_all(self.rows.first()?).0;
        let exercise = Exercise {
            mechanism: named.as_ref().map_or(&solved.compiled.mechanism, |named| &named.mechanism),
            file: &self.handout.source.name,
            text: &self.handout.source.text,
            scene: None,
            shown: None,
            asked: Vec::new(),
            hidden: Vec::new(),
            positions: Vec::new(),
            drives: Vec::new(),
            is_one_of_several: false,
            document: &self.handout.document,
            in_table: &|_| false,
            replaced: &|_| false,
            written: &[],
            row: None,
        };
        Some(key(&exercise, self.handout.language, &lines))
    }

    /// What the file asks for, and no more.
    fn answered(&self, overrides: &Overrides, problems: &mut Problems) -> Option<Solved> {
        let (compiled, found) = self.compiled(overrides);
        problems.append(found);
        let (solved, found) = pipeline::solve(compiled.filter(|_| !problems.has_errors())?);
        problems.append(found);
        solved.ok().filter(|_| !problems.has_errors())
    }

    /// The table of variants without the columns that no answer depends on, such as those of expectations.
    fn variants(&self) -> Option<(Vec<Column>, Vec<Vec<String>>)> {
        let document = &self.handout.document;
        let table = check::table(document)?;
        let given = Given::of(document);
        let is_named = |name: &str| document.notes.iter().any(|note| names(&note.node, name));
        let used = |name: &str| name == "variant" || given.used.contains(name) || is_named(name);
        let kept: Vec<usize> =
            (0..table.columns.len()).filter(|i| used(&table.columns[*i].name.node)).collect();
        let header = |i: &usize| {
            let column = &table.columns[*i];
            (column.name.node.clone(), column.unit.as_ref().map(|unit| unit.node.clone()).unwrap_or_default())
        };
        let cells = |row: &document::Row| {
            kept.iter()
                .filter_map(|i| row.cells.get(*i))
                .map(|c| c.node.text().to_owned())
                .collect::<Vec<_>>()
        };
        let rows = table.rows.iter().map(cells).collect();
        Some((kept.iter().map(header).collect(), rows))
    }
}
