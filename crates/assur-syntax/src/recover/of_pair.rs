//! `A (0, 300) mm`, `A at (0, 300) mm`: a unit behind the parentheses of coordinates.

use super::case::Case;
use assur_text::diagnostic::Diagnosis;

pub(super) fn explain(case: &Case<'_>) -> Option<Diagnosis> {
    case.slice.match_indices(')').find_map(|(close, _)| behind(case, close))
}

fn behind(case: &Case<'_>, close: usize) -> Option<Diagnosis> {
    let rest = case.slice.get(close + 1..)?;
    let unit = rest.trim_start_matches(' ');
    let unit = &unit[..unit.find([' ', ';', ',', '}', '\n']).unwrap_or(unit.len())];
    let before = case.slice.get(..close)?;
    let open = before.rfind('(')?;
    let coordinates: Vec<&str> = before[open + 1..].split(',').map(str::trim).collect();
    let plain = coordinates.len() == 2 && coordinates.iter().all(|one| one.parse::<f64>().is_ok());
    if !plain || !unit.starts_with(char::is_alphabetic) {
        return None;
    }
    let own = |one: &&str| if **one == *"0" { "0".to_owned() } else { format!("{one} {unit}") };
    let pair = format!("({})", coordinates.iter().map(own).collect::<Vec<_>>().join(", "));
    let end = close + 1 + rest.find(unit)? + unit.len();
    // a point in braces has no word before its coordinates
    let name = before[..open].trim_end();
    let without = name.strip_suffix(" at").map(|name| name.len() + 1);
    let starts = [Some(open), without];
    starts.into_iter().flatten().find_map(|start| case.instead((start, end), &pair, &pair))
}
