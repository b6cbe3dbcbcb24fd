//! Sheets of a key and of answers: quantities by name with their units, rows by number, variant, file and pose.

use super::columns::Role;
use super::places::{Latest, Placed, Positions};
use super::rows::{RowRequest, find};
use super::rules::MOST_POINTS;
use crate::exercise::table::{
    Cell, Fault, Lines, PreciseNumber, RawRow, Separator, Table, TableError, cells, from_cell,
};
use assur_text::source::{Source, Span, shown};
use assur_text::units::{Dimension, Unit, lookup};
use std::collections::BTreeMap;
use std::io::{self, BufRead};
use std::sync::Arc;
use unicode_normalization::UnicodeNormalization;

/// What names a row.
pub const NAMES: [&str; 4] = ["file", "row", "variant", "pose"];
/// What a row of points is called, as its row or variant.
const POINTS: &str = "points";
/// What a row is called that says of which quantities whole turns count, and what stands there.
const TURNS: &str = "turns";
const COUNTED: &str = "counted";
/// The most lines of each kind of which it is kept why they are not marked; the others are counted.
const MOST_KEPT: usize = 1000;
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

/// A row of a key that says of which quantities whole turns count.
#[derive(Clone, Debug)]
pub(super) struct TurnsRow {
    /// The problem that it is for; `None` for all.
    file: Option<String>,
    /// Per quantity.
    counted: Vec<bool>,
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
    /// How many more lines of answers cannot be used.
    pub(super) more_left_out: usize,
    /// Points, in a key.
    pub(super) points: Vec<PointsRow>,
    /// Of which quantities whole turns count, in a key.
    turns: Vec<TurnsRow>,
    /// Which of its lines are positions of one row, in a key.
    pub(super) positions: Positions,
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
        let (mut lines, mut latest) = (Lines::default(), Latest::default());
        loop {
            table.lines(CHUNK, &mut lines)?;
            if lines.is_empty() {
                break;
            }
            for raw in (0..lines.len()).filter_map(|i| lines.get(i)) {
                match sheet.line(&roles, name, &raw, table.separator, key.map(|key| (key, &mut latest))) {
                    Ok(()) => {}
                    Err(fault) if key.is_some() => keep(&mut sheet.left_out, fault, &mut sheet.more_left_out),
                    Err(fault) => return Ok(Err(fault)),
                }
            }
        }
        if key.is_none() {
            RowNames::shorten(&mut sheet.rows);
            sheet.positions = Positions::of(&mut sheet.rows);
        }
        Ok(match table.without_rows() {
            Some(fault) => Err(fault),
            None => Ok(sheet),
        })
    }

    fn empty(header: Source) -> Self {
        Self {
            quantities: Vec::new(),
            rows: Vec::new(),
            header,
            named: [false; 4],
            persons: false,
            left_out: Vec::new(),
            unknown: Vec::new(),
            more_left_out: 0,
            points: Vec::new(),
            turns: Vec::new(),
            positions: Positions::default(),
        }
    }

    /// The quantity of that name and kind: two files may call different things alike.
    pub(super) fn place(&self, name: &str, dimension: Dimension) -> Option<usize> {
        self.quantities.iter().position(|q| q.name == name && dimension.fits(q.unit.dimension))
    }

    /// Whether the key says of a quantity that whole turns count, in a row.
    pub(super) fn counts_turns(&self, row: &SheetRow, place: usize) -> bool {
        let is_for = |file: &Option<String>| file.is_none() || *file == row.names.each[0];
        self.turns.iter().any(|turns| is_for(&turns.file) && turns.counted[place])
    }

    fn line(
        &mut self,
        roles: &[Role],
        name: &str,
        raw: &RawRow<'_>,
        separator: Separator,
        key: Option<(&Self, &mut Latest)>,
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
        let is_called = |word: &str| names[1..3].iter().flatten().any(|n| n.eq_ignore_ascii_case(word));
        if key.is_some() && is_called(TURNS) {
            // a key that was filled in
            return Ok(());
        }
        if key.is_none() && is_called(POINTS) {
            let points = self.points_of(roles, (line, text), &found, names[0].take()).map_err(fault)?;
            self.points.push(points);
            return Ok(());
        }
        if key.is_none() && is_called(TURNS) {
            let turns = self.turns_of(roles, line, &found, names[0].take()).map_err(fault)?;
            self.turns.push(turns);
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
        let Some((key, latest)) = key else {
            row.names = RowNames::of(names);
            self.rows.push(row);
            return Ok(());
        };
        let request = RowRequest { line, text, names: &names, person: row.person.as_deref() };
        match find(key, self, &request) {
            Ok(found) => {
                row.in_key = Some(found.index);
                row.names = key.rows[found.index].names.and(names);
                let span = Span::new(0, text.len());
                let fault = |why, help| fault(TableError::UnknownRow { line, why, help, span });
                self.put(key, latest, Placed { row, found, fault: &fault });
            }
            Err(error) => {
                row.entries = Box::default();
                self.rows.push(row);
                keep(&mut self.unknown, fault(error), &mut self.more_left_out);
            }
        }
        Ok(())
    }

    fn turns_of(
        &self,
        roles: &[Role],
        line: usize,
        found: &[Cell<'_>],
        file: Option<String>,
    ) -> Result<TurnsRow, TableError> {
        let mut counted = vec![false; self.quantities.len()];
        for (role, cell) in roles.iter().zip(found) {
            let Role::Quantity(i, _) = role else { continue };
            match &*cell.text {
                COUNTED => counted[*i] = true,
                "" => {}
                other => {
                    let why = format!("`{other}` says nothing of whole turns");
                    let help = "write `counted` where whole turns count, else nothing";
                    return Err(TableError::Line { line, why, help, span: cell.span });
                }
            }
        }
        Ok(TurnsRow { file, counted })
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

/// Keeps a fault, or counts it where there are many.
pub(super) fn keep(kept: &mut Vec<Fault>, fault: Fault, more: &mut usize) {
    if kept.len() < MOST_KEPT { kept.push(fault) } else { *more += 1 }
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

// What names a row.

/// More characters of the name of a file, a row, a variant or a position are not shown.
const LONGEST: usize = 60;

/// What names a row: most lines of answers share the names of their row of the key.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RowNames {
    /// In the order of [`NAMES`]; `None` where nothing stands there.
    pub each: [Option<String>; 4],
    /// The file without folder and ending, where that names no other file.
    short: Option<String>,
}

impl RowNames {
    pub(super) fn of(each: [Option<String>; 4]) -> Arc<Self> {
        let short = each[0].as_deref().map(stem);
        Arc::new(Self { each, short })
    }

    /// With the names of others where these have none.
    pub(super) fn and(self: &Arc<Self>, others: [Option<String>; 4]) -> Arc<Self> {
        if self.each.iter().zip(&others).all(|(own, other)| own.is_some() || other.is_none()) {
            return Arc::clone(self);
        }
        let mut others = others;
        let all = Self::of(std::array::from_fn(|i| self.each[i].clone().or_else(|| others[i].take())));
        Arc::new(Self {
            short: self.short.clone().or_else(|| all.short.clone()),
            ..Arc::unwrap_or_clone(all)
        })
    }

    /// Of the problem and the position alone: which row it is, is not known.
    pub(super) fn of_problem(&self) -> Arc<Self> {
        let each = [self.each[0].clone(), None, None, self.each[3].clone()];
        Arc::new(Self { each, short: self.short.clone() })
    }

    /// Names files by their paths where two of the rows have the same name without folder and ending.
    pub(super) fn shorten(rows: &mut [SheetRow]) {
        let mut paths: BTreeMap<String, Option<String>> = BTreeMap::new();
        for names in rows.iter().map(|row| &row.names) {
            let (Some(path), Some(short)) = (&names.each[0], &names.short) else { continue };
            let known = paths.entry(short.clone()).or_insert_with(|| Some(path.clone()));
            if known.as_ref() != Some(path) {
                *known = None;
            }
        }
        for row in rows {
            let is_ambiguous = |short: &String| paths.get(short).is_some_and(Option::is_none);
            if row.names.short.as_ref().is_some_and(is_ambiguous) {
                let names = Arc::make_mut(&mut row.names);
                names.short.clone_from(&names.each[0]);
            }
        }
    }

    /// In words, the file shortly: `engine`, `row 3`, `pose 1`.
    #[must_use]
    pub fn words(&self) -> Vec<String> {
        let others = NAMES.iter().zip(&self.each).skip(1);
        let others = others.filter_map(|(what, name)| Some(format!("{what} {}", cut(name.as_deref()?))));
        self.short.as_deref().map(cut).into_iter().chain(others).collect()
    }
}

/// A file without folder and ending.
fn stem(path: &str) -> String {
    let name = path.rsplit(['/', '\\']).next().unwrap_or(path);
    let stem = name.strip_suffix(".mech").unwrap_or(name);
    if stem.is_empty() { path.to_owned() } else { stem.to_owned() }
}

/// The names of a row as they are written: `file a/engine.mech`, `row 3`.
pub(super) fn as_written(names: &[Option<String>; 4]) -> Vec<String> {
    let shown = NAMES.iter().zip(names).filter_map(|(what, name)| Some((*what, name.as_deref()?)));
    shown.map(|(what, name)| format!("{what} {name}")).collect()
}

/// A text of others, cut where it is long.
#[must_use]
pub fn cut(text: &str) -> String {
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

// What stands in a cell of a sheet.

/// Longer texts are not repeated in the reason why they cannot be read, bytes.
const LONG: usize = 60;

/// What stands in a cell.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Entry {
    #[default]
    Empty,
    /// A number, SI.
    Number(f64),
    Bool(bool),
    /// What cannot be read.
    Unreadable(Box<Unread>),
}

/// What cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unread {
    pub text: String,
    pub why: String,
}

impl Unread {
    /// A text with the reason.
    pub(super) fn new(text: &str, why: impl Into<String>) -> Box<Self> {
        Box::new(Self { text: text.to_owned(), why: why.into() })
    }
}

impl Entry {
    /// The number that stands there, SI.
    pub const fn number(&self) -> Option<f64> {
        match self {
            Self::Number(x) => Some(*x),
            _ => None,
        }
    }

    /// Reads a cell: a number, in the column's unit or in one of its own; true or false; nothing.
    pub(super) fn read(text: &str, unit: &Unit) -> Self {
        match text {
            "" | "-" | "—" => return Self::Empty,
            "true" => return Self::Bool(true),
            "false" => return Self::Bool(false),
            _ => {}
        }
        let (value, why) = match plain(text) {
            Ok(value) => (Some(unit.to_si(value)), String::new()),
            Err(why) => (with_unit(text, unit), why),
        };
        match value {
            Some(x) if x.is_finite() => Self::Number(x),
            Some(_) => Self::Unreadable(Unread::new(text, "it is too large")),
            None if text.len() > LONG => Self::Unreadable(Unread::new(text, "it is not a number")),
            None => Self::Unreadable(Unread::new(text, why)),
        }
    }

    /// The same answer given again in another column.
    pub(super) fn and(&mut self, text: &str, other: Self) {
        match (&*self, other) {
            (_, Self::Empty) => {}
            (Self::Empty, other) => *self = other,
            _ => *self = Self::Unreadable(Unread::new(text, "it is given in two columns")),
        }
    }
}

/// A number; a cell of its own may have a decimal comma.
pub(super) fn plain(text: &str) -> Result<f64, String> {
    PreciseNumber::read(text, Separator::Semicolon).map(|written| written.value).map_err(|(why, _)| why)
}

/// A number with a unit of its own, SI.
fn with_unit(text: &str, unit: &Unit) -> Option<f64> {
    let begins_unit = |c: char| c.is_alphabetic() && !matches!(c, 'e' | 'E') || matches!(c, '%' | '°');
    let (number, word) = text.split_at(text.find(begins_unit)?);
    let own = lookup(word.trim()).ok().filter(|own| own.dimension.fits(unit.dimension))?;
    Some(own.to_si(plain(number.trim()).ok()?))
}
