//! Tables as comma-separated values, RFC 4180. Texts that a spreadsheet would run have an apostrophe before them.

use super::document::Table;
use crate::exercise::table::as_cell;
use std::borrow::Cow;

/// The end of a line.
pub const LINE_END: &str = "\r\n";

/// The table with its header; lines end in CR LF.
#[must_use]
pub fn render(table: &Table) -> String {
    let headers = table.columns.iter().map(|c| c.header.as_str());
    let mut out = record(headers);
    for row in &table.rows {
        out += &record(row.iter().map(String::as_str));
    }
    out
}

/// A line with its end.
pub fn record<'a>(fields: impl Iterator<Item = &'a str>) -> String {
    fields.map(field).collect::<Vec<_>>().join(",") + LINE_END
}

/// A cell, in quotes where it needs them; no spreadsheet takes it for a formula.
#[must_use]
pub fn field(text: &str) -> Cow<'_, str> {
    let text = as_cell(text);
    if text.contains([',', '"', '\r', '\n']) {
        Cow::Owned(format!("\"{}\"", text.replace('"', "\"\"")))
    } else {
        text
    }
}
