//! Drives that a help proposes, at values at which the mechanism closes, and with what chooses between its assemblies.

use super::compile::Text;
use assur_check as check;
use assur_model::model::Mechanism;
use assur_model::structure;
use assur_position::plan;
use assur_position::position::BodyState;
use assur_solve::message::clause;
use assur_solve::solve::{self, Cause, Failure, Model};
use assur_syntax as syntax;
use assur_syntax::document::Document;
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Source;
use miette::Diagnostic;

/// Larger mechanisms are not solved for a help.
pub(super) const MOST_LINKS: usize = 60;
/// Links of one group: the search for the assemblies of a larger one takes longer than a help may.
const MOST_TOGETHER: usize = 4;
/// Groups of which an assembly is chosen.
const MOST_CHOSEN: usize = 4;
/// Values tried of a drive, the proposed one first: of several drives those of one number together.
pub(super) const ANGLES: [&str; 7] =
    ["45 deg", "90 deg", "135 deg", "0 deg", "180 deg", "-45 deg", "-90 deg"];
const LENGTHS: [&str; 7] = ["100 mm", "200 mm", "500 mm", "1 m", "2 m", "50 mm", "0 mm"];

/// What becomes of a mechanism with a line.
pub(super) enum Closes {
    At(Vec<BodyState>),
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
    let parts = parts(&help).into_iter().map(|part| part.that_closes(text));
    let words = parts.collect::<Vec<_>>().join("\n");
    if words == help { error } else { error.help(words) }
}

/// A sentence of a help and the lines that it sets apart.
struct Part<'a> {
    sentence: &'a str,
    lines: Vec<String>,
}

fn parts(help: &str) -> Vec<Part<'_>> {
    let mut parts: Vec<Part<'_>> = Vec::new();
    for line in help.lines() {
        match (line.strip_prefix("  "), parts.last_mut()) {
            (Some(line), Some(part)) => part.lines.push(line.to_owned()),
            _ => parts.push(Part { sentence: line, lines: Vec::new() }),
        }
    }
    parts
}

impl Part<'_> {
    fn that_closes(&self, text: Text<'_>) -> String {
        let written = || [vec![self.sentence.to_owned()], set_apart(&self.lines)].concat().join("\n");
        let Some((before, how_many)) = self.sentence.rsplit_once("add ") else { return written() };
        if !self.lines.iter().any(|line| is_drive(line)) {
            return written();
        }
        let ways: Vec<&[String]> = match how_many {
            "one of" | "the line" => self.lines.chunks(1).collect(),
            _ => vec![&self.lines],
        };
        let found: Vec<Vec<String>> = ways.into_iter().filter_map(|lines| closing(lines, text)).collect();
        if found.is_empty() {
            return written();
        }
        let is_choice = found.len() > 1 && found.iter().all(|lines| lines.len() == 1);
        if is_choice {
            return format!("{before}add one of\n{}", set_apart(&found.concat()).join("\n"));
        }
        let ways = found.iter().map(|lines| {
            let how_many = match lines.len() {
                1 => "the line",
                2 => "both lines",
                _ => "all these lines",
            };
            format!("add {how_many}\n{}", set_apart(lines).join("\n"))
        });
        format!("{before}{}", ways.collect::<Vec<_>>().join("\nor "))
    }
}

fn is_drive(line: &str) -> bool {
    line.starts_with("drive ") || line.starts_with("start ")
}

fn set_apart(lines: &[String]) -> Vec<String> {
    lines.iter().map(|line| format!("  {line}")).collect()
}

/// A drive at the value of a number, where it has any; 0 is its own.
fn with_value(line: &str, number: usize) -> String {
    let Some((place, value)) = line.split_once(" = ").filter(|_| is_drive(line) && number > 0) else {
        return line.to_owned();
    };
    let (value, rest) =
        value.split_once(" at ").map_or((value, String::new()), |(v, r)| (v, format!(" at {r}")));
    let values = if value.ends_with("deg") { ANGLES } else { LENGTHS };
    format!("{place} = {}{rest}", values[number - 1])
}

/// Lines with their drives at values at which everything closes, in one assembly if there are such values, else with the lines that
/// choose one.
fn closing(lines: &[String], text: Text<'_>) -> Option<Vec<String>> {
    if !lines.iter().any(|line| is_drive(line) && line.contains(" = ")) {
        return Some(lines.to_vec());
    }
    let mut several = None;
    let mut tried: Vec<Vec<String>> = Vec::new();
    for number in 0..=ANGLES.len() {
        let lines: Vec<String> = lines.iter().map(|line| with_value(line, number)).collect();
        if tried.contains(&lines) {
            continue;
        }
        tried.push(lines.clone());
        match closes(&lines, text)? {
            Closes::At(_) => return Some(lines),
            Closes::With(clause) if several.is_none() => several = Some([lines, vec![clause]].concat()),
            // it has several at most values
            Closes::With(_) => break,
            Closes::Never => {}
        }
    }
    chosen(several?, |lines| closes(lines, text)).map(|(lines, _)| lines)
}

/// The lines with those that choose an assembly, and where everything is then.
pub(super) fn chosen(
    mut lines: Vec<String>,
    closes: impl Fn(&[String]) -> Option<Closes>,
) -> Option<(Vec<String>, Vec<BodyState>)> {
    for _ in 0..=MOST_CHOSEN {
        match closes(&lines)? {
            Closes::At(bodies) => return Some((lines, bodies)),
            Closes::With(clause) => lines.push(clause),
            Closes::Never => return None,
        }
    }
    None
}

/// Whether the text closes with more lines; `None` where it is not tried.
fn closes(lines: &[String], text: Text<'_>) -> Option<Closes> {
    solved(&checked(lines, text)?)
}

/// The mechanism of a text with more lines, if nothing is wrong with it.
pub(super) fn checked(lines: &[String], text: Text<'_>) -> Option<Mechanism> {
    let document = with_lines(lines, text)?;
    let (mechanism, checked) = check::check(&document, text.overrides);
    mechanism.filter(|_| !checked.has_errors())
}

/// A text with more lines.
pub(super) fn with_lines(lines: &[String], text: Text<'_>) -> Option<Document> {
    let changed =
        Source { text: format!("{}\n{}\n", text.source.text, lines.join("\n")), ..text.source.clone() };
    let (document, read) = syntax::parse(&changed);
    (!read.has_errors()).then_some(document)
}

/// Whether a mechanism closes at the first position of its drives; `None` where it is not tried.
pub(super) fn solved(mechanism: &Mechanism) -> Option<Closes> {
    let mechanism = &super::agrees::moved(&super::equilibrium::at_rest(mechanism), 0.0)?;
    closes_as_it_is(mechanism)
}

fn closes_as_it_is(mechanism: &Mechanism) -> Option<Closes> {
    let (structure, _) = structure::structure(mechanism).ok()?;
    let largest = structure.motion.iter().map(|group| group.bodies.len()).max();
    if mechanism.links.len() > MOST_LINKS || largest > Some(MOST_TOGETHER) {
        return None;
    }
    let plan = plan::plan(mechanism, &structure);
    let model = Model { mechanism, structure: &structure, plan: &plan };
    let failure = match solve::solve(&model) {
        Ok(mut solution) => match solution.poses.pop()?.outcome {
            Ok(solved) => return Some(Closes::At(solved.state.motion.bodies)),
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
