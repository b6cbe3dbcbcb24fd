//! Words of other languages for a sign, a size or a place.

use super::case::Case;
use super::what::What;
use crate::error::SyntaxError;
use crate::line::Line;
use crate::words::is_name_char;
use assur_text::diagnostic::Help;
use assur_text::language::Collection;
use assur_text::units::{Dimension, lookup};

pub(super) fn explain(case: &Case<'_>) -> Option<SyntaxError> {
    at_in_find(case)
        .or_else(|| times(case))
        .or_else(|| diameter(case))
        .or_else(|| through(case))
        .or_else(|| bar(case))
        .or_else(|| position_or_speed(case))
        .or_else(|| comma_in_list(case))
}

/// `find omega(bar) at time = 0.5 s`
fn at_in_find(case: &Case<'_>) -> Option<SyntaxError> {
    if case.token(0) != "find" || case.token(case.fail) != "at" {
        return None;
    }
    let items = case.slice.get(..case.fail)?.trim_start_matches("find");
    let mut depth = 0;
    let between = |c: char| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        c == ',' && depth == 0
    };
    let item = items.split(between).next_back()?.trim();
    if item.is_empty() {
        // `at` is meant as a name
        return None;
    }
    let place = case.slice.get(case.fail..)?.trim();
    let answer = if place.starts_with("at time") || place.starts_with("at event") {
        "give `simulate … in N steps` an N that meets the instant"
    } else {
        "give the drive this position"
    };
    Some(SyntaxError::FindAt {
        help: format!("to see the value there {answer}; to check one: `expect {item} = … {place}`").into(),
        at: case.span(case.fail, "at".len()),
    })
}

/// `link rod from B to C 350 mm`, `link rod BC 350 mm`
fn bar(case: &Case<'_>) -> Option<SyntaxError> {
    let words = case.words();
    let at = words.iter().rposition(|(at, _)| *at < case.fail || case.token(*at) == "from")?;
    if case.token(0) != "link" {
        return None;
    }
    let ends = |pair: (usize, &str)| {
        let second = pair.1.char_indices().skip(1).find(|(_, c)| c.is_uppercase())?.0;
        let (from, to) = pair.1.split_at(second);
        from.starts_with(char::is_uppercase).then(|| (pair.0, pair.0 + pair.1.len(), format!("{from}-{to}")))
    };
    let spoken = words.windows(4).find_map(|four| match four {
        [(start, "from"), (_, from), (_, "to"), (last, to)] => {
            Some((*start, last + to.len(), format!("{from}-{to}")))
        }
        _ => None,
    });
    let (start, end, wanted) = spoken.or_else(|| ends(*words.get(at)?))?;
    case.reads(&case.with(start, end, &wanted)).then(|| SyntaxError::OtherWord {
        found: case.slice.get(start..end).unwrap_or_default().to_owned(),
        wanted: wanted.clone(),
        at: case.span(start, end - start),
        help: case.help(start, end, &wanted),
    })
}

/// `drive crank 45 deg`: `=` before a position, `at` before a speed.
fn position_or_speed(case: &Case<'_>) -> Option<SyntaxError> {
    if case.token(0) != "drive" || !case.token(case.fail).starts_with(|c: char| c.is_ascii_digit()) {
        return None;
    }
    let value = case.slice.get(case.fail..)?;
    let unit = value.trim_start_matches(|c: char| c.is_ascii_digit() || matches!(c, '.' | ' '));
    let unit = lookup(unit.split(' ').next()?).ok()?;
    let missing = match unit.dimension {
        Dimension::ANGLE | Dimension::LENGTH => "=",
        Dimension::ANGULAR_VELOCITY | Dimension::VELOCITY => "at",
        _ => return None,
    };
    let new = format!("{missing} ");
    case.reads(&case.with(case.fail, case.fail, &new)).then(|| SyntaxError::MissingWord {
        missing: missing.to_owned(),
        at: case.span(case.fail, case.token(case.fail).len()),
        help: case.help(case.fail, case.fail, &new),
    })
}

/// What is written for `*`.
const TIMES: &[&str] = &["x", "X", "times", "mal"];

