//! Sheets of a key and of answers: quantities by name with their units, rows by number, variant, file and pose.

use crate::exercise::table::{Fault, Lines, Separator, Table, TableError, Written, cells, from_cell};
use assur_syntax::document::Column;
use assur_text::diagnostic::did_you_mean;
use assur_text::source::{Source, Span, shown};
use assur_text::units::{Dimension, Unit, lookup};
use std::io::{self, BufRead};

/// What names a row.
pub const NAMES: [&str; 4] = ["file", "row", "variant", "pose"];
/// What names who answered.
const PERSONS: [&str; 2] = ["student", "name"];
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

/// What stands in a cell.
#[derive(Clone, Debug, PartialEq)]
pub enum Entry {
    /// Nothing.
    Empty,
    /// A number, SI.
    Number(f64),
    /// A truth.
    Bool(bool),
    /// What cannot be read, with the reason.
    Unreadable(String, String),
}

/// A row of a sheet.
#[derive(Clone, Debug)]
pub struct SheetRow {
    /// Its line in the file.
    pub line: usize,
    /// What names it, in the order of [`NAMES`]; `None` where the sheet has no such column.
    pub names: [Option<String>; 4],
    /// Who answered.
    pub person: Option<String>,
    /// One entry per quantity.
    pub entries: Vec<Entry>,
    /// Its text.
    pub text: Source,
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
    /// Whether a column says who answered.
    pub persons: bool,
}

enum Role {
    Name(usize),
    Person,
    /// A quantity, and the unit of this column: a key of several files may have it in several units.
    Quantity(usize, Unit),
}

impl Sheet {
    /// Reads a sheet. Where a key is given, the quantities must be among its.
    ///
    /// # Errors
    /// What cannot be read; the inner error is one of the header or of a line.
    pub fn read(name: &str, reader: impl BufRead, key: Option<&Self>) -> io::Result<Result<Self, Fault>> {
        let mut table = match Table::open(name, reader)? {
            Ok(table) => table,
            Err(fault) => return Ok(Err(fault)),
        };
        let header = table.header.clone();
        let mut sheet =
            Self { quantities: Vec::new(), rows: Vec::new(), header, named: [false; 4], persons: false };
        let mut roles = Vec::new();
        for column in &table.columns.columns {
            match sheet.role(column, key) {
                Ok(role) => roles.push(role),
                Err(error) => return Ok(Err((sheet.header, Box::new(error)))),
            }
        }
        let mut lines = Lines::default();
        loop {
            table.lines(CHUNK, &mut lines)?;
            if lines.is_empty() {
                break;
            }
            for raw in (0..lines.len()).filter_map(|i| lines.get(i)) {
                let text = String::from_utf8_lossy(raw.bytes).into_owned();
                let text = Source::line(name, text, raw.line);
                match sheet.row(&roles, text, raw.line, table.separator) {
                    Ok(row) => sheet.rows.push(row),
                    Err(fault) => return Ok(Err(fault)),
                }
            }
        }
        Ok(match table.without_rows() {
            Some(fault) => Err(fault),
            None => Ok(sheet),
        })
    }

    fn role(&mut self, column: &Column, key: Option<&Self>) -> Result<Role, TableError> {
        let name = &column.name.node;
        if column.unit.is_none() {
            if let Some(i) = NAMES.iter().position(|n| n == name) {
                self.named[i] = true;
                return Ok(Role::Name(i));
            }
            if PERSONS.contains(&name.as_str()) {
                self.persons = true;
                return Ok(Role::Person);
            }
        }
        let unit = match &column.unit {
            Some(word) => lookup(&word.node).map_err(|e| TableError::Unit {
                why: e.to_string(),
                help: e.help(),
                span: word.span,
            })?,
            None => Unit::si(Dimension::NUMBER),
        };
        if let Some(key) = key {
            fits(column, &unit, key)?;
        }
        let again = column.name.span;
        if let Some(i) = self.place(name, unit.dimension) {
            let first = &self.quantities[i];
            if first.unit.text == unit.text {
                return Err(TableError::Twice { name: name.clone(), first: first.span, again });
            }
            return Ok(Role::Quantity(i, unit));
        }
        self.quantities.push(Quantity { name: name.clone(), unit: unit.clone(), span: again });
        Ok(Role::Quantity(self.quantities.len() - 1, unit))
    }

