//! A document as a part of another page: HTML without a page around it, formulas in LaTeX between `\(` and `\)`, pictures as files.

use crate::document::{Block, Document, Figure, Inline, Line, Table, Term};
use assur_drawing::escaped;
use assur_formula::{Node, latex, latex_lines, name_node};

/// Where pictures are: what comes before a file's name, the name without ending of the first, and the ending.
#[derive(Clone, Copy, Debug)]
pub struct PicturePlace<'a> {
    pub before: &'a str,
    pub stem: &'a str,
    pub ending: &'a str,
}

/// The blocks of a document, and the names of its pictures' files with their contents as SVG.
#[must_use]
pub fn fragment(document: &Document, place: PicturePlace<'_>) -> (String, Vec<(String, String)>) {
    let mut out = String::new();
    let mut files = Vec::new();
    for block in &document.blocks {
        out += &match block {
            Block::Heading(2, words) | Block::Room(words) => format!("<h4>{}</h4>\n", escaped(words)),
            Block::Heading(_, words) => format!("<h5>{}</h5>\n", escaped(words)),
            Block::Paragraph(line) | Block::Remark(line) => format!("<p>{}</p>\n", inline(line)),
            Block::Equation(lines) => format!("<p>{}</p>\n", maths(&latex_lines(lines))),
            Block::Table(table) | Block::Form(table) => table_html(table),
            Block::List(items) => {
                let items: String = items.iter().map(|item| format!("<li>{}</li>", inline(item))).collect();
                format!("<ol>{items}</ol>\n")
            }
            Block::Vectors(terms) => table_html(&vectors(document, terms)),
            Block::Figures(figures) => {
                figures.iter().map(|figure| picture(document, figure, place, &mut files)).collect()
            }
        };
    }
    (out, files)
}

/// A line of a text.
#[must_use]
pub fn inline(line: &Line) -> String {
    let part = |part: &Inline| match part {
        Inline::Text(words) => escaped(words),
        Inline::Strong(words) => format!("<b>{}</b>", escaped(words)),
        Inline::Math(node) => of_node(node),
        Inline::Figure(it) => escaped(&it.words),
    };
    line.iter().map(part).collect()
}

fn of_node(node: &Node) -> String {
    maths(&latex(node))
}

fn maths(latex: &str) -> String {
    format!("\\({}\\)", escaped(latex.trim()))
}

fn picture(
    document: &Document,
    figure: &Figure,
    place: PicturePlace<'_>,
    files: &mut Vec<(String, String)>,
) -> String {
    let number = files.len() + 1;
    let stem = if files.is_empty() { place.stem.to_owned() } else { format!("{}-{number}", place.stem) };
    let name = format!("{stem}.{}", place.ending);
    // as it is written there
    let title = figure.svg.split_once("<title").and_then(|(_, rest)| rest.split_once('>'));
    let title = title.and_then(|(_, rest)| rest.split_once("</title>")).map_or("", |(title, _)| title);
    let below = escaped(&document.labels.below(number, &figure.caption));
    let html = format!(
        "<p><img src=\"{}{name}\" alt=\"{title}\" style=\"max-width:100%\"><br>{below}</p>\n",
        place.before
    );
    files.push((name, figure.svg.clone()));
    html
}

fn table_html(table: &Table) -> String {
    let row = |tag: &str, cells: &[Line]| {
        let cells: String = cells.iter().map(|cell| format!("<{tag}>{}</{tag}>", inline(cell))).collect();
        format!("<tr>{cells}</tr>")
    };
    let head = if table.headers.is_empty() { String::new() } else { row("th", &table.headers) };
    let rows: String = table.rows.iter().map(|cells| row("td", cells)).collect();
    format!("<table class=\"generaltable\"><tbody>{head}{rows}</tbody></table>\n")
}

fn vectors(document: &Document, terms: &[Term]) -> Table {
    let text = |words: &str| vec![Inline::Text(words.to_owned())];
    let name = |term: &Term| {
        let letters =
            if term.name.letter == "0" { text("0") } else { vec![Inline::Math(name_node(&term.name))] };
        [text(term.sign), text(" "), letters].concat()
    };
    let rows = document.labels.rows.iter().enumerate().map(|(i, label)| {
        let cells = terms.iter().map(|term| match i {
            0 => name(term),
            1 => term.magnitude.clone(),
            _ => term.direction.clone(),
        });
        std::iter::once(text(label)).chain(cells).collect()
    });
    Table { rows: rows.collect(), ..Table::default() }
}
