//! What the error productions caught: read again alone to learn where it fails, and mended on trial to learn how.
//!
//! A repair is believed only if the mended text reads.

mod brackets;
mod case;
mod first_word;
mod swap;
mod within;

use super::Rule;
use super::document::{Bad, Name};
use super::error::SyntaxError;
use super::line::{Line, mended};
use super::words::{self, Expected, is_name_char, is_reserved};
use crate::diagnostic::{Problems, did_you_mean};
use crate::source::Span;
use case::Case;
use unicode_normalization::UnicodeNormalization;

/// What was being read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum What {
    Statement,
    Member,
    Property,
    CamMember,
    Header,
    Row,
}

impl What {
    /// The rule that reads it alone.
    const fn rule(self) -> Rule {
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

/// Reports the text at `at`, and collects the names in it.
pub(super) fn report(text: &str, read: &str, at: Span, what: What, problems: &mut Problems) -> Bad {
    let slice = read.get(at.start..at.end).unwrap_or_default();
    if !slice.trim().is_empty() && !cut_off(text, read, at) {
        let case = Case::new(text, slice, at.start, what);
        let found = first_word::explain(&case)
            .or_else(|| within::explain(&case))
            .or_else(|| brackets::explain(&case))
            .or_else(|| swap::explain(&case))
            .or_else(|| within::missing(&case))
            .unwrap_or_else(|| unexpected(&case));
        problems.push(found);
    }
    Bad { names: names(slice) }
}

/// Whether the rest of the line was blanked out, which has been reported.
fn cut_off(text: &str, read: &str, at: Span) -> bool {
    let end = Line::around(text, at.end).end;
    let rest = |text: &str| text.get(at.end..end).unwrap_or_default().trim().to_owned();
    let lost = rest(text);
    rest(read).is_empty() && !lost.is_empty() && !lost.starts_with("//")
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
        None => SyntaxError::PointWithoutCoordinates { at, help: format!("write: {} (x, y)", name.node) },
    }
}

/// What can be said where no repair helps.
fn unexpected(case: &Case<'_>) -> SyntaxError {
    let token = case.token(case.fail);
    let found = if token.is_empty() { "it ends here".to_owned() } else { format!("found `{token}`") };
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
