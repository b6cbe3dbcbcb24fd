//! A report for a terminal.

use super::document::{Align, Block, Report, Section, Table};
use assur_text::source::{shown, shown_in_line};
use std::borrow::Cow;
use unicode_width::UnicodeWidthStr;

/// How a report is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Look {
    pub colour: bool,
    /// Columns to fill: wider tables are broken into several.
    pub width: usize,
    /// Sentences and tables of words are broken too: on a terminal, not in a file.
    pub fill: bool,
}

impl Look {
    /// Without colours, 100 columns.
    pub const PLAIN: Self = Self { colour: false, width: 100, fill: false };

    fn strong(self, text: &str) -> String {
        if self.colour { format!("\u{1b}[1m{text}\u{1b}[0m") } else { text.to_owned() }
    }
}

const GAP: &str = "  ";
/// No column is made narrower.
const NARROWEST: usize = 8;

/// The report as lines of text.
#[must_use]
pub fn render(report: &Report, look: Look) -> String {
    let mut out = String::new();
    // a part of a report has no title
    if !report.title.is_empty() {
        filled(&mut out, "", &look.strong(&shown_in_line(&report.title)), look);
    }
    if !report.notes.is_empty() {
        out.push('\n');
    }
    for note in if look.fill { paragraphs(&report.notes) } else { report.notes.clone() } {
        filled(&mut out, "", &shown(&note), look);
    }
    for section in &report.sections {
        out.push('\n');
        render_section(&mut out, section, look);
    }
    out
}

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

/// Lines of a text joined where the next word would not have fitted: who wrote them went on with the sentence.
fn paragraphs(lines: &[String]) -> Vec<String> {
    let most = lines.iter().map(|line| line.width()).max().unwrap_or(0);
    let mut joined: Vec<String> = Vec::new();
    for (i, line) in lines.iter().enumerate() {
        let word = line.split(' ').next().unwrap_or_default();
        let goes_on = !word.is_empty() && i > 0 && lines[i - 1].width() + 1 + word.width() > most;
        match joined.last_mut() {
            Some(before) if goes_on => *before += &format!(" {line}"),
            _ => joined.push(line.clone()),
        }
    }
    joined
}

/// A text behind what begins its first line, broken at blanks where it is wider than the terminal. A line that is indented stays so.
fn filled(out: &mut String, first: &str, text: &str, look: Look) {
    if !look.fill {
        return line(out, &format!("{first}{text}"));
    }
    let mut before = first.to_owned();
    for part in text.split('\n') {
        let indent = part.len() - part.trim_start_matches(' ').len();
        let behind = " ".repeat(before.width() + indent);
        for (i, piece) in broken(part, look.width.saturating_sub(before.width())).iter().enumerate() {
            let piece =
                if i == 0 { format!("{before}{piece}") } else { format!("{behind}{}", piece.trim_start()) };
            line(out, &piece);
        }
        before = " ".repeat(first.width());
    }
}

/// A line in pieces that are no wider, broken at blanks; a longer word stays whole.
fn broken(text: &str, width: usize) -> Vec<String> {
    let indent = text.len() - text.trim_start_matches(' ').len();
    let mut pieces = vec![String::new()];
    for word in text.split_inclusive(' ') {
        let last = pieces.len() - 1;
        let used = pieces[last].width() + if last > 0 { indent } else { 0 };
        let is_blank = pieces[last].trim().is_empty();
        if !is_blank && used + word.trim_end().width() > width {
            pieces.push(word.to_owned());
        } else {
            pieces[last].push_str(word);
        }
    }
    pieces.into_iter().map(|piece| piece.trim_end().to_owned()).collect()
}

fn render_section(out: &mut String, section: &Section, look: Look) {
    if !section.heading.is_empty() {
        filled(out, "", &look.strong(&shown_in_line(&section.heading)), look);
    }
    for block in &section.blocks {
        match block {
            Block::Text(text) => filled(out, GAP, &shown(text), look),
            Block::List(items) => {
                items.iter().for_each(|item| filled(out, &format!("{GAP}- "), &shown(item), look));
            }
            Block::Facts(facts) => {
                let names: Vec<_> = facts.iter().map(|f| shown_in_line(&f.0)).collect();
                let width = names.iter().map(|n| n.width()).max().unwrap_or(0);
                for (name, (_, fact)) in names.iter().zip(facts) {
                    filled(out, &format!("{GAP}{}{GAP}", padded(name, width, false)), &shown(fact), look);
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
    let is_words = table.keys >= table.columns.len();
    let keys = if is_words && look.fill && used(&widths) > look.width { 1 } else { table.keys };
    let parts = parts(&widths, keys, look.width);
    for (part, columns) in parts.iter().enumerate() {
        if part > 0 {
            out.push('\n');
        }
        let own: Vec<usize> = columns.iter().map(|&i| widths[i]).collect();
        let own = if look.fill { narrowed(own, look.width) } else { own };
        write_row(out, &cells, (columns, &own), 0);
        let rules: Vec<String> = own.iter().map(|width| "─".repeat(*width)).collect();
        line(out, &format!("{GAP}{}", rules.join(GAP)));
        // a line without a number in this part says nothing
        let is_shown = |row: &usize| {
            let numbers = columns.iter().skip(keys);
            parts.len() == 1 || numbers.into_iter().any(|&i| !cells[i][*row].trim().is_empty())
        };
        (1..=table.rows.len()).filter(is_shown).for_each(|row| write_row(out, &cells, (columns, &own), row));
    }
}

/// A row of a table in columns of these widths: a line, or several where cells are broken.
fn write_row(out: &mut String, cells: &[Vec<String>], (columns, widths): (&[usize], &[usize]), row: usize) {
    let cells = columns.iter().zip(widths).map(|(&i, width)| broken_cell(&cells[i][row], *width));
    let cells: Vec<Vec<String>> = cells.collect();
    for k in 0..cells.iter().map(Vec::len).max().unwrap_or(0) {
        let piece = |(cell, width): (&Vec<String>, &usize)| {
            padded(cell.get(k).map_or("", String::as_str), *width, false)
        };
        let pieces: Vec<String> = cells.iter().zip(widths).map(piece).collect();
        line(out, &format!("{GAP}{}", pieces.join(GAP)));
    }
}

/// What columns of these widths take.
fn used(widths: &[usize]) -> usize {
    widths.iter().map(|width| width + GAP.len()).sum()
}

/// Columns that fit, the widest of them narrowed: their cells take several lines.
fn narrowed(mut widths: Vec<usize>, most: usize) -> Vec<usize> {
    while used(&widths) > most {
        let Some(widest) = widths.iter_mut().max() else { break };
        if *widest <= NARROWEST {
            break;
        }
        *widest -= 1;
    }
    widths
}

/// A cell in a column that may have been narrowed.
fn broken_cell(cell: &str, width: usize) -> Vec<String> {
    if cell.width() <= width { vec![cell.to_owned()] } else { broken(cell.trim(), width) }
}

/// The columns of each part of a table that is broken to fit a width; the keys stand in every part.
fn parts(widths: &[usize], keys: usize, width: usize) -> Vec<Vec<usize>> {
    let keys: Vec<usize> = (0..keys.min(widths.len())).collect();
    let used = |columns: &[usize]| used(&columns.iter().map(|&i| widths[i]).collect::<Vec<_>>());
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
