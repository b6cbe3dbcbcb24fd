//! A document as one HTML file: no script, no request.

use crate::document::{Block, Document, Figure, Inline, Line, Table, Term};
use assur_drawing::escaped;
use assur_formula::{mathml, mathml_lines, name_node};
use std::fmt::Write;

/// The document as a page.
#[must_use]
pub fn html(document: &Document) -> String {
    html_of_several(std::slice::from_ref(document))
}

/// Documents one after another on one page, each sheet on new paper.
#[must_use]
pub fn html_of_several(documents: &[Document]) -> String {
    let Some(first) = documents.first() else { return String::new() };
    let mut out = String::new();
    let title = escaped(&first.title);
    let _ = write!(
        out,
        "<!doctype html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\"/>\n<title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n",
        first.language
    );
    let mut count = Counted::default();
    for document in documents {
        write_main(document, &mut count, &mut out);
    }
    out.push_str("</body>\n</html>\n");
    out
}

fn write_main(document: &Document, count: &mut Counted, out: &mut String) {
    if document.fields.is_empty() {
        out.push_str("<main>\n");
    } else {
        out.push_str("<main class=\"sheet\">\n<header>");
        for field in &document.fields {
            let _ = write!(out, "<span>{}</span>", escaped(field));
        }
        out.push_str("</header>\n");
    }
    let _ = writeln!(out, "<h1>{}</h1>", escaped(&document.title));
    contents(document, out);
    for block in &document.blocks {
        write_block(document, block, count, out);
    }
    out.push_str("</main>\n");
}

#[derive(Default)]
struct Counted {
    sections: usize,
    figures: usize,
}

fn contents(document: &Document, out: &mut String) {
    // of numbered sections
    let numbered =
        |b: &Block| matches!(b, Block::Heading(2, words) if words.starts_with(|c: char| c.is_ascii_digit()));
    if !document.blocks.iter().any(numbered) {
        return;
    }
    let headings = document.blocks.iter().filter_map(|b| match b {
        Block::Heading(2, words) => Some(words),
        _ => None,
    });
    let _ = write!(out, "<nav aria-label=\"{}\"><ol>", document.labels.contents);
    for (i, words) in headings.enumerate() {
        let words = words.split_once(' ').map_or(words.as_str(), |(_, rest)| rest);
        let _ = write!(out, "<li><a href=\"#s{}\">{}</a></li>", i + 1, escaped(words));
    }
    out.push_str("</ol></nav>\n");
}

fn write_block(document: &Document, block: &Block, count: &mut Counted, out: &mut String) {
    let _ = match block {
        Block::Heading(2, words) => {
            count.sections += 1;
            writeln!(out, "<h2 id=\"s{}\">{}</h2>", count.sections, escaped(words))
        }
        Block::Heading(level, words) => writeln!(out, "<h{level}>{}</h{level}>", escaped(words)),
        Block::Paragraph(line) => writeln!(out, "<p>{}</p>", inline(line)),
        Block::Remark(line) => writeln!(out, "<p class=\"soft\">{}</p>", inline(line)),
        Block::Equation(lines) => {
            let [begin, end] = fitted("", lines.fit());
            let class = if lines.rows.len() > LONG { "eq long" } else { "eq" };
            writeln!(out, "{begin}<div class=\"{class}\">{}</div>{end}", mathml_lines(lines))
        }
        Block::Table(table) => {
            for part in parts_of(table) {
                let [begin, end] = fitted("tab", LINE / width_of(&part).max(LINE));
                out.push_str(&begin);
                let class = if part.rows.len() > LONG { "long" } else { "" };
                write_table(&part, class, out);
                let _ = writeln!(out, "{end}");
            }
            Ok(())
        }
        Block::Form(table) => {
            let [begin, end] = fitted("tab", LINE / width_of(table).max(LINE));
            out.push_str(&begin);
            let class = if table.rows.len() > FULL { "form long" } else { "form" };
            write_table(table, class, out);
            writeln!(out, "{end}")
        }
        Block::List(items) => {
            let items: String = items.iter().map(|item| format!("<li>{}</li>", inline(item))).collect();
            writeln!(out, "<ol>{items}</ol>")
        }
        Block::Room(words) => {
            count.sections += 1;
            let n = count.sections;
            writeln!(out, "<section class=\"room\"><h2 id=\"s{n}\">{}</h2></section>", escaped(words))
        }
        Block::Vectors(terms) => {
            vectors(document, terms, out);
            Ok(())
        }
        Block::Figures(figures) => {
            write_figures(document, figures, count, out);
            Ok(())
        }
    };
}

