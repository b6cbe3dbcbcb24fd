//! A table of variants whose units are in its rows: one message, with the header and the rows as they are to be.

use super::simulation::Lower;
use super::walk::{P, span};
use crate::words::{Rule, is_name_char};
use assur_text::diagnostic::{Diagnosis, Help};
use assur_text::source::{Edit, Span};
use assur_text::units::{is_unit, suggestions};

/// A cell as written: a number, and its unit where it has one.
struct WrittenCell<'a> {
    number: &'a str,
    unit: Option<String>,
}

/// Reports a table with units in its rows as a whole, if every row can be read so. Says whether it did.
pub(super) fn units_in_rows(lower: &mut Lower<'_>, pairs: &[P<'_>]) -> bool {
    let of = |wanted: [Rule; 2]| pairs.iter().filter(move |p| wanted.contains(&p.as_rule()));
    let text = lower.text;
    let written = |pair: &P<'_>| {
        let at = span(pair);
        let whole = text.get(at.start..at.end).unwrap_or_default().trim_end();
        (Span::new(at.start, at.start + whole.len()), whole)
    };
    let Some((header_at, header)) = of([Rule::header, Rule::bad_header]).map(written).next() else {
        return false;
    };
    let lines = of([Rule::row, Rule::bad_row]).map(written).collect::<Vec<_>>();
    let Some(rows) = lines.iter().map(|(_, row)| cells(row)).collect::<Option<Vec<_>>>() else {
        return false;
    };
    let Some(corrected) = header_of(header, &rows) else { return false };
    let mut edits = vec![Edit::new(header_at, corrected)];
    for ((at, _), row) in lines.iter().zip(&rows) {
        let numbers = row.iter().map(|cell| cell.number).collect::<Vec<_>>();
        edits.push(Edit::new(*at, numbers.join(", ")));
    }
    let Some((last, _)) = lines.last() else { return false };
    let (first, _) = lines[0];
    let help = Help::lines(text, Span::new(header_at.start, last.end), edits);
    lower.problems.push(
        Diagnosis::error(
            "mech::syntax::unit_in_row",
            "table rows take plain numbers; the unit goes in the header",
        )
        .label(first, "units in a row")
        .help(help.certain()),
    );
    true
}

/// The cells of a row, separated by commas, or by blanks where it has none.
fn cells(row: &str) -> Option<Vec<WrittenCell<'_>>> {
    if row.contains(',') {
        return row.split(',').map(cell).collect();
    }
    let mut parts: Vec<WrittenCell<'_>> = Vec::new();
    for word in row.split_whitespace() {
        match (cell(word), parts.last_mut()) {
            (Some(number), _) => parts.push(number),
            (None, Some(last)) if last.unit.is_none() => last.unit = Some(unit(word)?),
            _ => return None,
        }
    }
    Some(parts)
}

/// `60 mm`, `60`, `group-1`
fn cell(text: &str) -> Option<WrittenCell<'_>> {
    let text = text.trim();
    let is_name =
        text.starts_with(char::is_alphabetic) && text.chars().all(|c| is_name_char(c) || "-.".contains(c));
    if (is_name && !is_unit(text)) || (text.starts_with('"') && text.ends_with('"')) {
        return Some(WrittenCell { number: text, unit: None });
    }
    let end = text.find(|c: char| !c.is_ascii_digit() && !"+-.".contains(c)).unwrap_or(text.len());
    let (number, rest) = text.split_at(end);
    number.parse::<f64>().ok()?;
    let unit = if rest.trim().is_empty() { None } else { Some(unit(rest.trim())?) };
    Some(WrittenCell { number, unit })
}

/// A unit, or the only one that is meant by another spelling.
fn unit(word: &str) -> Option<String> {
    if is_unit(word) {
        return Some(word.to_owned());
    }
    <[String; 1]>::try_from(suggestions(word)).ok().map(|[unit]| unit)
}

/// The header with the units of the columns; nothing where no row has a unit, or two rows differ in theirs.
fn header_of(header: &str, rows: &[Vec<WrittenCell<'_>>]) -> Option<String> {
    let bare = |name: &str| name.split(['[', '(']).next().unwrap_or_default().trim().to_owned();
    let own = |name: &str| Some(name.split_once(['[', '('])?.1.trim_end_matches([']', ')', ' ']).to_owned());
    let columns = match header.contains(',') {
        true => header.split(',').map(|name| (bare(name), own(name))).collect::<Vec<_>>(),
        false if header.contains(['[', '(']) => return None,
        false => header.split_whitespace().map(|name| (name.to_owned(), None)).collect(),
    };
    if rows.iter().any(|row| row.len() != columns.len())
        || rows.iter().flatten().all(|cell| cell.unit.is_none())
    {
        return None;
    }
    let column = |(i, (name, own)): (usize, &(String, Option<String>))| {
        let mut units = rows.iter().filter_map(|row| row.get(i)?.unit.as_ref()).chain(own.as_ref());
        let first = units.next();
        let is_name = !name.is_empty() && name.chars().all(is_name_char);
        if !is_name || units.any(|unit| Some(unit) != first) {
            return None;
        }
        Some(first.map_or_else(|| name.clone(), |unit| format!("{name} [{unit}]")))
    };
    let columns = columns.iter().enumerate().map(column).collect::<Option<Vec<_>>>()?;
    Some(columns.join(", "))
}
