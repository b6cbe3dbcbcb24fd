//! Texts that a spreadsheet would run: written with an apostrophe before them, and read without it. Controls are spelt out.

use assur_text::source::shown;
use std::borrow::Cow;

/// What begins a formula.
const BEGINS: [char; 6] = ['=', '+', '-', '@', '\t', '\n'];

/// A text as a cell that no spreadsheet runs; numbers stay as they are.
#[must_use]
pub fn as_cell(text: &str) -> Cow<'_, str> {
    if text.starts_with(BEGINS) && text != "-" && text.parse::<f64>().is_err() {
        Cow::Owned(format!("'{}", shown(text)))
    } else {
        shown(text)
    }
}

/// The text of such a cell.
#[must_use]
pub fn from_cell(cell: &str) -> &str {
    cell.strip_prefix('\'').filter(|text| text.starts_with(BEGINS)).unwrap_or(cell)
}
