//! Sheets of a key and of answers: quantities by name with their units, rows by number, variant, file and pose.

use super::columns::Role;
use super::entry::{Entry, plain};
use crate::exercise::table::{Cell, Fault, Lines, RawRow, Separator, Table, TableError, cells, from_cell};
use assur_text::source::{Source, Span, shown};
use assur_text::units::{Dimension, Unit};
use std::io::{self, BufRead};
use unicode_normalization::UnicodeNormalization;

/// What names a row.
pub const NAMES: [&str; 4] = ["file", "row", "variant", "pose"];
/// What a row of points is called, as its row or variant.
const POINTS: &str = "points";
/// Lines read at a time.
const CHUNK: usize = 4096;

/// A quantity of a sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// Its name: `Mb`, `reaction(B, rod).x`.
    pub name: String,
    /// The unit of its numbers.
    pub unit: Unit,
    /// Place of its header.
    pub span: Span,
}

/// A row of a sheet.
#[derive(Clone, Debug)]
pub struct SheetRow {
    /// Its line in the file.
    pub line: usize,
    /// What names it, in the order of [`NAMES`]; `None` where nothing stands there.
    pub names: [Option<String>; 4],
    /// Who answered; in a key, who is to answer.
    pub person: Option<String>,
    /// One entry per quantity.
    pub entries: Vec<Entry>,
    /// Its text.
    pub text: Source,
}

/// A row of a key that says how many points the quantities have.
#[derive(Clone, Debug)]
pub(super) struct PointsRow {
    /// The problem that it is for; `None` for all.
    pub file: Option<String>,
    /// Per quantity; none where nothing stands.
    pub points: Vec<f64>,
}

/// A sheet.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// Its quantities.
    pub quantities: Vec<Quantity>,
    /// Its rows.
    pub rows: Vec<SheetRow>,
    /// Its first line.
    pub header: Source,
    /// Which names of rows its columns are.
    pub named: [bool; 4],
    /// Whether a column says who answered, or who is to answer.
    pub persons: bool,
    /// Columns and lines of answers that cannot be used; the others are marked without them.
    pub left_out: Vec<Fault>,
    /// Points, in a key.
    pub(super) points: Vec<PointsRow>,
}

impl Sheet {
    /// Reads a sheet. Where a key is given, it is one of answers: columns that the key does not have and lines that cannot
    /// be read are left out.
    ///
    /// # Errors
    /// What cannot be read; the inner error is one of the header or, in a key, of a line.
    pub fn read(name: &str, reader: impl BufRead, key: Option<&Self>) -> io::Result<Result<Self, Fault>> {
        let (mut table, columns) = match Table::open_each(name, reader)? {
            Ok(opened) => opened,
            Err(fault) => return Ok(Err(fault)),
        };
        let mut sheet = Self::empty(table.header.clone());
        let roles = match sheet.roles(columns, key) {
            Ok(roles) => roles,
            Err(error) => return Ok(Err((sheet.header, Box::new(error)))),
        };
        let mut lines = Lines::default();
        loop {
            table.lines(CHUNK, &mut lines)?;
            if lines.is_empty() {
                break;
            }
            for raw in (0..lines.len()).filter_map(|i| lines.get(i)) {
                match sheet.line(&roles, name, &raw, table.separator, key.is_none()) {
                    Ok(()) => {}
                    Err(fault) if key.is_some() => sheet.left_out.push(fault),
                    Err(fault) => return Ok(Err(fault)),
                }
            }
        }
        Ok(match table.without_rows() {
            Some(fault) => Err(fault),
            None => Ok(sheet),
        })
    }

    const fn empty(header: Source) -> Self {
        Self {
            quantities: Vec::new(),
            rows: Vec::new(),
            header,
            named: [false; 4],
            persons: false,
            left_out: Vec::new(),
            points: Vec::new(),
        }
    }

    /// The quantity of that name and kind: two files may call different things alike.
    pub(super) fn place(&self, name: &str, dimension: Dimension) -> Option<usize> {
        self.quantities.iter().position(|q| q.name == name && dimension.fits(q.unit.dimension))
    }

