//! What is said in other words: directions, places, and parts left out, where only one line can be meant.

use super::case::Case;
use super::phrase::What;
use crate::recover::{comment_sign, instead, lacking, needless_word};
use crate::words::is_name_char;
use assur_text::diagnostic::{Diagnosis, Help};
use assur_text::units::lookup;

pub(super) fn explain(case: &Case<'_>) -> Option<Diagnosis> {
    quotes_inside(case)
        .or_else(|| quoted_value(case))
        .or_else(|| position_left_out(case))
        .or_else(|| without_braces(case))
        .or_else(|| one_point(case))
        .or_else(|| square_brackets(case).filter(|_| case.what != What::Header))
        .or_else(|| unit_before_name(case))
        .or_else(|| unit_in_parentheses(case))
        .or_else(|| raised(case))
        .or_else(|| polar_with_comma(case))
        .or_else(|| in_parentheses(case))
        .or_else(|| comment(case))
        .or_else(|| repeated(case))
        .or_else(|| filler(case))
        .or_else(|| in_other_places(case))
        .or_else(|| drive_left_out(case))
        .or_else(|| fillers(case))
}

/// Those of them that are one mistake of several, too.
pub(super) fn in_other_places(case: &Case<'_>) -> Option<Diagnosis> {
    inches(case)
        .or_else(|| direction(case))
        .or_else(|| point_of_link(case))
        .or_else(|| point_of(case))
        .or_else(|| relative(case))
}

/// The repair of a part, if the piece reads with it.
fn repair(case: &Case<'_>, start: usize, end: usize, wanted: &str, new: &str) -> Option<Diagnosis> {
    case.instead((start, end), new, wanted)
}

/// `mechanism "a \"quick\" return"`: a text has no quotes inside.
fn quotes_inside(case: &Case<'_>) -> Option<Diagnosis> {
    let (found, at) = ["\\\"", "\"\""].into_iter().find_map(|sign| Some((sign, case.slice.find(sign)?)))?;
    let new = case.slice.replace(found, "'");
    case.reads(&new)
        .then(|| instead(found, "'", case.span(at, found.len()), case.help(0, case.slice.len(), &new)))
}

/// `given P = "1000 N"`
fn quoted_value(case: &Case<'_>) -> Option<Diagnosis> {
    let open = case.slice.find('"').filter(|_| case.token(0) != "mechanism")?;
    let inner = case.slice.get(open + 1..)?.split('"').next()?;
    case.instead((open, open + inner.len() + 2), inner, inner)
}

/// `drive crank = at 1500 rpm`
fn position_left_out(case: &Case<'_>) -> Option<Diagnosis> {
    let before = case.slice.get(..case.fail)?.trim_end();
    let asked = matches!(case.token(0), "drive" | "start") && before.ends_with('=');
    if !asked || case.token(case.fail) != "at" {
        return None;
    }
    let rest = case.slice.get(case.fail + "at".len()..)?;
    let turns = ["rpm", "rad", "deg", "rev"].iter().any(|unit| rest.contains(unit));
    let position = if turns { "45 deg" } else { "100 mm" };
    let new = format!("{position} at");
    case.reads(&case.with(case.fail, case.fail + "at".len(), &new)).then(|| {
        lacking(
            position,
            case.span(case.fail, "at".len()),
            case.help(case.fail, case.fail + "at".len(), &new),
        )
    })
}