/// `0.3 x l`: the word was read as a unit, or stands where reading stopped.
fn times(case: &Case<'_>) -> Option<SyntaxError> {
    let words = case.words();
    let mut near = words.iter().rev().filter(|(at, _)| *at <= case.fail).take(2);
    let (at, found) = *near.find(|(_, word)| TIMES.contains(word))?;
    let end = at + found.len();
    let before = case.slice.get(..at)?.trim_end();
    let new = case.with(before.len(), end, " *");
    let factor = before.ends_with(is_name_char) || before.ends_with(')');
    (factor && case.reads(&new)).then(|| SyntaxError::OtherWord {
        found: found.to_owned(),
        wanted: "*".to_owned(),
        at: case.span(at, found.len()),
        help: case.help(before.len(), end, " *"),
    })
}

/// `circle rim centre O diameter 100 mm`
fn diameter(case: &Case<'_>) -> Option<SyntaxError> {
    let found = case.token(case.fail);
    if !matches!(found, "diameter" | "dia" | "d" | "⌀" | "Ø") {
        return None;
    }
    let rest = case.slice.get(case.fail + found.len()..)?;
    let value = rest.trim();
    let digits = value.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(value.len());
    let (number, unit) = value.split_at(digits);
    let half = match number.parse::<f64>() {
        Ok(number) if unit.trim().chars().all(char::is_alphabetic) => format!("{}{unit}", number / 2.0),
        _ if value.chars().all(|c| is_name_char(c) || c == '.') => format!("{value}/2"),
        _ => format!("({value})/2"),
    };
    let new = format!("radius {half}");
    let end = case.slice.len();
    case.reads(&case.with(case.fail, end, &new)).then(|| SyntaxError::OtherWord {
        found: case.slice.get(case.fail..end).unwrap_or_default().trim().to_owned(),
        wanted: new.clone(),
        at: case.span(case.fail, end - case.fail),
        help: case.help(case.fail, end, &new),
    })
}

/// `line guide along 0 deg`: through which point? One of those in the same braces.
fn through(case: &Case<'_>) -> Option<SyntaxError> {
    if case.what != What::Member || case.token(0) != "line" {
        return None;
    }
    let points = points(case);
    let with = |point: &str| format!("through {point} ");
    let fits = |point: &&str| case.reads(&case.with(case.fail, case.fail, &with(point)));
    let points = points.into_iter().filter(fits).collect::<Vec<_>>();
    let line = |point: &&str| case.help(case.fail, case.fail, &with(point));
    let (missing, help) = match points.as_slice() {
        [] => return None,
        [point] => (format!("through {point}"), line(point)),
        _ => ("through".to_owned(), Help::one_of(points.iter().map(line).collect())),
    };
    let at = case.span(case.fail, case.token(case.fail).len());
    Some(SyntaxError::MissingWord { missing, at, help })
}

/// The points on the line of a member, of the bar and in the braces.
fn points<'a>(case: &Case<'a>) -> Vec<&'a str> {
    /// The most points that are proposed.
    const MOST: usize = 4;
    let line = Line::around(case.text, case.offset);
    let line = case.text.get(line.start..line.end).unwrap_or_default();
    let (head, body) = line.split_once('{').unwrap_or(("", line));
    let named = |text: &'a str| !text.is_empty() && text.chars().all(is_name_char);
    let bar = head.split_whitespace().find_map(|word| word.split_once('-'));
    let ends = bar.into_iter().flat_map(|(from, to)| [from, to]);
    let members = body.split([';', '}']).filter_map(|member| member.trim().split_once('('));
    let mut points =
        ends.chain(members.map(|(name, _)| name.trim())).filter(|p| named(p)).collect::<Vec<_>>();
    points.truncate(MOST);
    points
}

/// `find reactions Mb`: something that is to be found after something complete.
fn comma_in_list(case: &Case<'_>) -> Option<SyntaxError> {
    let before = case.slice.get(..case.fail)?.trim_end();
    let here = case.token(case.fail);
    let complete = case.token(0) == "find" && before != "find" && case.reads(before);
    if !complete || !here.starts_with(is_name_char) {
        return None;
    }
    // `find v velocity(C)`: a name that stands nowhere else is given to what follows
    let last = before.rsplit(|c| !is_name_char(c)).next().unwrap_or_default();
    let count = case.text.split(|c| !is_name_char(c)).filter(|word| *word == last).count();
    let known = count > 1 || Collection::named(last).is_some() || before.ends_with(')');
    let new = case.with(before.len(), case.fail, ", ");
    (known && case.reads(&new)).then(|| SyntaxError::MissingWord {
        missing: ",".to_owned(),
        at: case.span(case.fail, here.len()),
        help: case.help(before.len(), case.fail, ", "),
    })
}
