//! Exercise sheets and their keys.

use super::texts::{for_all, names_a_column, numbers, used};
use super::{KINDS, written};
use crate::cli::args::{Report, ReportFormat};
use crate::cli::draw::file_name;
use crate::cli::error::CliError;
use crate::cli::reply::{Reply, Status, complaint};
use crate::cli::screen::Screen;
use crate::cli::threads::Threads;
use crate::pipeline::{self, Compiled, Solved, VariantSolver};
use crate::report::rows::AnswerColumns;
use crate::report::{Answers, PrintedDigits};
use assur_check::{self as check, FileRow, Overrides};
use assur_model::model::{Level, Value};
use assur_picture::Scene;
use assur_position::plan::Effects;
use assur_solve::solve::Pose;
use assur_syntax::document::{self, Document};
use assur_text::diagnostic::Problems;
use assur_text::source::Source;
use assur_worked::{Exercise, GivenRow, Variants, asks_for_positions, given, key, sheet};
use std::collections::BTreeSet;
use std::sync::Arc;

/// Rows that one thread takes at once: what they have in common is found once for all of them.
const PIECE: usize = 16;
/// Rows that are compared with the first: what is the same in all is given.
const COMPARED: usize = 3;
/// Characters of the name of a row in the name of a file.
const LONGEST: usize = 60;

/// Sheets of a file.
pub struct Sheets<'a> {
    pub args: &'a Report,
    pub format: ReportFormat,
    pub source: &'a Source,
    pub document: Arc<Document>,
    /// Names that are used outside of the table and of expectations.
    used: BTreeSet<String>,
    /// Numbers that the file gives outside of expectations and remarks, where it expects something.
    written: Vec<f64>,
}

/// The name and the unit of a column of variants.
type Column = (String, String);

/// A row of variants: its number, its name and its values.
struct Row {
    number: usize,
    /// Its name where it has one.
    label: Option<String>,
    overrides: Overrides,
}