/// What is around a part that is smaller on paper, to be no wider than it.
fn fitted(class: &str, fit: f64) -> [String; 2] {
    let begin = match (class, fit < 1.0) {
        ("", false) => return [String::new(), String::new()],
        (class, false) => format!("<div class=\"{class}\">"),
        (class, true) => {
            format!("<div class=\"{}\" style=\"--fit:{fit:.2}\">", format!("{class} fit").trim_start())
        }
    };
    [begin, "</div>".to_owned()]
}

/// Signs in a line of a table, those between two columns, and how small letters may be.
const LINE: f64 = 94.0;
const BETWEEN: f64 = 3.0;
const LEAST: f64 = 0.45;
/// More rows than this are a long table, and a form with low cells.
const LONG: usize = 12;
const FULL: usize = 6;

/// How wide a column is, in signs.
fn column_of(table: &Table, column: usize) -> f64 {
    let cells = table.rows.iter().filter_map(|row| row.get(column)).chain(table.headers.get(column));
    cells.map(signs).fold(0.0, f64::max) + BETWEEN
}

fn width_of(table: &Table) -> f64 {
    (0..table.headers.len()).map(|column| column_of(table, column)).sum()
}

/// A table that is too wide for the smallest letters, in several below each other, each with the first column, which tells rows apart.
fn parts_of(table: &Table) -> Vec<Table> {
    if width_of(table) <= LINE / LEAST {
        return vec![table.clone()];
    }
    let keys = usize::from(table.rows.len() > 1);
    let first: f64 = (0..keys).map(|column| column_of(table, column)).sum();
    let (mut parts, mut columns, mut taken) = (Vec::new(), (0..keys).collect::<Vec<_>>(), first);
    for column in keys..table.headers.len() {
        let width = column_of(table, column);
        if columns.len() > keys && taken + width > LINE {
            parts.push(std::mem::replace(&mut columns, (0..keys).collect()));
            taken = first;
        }
        columns.push(column);
        taken += width;
    }
    parts.push(columns);
    let of = |columns: Vec<usize>| Table {
        headers: columns.iter().filter_map(|i| table.headers.get(*i).cloned()).collect(),
        rows: (table.rows.iter())
            .map(|row| columns.iter().filter_map(|i| row.get(*i).cloned()).collect())
            .collect(),
        numbers: (0..columns.len()).filter(|i| table.numbers.contains(&columns[*i])).collect(),
    };
    parts.into_iter().map(of).collect()
}

/// How many signs a line takes.
fn signs(line: &Line) -> f64 {
    let part = |part: &Inline| match part {
        Inline::Math(node) => node.width(),
        Inline::Text(words) | Inline::Strong(words) => words.chars().count() as f64,
        Inline::Figure(it) => it.words.chars().count() as f64,
    };
    line.iter().map(part).sum()
}

fn inline(line: &Line) -> String {
    let part = |part: &Inline| match part {
        Inline::Text(words) => escaped(words),
        Inline::Strong(words) => format!("<b>{}</b>", escaped(words)),
        Inline::Math(node) => mathml(node),
        Inline::Figure(it) => format!("<a href=\"#f{}\">{}</a>", it.number, escaped(&it.words)),
    };
    line.iter().map(part).collect()
}

