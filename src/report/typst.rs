//! A report in Typst: sections and tables that a document takes in by `#include`; no package is needed.

use super::document::{Align, Block, Report, Table};
use assur_text::source::shown_in_line;
use assur_worked::typst_escaped;

/// The report as Typst.
#[must_use]
pub fn render(report: &Report) -> String {
    let mut out = String::new();
    // a part of a report has no title
    if !report.title.is_empty() {
        out += &format!("= {}\n", escaped(&report.title));
    }
    for note in &report.notes {
        out += &format!("\n{}\n", escaped(note));
    }
    for section in &report.sections {
        if !section.heading.is_empty() {
            out += &format!("\n== {}\n", escaped(&section.heading));
        }
        for block in &section.blocks {
            out.push('\n');
            match block {
                Block::Text(text) => out += &format!("{}\n", escaped(text)),
                Block::List(items) => items.iter().for_each(|item| out += &format!("- {}\n", escaped(item))),
                Block::Facts(facts) => {
                    facts.iter().for_each(|(n, f)| out += &format!("- *{}*: {}\n", escaped(n), escaped(f)));
                }
                Block::Table(table) => out += &render_table(table),
            }
        }
    }
    out
}

fn render_table(table: &Table) -> String {
    let aligns = table.columns.iter().map(|c| if matches!(c.align, Align::Left) { "left" } else { "right" });
    let row = |cells: Vec<String>| cells.iter().map(|cell| format!("[{cell}], ")).collect::<String>();
    let mut out = format!("#table(\n  columns: {}, align: (", table.columns.len());
    out += &aligns.map(|align| format!("{align}, ")).collect::<String>();
    out += "),\n  table.header(";
    out += &row(table.columns.iter().map(|c| escaped(&c.header)).collect());
    out += "),\n";
    for cells in &table.rows {
        out += &format!("  {}\n", row(cells.iter().map(|cell| escaped(cell)).collect()).trim_end());
    }
    out + ")\n"
}

fn escaped(text: &str) -> String {
    typst_escaped(&shown_in_line(text))
}