/// `link piston C (0, 0)`, `link piston ( C (0, 0) )`
fn without_braces(case: &Case<'_>) -> Option<Diagnosis> {
    if !matches!(case.token(0), "link" | "ground" | "shaft" | "slider") || !case.slice.contains('(') {
        return None;
    }
    let end = case.slice.trim_end().len();
    let whole = case.slice.get(..end)?;
    let words = case.words();
    let inside = whole.find('(').filter(|_| whole.ends_with(')'));
    let parentheses = inside.map(|open| (open, open + 1, end - 1));
    let members = words.iter().skip(1).take(5).map(|(at, _)| (*at, *at, end));
    let mut tried = members.chain(parentheses).filter(|(from, ..)| *from <= case.fail.max(*from));
    let braces = |(_, inner, to): &(usize, usize, usize)| {
        format!("{{ {} }}", whole.get(*inner..*to).unwrap_or_default().trim())
    };
    // a point with its coordinates comes first
    let is_point = |inner: usize| {
        let name = case.token(inner);
        let rest = whole.get(inner + name.len()..).unwrap_or_default();
        name.starts_with(char::is_alphabetic) && rest.starts_with(' ') && rest.trim_start().starts_with('(')
    };
    let (from, new) = tried.find_map(|place| {
        let first = whole.get(place.1..).map_or(0, |rest| rest.len() - rest.trim_start().len());
        let new = braces(&place);
        if !is_point(place.1 + first) {
            return None;
        }
        case.reads(&case.with(place.0, end, &new)).then_some((place.0, new))
    })?;
    Some(instead(
        whole.get(from..end).unwrap_or_default(),
        &new,
        case.span(from, end - from),
        case.help(from, end, &new),
    ))
}

/// `assemble C right of B`: left and right are of a line through two points.
fn one_point(case: &Case<'_>) -> Option<Diagnosis> {
    let words = case.words();
    let side = words.windows(2).find(|w| matches!(w[0].1, "left" | "right") && w[1].1 == "of")?;
    let (start, end) = (side[0].0, side[1].0 + "of".len());
    let fits = |wanted: &str| case.reads(&case.with(start, end, wanted));
    (case.token(0) == "assemble" && fits("ahead of")).then(|| {
        instead(
            &format!("{} of", side[0].1),
            "ahead of",
            case.span(start, end - start),
            Help::one_of(vec![case.help(start, end, "ahead of"), case.help(start, end, "behind")]),
        )
    })
}

/// `[x, y]`, `100 [mm]`
fn square_brackets(case: &Case<'_>) -> Option<Diagnosis> {
    let open = case.slice.find('[')?;
    let with = |open: &str, close: &str| case.slice.replace('[', open).replace(']', close);
    let tried = [("(", with("(", ")")), ("as", with("as ", "")), ("no bracket", with("", ""))];
    let (wanted, fits) = tried.into_iter().find(|(_, new)| case.reads(new))?;
    Some(instead("[", wanted, case.span(open, 1), case.help(0, case.slice.len(), &fits)))
}

/// `r (mm), n (rpm)` in the header of a table
fn unit_in_parentheses(case: &Case<'_>) -> Option<Diagnosis> {
    let open = case.slice.find('(').filter(|_| case.what == What::Header)?;
    let new = case.slice.replace('(', "[").replace(')', "]");
    case.reads(&new).then(|| instead("(", "[", case.span(open, 1), case.help(0, case.slice.len(), &new)))
}

/// `[mm] r` in the header of a table: the unit comes after the name.
fn unit_before_name(case: &Case<'_>) -> Option<Diagnosis> {
    let header = case.what == What::Header && case.slice.contains('[');
    let columns = case.slice.split(',').filter(|_| header);
    let turned = columns.map(|column| {
        let (unit, name) = column.trim().strip_prefix('[')?.split_once(']')?;
        Some(format!("{} [{unit}]", name.trim()))
    });
    let turned: Vec<Option<String>> = turned.collect();
    let written: Vec<&str> = case.slice.split(',').map(str::trim).collect();
    let (first, new) = written.iter().zip(&turned).find_map(|(old, new)| Some((*old, new.as_ref()?)))?;
    let line = written.iter().zip(&turned).map(|(old, new)| new.as_deref().unwrap_or(old));
    let line = line.collect::<Vec<_>>().join(", ");
    case.reads(&line).then(|| {
        instead(
            first,
            new,
            case.span(case.slice.find(first).unwrap_or_default(), first.len()),
            case.help(0, case.slice.trim_end().len(), &line),
        )
    })
}

/// `r²`
fn raised(case: &Case<'_>) -> Option<Diagnosis> {
    let (sign, power) =
        [('²', "^2"), ('³', "^3")].into_iter().find(|(sign, _)| case.slice.contains(*sign))?;
    let at = case.slice.find(sign)?;
    let all = case.slice.replace('²', "^2").replace('³', "^3");
    case.reads(&all).then(|| {
        instead(
            &sign.to_string(),
            power,
            case.span(at, sign.len_utf8()),
            case.help(0, case.slice.len(), &all),
        )
    })
}

