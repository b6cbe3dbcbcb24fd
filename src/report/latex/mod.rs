//! A report in LaTeX: sections and tables that a document takes in by `\input`; no package is needed.
//!
//! Letters beyond Greek, in titles and names, are left as they are: the document that has such texts has the fonts for them.

mod signs;

use super::document::{Align, Block, Report, Table};
use assur_text::source::shown_in_line;

/// The report as LaTeX.
#[must_use]
pub fn render(report: &Report) -> String {
    let mut out = String::new();
    // a part of a report has no title
    if !report.title.is_empty() {
        out += &format!("\\section*{{{}}}\n", escaped(&report.title));
    }
    for note in &report.notes {
        out += &format!("\n{}\n", escaped(note));
    }
    for section in &report.sections {
        if !section.heading.is_empty() {
            out += &format!("\n\\subsection*{{{}}}\n", escaped(&section.heading));
        }
        for block in &section.blocks {
            out.push('\n');
            match block {
                Block::Text(text) => out += &format!("{}\n", escaped(text)),
                Block::List(items) => out += &list(items.iter().map(|item| escaped(item))),
                Block::Facts(facts) => {
                    out += &list(
                        facts.iter().map(|(n, f)| format!("\\textbf{{{}}}: {}", escaped(n), escaped(f))),
                    );
                }
                Block::Table(table) => out += &render_table(table),
            }
        }
    }
    out
}

fn list(items: impl Iterator<Item = String>) -> String {
    let items: String = items.map(|item| format!("  \\item {item}\n")).collect();
    format!("\\begin{{itemize}}\n{items}\\end{{itemize}}\n")
}

fn render_table(table: &Table) -> String {
    let columns: String =
        table.columns.iter().map(|c| if matches!(c.align, Align::Left) { 'l' } else { 'r' }).collect();
    let row = |cells: Vec<String>| format!("  {} \\\\\n", cells.join(" & "));
    let mut out = format!("\\begin{{tabular}}{{{columns}}}\n  \\hline\n");
    out += &row(table.columns.iter().map(|c| escaped(&c.header)).collect());
    out += "  \\hline\n";
    for cells in &table.rows {
        out += &row(cells.iter().map(|cell| escaped(cell)).collect());
    }
    out + "  \\hline\n\\end{tabular}\n"
}

/// Text with the signs written out that mean something in LaTeX, or that its usual fonts lack.
fn escaped(text: &str) -> String {
    let shown = shown_in_line(text);
    let mut out = String::with_capacity(shown.len());
    if shown.starts_with(['[', '*']) {
        // at the head of a row or an item, LaTeX reads these as arguments
        out += "{}";
    }
    let mut rest = shown.chars().peekable();
    while let Some(c) = rest.next() {
        match rest.peek().and_then(|mark| signs::accent(*mark)) {
            Some(accent) => {
                rest.next();
                let mut base = String::new();
                signs::write(c, &mut base);
                out += &format!("$\\{accent}{{{}}}$", base.trim_matches('$'));
            }
            None => signs::write(c, &mut out),
        }
    }
    out
}
