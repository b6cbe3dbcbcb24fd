//! Drives that a help proposes, at values at which the mechanism closes, and with what chooses between its assemblies.

use super::compile::Text;
use assur_check as check;
use assur_model::model::Mechanism;
use assur_model::structure;
use assur_position::plan;
use assur_solve::message::clause;
use assur_solve::solve::{self, Cause, Failure, Model};
use assur_syntax as syntax;
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Source;
use miette::Diagnostic;

/// Larger mechanisms are not solved for a help.
const MOST_LINKS: usize = 60;
/// Links of one group: the search for the assemblies of a larger one takes longer than a help may.
const MOST_TOGETHER: usize = 4;
/// Groups of which an assembly is chosen.
const MOST_CHOSEN: usize = 4;
/// Values tried of a drive, the proposed one first.
const ANGLES: [&str; 7] = ["45 deg", "90 deg", "135 deg", "0 deg", "180 deg", "-45 deg", "-90 deg"];
const LENGTHS: [&str; 7] = ["100 mm", "200 mm", "500 mm", "1 m", "2 m", "50 mm", "0 mm"];

/// What stands before the lines of drives in a help.
const ONE_OF: &str = "drive it: add one of\n";
const THE_LINE: &str = "drive it: add the line\n";

/// What becomes of a mechanism with a line.
enum Closes {
    At,
    /// The line that chooses one of several assemblies.
    With(String),
    Never,
}

/// The error with drives that close, as far as any is found.
pub(super) fn that_closes(error: Diagnosis, text: Text<'_>) -> Diagnosis {
    if !error.is("mech::determinacy::underconstrained") {
        return error;
    }
    let help = Diagnostic::help(&error).map(|help| help.to_string()).unwrap_or_default();
    let parts = help.split_once(ONE_OF).or_else(|| help.split_once(THE_LINE));
    let Some((before, drives)) = parts else { return error };
    let found: Vec<Vec<String>> = drives.lines().filter_map(|line| closing(line.trim(), text)).collect();
    if found.is_empty() {
        return error;
    }
    let is_alone = found.iter().all(|lines| lines.len() == 1);
    let words = if is_alone && found.len() > 1 {
        vec![ONE_OF.to_owned() + &set_apart(&found.concat())]
    } else {
        each(&found)
    };
    error.help(format!("{before}{}", words.join("\nor ")))
}

/// Each way by itself.
fn each(found: &[Vec<String>]) -> Vec<String> {
    let ways = found.iter().enumerate().map(|(i, lines)| {
        let drive = if i == 0 { "drive it: " } else { "" };
        let how_many = match lines.len() {
            1 => "the line",
            2 => "both lines",
            _ => "all these lines",
        };
        format!("{drive}add {how_many}\n{}", set_apart(lines))
    });
    ways.collect()
}

fn set_apart(lines: &[String]) -> String {
    lines.iter().map(|line| format!("  {line}")).collect::<Vec<_>>().join("\n")
}

/// A drive at a value at which everything closes, in one assembly if there is such a value, else with the lines that choose one.
fn closing(line: &str, text: Text<'_>) -> Option<Vec<String>> {
    let Some((place, value)) = line.split_once(" = ") else { return Some(vec![line.to_owned()]) };
    let (value, rest) =
        value.split_once(" at ").map_or((value, String::new()), |(v, r)| (v, format!(" at {r}")));
    let values = if value.ends_with("deg") { ANGLES } else { LENGTHS };
    let mut several = None;
    for value in values {
        let line = format!("{place} = {value}{rest}");
        match closes(std::slice::from_ref(&line), text)? {
            Closes::At => return Some(vec![line]),
            Closes::With(clause) if several.is_none() => several = Some(vec![line, clause]),
            // it has several at most values
            Closes::With(_) => break,
            Closes::Never => {}
        }
    }
    let mut lines = several?;
    for _ in 0..MOST_CHOSEN {
        match closes(&lines, text)? {
            Closes::At => return Some(lines),
            Closes::With(clause) => lines.push(clause),
            Closes::Never => return None,
        }
    }
    None
}

/// Whether the text closes with more lines; `None` where it is not tried.
fn closes(lines: &[String], text: Text<'_>) -> Option<Closes> {
    let changed =
        Source { text: format!("{}\n{}\n", text.source.text, lines.join("\n")), ..text.source.clone() };
    let (document, read) = syntax::parse(&changed);
    let (mechanism, checked) = check::check(&document, text.overrides);
    if read.has_errors() || checked.has_errors() {
        return None;
    }
    solved(&super::agrees::moved(&super::equilibrium::at_rest(&mechanism?), 0.0)?)
}

fn solved(mechanism: &Mechanism) -> Option<Closes> {
    let (structure, _) = structure::structure(mechanism).ok()?;
    let largest = structure.motion.iter().map(|group| group.bodies.len()).max();
    if mechanism.links.len() > MOST_LINKS || largest > Some(MOST_TOGETHER) {
        return None;
    }
    let plan = plan::plan(mechanism, &structure);
    let model = Model { mechanism, structure: &structure, plan: &plan };
    let failure = match solve::solve(&model) {
        Ok(mut solution) => match solution.poses.pop()?.outcome {
            Ok(_) => return Some(Closes::At),
            Err(failure) => failure,
        },
        Err(mut failures) => failures.pop()?,
    };
    Some(match failure {
        Failure { cause: Cause::Ambiguous { groups, .. }, .. } => {
            let line = groups.iter().find_map(|(_, clauses)| clauses.first());
            line.map_or(Closes::Never, |line| Closes::With(clause(&model, line)))
        }
        _ => Closes::Never,
    })
}