/// A long one may go on with the next page on paper.
fn write_table(table: &Table, class: &str, out: &mut String) {
    let class = if class.is_empty() { String::new() } else { format!(" class=\"{class}\"") };
    let _ = write!(out, "<table{class}><thead><tr>");
    for header in &table.headers {
        let _ = write!(out, "<th scope=\"col\">{}</th>", inline(header));
    }
    out.push_str("</tr></thead><tbody>");
    for row in &table.rows {
        out.push_str("<tr>");
        for (i, cell) in row.iter().enumerate() {
            let class = if table.numbers.contains(&i) { " class=\"n\"" } else { "" };
            let _ = write!(out, "<td{class}>{}</td>", inline(cell));
        }
        out.push_str("</tr>");
    }
    out.push_str("</tbody></table>");
}

/// The same of a vector equation.
fn vectors_fit(document: &Document, terms: &[Term]) -> f64 {
    // these tables have smaller letters, and a sign before every term
    const LINE: f64 = 102.0;
    const BETWEEN: f64 = 3.5;
    let widest = |term: &Term| {
        let name = name_node(&term.name).width();
        name.max(signs(&term.magnitude)).max(signs(&term.direction)) + BETWEEN
    };
    let label = document.labels.rows.iter().map(|row| row.chars().count() as f64).fold(0.0, f64::max);
    let all = label + terms.iter().map(widest).sum::<f64>();
    LINE / all.max(LINE)
}

fn vectors(document: &Document, terms: &[Term], out: &mut String) {
    let [begin, end] = fitted("tab", vectors_fit(document, terms));
    out.push_str(&begin);
    out.push_str("<table class=\"vec\"><tbody>");
    for (row, label) in document.labels.rows.iter().enumerate() {
        let _ = write!(out, "<tr><th scope=\"row\">{label}</th>");
        for term in terms {
            let zero = term.name.letter == "0";
            let cell = match row {
                0 if zero => "0".to_owned(),
                0 => mathml(&name_node(&term.name)),
                1 => inline(&term.magnitude),
                _ => inline(&term.direction),
            };
            let sign = if row == 0 { term.sign } else { "" };
            let _ = write!(out, "<td>{sign}</td><td>{cell}</td>");
        }
        out.push_str("</tr>");
    }
    let _ = writeln!(out, "</tbody></table>{end}");
}

fn write_figures(document: &Document, figures: &[Figure], count: &mut Counted, out: &mut String) {
    if figures.len() > 1 {
        out.push_str("<div class=\"two\">\n");
    }
    for figure in figures {
        count.figures += 1;
        let n = count.figures;
        // diagrams have axes, and no scale that paper keeps
        let class = if matches!(figure.name.as_str(), "plot" | "work") { " class=\"free\"" } else { "" };
        let _ = write!(
            out,
            "<figure id=\"f{n}\"{class}>\n{}<figcaption>{}</figcaption></figure>\n",
            figure.svg.trim_start(),
            escaped(&document.labels.below(n, &figure.caption))
        );
    }
    if figures.len() > 1 {
        out.push_str("</div>\n");
    }
}

// The rules of a page: light, dark, phone, paper.

