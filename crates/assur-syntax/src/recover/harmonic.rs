//! `harmonic(M, 2)`: the name of a law of cams, where a term of a Fourier series is meant.

use super::case::Case;
use assur_text::diagnostic::Diagnosis;

const FOUND: &str = "harmonic";

pub(super) fn explain(case: &Case<'_>) -> Option<Diagnosis> {
    if case.token(case.fail) != FOUND {
        return None;
    }
    let open = case.fail + FOUND.len();
    let inside = inside(case.slice.get(open..)?)?;
    let end = open + inside.len() + "()".len();
    let order = if has_order(inside) { "" } else { ", 1" };
    let part = if case.token(end) == "." { "" } else { ".amplitude" };
    let wanted = format!("fourier({inside}{order}){part}");
    case.instead((case.fail, end), &wanted, &wanted)
}

/// What is between the parenthesis that opens and the one that closes it.
fn inside(text: &str) -> Option<&str> {
    let inner = text.strip_prefix('(')?;
    let mut depth = 1;
    let end = inner.find(|c| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        depth == 0
    })?;
    inner.get(..end)
}

/// Whether a second argument follows the first.
fn has_order(arguments: &str) -> bool {
    let mut depth = 0;
    arguments.contains(|c| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        depth == 0 && c == ','
    })
}
