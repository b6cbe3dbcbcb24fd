//! What the error productions caught: read again alone to learn where it fails, and corrected on trial to learn how.
//!
//! A repair is proposed only if the corrected text reads.

mod brackets;
mod case;
mod commas;
mod first_word;
mod meant;
mod name;
mod order;
mod phrase;
mod range;
mod separator;
mod swap;
mod what;
mod within;

pub(super) use what::What;

use super::document::{Bad, Name};
use super::error::SyntaxError;
use super::line::{Line, mended};
use super::words::{self, Expected, is_name_char, is_reserved};
use assur_text::diagnostic::{Problems, did_you_mean};
use assur_text::source::Span;
use case::Case;
use std::collections::BTreeSet;
use unicode_normalization::UnicodeNormalization;

/// The mistakes of a file that are looked into: repairs are tried, which takes time, and nobody reads more.
const EXPLAINED: usize = 200;

/// What was meant, where a repair reads.
fn explain(case: &Case<'_>) -> Option<SyntaxError> {
    first_word::explain(case)
        .or_else(|| within::equals_of_expect(case))
        .or_else(|| commas::explain(case))
        .or_else(|| separator::statements(case))
        .or_else(|| range::explain(case))
        .or_else(|| swap::of_without_brackets(case))
        .or_else(|| meant::explain(case))
        .or_else(|| name::explain(case))
        .or_else(|| phrase::explain(case))
        .or_else(|| within::explain(case))
        .or_else(|| separator::members(case))
        .or_else(|| brackets::explain(case))
        .or_else(|| swap::explain(case))
        .or_else(|| order::explain(case))
        .or_else(|| within::missing(case))
}

/// Reports the text at `at`, and collects the names in it.
pub(super) fn report(
    text: &str,
    read: &str,
    at: Span,
    what: What,
    problems: &mut Problems,
    reserved: &mut BTreeSet<String>,
) -> Bad {
    let slice = read.get(at.start..at.end).unwrap_or_default();
    let mut names = names(slice);
    if !slice.trim().is_empty() && !cut_off(text, read, at) {
        let case = Case::new(text, slice, at.start, what);
        let found = if problems.len() < EXPLAINED { explain(&case) } else { None };
        let found = found.unwrap_or_else(|| unexpected(&case));
        // A name that cannot be one is reported where it stands first.
        let again =
            matches!(&found, SyntaxError::ReservedName { found, .. } if !reserved.insert(found.clone()));
        // `left-arm` declares `left_arm`
        if let SyntaxError::OtherWord { wanted, .. } = &found {
            names.extend(self::names(wanted));
        }
        if !again {
            problems.push(found);
        }
    }
    Bad { names }
}

/// Whether the rest of the line was blanked out, which has been reported.
fn cut_off(text: &str, read: &str, at: Span) -> bool {
    let end = Line::around(text, at.end).end;
    let rest = |text: &str| text.get(at.end..end).unwrap_or_default().trim().to_owned();
    let lost = rest(text);
    let comment = ["//", "#", "/*"].into_iter().any(|sign| lost.starts_with(sign));
    rest(read).is_empty() && !lost.is_empty() && !comment
}

/// A pair of the grammar that has not the shape it promises.
pub(super) fn unreadable(at: Span) -> SyntaxError {
    SyntaxError::Unexpected {
        what: "this".to_owned(),
        expected: "it is too long or too deeply nested".to_owned(),
        at,
        found: "from here".to_owned(),
        help: None,
    }
}

/// `S 21 N` in a body: a misspelt word, or a point without coordinates.
pub(super) fn point_without_coordinates(text: &str, name: &Name, at: Span) -> SyntaxError {
    match did_you_mean(&name.node, words::MEMBERS.iter().copied()).first() {
        Some(wanted) => SyntaxError::MisspeltWord {
            found: name.node.clone(),
            at: name.span,
            wanted: (*wanted).to_owned(),
            help: Some(format!("write: {}", mended(text, name.span, wanted))),
        },
        None => without_coordinates(&name.node, at),
    }
}

fn without_coordinates(name: &str, at: Span) -> SyntaxError {
    let help = format!("give its coordinates, as in: {name} (100 mm, 20 mm)");
    SyntaxError::PointWithoutCoordinates { at, help }
}

