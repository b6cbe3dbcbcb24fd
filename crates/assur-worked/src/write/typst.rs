//! A document in Typst; pictures are files next to it.

use crate::document::{Block, Document, Inline, Line, Table, Term};
use assur_formula::{name_node, typst as formula, typst_lines};

/// The document, and the names of its pictures' files with their contents.
#[must_use]
pub fn typst(document: &Document, stem: &str) -> (String, Vec<(String, String)>) {
    let fields = document.fields.iter().map(|field| escaped(field)).collect::<Vec<_>>().join(" #h(1fr) ");
    let fields = if fields.is_empty() { fields } else { format!("{fields}\n\n") };
    let mut out = format!(
        "#set document(title: \"{}\")\n#set page(paper: \"a4\", margin: (x: 14mm, y: 16mm))\n#set text(lang: \"{}\", size: 10.5pt)\n#show table.cell.where(y: 0): strong\n\n{fields}= {}\n",
        document.title.replace('\\', "").replace('"', "'"),
        document.language,
        escaped(&document.title)
    );
    let mut files = Vec::new();
    for block in &document.blocks {
        out.push('\n');
        match block {
            Block::Heading(level, words) => {
                out += &format!("{} {}\n", "=".repeat(usize::from(*level)), escaped(words));
            }
            Block::Paragraph(line) => out += &format!("{}\n", inline(line)),
            Block::Remark(line) => out += &format!("#text(fill: luma(35%))[{}]\n", inline(line)),
            Block::Equation(lines) => out += &format!("$ {} $\n", typst_lines(lines).trim_end()),
            Block::Table(table) | Block::Form(table) => out += &table_text(table),
            Block::List(items) => items.iter().for_each(|item| out += &format!("+ {}\n", inline(item))),
            Block::Room(words) => out += &format!("== {}\n#v(1fr)\n", escaped(words)),
            Block::Vectors(terms) => out += &vectors(document, terms),
            Block::Figures(figures) => {
                for figure in figures {
                    let name = format!("{stem}-{}.svg", files.len() + 1);
                    let caption = escaped(&figure.caption);
                    out += &format!("#figure(image(\"{name}\"), caption: [{caption}])\n");
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
        Inline::Strong(words) => format!("*{}*", escaped(words)),
        Inline::Figure(reference) => escaped(&reference.words),
        Inline::Math(node) => format!("${}$", formula(node).trim_end()),
    };
    line.iter().map(part).collect()
}

fn table_text(table: &Table) -> String {
    let cell = |words: String| format!("[{words}], ");
    let mut out = format!("#table(columns: {},\n  ", table.headers.len());
    table.headers.iter().for_each(|h| out += &cell(inline(h)));
    for row in &table.rows {
        out += "\n  ";
        row.iter().for_each(|c| out += &cell(inline(c)));
    }
    out + "\n)\n"
}

fn vectors(document: &Document, terms: &[Term]) -> String {
    let mut out = format!("#table(columns: {}, stroke: none, align: center,\n", terms.len() + 1);
    for (i, label) in document.labels.rows.iter().enumerate() {
        out += &format!("  [{label}], ");
        for term in terms {
            let words = match i {
                0 if term.name.letter == "0" => format!("$ {} 0 $", term.sign),
                0 => format!("${} {}$", term.sign, formula(&name_node(&term.name)).trim_end()),
                1 => inline(&term.magnitude),
                _ => inline(&term.direction),
            };
            out += &format!("[{words}], ");
        }
        out.push('\n');
    }
    out + ")\n"
}

/// Text with the signs escaped that mean something in Typst.
#[must_use]
pub fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    // at the head of a paragraph or a cell these begin an item
    let number = text.bytes().take_while(u8::is_ascii_digit).count();
    let item = if text.starts_with(['-', '+']) { 0 } else { number };
    for (at, c) in text.char_indices() {
        let begins_item = at == item
            && (at == 0 && matches!(c, '-' | '+') || at > 0 && c == '.')
            && text[at + 1..].starts_with(' ');
        if begins_item
            || matches!(c, '\\' | '*' | '_' | '`' | '[' | ']' | '<' | '>' | '#' | '$' | '@' | '~' | '=' | '/')
        {
            out.push('\\');
        }
        out.push(if c.is_control() { ' ' } else { c });
    }
    out
}
