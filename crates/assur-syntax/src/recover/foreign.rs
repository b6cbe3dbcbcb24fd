//! Words and signs of textbooks and other programs, where the piece reads with those of the language.

use super::case::Case;
use super::phrase::What;
use super::unnamed::points_of;
use crate::recover::{comment_sign, instead, lacking};
use crate::trivia::{Line, corrected};
use crate::words::is_name_char;
use assur_text::diagnostic::{Diagnosis, Help, did_you_mean};
use assur_text::language::PROPERTIES;
use assur_text::source::Span;

pub(super) fn explain(case: &Case<'_>) -> Option<Diagnosis> {
    bars(case)
        .or_else(|| sign_of(case))
        .or_else(|| sense(case))
        .or_else(|| both_conditions(case))
        .or_else(|| segment_of(case))
        .or_else(|| word(case))
        .or_else(|| property(case))
}

/// What others write, the words in its place, and the statements in which it is so; in all of them if none is named.
const WORDS: &[(&str, &[&str], &[&str])] = &[
    ("points", &["steps"], &["drive", "simulate", "find"]),
    ("point", &["steps"], &["drive", "simulate", "find"]),
    ("positions", &["steps"], &["drive", "simulate", "find"]),
    ("intervals", &["steps"], &["drive", "simulate", "find"]),
    ("increments", &["steps"], &["drive", "simulate", "find"]),
    ("parts", &["steps"], &["drive", "simulate", "find"]),
    ("frames", &["steps"], &["drive", "simulate", "find"]),
    ("times", &["steps"], &["drive", "simulate", "find"]),
    ("every", &["step"], &["drive"]),
    ("increment", &["step"], &["drive"]),
    ("interval", &["step"], &["drive"]),
    ("under", &["along", "@"], &["balance", "force", "ground", "link"]),
    ("∠", &["@"], &[]),
    ("upwards", &["up"], &["force"]),
    ("downwards", &["down"], &["force"]),
    ("rightwards", &["right"], &["force"]),
    ("leftwards", &["left"], &["force"]),
    ("clockwise", &["cw"], &[]),
    ("anticlockwise", &["ccw"], &[]),
    ("counterclockwise", &["ccw"], &[]),
    ("backward", &["back"], &["drive"]),
    ("backwards", &["back"], &["drive"]),
    ("forwards", &["forward"], &["drive"]),
    ("parallel", &["along"], &[]),
    ("above", &["left of", "ahead of"], &["assemble"]),
    ("towards", &["to"], &["link", "ground"]),
    ("joining", &["-"], &[]),
    ("tolerance", &["within"], &["expect"]),
];

/// `in 12 points`: the word where reading stopped, or the one before, which was read as a unit or a name.
fn word(case: &Case<'_>) -> Option<Diagnosis> {
    let words = case.words();
    let near = words.iter().rev().filter(|(at, _)| *at > 0 && *at <= case.fail).take(2);
    near.into_iter().find_map(|(at, found)| {
        let wanted = WORDS.iter().filter(|(other, _, of)| {
            *other == found.to_lowercase() && (of.is_empty() || of.contains(&case.token(0)))
        });
        let mut wanted = wanted.flat_map(|(_, wanted, _)| wanted.iter());
        wanted.find_map(|wanted| case.instead((*at, at + found.len()), wanted, wanted))
    })
}

/// `|x|`: the absolute value.
fn bars(case: &Case<'_>) -> Option<Diagnosis> {
    let signs = case.slice.match_indices('|').map(|(at, _)| at).collect::<Vec<_>>();
    let (pairs, rest) = signs.as_chunks::<2>();
    if pairs.is_empty() || !rest.is_empty() || case.slice.contains("||") {
        return None;
    }
    let mut new = case.slice.to_owned();
    for [open, close] in pairs.iter().rev() {
        new.replace_range(close..=close, ")");
        new.replace_range(open..=open, "abs(");
    }
    let [open, close] = pairs[0];
    case.reads(&new).then(|| {
        instead("|…|", "abs(…)", case.span(open, close + 1 - open), case.help(0, case.slice.len(), &new))
    })
}

/// Several lines of which one is meant.
fn one_of(case: &Case<'_>, (start, end): (usize, usize), words: &[&str]) -> Option<Help> {
    let fits = words.iter().filter(|word| case.reads(&case.with(start, end, word)));
    let mut helps = fits.map(|word| case.help(start, end, word)).collect::<Vec<_>>();
    if helps.len() > 1 { Some(Help::one_of(helps)) } else { helps.pop() }
}