/// What can be said where no repair helps.
fn unexpected(case: &Case<'_>) -> SyntaxError {
    let alone = case.slice.chars().all(is_name_char) && !words::MEMBERS.contains(&case.slice);
    if case.what == What::Member && alone && case.reads(&format!("{} (0, 0)", case.slice)) {
        return without_coordinates(case.slice, case.span(0, case.slice.len()));
    }
    let token = case.token(case.fail);
    let found = if token.is_empty() { "the line ends here".to_owned() } else { format!("found `{token}`") };
    let first = case.token(0);
    let what = match case.what {
        What::Statement if words::STATEMENTS.contains(&first) => format!("this `{first}`"),
        What::Statement => "this statement".to_owned(),
        What::Member if words::MEMBERS.contains(&first) => format!("this `{first}`"),
        What::Member => "this member".to_owned(),
        What::CamMember => "this part of the cam".to_owned(),
        What::Property => "this property".to_owned(),
        What::Header => "this header".to_owned(),
        What::Row => "this row".to_owned(),
    };
    let expected = case.expected.iter().flat_map(|r| words::expected(*r)).collect::<Vec<Expected>>();
    let at = case.span(case.fail, token.len());
    let help = match case.what {
        What::Header | What::Row => Some(
            "the header and each row stand on a line of their own: names with units, then plain numbers"
                .to_owned(),
        ),
        _ if first == "link" && token.is_empty() && case.slice.contains('-') && !case.slice.contains('{') => {
            Some(format!("give its length, as in: {} 100 mm", case.slice.trim()))
        }
        _ if case.slice.trim() == "gravity" => Some("write: gravity 9.81 m/s^2".to_owned()),
        _ => help(first),
    };
    SyntaxError::Unexpected { what, expected: words::list(expected), at, found, help }
}

/// The shape of a statement that could not be read.
fn help(word: &str) -> Option<String> {
    let shape = match word {
        "given" => "given r = 100 mm",
        "let" => "let l = 3.5 * r",
        "ground" => "ground { A (0, 0); line guide through A along 0 deg }",
        "link" => "link rod B-C 350 mm { S (100 mm, 0); mass 2.5 kg at S }",
        "revolute" => "revolute B: crank - rod",
        "prismatic" => "prismatic D: piston.C - ground.guide",
        "slot" => "slot K: crank.B - bar.slot",
        "contact" => "contact N: cam.c - lever.roller",
        "cylinder" => "cylinder c1: ground.G1 - boom.K1",
        "mesh" => "mesh k: w2 - w3",
        "rope" => "rope a: A - over(C) - w1",
        "spring" => "spring k: ground.C - bar.D { stiffness 4530 N/m; free_length 77.85 mm }",
        "group" => "group rod_piston: rod, piston",
        "drive" => "drive crank = 0 deg .. 360 deg in 12 steps at 80 rpm",
        "pose" => "pose 4' at crank = 90 deg",
        "assemble" => "assemble C left of B-D",
        "force" => "force P on ram at E = 1000 N @ 180 deg",
        "torque" => "torque M on rocker = 60 N*m cw",
        "balance" => "balance torque Mb on crank",
        "find" => "find v_C = velocity(C) as m/s",
        "expect" => "expect Mb = 26 N*m within 1 %",
        "variants" => "variants { then a header and rows, each on a line of its own }",
        "line" => "line guide through A along 0 deg",
        "circle" => "circle roller centre D radius 15 mm",
        "mass" => "mass 2.5 kg at S",
        "weight" => "weight 21 N at C",
        "inertia" => "inertia 0.0425 kg*m^2",
        "wheel" => "wheel z1 teeth 18 module 16 mm",
        "gravity" => "gravity 9.81 m/s^2",
        "slider" => "slider A",
        "rack" => "rack r: w3 - bar.line1",
        "all" => "all revolute { friction_circle 5 mm }",
        "cam" => "cam plate { base_radius 50 mm; turning cw; rise 60 deg through 18 deg parabolic }",
        "flywheel" => "flywheel J on O1 for Mb { fluctuation 1/30 }",
        "until" => "until angle(crank) = 360 deg",
        "ignore" => "ignore inertia",
        "shaft" => "shaft I { wheel w1 radius 0.2 m }",
        "start" => "start OF = 5 deg at 0 rad/s",
        "simulate" => "simulate 0 s .. 0.03 s within 1e-9",
        _ => return None,
    };
    Some(format!("for example: {shape}"))
}

/// Every word that may be a name.
pub(super) fn names(slice: &str) -> Vec<String> {
    let mut found = Vec::<String>::new();
    for line in slice.lines() {
        let code = line.split_once("//").map_or(line, |(code, _)| code);
        for word in code.split(|c| !is_name_char(c)) {
            let starts_well = word.chars().next().is_some_and(char::is_alphabetic);
            if starts_well && !is_reserved(word) {
                found.push(word.nfc().collect());
            }
        }
    }
    found.sort();
    found.dedup();
    found
}
