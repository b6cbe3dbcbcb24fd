//! Texts that a spreadsheet would run: written with an apostrophe before them, and read without it. Controls are spelt out.

use crate::source::shown;
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

#[cfg(test)]
mod tests {
    use super::{as_cell, from_cell};

    #[test]
    fn formulas_come_back_and_numbers_stay() {
        assert_eq!(as_cell("\r=1\u{1b}"), "\\u{d}=1\\u{1b}");
        for text in ["=1+1", "@SUM(1)", "+1+1", "-1-1", "\t=1", "\n=1", "-A1"] {
            assert_eq!(as_cell(text), format!("'{text}"));
            assert_eq!(from_cell(&as_cell(text)), text);
        }
        for text in ["-3", "+1.5e-3", "-0", "1+1", "A", "", "'quoted'", "—", "-"] {
            assert_eq!(as_cell(text), text);
            assert_eq!(from_cell(text), text);
        }
    }
}