    fn line(
        &mut self,
        roles: &[Role],
        name: &str,
        raw: &RawRow<'_>,
        separator: Separator,
        of_key: bool,
    ) -> Result<(), Fault> {
        let text = Source::line(name, raw.text(name)?, raw.line);
        let fault = |error| (text.clone(), Box::new(error));
        let line = raw.line;
        let found = divided(&text.text, line, separator, roles.len()).map_err(fault)?;
        let mut row = SheetRow {
            line,
            names: [None, None, None, None],
            person: None,
            entries: vec![Entry::Empty; self.quantities.len()],
            text: text.clone(),
        };
        for (role, cell) in roles.iter().zip(&found) {
            match role {
                Role::Name(i) => row.names[*i] = name_in(cell),
                Role::Person => row.person = name_in(cell),
                Role::Quantity(..) | Role::LeftOut => {}
            }
        }
        if of_key && row.names[1..3].iter().flatten().any(|name| name.eq_ignore_ascii_case(POINTS)) {
            let points = self.points_of(roles, line, &found, &row).map_err(fault)?;
            self.points.push(points);
            return Ok(());
        }
        for ((role, cell), column) in roles.iter().zip(&found).zip(1..) {
            let Role::Quantity(i, unit) = role else { continue };
            match Entry::read(&cell.text, unit) {
                Entry::Unreadable(_, why) if of_key => {
                    let name = self.quantities[*i].name.clone();
                    let help = Some("the key has numbers, true or false, and empty cells".to_owned());
                    return Err(fault(TableError::Number { line, column, name, why, help, span: cell.span }));
                }
                entry => row.entries[*i].and(&cell.text, entry),
            }
        }
        self.rows.push(row);
        Ok(())
    }

    fn points_of(
        &self,
        roles: &[Role],
        line: usize,
        found: &[Cell<'_>],
        row: &SheetRow,
    ) -> Result<PointsRow, TableError> {
        let file = row.names[0].clone();
        if self.points.iter().any(|other| other.file == file) {
            let why = "the points are given twice".to_owned();
            let help = "keep one row of points, or one per file";
            return Err(TableError::Line { line, why, help, span: Span::new(0, row.text.text.len()) });
        }
        let mut points = vec![0.0; self.quantities.len()];
        for ((role, cell), column) in roles.iter().zip(found).zip(1..) {
            let Role::Quantity(i, _) = role else { continue };
            if cell.text.is_empty() {
                continue;
            }
            let wrong = |why| {
                let name = self.quantities[*i].name.clone();
                let help = Some("write the points as a number from 0".to_owned());
                TableError::Number { line, column, name, why, help, span: cell.span }
            };
            points[*i] = match plain(&cell.text).map_err(wrong)? {
                number if number >= 0.0 => number,
                _ => return Err(wrong(format!("`{}` points are less than none", cell.text))),
            };
        }
        Ok(PointsRow { file, points })
    }
}

/// The cells of a line, no more than there are columns.
fn divided(
    text: &str,
    line: usize,
    separator: Separator,
    columns: usize,
) -> Result<Vec<Cell<'_>>, TableError> {
    let found = cells(text, separator).map_err(|span| {
        let help = "a quote within a text is written twice";
        TableError::Line { line, why: "a quote is not closed".to_owned(), help, span }
    })?;
    match found.iter().skip(columns).find(|cell| !cell.text.is_empty()) {
        None => Ok(found),
        Some(extra) => Err(TableError::TooMany {
            line,
            found: found.len(),
            columns: format!("{columns} columns"),
            help: "texts with a comma in them stand in quotes".to_owned(),
            span: Span::new(extra.span.start, text.len()),
        }),
    }
}

/// The name in a cell; nothing where it is empty.
fn name_in(cell: &Cell<'_>) -> Option<String> {
    let text: String = shown(&cell.text).nfc().collect();
    let name = from_cell(&text).split_whitespace().collect::<Vec<_>>().join(" ");
    (!name.is_empty()).then_some(name)
}

/// The names of a row in words: `row 3`, `pose 1`.
pub(super) fn row_words(names: &[Option<String>; 4]) -> Vec<String> {
    let shown = NAMES.iter().zip(names).filter_map(|(what, name)| Some((*what, name.as_deref()?)));
    shown.map(|(what, name)| format!("{what} {name}")).collect()
}
