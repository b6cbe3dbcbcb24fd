//! Sheets of a key and of answers: quantities by name with their units, rows by number, variant, file and pose.

use super::columns::Role;
use super::entry::{Entry, plain};
use super::row_names::RowNames;
use super::rows::{Wanted, find};
use super::rules::MOST_POINTS;
use crate::exercise::table::{Cell, Fault, Lines, RawRow, Separator, Table, TableError, cells, from_cell};
use assur_text::source::{Source, Span, shown};
use assur_text::units::{Dimension, Unit};
use std::io::{self, BufRead};
use std::sync::Arc;
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
    /// What names it; of answers with what names the row of the key.
    pub names: Arc<RowNames>,
    /// Who answered; in a key, who is to answer.
    pub person: Option<Arc<str>>,
    /// One entry per quantity.
    pub entries: Box<[Entry]>,
    /// Of answers, the row of the key that they are for, where there is one.
    pub in_key: Option<usize>,
}

/// A row of a key that says how many points the quantities have.
#[derive(Clone, Debug)]
pub(super) struct PointsRow {
    /// The problem that it is for; `None` for all.
    pub file: Option<String>,
    /// Per quantity; none where nothing stands.
    pub points: Vec<f64>,
}

#[derive(Clone, Debug)]
pub struct Sheet {
    pub quantities: Vec<Quantity>,
    pub rows: Vec<SheetRow>,
    pub header: Source,
    /// Which names of rows its columns are.
    pub named: [bool; 4],
    /// Whether a column says who answered, or who is to answer.
    pub persons: bool,
    /// Columns and lines of answers that cannot be used; the others are marked without them.
    pub left_out: Vec<Fault>,
    /// Lines of answers that are no row of the key.
    pub(super) unknown: Vec<Fault>,
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
                match sheet.line(&roles, name, &raw, table.separator, key) {
                    Ok(()) => {}
                    Err(fault) if key.is_some() => sheet.left_out.push(fault),
                    Err(fault) => return Ok(Err(fault)),
                }
            }
        }
        if key.is_none() {
            RowNames::shorten(&mut sheet.rows);
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
            unknown: Vec::new(),
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
        key: Option<&Self>,
    ) -> Result<(), Fault> {
        let text = raw.text(name)?;
        let fault = |error| (Source::line(name, text, raw.line), Box::new(error));
        let line = raw.line;
        let found = divided(text, line, separator, roles.len()).map_err(fault)?;
        let (mut names, mut person) = ([None, None, None, None], None);
        for (role, cell) in roles.iter().zip(&found) {
            match role {
                Role::Name(i) => names[*i] = name_in(cell),
                Role::Person => person = name_in(cell).map(Arc::from),
                Role::Quantity(..) | Role::LeftOut => {}
            }
        }
        if key.is_none() && names[1..3].iter().flatten().any(|name| name.eq_ignore_ascii_case(POINTS)) {
            let points = self.points_of(roles, (line, text), &found, names[0].take()).map_err(fault)?;
            self.points.push(points);
            return Ok(());
        }
        let mut entries = vec![Entry::Empty; self.quantities.len()].into_boxed_slice();
        for ((role, cell), column) in roles.iter().zip(&found).zip(1..) {
            let Role::Quantity(i, unit) = role else { continue };
            match Entry::read(&cell.text, unit) {
                Entry::Unreadable(unread) if key.is_none() => {
                    let name = self.quantities[*i].name.clone();
                    let help = Some("the key has numbers, true or false, and empty cells".to_owned());
                    let why = unread.why;
                    return Err(fault(TableError::Number { line, column, name, why, help, span: cell.span }));
                }
                entry => entries[*i].and(&cell.text, entry),
            }
        }
        let mut row = SheetRow { line, names: Arc::default(), person, entries, in_key: None };
        match key.map(|key| {
            (key, find(key, self, &Wanted { line, text, names: &names, person: row.person.as_deref() }))
        }) {
            None => row.names = RowNames::of(names),
            Some((key, Ok(found))) => {
                row.in_key = Some(found);
                row.names = key.rows[found].names.and(names);
            }
            Some((_, Err(error))) => self.unknown.push(fault(error)),
        }
        self.rows.push(row);
        Ok(())
    }

    fn points_of(
        &self,
        roles: &[Role],
        (line, text): (usize, &str),
        found: &[Cell<'_>],
        file: Option<String>,
    ) -> Result<PointsRow, TableError> {
        if self.points.iter().any(|other| other.file == file) {
            let why = "the points are given twice".to_owned();
            let help = "keep one row of points, or one per file";
            return Err(TableError::Line { line, why, help, span: Span::new(0, text.len()) });
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
                number if number > MOST_POINTS => {
                    return Err(wrong(format!("`{}` points are more than 1e9", cell.text)));
                }
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
