//! Pieces that read with one sign or word exchanged, left out, or put into brackets.

use super::case::Case;
use super::phrase::What;
use crate::recover::{self, instead, needless_word};
use crate::words::{self, Expected, Rule, is_name_char, is_reserved};
use assur_text::diagnostic::Diagnosis;
use assur_text::language::{Place, words_of};
use assur_text::units::lookup;

pub(super) fn explain(case: &Case<'_>) -> Option<Diagnosis> {
    broken_unit(case)
        .or_else(|| comma_between(case))
        .or_else(|| without_brackets(case))
        .or_else(|| foreign_operator(case))
        .or_else(|| comma_for_accelerating(case))
        .or_else(|| needless_sign(case))
        .or_else(|| split_word(case))
        .or_else(|| digit_first(case))
        .or_else(|| other_word(case))
        .or_else(|| other_word_before(case))
}

/// Those of them that are one mistake of several, too.
pub(super) fn one_for_another(case: &Case<'_>) -> Option<Diagnosis> {
    foreign_operator(case).or_else(|| other_word(case))
}

/// `A (0, 0), B (1 m, 0)`, `given r = 1 m, l = 2 m`
fn comma_between(case: &Case<'_>) -> Option<Diagnosis> {
    let complete = case.token(case.fail) == "," && case.expected.contains(&Rule::EOI);
    let (first, second) = (case.slice.get(..case.fail)?, case.slice.get(case.fail + 1..)?);
    if !complete || !case.reads(first) {
        return None;
    }
    let again = matches!(case.token(0), "given" | "let") && second.contains('=');
    let line_ends = second.trim_start_matches(' ').starts_with(['\n', '\r']);
    let before = if again { format!("{} ", case.token(0)) } else { String::new() };
    // what follows must be one of its kind too, as far as the next comma
    let ends = second.match_indices(',').map(|(at, _)| at).chain([second.len()]);
    let fits = |end: usize| case.reads(&format!("{before}{}", second.get(..end).unwrap_or_default().trim()));
    if !line_ends && !ends.into_iter().any(fits) {
        return None;
    }
    let each: Vec<&str> = second.split(',').map(str::trim).collect();
    if again && each.iter().all(|one| one.contains('=') && case.reads(&format!("{before}{one}"))) {
        let new: String = each.iter().map(|one| format!("; {before}{one}")).collect();
        return Some(comma(case).help(case.help(case.fail, case.slice.len(), &new)));
    }
    let new = match case.token(0) {
        _ if line_ends => String::new(),
        word if again => format!("; {word}"),
        _ => ";".to_owned(),
    };
    Some(comma(case).help(case.help(case.fail, case.fail + 1, &new)))
}

fn comma(case: &Case<'_>) -> Diagnosis {
    Diagnosis::error("mech::syntax::comma_between", "a comma does not separate statements or members")
        .label(case.span(case.fail, 1), "`;` or a new line instead of this")
}

/// `5 k N`
fn broken_unit(case: &Case<'_>) -> Option<Diagnosis> {
    let before = case.slice.get(..case.fail)?.trim_end();
    let digits = before.rfind(|c: char| c.is_ascii_digit())? + 1;
    let start = before.len() - before.get(digits..)?.trim_start().len();
    let words = case.words().into_iter().filter(|(at, _)| *at >= case.fail).take(2);
    let whole = words.map(|(at, word)| (at + word.len(), case.slice.get(start..at + word.len())));
    let (end, unit) =
        whole.filter_map(|(end, unit)| Some((end, unit?.replace(' ', "")))).find(|(end, unit)| {
            start < before.len() && lookup(unit).is_ok() && case.reads(&case.with(start, *end, unit))
        })?;
    Some(recover::broken_unit(case.span(start, end - start), vec![case.help(start, end, &unit)]))
}

/// `free length 77 mm`
fn split_word(case: &Case<'_>) -> Option<Diagnosis> {
    let words = case.words();
    let (second_at, second) = *words.iter().rev().find(|(at, _)| *at < case.fail)?;
    let (first_at, first) = *words.iter().rev().find(|(at, _)| *at < second_at)?;
    let (start, end) = (first_at, second_at + second.len());
    let joined = format!("{first}_{second}");
    let named = matches!(case.what, What::Property | What::CamMember) && start == 0;
    (named && case.reads(&case.with(start, end, &joined))).then(|| {
        instead(
            &format!("{first} {second}"),
            &joined,
            case.span(start, end - start),
            case.help(start, end, &joined),
        )
    })
}