/// `assemble s = 0`: an assembly has a coordinate on one side of a value, not at it.
fn sign_of(case: &Case<'_>) -> Option<Diagnosis> {
    if case.token(0) != "assemble" || case.token(case.fail) != "=" {
        return None;
    }
    let end = case.fail + if case.slice.get(case.fail + 1..)?.starts_with('=') { 2 } else { 1 };
    let help = one_of(case, (case.fail, end), &[">", "<"])?;
    Some(instead("=", "> or <", case.span(case.fail, end - case.fail), help))
}

/// `drive P = 0 m moving up`: along the line of the guide, or against it.
fn sense(case: &Case<'_>) -> Option<Diagnosis> {
    let word = case.token(case.fail);
    let before = case.slice.get(..case.fail)?.trim_end();
    let place = matches!(word, "up" | "down" | "left" | "right" | "out" | "in" | "inwards" | "outwards");
    if case.token(0) != "drive" || !before.ends_with(" moving") || !place {
        return None;
    }
    let end = case.fail + word.len();
    let help = one_of(case, (case.fail, end), &["forward", "back"])?;
    Some(instead(word, "forward or back", case.span(case.fail, word.len()), help))
}

/// `when a > b, c > 0`
fn both_conditions(case: &Case<'_>) -> Option<Diagnosis> {
    let before = case.slice.get(..case.fail)?;
    let conditions = before.contains(" when ") || case.token(0) == "until" || case.token(0) == "event";
    if case.token(case.fail) != "," || !conditions {
        return None;
    }
    case.instead((case.fail, case.fail + 1), " and", "and")
}

/// `force q from A to B = …`: on the link that has both points.
fn segment_of(case: &Case<'_>) -> Option<Diagnosis> {
    if case.token(0) != "force" || case.token(case.fail) != "from" {
        return None;
    }
    let words = case.words();
    let here = words.iter().position(|(at, _)| *at == case.fail)?;
    let [(_, "from"), (_, from), (_, "to"), (_, to)] = words.get(here..here + 4)? else { return None };
    let named = |line: &'_ str| {
        let mut words = line.split(|c: char| c == '{' || c.is_whitespace()).filter(|word| !word.is_empty());
        let kind = words.next();
        let number = |word: &&str| word.bytes().all(|b| b.is_ascii_digit());
        matches!(kind, Some("link")).then(|| words.find(|word| !number(word)).map(str::to_owned)).flatten()
    };
    let links = case.text.lines().filter_map(named);
    let both = |link: &String| [from, to].iter().all(|p| points_of(case.text, link).contains(p));
    let links = links.filter(both).map(|link| format!("on {link} ")).collect::<Vec<_>>();
    let texts = links.iter().map(String::as_str).collect::<Vec<_>>();
    let help = one_of(case, (case.fail, case.fail), &texts)?;
    let missing = match texts.as_slice() {
        [only] => only.trim(),
        _ => "on",
    };
    Some(lacking(missing, case.span(case.fail, "from".len()), help))
}

/// `; a remark`, alone on its line
pub(super) fn comment_of_semicolon(case: &Case<'_>) -> Option<Diagnosis> {
    let line = Line::around(case.text, case.offset);
    let before = case.text.get(line.start..case.offset)?;
    if case.what != What::Statement || !before.trim_start().starts_with(';') || !is_prose(case.slice) {
        return None;
    }
    let start = line.start + before.find(';')?;
    let at = Span::new(start, start + 1);
    Some(comment_sign(at, ";", corrected(case.text, at, "//")))
}

/// Whether a piece is words alone.
pub(super) fn is_prose(text: &str) -> bool {
    let letters = |c: char| (is_name_char(c) && !c.is_numeric()) || " .,:!?()'-".contains(c);
    text.starts_with(char::is_alphabetic) && text.chars().all(letters) && !text.contains(": ")
}

/// `{ slot 6 }`: a property in the braces of a statement that is near one.
fn property(case: &Case<'_>) -> Option<Diagnosis> {
    let open = case.slice.find('{')?;
    let (at, found) = case.words().into_iter().rev().find(|(at, _)| *at > open && *at < case.fail)?;
    let known = PROPERTIES.iter().flat_map(|(_, all)| all.iter().map(|p| p.name));
    let near = did_you_mean(found, known);
    near.into_iter().find_map(|wanted| case.instead((at, at + found.len()), wanted, wanted))
}
