//! Words of other languages for a sign, a size or a place.

use super::case::Case;
use super::unnamed::points_in;
use crate::recover::{instead, lacking, needless_word};
use crate::trivia::Line;
use crate::words::{Rule, is_name_char};
use assur_text::diagnostic::{Diagnosis, Help};
use assur_text::language::Collection;
use assur_text::units::{Dimension, lookup};

pub(super) fn explain(case: &Case<'_>) -> Option<Diagnosis> {
    at_in_find(case).or_else(|| of_other_languages(case)).or_else(|| comma_in_list(case))
}

/// Those of them that are one mistake of several, too.
pub(super) fn of_other_languages(case: &Case<'_>) -> Option<Diagnosis> {
    times(case)
        .or_else(|| diameter(case))
        .or_else(|| through(case))
        .or_else(|| bar(case))
        .or_else(|| balanced(case))
        .or_else(|| position_or_speed(case))
        .or_else(|| speed_by_name(case))
}

/// Names of quantities in two words.
const TWO_WORDS: &[(&str, &str, &str)] =
    &[("angular", "velocity", "omega"), ("angular", "speed", "omega"), ("angular", "acceleration", "alpha")];

/// `find angular velocity of rocker`
pub(super) fn two_words(case: &Case<'_>) -> Option<Diagnosis> {
    let words = case.words();
    let named =
        |pair: &&[(usize, &str)]| TWO_WORDS.iter().any(|(a, b, _)| (pair[0].1, pair[1].1) == (*a, *b));
    let pair = words.windows(2).find(named)?;
    let (_, _, wanted) = TWO_WORDS.iter().find(|(a, b, _)| (pair[0].1, pair[1].1) == (*a, *b))?;
    let (start, end) = (pair[0].0, pair[1].0 + pair[1].1.len());
    case.instead((start, end), wanted, wanted)
}

/// `find the acceleration of B`
pub(super) fn article(case: &Case<'_>) -> Option<Diagnosis> {
    let words = case.words();
    let asked = matches!(case.token(0), "find" | "expect");
    let is_article = |(_, word): &&(usize, &str)| matches!(*word, "the" | "a" | "an") && asked;
    let (at, word) = *words.iter().filter(|(at, _)| *at <= case.fail).rev().find(is_article)?;
    let end = at + word.len() + 1;
    case.reads(&case.with(at, end, ""))
        .then(|| needless_word(word, case.span(at, word.len()), case.help(at, end, "")))
}

/// `balance Mb on crank`: what is sought, by the letter of its name.
fn balanced(case: &Case<'_>) -> Option<Diagnosis> {
    let name = case.token(case.fail);
    if case.token(0) != "balance" || !name.starts_with(is_name_char) {
        return None;
    }
    if let Some((kind, "on" | "in" | "at")) = case.words().get(1).map(|(_, kind)| (*kind, name)) {
        let effort = if kind == "force" { "Fb" } else { "Mb" };
        let new = format!("{effort} ");
        return case.reads(&case.with(case.fail, case.fail, &new)).then(|| {
            lacking(effort, case.span(case.fail, name.len()), case.help(case.fail, case.fail, &new))
        });
    }
    let line = |kind: &str| case.help(case.fail, case.fail, &format!("{kind} "));
    let reads = |kind: &&str| case.reads(&case.with(case.fail, case.fail, &format!("{kind} ")));
    let kinds: &[&str] = match name.chars().next()? {
        'M' | 'T' => &["torque"],
        'F' | 'P' | 'Q' => &["force"],
        _ => &["torque", "force"],
    };
    let (missing, help) = match kinds.iter().copied().filter(reads).collect::<Vec<_>>().as_slice() {
        [] => return None,
        [kind] => ((*kind).to_owned(), line(kind)),
        several => (several.join("` or `"), Help::one_of(several.iter().map(|kind| line(kind)).collect())),
    };
    Some(lacking(&missing, case.span(case.fail, name.len()), help))
}

/// `find omega(bar) at time = 0.5 s`
fn at_in_find(case: &Case<'_>) -> Option<Diagnosis> {
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
    Some(
        Diagnosis::error(
            "mech::syntax::misplaced_member",
            "an item of `find` is taken at all positions, and takes no `at`",
        )
        .label(case.span(case.fail, "at".len()), "not here")
        .help(format!("to see the value there {answer}; to check one: `expect {item} = … {place}`")),
    )
}

