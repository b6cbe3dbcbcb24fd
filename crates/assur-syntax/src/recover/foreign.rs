//! Words and signs of textbooks and other programs, where the piece reads with those of the language.

use super::case::Case;
use super::phrase::What;
use super::unnamed::points_of;
use crate::recover::{comment_sign, instead, lacking, needless_word};
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
        .or_else(|| phrase(case))
        .or_else(|| count_of_steps(case))
        .or_else(|| name_of_speed(case))
        .or_else(|| in_hinge(case))
        .or_else(|| segment_of(case))
        .or_else(|| colon(case))
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
    ("decreasing", &["falling"], &["event"]),
    ("increasing", &["rising"], &["event"]),
    ("torque", &["capacity"], &["clutch", "brake"]),
    ("of", &["in"], &["force"]),
    ("clockwise", &["cw"], &[]),
    ("anticlockwise", &["ccw"], &[]),
    ("counterclockwise", &["ccw"], &[]),
    ("backward", &["back"], &["drive"]),
    ("backwards", &["back"], &["drive"]),
    ("forwards", &["forward"], &["drive"]),
    ("parallel", &["along"], &[]),
    ("above", &["left of"], &["assemble"]),
    ("towards", &["to"], &["link", "ground"]),
    ("joining", &["-"], &[]),
    ("tolerance", &["within"], &["expect"]),
    ("in", &["at"], &["mass", "weight"]),
    ("on", &["at"], &["mass", "weight"]),
    ("z", &["teeth"], &["wheel"]),
    ("Z", &["teeth"], &["wheel"]),
    ("m", &["module"], &["wheel"]),
    ("r", &["radius"], &["wheel", "circle"]),
    ("R", &["radius"], &["wheel", "circle"]),
    ("d", &["diameter"], &["wheel"]),
    ("sine", &["cycloidal"], &["rise", "fall"]),
    ("cycloid", &["cycloidal"], &["rise", "fall"]),
    ("cosine", &["harmonic"], &["rise", "fall"]),
    ("shm", &["harmonic"], &["rise", "fall"]),
    ("simple_harmonic", &["harmonic"], &["rise", "fall"]),
    ("constant_velocity", &["uniform"], &["rise", "fall"]),
    ("linear", &["uniform"], &["rise", "fall"]),
    ("constant_acceleration", &["parabolic"], &["rise", "fall"]),
    ("parabola", &["parabolic"], &["rise", "fall"]),
    ("polynomial", &["poly345", "poly4567"], &["rise", "fall"]),
    ("sinusoidal", &["cycloidal", "harmonic"], &["rise", "fall"]),
];

/// Several words for one.
const PHRASES: &[(&str, &str)] = &[
    ("in front of", "ahead of"),
    ("in back of", "behind"),
    ("to the left of", "left of"),
    ("to the right of", "right of"),
    ("on the left of", "left of"),
    ("on the right of", "right of"),
    ("counter clockwise", "ccw"),
    ("counter-clockwise", "ccw"),
    ("anti-clockwise", "ccw"),
    ("against the motion", "against motion"),
    ("opposite to motion", "against motion"),
    ("in direction of", "along"),
    ("in the direction of", "along"),
    ("as long as", "when"),
    ("simulate until", "simulate"),
    ("simulate up to", "simulate"),
    ("simulate to", "simulate"),
];

fn phrase(case: &Case<'_>) -> Option<Diagnosis> {
    PHRASES.iter().find_map(|(found, wanted)| {
        let at = case.slice.find(found)?;
        case.instead((at, at + found.len()), wanted, wanted)
    })
}

/// `with 5 positions`: `in 5 steps`
fn count_of_steps(case: &Case<'_>) -> Option<Diagnosis> {
    let words = case.words();
    let steps = |word: &str| {
        WORDS.iter().any(|(other, wanted, _)| *other == word && *wanted == ["steps"]) || word == "steps"
    };
    let run = words.windows(3).find(|run| {
        let number = run[1].1.bytes().all(|b| b.is_ascii_digit());
        number
            && steps(run[2].1)
            && matches!(run[0].1, "with" | "by" | "using" | "at" | "over" | "for" | "of")
    })?;
    let (start, end) = (run[0].0, run[2].0 + run[2].1.len());
    let wanted = format!("in {} steps", run[1].1);
    case.instead((start, end), &wanted, &wanted)
}

/// `at n = 1450 rpm`: a speed has no name of its own in a statement.
fn name_of_speed(case: &Case<'_>) -> Option<Diagnosis> {
    let words = case.words();
    let at = words.windows(2).find(|pair| pair[0].1 == "at" && case.fail >= pair[1].0)?;
    let (name_at, name) = at[1];
    let rest = case.slice.get(name_at + name.len()..)?;
    let value = rest.trim_start().strip_prefix('=')?.trim_start();
    let end = case.slice.len() - value.len();
    let is_speed = ["rpm", "/s", "/min", "rev"].iter().any(|unit| value.contains(unit));
    let drives = matches!(case.token(0), "drive" | "start") && is_speed;
    let reads = drives && case.reads(&case.with(name_at, end, ""));
    reads.then(|| {
        let found = case.slice.get(name_at..end).unwrap_or_default().trim();
        needless_word(found, case.span(name_at, found.len()), case.help(name_at, end, ""))
    })
}