    /// The quantity of that name and kind: two files may call different things alike.
    pub(super) fn place(&self, name: &str, dimension: Dimension) -> Option<usize> {
        self.quantities.iter().position(|q| q.name == name && dimension.fits(q.unit.dimension))
    }

    fn row(
        &self,
        roles: &[Role],
        text: Source,
        line: usize,
        separator: Separator,
    ) -> Result<SheetRow, Fault> {
        let found = cells(&text.text, separator).map_err(|span| {
            let help = "a quote within a text is written twice";
            let error = TableError::Line { line, why: "a quote is not closed".to_owned(), help, span };
            (text.clone(), Box::new(error))
        })?;
        if let Some(extra) = found.get(roles.len()) {
            let columns = format!("{} columns", roles.len());
            let span = Span::new(extra.span.start, text.text.len());
            let help = "texts with a comma in them stand in quotes".to_owned();
            let error = TableError::TooMany { line, found: found.len(), columns, help, span };
            return Err((text, Box::new(error)));
        }
        let mut row = SheetRow {
            line,
            names: [None, None, None, None],
            person: None,
            entries: vec![Entry::Empty; self.quantities.len()],
            text: text.clone(),
        };
        for (role, cell) in roles.iter().zip(&found) {
            match role {
                Role::Name(i) => row.names[*i] = Some(from_cell(&shown(&cell.text)).to_owned()),
                Role::Person => row.person = Some(from_cell(&shown(&cell.text)).to_owned()),
                Role::Quantity(i, unit) => match entry(&cell.text, unit) {
                    Entry::Empty => {}
                    entry => row.entries[*i] = entry,
                },
            }
        }
        Ok(row)
    }
}

/// Whether the key has a quantity of that name and kind.
fn fits(column: &Column, unit: &Unit, key: &Sheet) -> Result<(), TableError> {
    let name = &column.name.node;
    let Some(quantity) = key.quantities.iter().find(|q| q.name == *name) else {
        let near = did_you_mean(name, key.quantities.iter().map(|q| q.name.as_str()));
        let all = || key.quantities.iter().map(|q| format!("`{}`", q.name)).collect::<Vec<_>>().join(", ");
        let help = match near.first() {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("the key has {}; rows are named by row, variant, file, pose", all()),
        };
        return Err(TableError::UnknownColumn { name: name.clone(), help, span: column.name.span });
    };
    if key.place(name, unit.dimension).is_some() {
        return Ok(());
    }
    let wanted = &quantity.unit.text;
    let (why, help) = match (&column.unit, wanted.is_empty()) {
        (None, _) => (format!("`{name}` has no unit"), format!("write `{name} [{wanted}]`")),
        (Some(_), true) => (format!("`{name}` is a plain number"), format!("write `{name}`")),
        (Some(_), false) => {
            (format!("`{name}` is given in {wanted} by the key"), format!("write `{name} [{wanted}]`"))
        }
    };
    let span = column.unit.as_ref().map_or(column.name.span, |u| u.span);
    Err(TableError::Unit { why, help: Some(help), span })
}

/// A number, in the column's unit or in one of its own; a truth; nothing.
fn entry(text: &str, unit: &Unit) -> Entry {
    match text {
        "" | "-" | "—" => return Entry::Empty,
        "true" => return Entry::Bool(true),
        "false" => return Entry::Bool(false),
        _ => {}
    }
    // a cell of its own may have a decimal comma
    let read = |text: &str| Written::read(text, Separator::Semicolon);
    match read(text) {
        Ok(written) => Entry::Number(unit.to_si(written.value)),
        Err((why, _)) => {
            let split =
                text.find(|c: char| c.is_alphabetic() && !matches!(c, 'e' | 'E') || matches!(c, '%' | '°'));
            let own = split.and_then(|i| {
                let (number, word) = text.split_at(i);
                let own = lookup(word.trim()).ok().filter(|own| own.dimension.fits(unit.dimension))?;
                Some(own.to_si(read(number.trim()).ok()?.value))
            });
            own.map_or_else(|| Entry::Unreadable(text.to_owned(), why), Entry::Number)
        }
    }
}