/// `190mm mm`, `leg - plate -`: a word twice, or a sign that joins nothing.
fn repeated(case: &Case<'_>) -> Option<Diagnosis> {
    let token = case.token(case.fail);
    let before = case.slice.get(..case.fail)?.trim_end();
    let (start, end) = if token.is_empty() {
        let sign = before.chars().next_back().filter(|c| "-,+*/=.".contains(*c))?;
        // `r.p.m.` is another matter
        let dots = || before.rsplit(' ').next().unwrap_or_default().split('.');
        let is_number = |part: &&str| part.ends_with(|c: char| c.is_ascii_digit());
        if sign == '.' && dots().count() > 2 + usize::from(dots().next().as_ref().is_some_and(is_number)) {
            return None;
        }
        (before.len() - sign.len_utf8(), before.len())
    } else if token.starts_with(char::is_alphabetic) && before.ends_with(token) {
        (case.fail, case.fail + token.len())
    } else {
        return None;
    };
    let left = case.slice.get(..start)?.trim_end().len();
    case.reads(case.with(left, end, "").trim_end()).then(|| {
        needless_word(
            case.slice.get(start..end).unwrap_or_default(),
            case.span(start, end - start),
            case.help(left, end, ""),
        )
    })
}

/// Words that say nothing where they are.
const FILLERS: &[&str] = &[
    "is", "are", "joint", "pair", "hinge", "length", "size", "constant", "const", "the", "a", "an", "point",
    "link", "equal", "uniform", "value", "for", "during",
];

/// `revolute joint A: …`, `link rod B-C length 350 mm`
fn filler(case: &Case<'_>) -> Option<Diagnosis> {
    if case.what != What::Statement {
        return None;
    }
    let words = case.words();
    let mut near = words.iter().filter(|(at, word)| *at > 0 && *at <= case.fail && FILLERS.contains(word));
    let (at, word) = near.next_back()?;
    let left = case.slice.get(..*at)?.trim_end().len();
    let end = at + word.len();
    case.reads(&case.with(left, end, ""))
        .then(|| needless_word(word, case.span(*at, word.len()), case.help(left, end, "")))
}

/// `C to the left of B-D`, `at a speed of 30 rpm`: words around the place where reading stopped.
fn fillers(case: &Case<'_>) -> Option<Diagnosis> {
    /// The most words that are left out.
    const MOST: usize = 4;
    const MORE: &[&str] = &["to", "on", "at", "of", "by", "from", "speed", "velocity", "angle"];
    if case.what != What::Statement {
        return None;
    }
    let says_nothing = |word: &str| FILLERS.contains(&word) || MORE.contains(&word);
    let words = case.words();
    let here = words.iter().position(|(at, _)| *at >= case.fail)?;
    let before = words.get(..here)?.iter().rev().take_while(|(_, word)| says_nothing(word)).take(MOST);
    let starts = std::iter::once(case.fail).chain(before.map(|(at, _)| *at)).collect::<Vec<_>>();
    let run = words.get(here..)?.iter().take_while(|(_, word)| says_nothing(word)).take(MOST);
    let last = words.get(here.checked_sub(1)?).filter(|_| starts.len() > 1);
    // what has an argument is a function
    let alone = |end: &usize| !case.slice.get(*end..).unwrap_or_default().trim_start().starts_with('(');
    let ends =
        last.into_iter().chain(run).map(|(at, word)| at + word.len()).filter(alone).collect::<Vec<_>>();
    let all = starts.iter().flat_map(|start| ends.iter().map(move |end| (*start, *end)));
    let left = |start: usize| case.slice.get(..start).unwrap_or_default().trim_end().len();
    let (start, end) = all
        .into_iter()
        .filter(|(start, end)| start < end)
        .find(|(start, end)| case.reads(&case.with(left(*start), *end, "")))?;
    Some(needless_word(
        case.slice.get(start..end)?,
        case.span(start, end - start),
        case.help(left(start), end, ""),
    ))
}