/// `spring k: O`: a spring in a hinge.
fn in_hinge(case: &Case<'_>) -> Option<Diagnosis> {
    let colon = case.slice.find(':').filter(|_| case.token(0) == "spring")?;
    let end =
        colon + 1 + case.slice.get(colon + 1..)?.len() - case.slice.get(colon + 1..)?.trim_start().len();
    let reads = case.reads(&case.with(colon, end, " in "));
    reads.then(|| instead(":", "in", case.span(colon, 1), case.help(colon, end, " in ")))
}

/// `hydraulic cylinder c: …`: a word before a statement that reads without it.
pub(super) fn adjective(case: &Case<'_>) -> Option<Diagnosis> {
    let words = case.words();
    let [(0, first), (at, second), ..] = words.as_slice() else { return None };
    let is_word = crate::words::is_statement(second) && !crate::words::is_statement(first);
    let joined = case.slice.get(first.len()..*at)?.trim().is_empty();
    (case.what == What::Statement && is_word && joined && case.reads(case.slice.get(*at..)?))
        .then(|| needless_word(first, case.span(0, first.len()), case.help(0, *at, "")))
}

/// `pose upper: crank = 100 deg`: the word that is due in place of a colon.
fn colon(case: &Case<'_>) -> Option<Diagnosis> {
    let place = (case.fail, case.fail + 1);
    let fits = |word: &String| case.reads(&case.with(place.0, place.1, &format!(" {word} ")));
    let is_word = |word: &String| word.starts_with(char::is_alphabetic);
    let mut wanted = case.literals().into_iter().filter(|w| is_word(w) && fits(w));
    let word = wanted.next().filter(|_| case.token(case.fail) == ":" && wanted.next().is_none())?;
    case.instead(place, &format!(" {word}"), &word)
}

/// `in 12 points`: the word where reading stopped, or the one before, which was read as a unit or a name.
fn word(case: &Case<'_>) -> Option<Diagnosis> {
    let words = case.words();
    let near = words.iter().rev().filter(|(at, _)| *at > 0 && *at <= case.fail).take(2);
    near.into_iter().find_map(|(at, found)| {
        let wanted = WORDS.iter().filter(|(other, _, of)| {
            *other == found.to_lowercase() && (of.is_empty() || of.contains(&case.token(0)))
        });
        let wanted = wanted.flat_map(|(_, wanted, _)| wanted.iter().copied()).collect::<Vec<_>>();
        let place = (*at, at + found.len());
        let help = one_of(case, place, &wanted)?;
        let named = wanted.iter().filter(|word| case.reads(&case.with(place.0, place.1, word)));
        let named = named.copied().collect::<Vec<_>>().join("` or `");
        Some(instead(found, &named, case.span(place.0, found.len()), help))
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
    let inner = case.slice.get(open + 1..close)?.trim();
    // the magnitude of a vector
    let vector = ["velocity(", "acceleration(", "position(", "reaction(", "inertia_force("];
    if inner.ends_with(')') && vector.iter().any(|call| inner.starts_with(call)) {
        new = new.replace("abs(", "mag(");
    }
    case.reads(&new).then(|| {
        let wanted =
            if new.contains("mag(") && !case.slice.contains("mag(") { "mag(…)" } else { "abs(…)" };
        instead("|…|", wanted, case.span(open, close + 1 - open), case.help(0, case.slice.len(), &new))
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
    let before = case.slice.get(..case.fail)?;
    let compares = case.token(0) == "assemble" || before.contains(" when ");
    if !compares || case.token(case.fail) != "=" {
        return None;
    }
    let end = case.fail + if case.slice.get(case.fail + 1..)?.starts_with('=') { 2 } else { 1 };
    let help = one_of(case, (case.fail, end), &[">", "<"])?;
    Some(instead("=", ">` or `<", case.span(case.fail, end - case.fail), help))
}

/// `drive P = 0 m moving up`: along the line of the guide, or against it.
fn sense(case: &Case<'_>) -> Option<Diagnosis> {
    let word = case.token(case.fail);
    let before = case.slice.get(..case.fail)?.trim_end();
    let place = matches!(
        word,
        "up" | "down"
            | "left"
            | "right"
            | "out"
            | "in"
            | "inwards"
            | "outwards"
            | "upwards"
            | "downwards"
            | "upward"
            | "downward"
    );
    if case.token(0) != "drive" || !before.ends_with(" moving") || !place {
        return None;
    }
    let end = case.fail + word.len();
    let help = one_of(case, (case.fail, end), &["forward", "back"])?;
    Some(instead(word, "forward` or `back", case.span(case.fail, word.len()), help))
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
