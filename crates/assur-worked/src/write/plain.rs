//! A document as plain text, for a terminal.

use crate::document::{Block, Document, Inline, Line, Table, Term};
use assur_formula::{name_node, text as formula, text_lines};

/// The document as text; pictures are named alone.
#[must_use]
pub fn text(document: &Document) -> String {
    let mut out = format!("{}\n{}\n", document.title, "=".repeat(width(&document.title)));
    if !document.fields.is_empty() {
        out += &format!("\n{}", wrapped(&document.fields.join(" ")));
    }
    let mut figures = 0;
    let mut after_equation = false;
    for block in &document.blocks {
        let equation = matches!(block, Block::Equation(_));
        if !(equation && after_equation) {
            out.push('\n');
        }
        after_equation = equation;
        match block {
            Block::Heading(level, words) => {
                let under = if *level == 2 { "-" } else { "" };
                out += &format!("{words}\n");
                if !under.is_empty() {
                    out += &format!("{}\n", under.repeat(width(words)));
                }
            }
            Block::Paragraph(line) | Block::Remark(line) => out += &wrapped(&inline(line)),
            Block::Equation(lines) => {
                for line in text_lines(lines).lines() {
                    out += &format!("    {line}\n");
                }
            }
            Block::Table(table) | Block::Form(table) => out += &table_text(table),
            Block::List(items) => {
                let numbered = items.iter().enumerate();
                numbered.for_each(|(i, item)| out += &wrapped(&format!("{}. {}", i + 1, inline(item))));
            }
            Block::Room(words) => out += &format!("{words}\n"),
            Block::Vectors(terms) => out += &vectors(document, terms),
            Block::Figures(all) => {
                for figure in all {
                    figures += 1;
                    out += &format!("[{}]\n", document.labels.below(figures, &figure.caption));
                }
            }
        }
    }
    out
}

fn width(words: &str) -> usize {
    // arrows over letters take no room
    words.chars().filter(|c| *c != '\u{20d7}').count()
}

fn inline(line: &Line) -> String {
    let part = |part: &Inline| match part {
        Inline::Text(words) | Inline::Strong(words) => words.clone(),
        Inline::Figure(reference) => reference.words.clone(),
        Inline::Math(node) => formula(node),
    };
    line.iter().map(part).collect()
}

/// Lines of up to a hundred signs.
fn wrapped(words: &str) -> String {
    const LINE: usize = 100;
    let (mut out, mut taken) = (String::new(), 0);
    for word in words.split_whitespace() {
        let own = width(word);
        if taken > 0 && taken + 1 + own > LINE {
            out.push('\n');
            taken = 0;
        }
        if taken > 0 {
            out.push(' ');
            taken += 1;
        }
        out += word;
        taken += own;
    }
    out + "\n"
}

fn columns(rows: &[Vec<String>]) -> String {
    let count = rows.iter().map(Vec::len).max().unwrap_or(0);
    let widths: Vec<usize> = (0..count)
        .map(|i| rows.iter().filter_map(|r| r.get(i)).map(|c| width(c)).max().unwrap_or(0))
        .collect();
    let mut out = String::new();
    for row in rows {
        let mut line = String::from("   ");
        for (cell, wide) in row.iter().zip(&widths) {
            line += &format!(" {cell}{} ", " ".repeat(wide - width(cell)));
        }
        out += line.trim_end();
        out.push('\n');
    }
    out
}

fn table_text(table: &Table) -> String {
    let mut rows = vec![table.headers.iter().map(inline).collect::<Vec<_>>()];
    rows.extend(table.rows.iter().map(|row| row.iter().map(inline).collect::<Vec<_>>()));
    columns(&rows)
}

fn vectors(document: &Document, terms: &[Term]) -> String {
    let cell = |i: usize, term: &Term| match i {
        0 => format!("{} {}", term.sign, formula(&name_node(&term.name))).trim().to_owned(),
        1 => inline(&term.magnitude),
        _ => inline(&term.direction),
    };
    let row = |(i, label): (usize, &&str)| {
        std::iter::once((*label).to_owned()).chain(terms.iter().map(|t| cell(i, t))).collect::<Vec<_>>()
    };
    columns(&document.labels.rows.iter().enumerate().map(row).collect::<Vec<_>>())
}
