//! A document in Markdown, with formulas in LaTeX; pictures are files next to it.

use crate::document::{Block, Document, Inline, Line, Table, Term};
use assur_formula::{latex, latex_lines, name_node};

/// The document, and the names of its pictures' files with their contents.
#[must_use]
pub fn markdown(document: &Document, stem: &str) -> (String, Vec<(String, String)>) {
    let mut out = format!("# {}\n", escaped(&document.title));
    if !document.fields.is_empty() {
        out += &format!("\n{}\n", escaped(&document.fields.join("   ")));
    }
    let mut files = Vec::new();
    for block in &document.blocks {
        out.push('\n');
        match block {
            Block::Heading(level, words) => {
                out += &format!("{} {}\n", "#".repeat(usize::from(*level)), escaped(words));
            }
            Block::Paragraph(line) | Block::Remark(line) => out += &format!("{}\n", inline(line)),
            Block::Equation(lines) => out += &format!("$$\n{}\n$$\n", latex_lines(lines)),
            Block::Table(table) | Block::Form(table) => out += &table_text(table),
            Block::List(items) => items.iter().for_each(|item| out += &format!("1. {}\n", inline(item))),
            Block::Room(words) => out += &format!("## {}\n", escaped(words)),
            Block::Vectors(terms) => out += &vectors(document, terms),
            Block::Figures(figures) => {
                for figure in figures {
                    let name = format!("{stem}-{}.svg", files.len() + 1);
                    let caption = escaped(&figure.caption);
                    let below = document.labels.below(files.len() + 1, &caption);
                    out += &format!("![{caption}]({name})\n\n{below}\n");
                    files.push((name, figure.svg.clone()));
                }
            }
        }
    }
    (out, files)
}

fn inline(line: &Line) -> String {
    let part = |part: &Inline| match part {
        Inline::Text(words) => escaped(words),
        Inline::Strong(words) => format!("**{}**", escaped(words)),
        Inline::Figure(reference) => escaped(&reference.words),
        Inline::Math(node) => format!("${}$", latex(node).trim()),
    };
    line.iter().map(part).collect()
}

fn table_text(table: &Table) -> String {
    let row = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    let mut out = row(table.headers.iter().map(inline).collect());
    let rule = |i: usize| if table.numbers.contains(&i) { "---:" } else { ":---" }.to_owned();
    out += &row((0..table.headers.len()).map(rule).collect());
    for cells in &table.rows {
        out += &row(cells.iter().map(inline).collect());
    }
    out
}

fn vectors(document: &Document, terms: &[Term]) -> String {
    let row = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    let [first, rows @ ..] = &document.labels.rows;
    let name = |term: &Term| {
        let letters = if term.name.letter == "0" { "0".to_owned() } else { latex(&name_node(&term.name)) };
        format!("${} {}$", term.sign, letters.trim())
    };
    let mut out = row([vec![(*first).to_owned()], terms.iter().map(name).collect()].concat());
    out += &row(vec![":---:".to_owned(); terms.len() + 1]);
    for (i, label) in rows.iter().enumerate() {
        let cells = terms.iter().map(|t| inline(if i == 0 { &t.magnitude } else { &t.direction }));
        out += &row([vec![(*label).to_owned()], cells.collect()].concat());
    }
    out
}

/// Text with the signs escaped that mean something in Markdown.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if matches!(c, '\\' | '|' | '*' | '_' | '`' | '[' | ']' | '<' | '>' | '#' | '$') {
            out.push('\\');
        }
        out.push(if c.is_control() { ' ' } else { c });
    }
    out
}
