//! Commas and semicolons within numbers and brackets.

use super::case::Case;
use super::phrase::What;
use crate::comma;
use crate::recover::comma_in_number;
use crate::recover::instead;
use assur_text::diagnostic::{Diagnosis, Help};

pub(super) fn explain(case: &Case<'_>) -> Option<Diagnosis> {
    if matches!(case.what, What::Row | What::Header) {
        return None;
    }
    semicolon_in_brackets(case)
        .or_else(|| between_properties(case))
        .or_else(|| decimal_comma(case))
        .or_else(|| grouped(case))
}

/// `{ friction 0.2, radius 10 mm }`, `{ bevel, far }`: properties apart by a comma.
fn between_properties(case: &Case<'_>) -> Option<Diagnosis> {
    let open = case.slice.find('{');
    let inner = if case.what == What::Property { 0 } else { open? + 1 };
    let mut commas = case.slice.get(inner..)?.match_indices(',').map(|(at, _)| inner + at);
    let word_behind = |at: usize| {
        let rest = case.slice.get(at + 1..).unwrap_or_default().trim_start();
        rest.starts_with(|c: char| c.is_ascii_lowercase())
    };
    commas.find_map(|at| {
        if !word_behind(at) {
            return None;
        }
        if case.what == What::Property {
            let (first, second) = (case.slice.get(..at)?, case.slice.get(at + 1..)?);
            if ["far", "ccw", "cw"].contains(&second.trim()) {
                let new = format!("{} {}", first.trim(), second.trim());
                return case.instead((0, case.slice.len()), &new, &new);
            }
            let both = case.reads(first.trim()) && case.reads(second.trim());
            return both.then(|| instead(",", ";", case.span(at, 1), case.help(at, at + 1, ";")));
        }
        case.instead((at, at + 1), ";", ";")
    })
}

/// `0,5 m`: first the comma nearest before the failure alone, then all.
fn decimal_comma(case: &Case<'_>) -> Option<Diagnosis> {
    let commas = comma::between_digits(case.slice);
    let nearest = *commas.iter().rev().find(|i| **i <= case.fail).or(commas.first())?;
    for (at, commas) in [(nearest, &[nearest][..]), (*commas.first()?, &commas)] {
        let readings = comma::readings(case.slice, commas);
        if readings.iter().all(|new| case.reads(new)) {
            return Some(comma_in_number(case.span(at, 1), lines(case, &readings)));
        }
    }
    None
}

/// `1 500 mm`, `1'500 mm`, `1.500,5 mm`: thousands apart
fn grouped(case: &Case<'_>) -> Option<Diagnosis> {
    let is_digit = |c: &char| c.is_ascii_digit();
    let mut starts = case
        .slice
        .char_indices()
        .filter(|(_, c)| is_digit(c))
        .map(|(at, _)| at)
        .filter(|at| *at <= case.fail);
    let start = starts
        .rfind(|at| !case.slice[..*at].ends_with(|c: char| c.is_alphanumeric() || "_.,".contains(c)))?;
    let word = |c: char| c.is_ascii_digit() || " '.,".contains(c);
    let rest = case.slice.get(start..)?;
    let number = rest.find(|c| !word(c)).map_or(rest, |end| &rest[..end]).trim_end();
    let (groups, decimals) =
        number.split_once(',').map_or((number, ""), |(groups, decimals)| (groups, decimals));
    let mut parts = groups.split([' ', '\'', '.']);
    let first = parts.next()?;
    let three = |part: &str| part.len() == 3 && part.bytes().all(|b| b.is_ascii_digit());
    let rest = parts.collect::<Vec<_>>();
    if rest.is_empty() || first.len() > 3 || !rest.iter().all(|part| three(part)) {
        return None;
    }
    let point = if decimals.is_empty() { "" } else { "." };
    let wanted = format!("{first}{}{point}{decimals}", rest.concat());
    let end = start + number.len();
    case.reads(&case.with(start, end, &wanted))
        .then(|| instead(number, &wanted, case.span(start, number.len()), case.help(start, end, &wanted)))
}

/// `(120,5 mm; 10 mm)`
fn semicolon_in_brackets(case: &Case<'_>) -> Option<Diagnosis> {
    let mut depth = 0_usize;
    let mut new = String::with_capacity(case.slice.len());
    let mut first = None;
    for (at, c) in case.slice.char_indices() {
        match c {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            ';' if depth > 0 => first = first.or(Some(at)),
            _ => {}
        }
        new.push(if c == ';' && depth > 0 { ',' } else { c });
    }
    let first = first?;
    if case.reads(&new) {
        let help = case.help(0, case.slice.len(), &new);
        let (found, wanted) = (";".to_owned(), ",".to_owned());
        return Some(instead(&found, &wanted, case.span(first, 1), help));
    }
    let commas = comma::between_digits(case.slice);
    let at = *commas.first()?;
    let readings = comma::readings(&new, &commas);
    let fits = readings.iter().all(|new| case.reads(new));
    fits.then(|| comma_in_number(case.span(at, 1), lines(case, &readings)))
}

/// The author's lines with each of the texts in place of the piece.
fn lines(case: &Case<'_>, readings: &[String]) -> Vec<Help> {
    readings.iter().map(|new| case.help(0, case.slice.len(), new)).collect()
}
