//! A report in Markdown (GitHub's tables).

use super::document::{Align, Block, Report, Table};
use assur_text::source::{shown, shown_in_line};

/// The report as Markdown.
#[must_use]
pub fn render(report: &Report) -> String {
    let mut out = String::new();
    // a part of a report has no title
    if !report.title.is_empty() {
        out += &format!("# {}\n", escaped(&shown_in_line(&report.title)));
    }
    if !report.notes.is_empty() {
        out.push('\n');
    }
    for note in &report.notes {
        out += &format!("{}\n", escaped(note));
    }
    for section in &report.sections {
        if !section.heading.is_empty() {
            out += &format!("\n## {}\n", escaped(&section.heading));
        }
        for block in &section.blocks {
            out.push('\n');
            match block {
                Block::Text(text) => out += &format!("{}\n", escaped(text)),
                Block::List(items) => items.iter().for_each(|i| out += &format!("- {}\n", escaped(i))),
                Block::Facts(facts) => {
                    facts.iter().for_each(|(n, f)| out += &format!("- **{}**: {}\n", escaped(n), escaped(f)));
                }
                Block::Table(table) => out += &render_table(table),
            }
        }
    }
    out
}

fn render_table(table: &Table) -> String {
    let row = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    let rules = table.columns.iter().map(|c| match c.align {
        Align::Left => ":---".to_owned(),
        Align::Right | Align::Decimal => "---:".to_owned(),
    });
    let mut out = row(table.columns.iter().map(|c| escaped(&shown_in_line(&c.header))).collect());
    out += &row(rules.collect());
    for cells in &table.rows {
        out += &row(cells.iter().map(|c| escaped(&shown_in_line(c))).collect());
    }
    out
}

/// Text with the signs escaped that mean something in Markdown within a line, and those that a terminal would obey.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in shown(text).chars() {
        if matches!(c, '\\' | '|' | '*' | '_' | '`' | '[' | ']' | '<' | '>' | '#') {
            out.push('\\');
        }
        out.push(c);
    }
    out
}
