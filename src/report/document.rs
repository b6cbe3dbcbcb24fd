//! The parts of a report, for all renderers.

use serde::Serialize;

/// A report: one per file.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Report {
    /// The mechanism's title; the file's name where it has none.
    pub title: String,
    pub notes: Vec<String>,
    pub sections: Vec<Section>,
}

#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Section {
    pub heading: String,
    /// Its contents, in this order.
    pub blocks: Vec<Block>,
}

/// A part of a section.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Block {
    /// A line of text.
    Text(String),
    /// Items, one per line.
    List(Vec<String>),
    /// Names with what is said of them, one per line.
    Facts(Vec<(String, String)>),
    Table(Table),
}

/// A table of texts.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Table {
    pub columns: Vec<Column>,
    /// Its rows, each as long as `columns`.
    pub rows: Vec<Vec<String>>,
    /// How many columns on the left name the row: they are repeated where a wide table is broken.
    pub keys: usize,
}

/// A column of a table.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Column {
    pub header: String,
    /// The alignment of its cells.
    pub align: Align,
}

/// The alignment of cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Align {
    /// At their left ends.
    Left,
    /// At their right ends.
    Right,
    /// At their decimal points.
    Decimal,
}

impl Section {
    pub fn new(heading: impl Into<String>) -> Self {
        Self { heading: heading.into(), blocks: Vec::new() }
    }

    /// Adds a line of text.
    pub fn text(&mut self, text: impl Into<String>) {
        self.blocks.push(Block::Text(text.into()));
    }

    /// Adds a table, unless it has no rows.
    pub fn table(&mut self, table: Table) {
        if !table.rows.is_empty() {
            self.blocks.push(Block::Table(table));
        }
    }

    /// Adds a list, unless it is empty.
    pub fn list(&mut self, items: Vec<String>) {
        if !items.is_empty() {
            self.blocks.push(Block::List(items));
        }
    }
}

impl Report {
    /// Adds a section, unless it is empty.
    pub fn section(&mut self, section: Section) {
        if !section.blocks.is_empty() {
            self.sections.push(section);
        }
    }
}

impl Table {
    /// A table without rows.
    #[must_use]
    pub fn new(columns: Vec<Column>, keys: usize) -> Self {
        Self { columns, rows: Vec::new(), keys }
    }

    /// A table of words, by its headers: it is not broken.
    #[must_use]
    pub fn of_words(headers: &[&str]) -> Self {
        Self::new(headers.iter().map(|h| Column::words(*h)).collect(), headers.len())
    }

    /// Adds a column of numbers: one cell per row.
    pub fn column(&mut self, header: String, cells: impl Iterator<Item = String>) {
        self.columns.push(Column::numbers(header));
        self.rows.iter_mut().zip(cells).for_each(|(row, cell)| row.push(cell));
    }

    /// Adds a row; cells that are missing are empty.
    pub fn row(&mut self, mut cells: Vec<String>) {
        cells.resize(self.columns.len(), String::new());
        self.rows.push(cells);
    }
}

impl Column {
    /// A column of words.
    pub fn words(header: impl Into<String>) -> Self {
        Self { header: header.into(), align: Align::Left }
    }

    /// A column of numbers.
    pub fn numbers(header: impl Into<String>) -> Self {
        Self { header: header.into(), align: Align::Decimal }
    }

    /// A column of counts and figures in brackets.
    pub fn right(header: impl Into<String>) -> Self {
        Self { header: header.into(), align: Align::Right }
    }
}