pub(super) const STYLE: &str = "\
:root{--ink:#111;--soft:#5b6470;--pap:#fff;--line:#d4d8de;--acc:#0072b2}
@media (prefers-color-scheme:dark){:root{--ink:#ececec;--soft:#a4adb8;--pap:#16181c;--line:#3a3f47;--acc:#56b4e9}}
body{font-family:\"Times New Roman\",Tinos,\"Liberation Serif\",serif;color:var(--ink);background:var(--pap);max-width:56rem;margin:0 auto;padding:1.5rem 1.2rem 4rem;line-height:1.5;font-size:17px}
h1{font-size:1.7rem;line-height:1.2;margin:.2em 0 .4em}
h2{font-size:1.3rem;margin:2em 0 .5em;border-bottom:1px solid var(--line);padding-bottom:.2em}
h3{font-size:1.08rem;margin:1.4em 0 .3em}
p{margin:.5em 0}.soft{color:var(--soft)}
table{border-collapse:collapse;margin:.8em 0;font-variant-numeric:tabular-nums}
th,td{border:1px solid var(--line);padding:.25em .7em;text-align:left}
th{font-weight:600}td.n{text-align:right}
table.vec{border:0;white-space:nowrap}.tab{overflow-x:auto}
table.vec th,table.vec td{border:0;padding:.15em .35em;text-align:center}
table.vec th{color:var(--soft);font-weight:400;text-align:right}
.eq{margin:.15em 0;padding:.4em 0 .62em 2em;overflow-x:auto;overflow-y:hidden}
.rows{display:grid;grid-template-columns:auto 1fr;align-items:baseline;gap:.3em .1em}.rows .on{padding-left:1.5em}.rows span{text-indent:0}.eq math{padding:.1em 0}
math{font-size:1.02em;font-family:\"Times New Roman\",Tinos,\"Liberation Serif\",\"Noto Serif\",\"DejaVu Serif\",serif}
mi{text-transform:none;font-style:italic}mi[mathvariant=normal]{font-style:normal}
@supports (text-transform:math-auto) and (not (-moz-appearance:none)){
mo.tall{transform:scaleY(var(--tall))}mfrac mo.tall{transform:scaleY(calc(.75*var(--tall)))}mfrac{margin:0 .08em}mfrac>*{padding:.08em 0}msub,msup,msubsup{margin-right:-.1em}
msqrt{display:inline-block;position:relative;padding:.1em .12em 0 .62em;margin:0 .12em}
msqrt::before{content:\"\";position:absolute;left:0;top:0;bottom:0;width:.6em;background:currentColor;print-color-adjust:exact;clip-path:polygon(0 62%,18% 55%,48% 88%,92% 0,100% 0,100% .07em,97% .07em,52% 100%,42% 100%,16% 64%,2% 67%)}
msqrt::after{content:\"\";position:absolute;left:.59em;right:0;top:0;border-top:.065em solid}}
figure{margin:1.2em 0;max-width:100%;overflow-x:auto}
figure svg{max-width:100%;height:auto;display:block}
.sheet header{display:flex;justify-content:space-between;flex-wrap:wrap;gap:.2em 1.5em;border-bottom:1px solid var(--ink);padding-bottom:.35em;font-size:.95em}
.sheet h1{font-size:1.4rem;margin:.5em 0 .3em}.sheet h2{font-size:1.08rem;border:0;padding:0;margin:.9em 0 .2em}
.sheet ol{margin:.2em 0 .6em;padding-left:1.7em}.sheet li{margin:.15em 0}.sheet figure{margin:.5em 0}.sheet table{margin:.4em 0 .7em}
.sheet th,.sheet td{text-align:center}.form{width:100%}.form td{height:2.3em}.form.long td{height:1.5em}
.room{min-height:14rem}main+main{margin-top:3rem}
figcaption{color:var(--soft);font-size:.93em;margin-top:.4em}
.two{display:flex;flex-wrap:wrap;gap:.5rem 2.5rem;align-items:end}.two figure{margin:.8em 0}
nav ol{columns:2;padding-left:1.2em}a{color:var(--acc);text-decoration:none}
@media(max-width:34rem){.eq{padding-left:1.6em;text-indent:-1.2em}.eq math{text-indent:0}nav ol{columns:1}table{font-size:.88em}th,td{padding:.25em .35em}}
@media print{:root{--ink:#000;--soft:#444;--pap:#fff;--line:#aaa;--acc:#000}
h2,h3{break-after:avoid}figure,table,.eq{break-inside:avoid}.eq,.tab,figure{overflow:visible}
.long{break-inside:auto}.eq.long{margin:0;padding:0 0 0 2em}tr{break-inside:avoid}
table.vec{white-space:nowrap;font-size:.88em}h2{margin-top:1.2em}td,th{padding:.12em .6em}nav{display:none}.two{display:block;orphans:1;widows:1;word-spacing:2.5rem}.two figure{display:inline-block;vertical-align:bottom;word-spacing:normal}
.fit{font-size:calc(1em*var(--fit))}.free svg{max-height:150mm}.sheet h1{font-size:14pt}.room{min-height:14mm;break-inside:avoid}.sheet+.sheet{break-before:page;margin:0}@page{size:A4;margin:16mm 14mm}body{font-size:10.5pt;max-width:none;padding:0}}
";
