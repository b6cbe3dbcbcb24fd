//! Cells that a spreadsheet would run.

use assur::internals::exercise::table::{as_cell, from_cell};

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
