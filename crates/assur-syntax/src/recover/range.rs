//! Sweeps of a drive as other languages write them: with a step, with colons, or without a number of steps.

use super::case::Case;
use super::phrase::What;
use crate::recover::{instead, lacking};
use assur_text::diagnostic::Diagnosis;

/// The most steps that are proposed.
const MOST: f64 = 1e6;

pub(super) fn explain(case: &Case<'_>) -> Option<Diagnosis> {
    if case.what == What::Statement && case.token(0) == "simulate" {
        return of_time(case);
    }
    if case.what != What::Statement || case.token(0) != "drive" {
        return None;
    }
    // `drive crank from 0 deg to 90 deg …`
    let from = case.slice.find(" from ").filter(|_| !case.slice.contains('='));
    let start = from.map_or_else(|| case.slice.find('=').map(|at| at + 1), Some)?;
    let ends = [" at ", " turning ", " moving ", " accelerating "];
    let end = ends.iter().filter_map(|word| Some(start + case.slice.get(start..)?.find(word)?)).min();
    let end = end.unwrap_or(case.slice.trim_end().len());
    let written = case.slice.get(start..end)?;
    let (from_value, to, count) = parts(written.strip_prefix(" from ").unwrap_or(written))?;
    let steps = match count {
        Count::Missing => EXAMPLE,
        Count::Steps(steps) => steps.trim().parse().ok()?,
        Count::Size(size) => number_of(from_value, to, size)?,
    };
    let (sweep, wanted) = (format!("{from_value} .. {to} in {steps} steps"), format!("in {steps} steps"));
    let new = format!(" {}{sweep}", if from.is_some() { "= " } else { "" });
    if !case.reads(&case.with(start, end, &new)) {
        return None;
    }
    let help = case.help(start, end, &new);
    let at = start + (written.len() - written.trim_start().len());
    let at = case.span(at, end - at);
    let found = written.trim().to_owned();
    Some(match count {
        Count::Missing => lacking(&wanted, at, help),
        _ => instead(&found, &sweep, at, help),
    })
}

/// `simulate 2 s step 0.05 s`
fn of_time(case: &Case<'_>) -> Option<Diagnosis> {
    const SIZES: &[&str] = &[
        " in steps of ",
        " with steps of ",
        " with step ",
        " steps of ",
        " step ",
        " dt ",
        " every ",
        " by ",
    ];
    let (at, word) = SIZES.iter().find_map(|word| Some((case.slice.find(word)?, *word)))?;
    let length = case.slice.get("simulate".len()..at)?.trim();
    let rest = case.slice.get(at + word.len()..)?;
    let size = rest.split(" within").next()?;
    let (from, to) = length.split_once("..").map_or(("0 s", length), |(from, to)| (from.trim(), to.trim()));
    let steps = number_of(from, to, size.trim().trim_start_matches(['=', ' ']))?;
    let wanted = format!("in {steps} steps");
    let end = at + word.len() + size.trim_end().len();
    let new = format!(" {wanted}");
    let start = at + 1;
    case.reads(&case.with(at, end, &new)).then(|| {
        instead(
            case.slice.get(start..end).unwrap_or_default(),
            &wanted,
            case.span(start, end - start),
            case.help(at, end, &new),
        )
    })
}

/// The number of steps that is proposed where none is written.
const EXAMPLE: usize = 12;

/// How a sweep is divided.
#[derive(Clone, Copy)]
enum Count<'a> {
    Missing,
    /// Into a number of steps.
    Steps(&'a str),
    /// Into steps of a size.
    Size(&'a str),
}

/// Beginning, end and division of a sweep.
fn parts(written: &str) -> Option<(&str, &str, Count<'_>)> {
    let colons = written.split(':').map(str::trim).collect::<Vec<_>>();
    if let [from, step, to] = colons.as_slice() {
        return Some((from, to, Count::Size(step)));
    }
    let splits = ["..", " to ", ":", " - ", " – ", "…"].into_iter().find_map(|sign| written.split_once(sign));
    let (from, rest) = splits?;
    let sizes = [" in steps of ", " with step ", " step ", " steps of ", " by ", " every "];
    let numbers = [" in ", " steps "];
    let size = sizes.iter().find_map(|word| rest.split_once(word));
    let number = numbers.iter().find_map(|word| rest.split_once(word));
    let (to, count) = match (size, number) {
        (Some((to, size)), _) => (to, Count::Size(size.trim_start_matches(['=', ' ']))),
        (None, Some((to, number))) => (to, Count::Steps(number.trim_end_matches(" steps"))),
        _ => (rest, Count::Missing),
    };
    Some((from.trim(), to.trim(), count))
}

/// How many steps of that size a sweep has, if they are numbers in one unit and their number is whole.
fn number_of(from: &str, to: &str, step: &str) -> Option<usize> {
    let ((a, a_unit), (b, unit), (step, step_unit)) = (quantity(from)?, quantity(to)?, quantity(step)?);
    let one_unit = unit == step_unit && (a_unit == unit || (a == 0.0 && a_unit.is_empty()));
    let steps = ((b - a) / step).abs();
    let whole = steps.round();
    let fits = (1.0..=MOST).contains(&whole) && (steps - whole).abs() < 1e-9 * whole;
    (one_unit && fits).then_some(whole as usize)
}

/// A number and its unit.
fn quantity(text: &str) -> Option<(f64, &str)> {
    let end = text.find(|c: char| c.is_alphabetic() || matches!(c, '°' | '%')).unwrap_or(text.len());
    let (number, unit) = text.split_at(end);
    let number = number.trim().parse::<f64>().ok().filter(|x| x.is_finite())?;
    Some((number, unit.trim()))
}