/// What a sheet is for: all rows, with their table, or one.
#[derive(Clone, Copy)]
enum Of<'r> {
    All(&'r [Row]),
    Row(Option<&'r Row>),
}

impl Row {
    /// Its name, or its number.
    fn name(&self) -> String {
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

    /// The same in the name of a file: `2-A2`.
    fn in_file(&self) -> String {
        let number = self.number.to_string();
        match self.label.as_deref().filter(|label| **label != number) {
            Some(label) => {
                let label: String = file_name(label).chars().take(LONGEST).collect();
                format!("{number}-{label}")
            }
            None => number,
        }
    }
}

impl<'a> Sheets<'a> {
    pub fn new(args: &'a Report, format: ReportFormat, source: &'a Source, document: Arc<Document>) -> Self {
        let text = &source.text;
        Self { args, format, source, document, used: used(text), written: numbers(text) }
    }
}

impl Sheets<'_> {
    pub fn reply(&self, found: Problems, screen: &Screen) -> Reply {
        let mut problems = found;
        let rows = self.rows(&mut problems);
        if problems.has_errors() {
            return Reply::new(String::new(), &problems, self.source, screen);
        }
        let result = if self.args.key {
            self.key(&rows, &mut problems)
        } else if self.args.per_row {
            self.each(&rows, &mut problems)
        } else {
            self.one(&rows, &mut problems, self.args.out.as_deref())
        };
        match result {
            Ok(results) => Reply::new(results, &problems, self.source, screen),
            Err(error) => {
                let diagnostics = screen.diagnostics(&problems, self.source) + &complaint(error, screen);
                Reply { results: String::new(), diagnostics, status: Status::Unusable }
            }
        }
    }

    /// The rows of the file's own table; the file as written where it has none.
    fn rows(&self, problems: &mut Problems) -> Vec<Row> {
        let overrides = self.args.overrides();
        let written = |overrides: Overrides| vec![Row { number: 1, label: None, overrides }];
        let Some(rows) = self.file_rows(&overrides, problems) else { return written(overrides) };
        let row = |(i, row): (usize, FileRow)| Row {
            number: i + 1,
            label: row.label,
            overrides: Overrides { values: overrides.values.clone(), row: row.row },
        };
        rows.into_iter().enumerate().map(row).collect()
    }

    fn file_rows(&self, overrides: &Overrides, problems: &mut Problems) -> Option<Vec<FileRow>> {
        let table = check::table(&self.document)?;
        let (columns, found) = check::columns(&self.document, overrides, table);
        problems.append(found);
        let rows = check::file_rows(table, &columns?.into());
        (!rows.is_empty()).then_some(rows)
    }

    /// One sheet, with the table of all variants.
    fn one(&self, rows: &[Row], problems: &mut Problems, out: Option<&str>) -> Result<String, CliError> {
        let Some(first) = rows.first() else { return Ok(String::new()) };
        let for_all = Arc::new(for_all(&self.document, &names(rows)));
        let (compiled, found) =
            pipeline::compile_document(self.source, &for_all, Problems::new(), &first.overrides);
        self.sheet(compiled, found, problems, (out, Of::All(rows)))
    }

    /// What other rows have under "Given": what differs there is not given by the text.
    fn given_of(&self, rows: &[Row]) -> Vec<Vec<GivenRow>> {
        let of = |row: &Row| {
            let compiled = self.compiled(&row.overrides).0?;
            let solved = pipeline::solve(pipeline::planned_to_draw(compiled, &KINDS)).0.ok()?;
            let scene = self.scene(&solved, &mut Problems::new()).ok()??;
            Some(given(scene, self.args.language.into()))
        };
        rows.iter().take(COMPARED).filter_map(of).collect()
    }

    fn compiled(&self, overrides: &Overrides) -> (Option<Compiled>, Problems) {
        pipeline::compile_document(self.source, &self.document, Problems::new(), overrides)
    }

    /// The sheet of a compiled row, with the table of all variants or without it.
    fn sheet(
        &self,
        compiled: Option<Compiled>,
        found: Problems,
        problems: &mut Problems,
        (out, of): (Option<&str>, Of<'_>),
    ) -> Result<String, CliError> {
        problems.append(found);
        let Some(compiled) = compiled.filter(|_| !problems.has_errors()) else { return Ok(String::new()) };
        let drawn = pipeline::planned_to_draw(compiled.clone(), &KINDS);
        let (solved, found) = pipeline::solve(drawn);
        problems.append(found);
        let Some(solved) = solved.ok().filter(|_| !problems.has_errors()) else { return Ok(String::new()) };
        let Ok(scene) = self.scene(&solved, problems) else { return Ok(String::new()) };
        // pictures may show more than the file asks for
        let asked = Effects::at_least(&solved.compiled.mechanism, Level::Positions, false);
        let own = if asked == solved.compiled.plan.effects {
            None
        } else {
            let Ok(own) = pipeline::solve(compiled).0 else { return Ok(String::new()) };
            Some(own)
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
        let table = check::table(&self.document);
        let rows = if let (Of::All(rows), Some(_)) = (of, table) { rows } else { &[] };
        let with_table = !rows.is_empty();
        let varied = |name: &str| {
            let in_table = table.is_some_and(|t| t.columns.iter().any(|c| c.name.node == name));
            !self.is_used(name) || with_table && in_table
        };
        let exercise = Exercise {
            mechanism,
            file: &self.source.name,
            text: &self.source.text,
            scene,
            shown,
            asked: AnswerColumns::of(&answers.model).asked(&answers, wanted),
            hidden: self.hidden(asking),
            positions: self.positions(&answers),
            varied: &varied,
            others: &self.given_of(rows.get(1..).unwrap_or_default()),
            row: if let Of::Row(row) = of { row.map(Row::words) } else { None },
        };
        let variants = rows.first().and_then(|first| {
            let (columns, rows) = self.variants()?;
            let in_text = self.document.notes.iter().any(|note| names_a_column(&note.node, table));
            Some(Variants { columns, rows, drawn_for: first.words(), in_text })
        });
        let document = sheet(&exercise, self.args.language.into(), variants);
        written(self.args, self.format, document, out)
    }

    /// The position that is named, or the first; none where the file has none.
    fn scene<'a>(&'a self, solved: &'a Solved, problems: &mut Problems) -> Result<Option<Scene<'a>>, ()> {
        if solved.solution.poses.is_empty() && self.args.pose.is_none() {
            return Ok(None);
        }
        let file = (self.source.name.as_str(), self.source.text.as_str());
        let scene = Scene::of(solved.compiled.model(), &solved.solution, file, self.args.pose.as_deref());
        scene.map(Some).map_err(|missing| problems.push(missing))
    }

    /// The positions that answers are wanted at, by name.
    fn positions(&self, answers: &Answers<'_>) -> Vec<String> {
        let events = answers.solution.simulation.iter().flat_map(|run| run.events.iter().flatten());
        let events: Vec<f64> = events.copied().collect();
        // the instant of an event is an answer
        let of_event =
            |pose: &&Pose| pose.outcome.as_ref().is_ok_and(|at| events.contains(&at.state.motion.time));
        let poses = answers.poses().filter(|pose| self.is_wanted(pose) && !of_event(pose));
        poses.map(|pose| pose.name.clone()).collect()
    }

    /// Expected numbers that the file does not give elsewhere.
    fn hidden(&self, solved: &Solved) -> Vec<f64> {
        let numbers = solved.outcomes.iter().flat_map(|outcome| match outcome.expected {
            Value::Scalar(x) => vec![outcome.display.of_si(x)],
            Value::Vector(v) => {
                let v = outcome.display.of_si_vector(v);
                vec![v.x, v.y]
            }
            Value::Bool(_) => Vec::new(),
        });
        numbers.filter(|x| !self.written.iter().any(|w| (w - x.abs()).abs() <= 1e-9 * w)).collect()
    }

    fn is_wanted(&self, pose: &Pose) -> bool {
        self.args.pose.as_ref().is_none_or(|name| *name == pose.name)
    }

    /// One sheet per row: `sheet-2.html` of `sheet.html`.
    fn each(&self, rows: &[Row], problems: &mut Problems) -> Result<String, CliError> {
        let has_table = check::table(&self.document).is_some();
        let name = self.args.out.as_deref().unwrap_or_default();
        let (stem, ending) = name.rsplit_once('.').unwrap_or((name, ""));
        let values = Overrides { values: self.args.overrides().values, ..Overrides::none() };
        let pieces = rows.chunks(PIECE).map(|rows| (rows, Problems::new(), None));
        let mut written: Vec<(&[Row], Problems, Option<CliError>)> = pieces.collect();
        Threads::new(None).each(&mut written, |(_, (rows, problems, error))| {
            let mut solver = VariantSolver::new(&self.document, &values);
            for row in *rows {
                let out = format!("{stem}-{}.{ending}", row.in_file());
                let (compiled, found) = match solver.compile(&row.overrides.row) {
                    (Some(compiled), found) if !found.has_errors() => (Some(compiled), found),
                    // its messages are those of the file as a whole
                    _ => self.compiled(&row.overrides),
                };
                let mut own = Problems::new();
                *error = self
                    .sheet(compiled, found, &mut own, (Some(&out), Of::Row(has_table.then_some(row))))
                    .err();
                problems.append(own);
                if error.is_some() {
                    break;
                }
            }
        });
        for (_, found, error) in written {
            problems.append(found);
            if let Some(error) = error {
                return Err(error);
            }
        }
        Ok(String::new())
    }

    /// The answers of all rows, as `assur batch --key` has them.
    fn key(&self, rows: &[Row], problems: &mut Problems) -> Result<String, CliError> {
        let (mut lines, mut last) = (Vec::new(), None);
        for row in rows {
            let Some(solved) = self.answered(&row.overrides, problems) else { continue };
            if self.scene(&solved, problems).is_err() {
                return Ok(String::new());
            }
            let answers = solved.answers(PrintedDigits::READABLE);
            let columns = AnswerColumns::of(&solved.compiled.model());
            let poses: Vec<&Pose> = answers.poses().filter(|pose| self.is_wanted(pose)).collect();
            if poses.is_empty() {
                lines.push(([row.name(), String::new()], columns.asked(&answers, None)));
            }
            for pose in poses {
                lines.push(([row.name(), pose.name.clone()], columns.asked(&answers, Some(pose))));
            }
            last = Some(solved);
        }
        let (Some(solved), Some(first)) = (last, rows.first()) else { return Ok(String::new()) };
        let for_all = Arc::new(for_all(&self.document, &names(rows)));
        let named = pipeline::compile_document(self.source, &for_all, Problems::new(), &first.overrides).0;
        let exercise = Exercise {
            mechanism: named.as_ref().map_or(&solved.compiled.mechanism, |named| &named.mechanism),
            file: &self.source.name,
            text: &self.source.text,
            scene: None,
            shown: None,
            asked: Vec::new(),
            hidden: Vec::new(),
            positions: Vec::new(),
            varied: &|_| false,
            others: &[],
            row: None,
        };
        let document = key(&exercise, self.args.language.into(), &lines);
        written(self.args, self.format, document, self.args.out.as_deref())
    }

    /// What the file asks for, and no more.
    fn answered(&self, overrides: &Overrides, problems: &mut Problems) -> Option<Solved> {
        let (compiled, found) = self.compiled(overrides);
        problems.append(found);
        let (solved, found) = pipeline::solve(compiled.filter(|_| !problems.has_errors())?);
        problems.append(found);
        solved.ok().filter(|_| !problems.has_errors())
    }

    /// The table of variants without the columns that expectations alone use.
    fn variants(&self) -> Option<(Vec<Column>, Vec<Vec<String>>)> {
        let table = check::table(&self.document)?;
        let used = |name: &str| self.is_used(name);
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

    /// Whether a name is used outside of the table and of expectations.
    fn is_used(&self, name: &str) -> bool {
        name == "variant" || self.used.contains(name)
    }
}

fn names(rows: &[Row]) -> Vec<String> {
    rows.iter().map(Row::name).collect()
}