/// Forms of other languages, and of this one.
const OPERATORS: &[(&str, &str)] = &[
    ("**", "^"),
    ("&&", "and"),
    ("||", "or"),
    ("&", "and"),
    ("|", "or"),
    ("!", "not "),
    ("~", "="),
    ("≈", "="),
    ("...", ".."),
    ("=>", ">="),
    ("<->", "-"),
    ("-->", "-"),
    ("->", "-"),
    ("→", "-"),
    ("--", "-"),
    ("at an angle of", "@"),
    ("at an angle", "@"),
    ("at angle", "@"),
];

fn foreign_operator(case: &Case<'_>) -> Option<Diagnosis> {
    let fits = |start: usize, (found, wanted): &(&'static str, &'static str)| {
        let here = case.slice.get(start..)?.starts_with(found);
        let end = start + found.len();
        (here && case.reads(&case.with(start, end, wanted))).then_some((start, *found, *wanted))
    };
    let starts = [Some(case.fail), case.fail.checked_sub(1), case.fail.checked_sub(2)];
    let (start, found, wanted) = starts
        .into_iter()
        .flatten()
        .find_map(|start| OPERATORS.iter().find_map(|operator| fits(start, operator)))?;
    Some(instead(
        found,
        wanted.trim(),
        case.span(start, found.len()),
        case.help(start, start + found.len(), wanted),
    ))
}

/// `drive crank = 30 deg at 12 rad/s, -40 rad/s^2`
fn comma_for_accelerating(case: &Case<'_>) -> Option<Diagnosis> {
    const WANTED: &str = "accelerating";
    if case.token(0) != "drive" || case.token(case.fail) != "," {
        return None;
    }
    let end = case.fail + 1;
    let blank = if case.slice.get(end..)?.starts_with(' ') { "" } else { " " };
    let new = format!(" {WANTED}{blank}");
    let reads = case.reads(&case.with(case.fail, end, &new));
    reads.then(|| instead(",", WANTED, case.span(case.fail, 1), case.help(case.fail, end, &new)))
}

/// `friction = 0.1` in braces
fn needless_sign(case: &Case<'_>) -> Option<Diagnosis> {
    let found = case.token(case.fail);
    let end = case.fail + found.len();
    let listed = found == "," && case.what == What::Member;
    let needless =
        !listed && matches!(found, "=" | ":" | "," | "-") && case.reads(&case.with(case.fail, end, " "));
    let before = case.slice.get(..case.fail)?.trim_end().len();
    let behind = end + case.slice.get(end..)?.len() - case.slice.get(end..)?.trim_start().len();
    needless.then(|| needless_word(found, case.span(case.fail, found.len()), case.help(before, behind, " ")))
}

/// `position of C`, `find velocity C`: the function is no word that says nothing.
pub(super) fn of_without_brackets(case: &Case<'_>) -> Option<Diagnosis> {
    let asked = matches!(case.token(0), "find" | "expect");
    (asked || case.token(case.fail) == "of").then(|| without_brackets(case))?
}

/// `sin 30 deg`, `position of C`
fn without_brackets(case: &Case<'_>) -> Option<Diagnosis> {
    let words = case.words();
    let (name_at, name) = *words.iter().rev().find(|(at, _)| *at < case.fail)?;
    let name_end = name_at + name.len();
    let here = case.token(case.fail);
    if !words::is_called(name) || !(here == "of" || here.starts_with(is_name_char) && !is_reserved(here)) {
        return None;
    }
    let open = if here == "of" { case.fail + here.len() } else { case.fail };
    // The argument ends with one of the next words, or where reading it stops.
    for (at, word) in words.iter().filter(|(at, _)| *at >= open).take(3) {
        let end = at + word.len();
        let argument = case.slice.get(open..end)?.trim();
        let call = format!("({argument})");
        if case.reads(&case.with(name_end, end, &call)) {
            return Some(
                Diagnosis::error(
                    "mech::syntax::without_brackets",
                    format!("put the argument of `{name}` in parentheses"),
                )
                .label(case.span(open, end - open), "in parentheses")
                .help(case.help(name_end, end, &call)),
            );
        }
    }
    None
}

