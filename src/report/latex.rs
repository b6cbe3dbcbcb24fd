//! A report in LaTeX: sections and tables that a document takes in by `\input`; no package is needed.

use super::document::{Align, Block, Report, Table};
use assur_text::source::shown_in_line;

/// The report as LaTeX.
#[must_use]
pub fn render(report: &Report) -> String {
    let mut out = format!("\\section*{{{}}}\n", escaped(&report.title));
    for note in &report.notes {
        out += &format!("\n{}\n", escaped(note));
    }
    for section in &report.sections {
        out += &format!("\n\\subsection*{{{}}}\n", escaped(&section.heading));
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
    let mut out = String::with_capacity(text.len());
    for c in shown_in_line(text).chars() {
        match c {
            '\\' => out += "\\textbackslash{}",
            '~' => out += "\\textasciitilde{}",
            '^' => out += "\\textasciicircum{}",
            '<' => out += "\\textless{}",
            '>' => out += "\\textgreater{}",
            '"' => out += "\\textquotedbl{}",
            '→' => out += "$\\rightarrow$",
            '−' => out += "$-$",
            '·' => out += "$\\cdot$",
            '×' => out += "$\\times$",
            '≤' => out += "$\\le$",
            '≥' => out += "$\\ge$",
            '≈' => out += "$\\approx$",
            '—' => out += "---",
            '–' => out += "--",
            '…' => out += "\\dots{}",
            'α' => out += "$\\alpha$",
            'φ' => out += "$\\varphi$",
            'ω' => out += "$\\omega$",
            'ε' => out += "$\\varepsilon$",
            'µ' | 'μ' => out += "$\\mu$",
            'π' => out += "$\\pi$",
            '°' => out += "$^\\circ$",
            '²' => out += "$^2$",
            '³' => out += "$^3$",
            '{' | '}' | '$' | '&' | '#' | '_' | '%' => {
                out.push('\\');
                out.push(c);
            }
            c => out.push(c),
        }
    }
    out
}