/// `P 70 mm, 45 deg`: a point by its distance and direction.
fn polar_with_comma(case: &Case<'_>) -> Option<Diagnosis> {
    let (before, behind) = case.slice.split_once(',')?;
    let is_angle = ["deg", "rad", "°"].iter().any(|unit| behind.trim_end().ends_with(unit));
    let at = before.len();
    let alone = case.what == What::Member && is_angle && !before.contains('(');
    if alone { case.instead((at, at + 1), " at", "at") } else { None }
}

/// `A 0, 0`, `A (0 0)`, `(120, 10) mm`, `1 rad/s (5 %)`
fn in_parentheses(case: &Case<'_>) -> Option<Diagnosis> {
    let (from, new, wanted) =
        coordinates_alone(case).or_else(|| blank_between(case)).or_else(|| unit_behind(case))?;
    case.reads(&new).then(|| {
        instead(
            case.slice.get(from..).unwrap_or_default().trim(),
            &wanted,
            case.span(from, case.slice.len() - from),
            case.help(0, case.slice.len(), &new),
        )
    })
}

/// What is wrong from a byte on, the piece with it corrected, and what is wanted there.
type Corrected = (usize, String, String);

/// `A 0, 0`
fn coordinates_alone(case: &Case<'_>) -> Option<Corrected> {
    let (name, rest) = case.slice.split_once(' ')?;
    let numbers =
        rest.trim_start().starts_with(|c: char| c.is_ascii_digit() || c == '-') && rest.contains(',');
    let wanted = format!("({})", rest.trim());
    let point = case.what == What::Member && numbers && name.chars().all(is_name_char);
    point.then(|| (name.len() + 1, format!("{name} {wanted}"), wanted))
}

/// `(0 0)`
fn blank_between(case: &Case<'_>) -> Option<Corrected> {
    let before = case.slice.get(..case.fail)?.trim_end();
    let open =
        before.rfind('(').filter(|open| !before.get(*open..).unwrap_or_default().contains([')', ',']))?;
    let number = case.token(case.fail).starts_with(|c: char| c.is_ascii_digit() || c == '-');
    let new = case.with(before.len(), case.fail, ", ");
    let wanted = new.get(open..)?.to_owned();
    number.then_some((open, new, wanted))
}

/// `(120, 10) mm`; `(5 %)` after an expected value
fn unit_behind(case: &Case<'_>) -> Option<Corrected> {
    let before = case.slice.get(..case.fail)?.trim_end();
    if case.token(0) == "expect" && case.token(case.fail) == "(" {
        let (inside, rest) = case.slice.get(case.fail + 1..)?.split_once(')')?;
        let wanted = format!("within {}{rest}", inside.trim());
        return Some((case.fail, format!("{before} {wanted}"), wanted));
    }
    let open = before.strip_suffix(')')?.rfind('(')?;
    let (x, y) = before.get(open + 1..before.len() - 1)?.split_once(',')?;
    let rest = case.slice.get(case.fail..)?;
    let end = rest.find([' ', ';', '}', '\n']).unwrap_or(rest.len());
    let (unit, behind) = rest.split_at(end);
    lookup(unit).ok()?;
    let wanted = format!("({} {unit}, {} {unit})", x.trim(), y.trim());
    Some((open, format!("{}{wanted}{behind}", case.slice.get(..open)?), wanted))
}

/// `… % a comment`
fn comment(case: &Case<'_>) -> Option<Diagnosis> {
    let rest = case.slice.get(case.fail..)?;
    let sign = ["%", "--", "!", "'"].into_iter().find(|sign| rest.starts_with(sign))?;
    let words = rest.get(sign.len()..).is_some_and(|text| text.starts_with(' '));
    let complete = words && case.reads(case.slice.get(..case.fail)?.trim_end());
    complete.then(|| {
        comment_sign(
            case.span(case.fail, sign.len()),
            sign,
            case.help(case.fail, case.fail + sign.len(), "//"),
        )
    })
}