/// `given 2r = 5 mm`
fn digit_first(case: &Case<'_>) -> Option<Diagnosis> {
    let found = case.token(case.fail);
    let letters = found.trim_start_matches(|c: char| c.is_ascii_digit());
    let digits = &found[..found.len() - letters.len()];
    let named = case.expected.iter().any(|r| words::expected(*r).contains(&Expected::Name));
    if digits.is_empty() || letters.is_empty() || !named {
        return None;
    }
    let end = case.fail + found.len();
    // `1A` where points are named `A`
    let alone = case.text.split(|c| !is_name_char(c)).any(|word| word == letters);
    let wanted = if alone { letters.to_owned() } else { format!("{letters}{digits}") };
    case.reads(&case.with(case.fail, end, &wanted)).then(|| {
        Diagnosis::error(
            "mech::syntax::digit_first",
            format!("`{found}` cannot be a name: it begins with a digit"),
        )
        .label(case.span(case.fail, found.len()), "a name begins with a letter")
        .help(case.help(case.fail, end, &wanted))
    })
}

/// Other spellings of words of the language.
const SYNONYMS: &[(&str, &str)] = &[
    ("clockwise", "cw"),
    ("counterclockwise", "ccw"),
    ("anticlockwise", "ccw"),
    ("along", "@"),
    ("@", "along"),
    ("by", "in"),
    ("with", "at"),
    ("at", "@"),
    ("∠", "@"),
    ("and", ","),
    ("is", "="),
    ("equals", "="),
    ("tolerance", "within"),
    ("speed", "at"),
    ("velocity", "at"),
    ("acceleration", "accelerating"),
    ("if", "when"),
    ("while", "when"),
    ("where", "when"),
    ("opposite", "against"),
    ("opposing", "against"),
    ("opposed", "against"),
    ("via", "through"),
    ("angle", "along"),
    ("angle", "@"),
    ("direction", "@"),
];

/// Whether a word or sign may have been meant: a sign for a word, and what fits nearly everywhere, says nothing.
fn may_replace(found: &str, wanted: &str) -> bool {
    let is_word = |text: &str| text.starts_with(is_name_char);
    let anywhere = ["@", "within", "when", "along", "near", "on"].contains(&wanted);
    !anywhere && (is_word(found) || !is_word(wanted)) && !matches!((found, wanted), (",", ":" | "="))
}

/// A sign or word where another one stands, if there is just one that fits.
fn other_word(case: &Case<'_>) -> Option<Diagnosis> {
    let found = case.token(case.fail);
    let end = case.fail + found.len();
    // `speed of 30 rpm`, `opposite to motion`
    let known = SYNONYMS.iter().any(|(word, _)| *word == found);
    let rest = case.slice.get(end..).filter(|_| known).unwrap_or_default();
    let more = [" of", " to the", " to"]
        .into_iter()
        .find(|more| rest.strip_prefix(more).is_some_and(|r| r.starts_with(' ')));
    let end = end + more.map_or(0, str::len);
    let fits = |wanted: &str| case.reads(&case.with(case.fail, end, &format!(" {wanted} ")));
    let synonym = SYNONYMS.iter().find(|(word, wanted)| *word == found && fits(wanted));
    let mut fitting = match synonym {
        Some((_, wanted)) => vec![(*wanted).to_owned()],
        None if is_reserved(found) || !found.starts_with(is_name_char) => case.literals(),
        None => return None,
    };
    let operator = case.expected.iter().any(|r| words::expected(*r).contains(&Expected::Operator));
    if operator && synonym.is_none() {
        fitting.push("@".to_owned());
    }
    fitting.retain(|w| w != "(" && w != "{" && case.reads(&case.with(case.fail, end, &format!(" {w} "))));
    fitting.dedup();
    let wanted = match fitting.as_slice() {
        [wanted] if synonym.is_some() || may_replace(found, wanted) => wanted,
        _ => return None,
    };
    let before = case.slice.get(..case.fail)?;
    let close = matches!(wanted.as_str(), "," | ":") || before.ends_with(' ');
    let blank = if close { "" } else { " " };
    (!found.is_empty()).then(|| {
        instead(
            found,
            wanted,
            case.span(case.fail, found.len()),
            case.help(case.fail, end, &format!("{blank}{wanted}")),
        )
    })
}

/// A connecting word further back that led astray: `find v in m/s`.
fn other_word_before(case: &Case<'_>) -> Option<Diagnosis> {
    let words = case.words();
    let (at, found) = *words.iter().rev().find(|(at, w)| *at < case.fail && is_reserved(w))?;
    let end = at + found.len();
    let mut fitting = words_of(Place::Connecting).collect::<Vec<_>>();
    fitting
        .retain(|w| !matches!(*w, "and" | "or" | "not") && *w != found && case.reads(&case.with(at, end, w)));
    let wanted = match fitting.as_slice() {
        [wanted] if may_replace(found, wanted) => wanted,
        _ => return None,
    };
    Some(instead(found, wanted, case.span(at, found.len()), case.help(at, end, wanted)))
}
