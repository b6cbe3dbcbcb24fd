//! A report for a terminal.

use super::document::{Align, Block, Report, Section, Table};
use assur_text::source::{shown, shown_in_line};
use std::borrow::Cow;
use unicode_width::UnicodeWidthStr;

/// How a report is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Look {
    /// With colours.
    pub colour: bool,
    /// Columns to fill: wider tables are broken into several.
    pub width: usize,
}

impl Look {
    /// Without colours, 100 columns.
    pub const PLAIN: Self = Self { colour: false, width: 100 };

    fn strong(self, text: &str) -> String {
        if self.colour { format!("\u{1b}[1m{text}\u{1b}[0m") } else { text.to_owned() }
    }
}

const GAP: &str = "  ";

/// The report as lines of text.
#[must_use]
pub fn render(report: &Report, look: Look) -> String {
    let mut out = String::new();
    // a part of a report has no title
    if !report.title.is_empty() {
        line(&mut out, &look.strong(&shown_in_line(&report.title)));
    }
    if !report.notes.is_empty() {
        out.push('\n');
    }
    for note in &report.notes {
        line(&mut out, &shown(note));
    }
    for section in &report.sections {
        out.push('\n');
        render_section(&mut out, section, look);
    }
    out
}

/// A section alone.
#[must_use]
pub fn section(section: &Section, look: Look) -> String {
    let mut out = String::new();
    render_section(&mut out, section, look);
    out
}

fn line(out: &mut String, text: &str) {
    out.push_str(text.trim_end());
    out.push('\n');
}

fn render_section(out: &mut String, section: &Section, look: Look) {
    if !section.heading.is_empty() {
        line(out, &look.strong(&shown_in_line(&section.heading)));
    }
    for block in &section.blocks {
        match block {
            Block::Text(text) => line(out, &format!("{GAP}{}", shown(text))),
            Block::List(items) => {
                items.iter().for_each(|item| line(out, &format!("{GAP}- {}", shown(item))));
            }
            Block::Facts(facts) => {
                let names: Vec<_> = facts.iter().map(|f| shown_in_line(&f.0)).collect();
                let width = names.iter().map(|n| n.width()).max().unwrap_or(0);
                for (name, (_, fact)) in names.iter().zip(facts) {
                    line(out, &format!("{GAP}{}{GAP}{}", padded(name, width, false), shown(fact)));
                }
            }
            Block::Table(table) => render_table(out, table, look),
        }
    }
}

/// Cells padded to the width of their column, the header first.
fn aligned(table: &Table) -> Vec<Vec<String>> {
    (0..table.columns.len())
        .map(|i| {
            let column = &table.columns[i];
            let cells: Vec<_> = table.rows.iter().map(|row| shown_in_line(&row[i])).collect();
            let cells: Vec<String> = match column.align {
                Align::Decimal => at_decimal_points(&cells),
                Align::Left | Align::Right => cells.into_iter().map(Cow::into_owned).collect(),
            };
            let header = shown_in_line(&column.header);
            let width = cells.iter().map(|c| c.width()).chain([header.width()]).max().unwrap_or(0);
            let right = column.align != Align::Left;
            let header = padded(&header, width, right);
            [header].into_iter().chain(cells.iter().map(|c| padded(c, width, right))).collect()
        })
        .collect()
}

/// Numbers with blanks after them so that their decimal points stand below each other.
fn at_decimal_points(cells: &[Cow<'_, str>]) -> Vec<String> {
    let is_number = |c: &str| c.starts_with(|c: char| c.is_ascii_digit() || c == '-' || c == '.');
    let after = |c: &str| if is_number(c) { c.find('.').map_or(0, |at| c.len() - at) } else { 0 };
    let most = cells.iter().map(|c| after(c)).max().unwrap_or(0);
    cells.iter().map(|c| format!("{c}{}", " ".repeat(most - after(c)))).collect()
}

fn padded(text: &str, width: usize, right: bool) -> String {
    let blanks = " ".repeat(width.saturating_sub(text.width()));
    if right { blanks + text } else { text.to_owned() + &blanks }
}

fn render_table(out: &mut String, table: &Table, look: Look) {
    let cells = aligned(table);
    let widths: Vec<usize> = cells.iter().map(|c| c[0].width()).collect();
    for (part, columns) in parts(&widths, table.keys, look.width).iter().enumerate() {
        if part > 0 {
            out.push('\n');
        }
        let row = |row: usize| {
            let joined: Vec<&str> = columns.iter().map(|&i| cells[i][row].as_str()).collect();
            format!("{GAP}{}", joined.join(GAP))
        };
        let rules: Vec<String> = columns.iter().map(|&i| "─".repeat(widths[i])).collect();
        line(out, &row(0));
        line(out, &format!("{GAP}{}", rules.join(GAP)));
        (1..=table.rows.len()).for_each(|i| line(out, &row(i)));
    }
}

/// The columns of each part of a table that is broken to fit a width; the keys stand in every part.
fn parts(widths: &[usize], keys: usize, width: usize) -> Vec<Vec<usize>> {
    let keys: Vec<usize> = (0..keys.min(widths.len())).collect();
    let used = |columns: &[usize]| columns.iter().map(|&i| widths[i] + GAP.len()).sum::<usize>();
    let mut parts = vec![keys.clone()];
    for (i, column) in widths.iter().enumerate().skip(keys.len()) {
        let last = parts.len() - 1;
        let part = &mut parts[last];
        if part.len() > keys.len() && used(part) + column + GAP.len() > width {
            parts.push(keys.iter().copied().chain([i]).collect());
        } else {
            part.push(i);
        }
    }
    parts
}