/// `5 in`: `in` is a word of the language, the unit is `inch`.
fn inches(case: &Case<'_>) -> Option<Diagnosis> {
    let is_unit = |(at, word): &(usize, &str)| {
        let before = case.slice.get(..*at).unwrap_or_default().trim_end();
        let behind_number = before.ends_with(|c: char| c.is_ascii_digit() || "*/·".contains(c));
        *word == "in" && (behind_number || before.ends_with(" as"))
    };
    let found = case.words().into_iter().filter(is_unit).map(|(at, _)| at).collect::<Vec<_>>();
    let first = *found.first()?;
    let mut all = case.slice.to_owned();
    for at in found.iter().rev() {
        all.replace_range(*at..at + 2, "inch");
    }
    case.reads(&all).then(|| instead("in", "inch", case.span(first, 2), case.help(0, case.slice.len(), &all)))
}

const DIRECTIONS: &[(&[&str], &str)] = &[
    (&["right", "rightward", "rightwards"], "@ 0 deg"),
    (&["up", "upward", "upwards"], "@ 90 deg"),
    (&["left", "leftward", "leftwards"], "@ 180 deg"),
    (&["down", "downward", "downwards"], "@ 270 deg"),
];

/// `3 kN left`, `100 N to the left`
fn direction(case: &Case<'_>) -> Option<Diagnosis> {
    let words = case.words();
    let (at, word) = *words.iter().find(|(at, _)| *at >= case.fail)?;
    let skipped = case.slice.get(case.fail..at)?.trim();
    let (end, word) = match (skipped, word) {
        ("", "to" | "in") => words.iter().rev().find(|(i, _)| *i > at).map(|(i, w)| (i + w.len(), *w))?,
        ("", word) => (at + word.len(), word),
        _ => return None,
    };
    let (_, angle) = DIRECTIONS.iter().find(|(words, _)| words.contains(&word))?;
    repair(case, case.fail, end, angle, angle)
}

/// `force F on crank.B`
fn point_of_link(case: &Case<'_>) -> Option<Diagnosis> {
    let dot = case.token(case.fail) == ".";
    if dot { repair(case, case.fail, case.fail + 1, "at", " at ") } else { None }
}

/// `force F on S of coupler`
fn point_of(case: &Case<'_>) -> Option<Diagnosis> {
    let words = case.words();
    let of = words.iter().position(|(at, word)| *at >= case.fail && *word == "of")?;
    let [(on_at, "on"), (_, point), (_, "of"), (link_at, link)] = words.get(of.checked_sub(2)?..of + 2)?
    else {
        return None;
    };
    let new = format!("on {link} at {point}");
    repair(case, *on_at, link_at + link.len(), &new, &new)
}

/// `position(C) relative to D`
fn relative(case: &Case<'_>) -> Option<Diagnosis> {
    let rest = case.slice.get(case.fail..)?;
    let of = ["relative to ", "with respect to ", "minus "].into_iter().find_map(|w| rest.strip_prefix(w))?;
    let before = case.slice.get(..case.fail)?.trim_end();
    let open = before.strip_suffix(')')?.rfind('(')?;
    let name = before.get(..open)?.rsplit(|c| !is_name_char(c)).next()?;
    let of = of.trim_start();
    let reference = of.find(|c| !is_name_char(c) && c != '.').map_or(of, |end| &of[..end]);
    let end = case.slice.len() - of.len() + reference.len();
    let wanted = format!("- {name}({reference})");
    repair(case, case.fail, end, &wanted, &wanted)
}

/// `expect Mb = 80 deg at 60 deg`: at which position of the drive?
fn drive_left_out(case: &Case<'_>) -> Option<Diagnosis> {
    let word = case.token(0);
    if case.what != What::Statement || !matches!(word, "expect" | "pose") {
        return None;
    }
    let drives = case.text.lines().filter_map(|line| line.trim_start().strip_prefix("drive "));
    let name = drives.filter_map(|rest| rest.trim_start().split([' ', '=']).next()).next()?;
    let missing = format!("{name} =");
    let new = format!("{missing} ");
    case.reads(&case.with(case.fail, case.fail, &new)).then(|| {
        lacking(
            &missing,
            case.span(case.fail, case.token(case.fail).len()),
            case.help(case.fail, case.fail, &new),
        )
    })
}