/// `link rod from B to C 350 mm`, `link rod BC 350 mm`
fn bar(case: &Case<'_>) -> Option<Diagnosis> {
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
    case.instead((start, end), &wanted, &wanted)
}

/// `drive crank 45 deg`: `=` before a position, `at` before a speed.
fn position_or_speed(case: &Case<'_>) -> Option<Diagnosis> {
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
    case.reads(&case.with(case.fail, case.fail, &new)).then(|| {
        lacking(
            missing,
            case.span(case.fail, case.token(case.fail).len()),
            case.help(case.fail, case.fail, &new),
        )
    })
}

/// `drive crank = 45 deg omega 1500 rpm`: a name of the speed for `at`.
fn speed_by_name(case: &Case<'_>) -> Option<Diagnosis> {
    const SPEEDS: &[&str] =
        &["omega", "w", "n", "v", "speed", "velocity", "with", "rate", "rotating", "running"];
    let start = case.token(0);
    let word = case.token(case.fail);
    if !matches!(start, "drive" | "start") || !SPEEDS.contains(&word) {
        return None;
    }
    let rest = case.slice.get(case.fail + word.len()..)?;
    let value = rest.trim_start().trim_start_matches('=');
    let end = case.slice.len() - value.len();
    case.reads(&case.with(case.fail, end, "at ").replace("at  ", "at ")).then(|| {
        instead(
            word,
            "at",
            case.span(case.fail, word.len()),
            case.help(case.fail, case.slice.len() - value.trim_start().len(), "at "),
        )
    })
}

/// What is written for `*`.
const TIMES: &[&str] = &["x", "X", "times", "mal"];

/// `0.3 x l`: the word was read as a unit, or stands where reading stopped.
fn times(case: &Case<'_>) -> Option<Diagnosis> {
    let words = case.words();
    let mut near = words.iter().rev().filter(|(at, _)| *at <= case.fail).take(2);
    let (at, found) = *near.find(|(_, word)| TIMES.contains(word))?;
    let end = at + found.len();
    let before = case.slice.get(..at)?.trim_end();
    let new = case.with(before.len(), end, " *");
    let factor = before.ends_with(is_name_char) || before.ends_with(')');
    (factor && case.reads(&new))
        .then(|| instead(found, "*", case.span(at, found.len()), case.help(before.len(), end, " *")))
}

/// `circle rim centre O diameter 100 mm`
fn diameter(case: &Case<'_>) -> Option<Diagnosis> {
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
    case.reads(&case.with(case.fail, end, &new)).then(|| {
        instead(
            case.slice.get(case.fail..end).unwrap_or_default().trim(),
            &new,
            case.span(case.fail, end - case.fail),
            case.help(case.fail, end, &new),
        )
    })
}

/// `line guide along 0 deg`: through which point? One of those in the same braces.
fn through(case: &Case<'_>) -> Option<Diagnosis> {
    if case.what != What::Member || case.token(0) != "line" {
        return None;
    }
    /// The most points that are proposed.
    const MOST: usize = 4;
    let line = Line::around(case.text, case.offset);
    let mut points = points_in(case.text.get(line.start..line.end).unwrap_or_default());
    points.truncate(MOST);
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
    Some(lacking(&missing, at, help))
}

/// `find reactions Mb`: something that is to be found after something complete.
fn comma_in_list(case: &Case<'_>) -> Option<Diagnosis> {
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
    (known && case.reads(&new))
        .then(|| lacking(",", case.span(case.fail, here.len()), case.help(before.len(), case.fail, ", ")))
}

// The kind of part that was being read when a mistake was found.

/// The kind of part being read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum What {
    Statement,
    /// A member of a link.
    Member,
    /// A property in braces.
    Property,
    /// A part of a cam.
    CamMember,
    /// The header of a table of variants.
    Header,
    /// A row of such a table.
    Row,
}

impl What {
    /// The rule that reads it alone.
    pub const fn rule(self) -> Rule {
        match self {
            Self::Statement => Rule::one_statement,
            Self::Member => Rule::one_member,
            Self::Property => Rule::one_property,
            Self::CamMember => Rule::one_cam_member,
            Self::Header => Rule::one_header,
            Self::Row => Rule::one_row,
        }
    }
}
