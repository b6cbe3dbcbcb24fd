//! Cylinders and ropes whose lines may be lost: lines to paste, checked as those of a file, a cylinder at a length at which it closes.

use super::closing::{ANGLES, chosen, solved, with_lines};
use super::compile::Text;
use assur_check as check;
use assur_model::model::{LinkId, LinkPoint, Mechanism, PairKind, Value};
use assur_model::structure::{self, Lost, LostPair};
use assur_position::position::BodyState;
use assur_syntax::document::Statement;
use assur_text::diagnostic::{Diagnosis, Fix, Problems, Undeclared, did_you_mean};
use assur_text::units::Dimension;
use miette::{Diagnostic, LabeledSpan};

/// In larger mechanisms no line is looked for: each takes several solutions.
const MOST_LINKS: usize = 30;
/// Positions from which lengths are taken.
const MOST_POSITIONS: usize = 3;
/// Digits of a length.
const DIGITS: usize = 2;

/// The error with lines that may be lost.
pub(super) fn or_lost(error: Diagnosis, mechanism: &Mechanism, text: Text<'_>) -> Diagnosis {
    if !error.is("mech::determinacy::underconstrained") || mechanism.links.len() > MOST_LINKS {
        return error;
    }
    let ways = ways(mechanism, text, &[]);
    if ways.is_empty() {
        return error;
    }
    let help = Diagnostic::help(&error).map(|help| help.to_string()).unwrap_or_default();
    error.help(format!("{help}\nor {}", words(&ways)))
}

/// The errors that all follow from lost lines of cylinders and ropes: their names are used and not declared. As one error.
pub(super) fn undeclared(errors: &Problems, mechanism: &Mechanism, text: Text<'_>) -> Option<Diagnosis> {
    let mut missing: Vec<&Undeclared> = Vec::new();
    for name in errors.undeclared().filter(|name| name.kind.contains("pair")) {
        if missing.iter().all(|other| other.name != name.name) {
            missing.push(name);
        }
    }
    let names: Vec<&str> = missing.iter().map(|missing| missing.name.as_str()).collect();
    let is_slip = |name: &&str| {
        // what has a length too
        let slides = mechanism.pairs.iter().filter(|pair| {
            let is_slide =
                matches!(pair.kind, PairKind::Prismatic(_) | PairKind::Slot(_) | PairKind::Cylinder { .. });
            is_slide && pair.bearing.is_none()
        });
        let known = slides.map(|pair| pair.name.as_str());
        // one that is driven is not meant
        did_you_mean(name, known).iter().any(|near| !is_driven(text, near))
    };
    if names.is_empty() || mechanism.links.len() > MOST_LINKS || names.iter().any(is_slip) {
        return None;
    }
    let ways = ways(mechanism, text, &names);
    if ways.is_empty() {
        return None;
    }
    let help = words(&ways);
    let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    let (is, s) = if names.len() == 1 { ("is", "") } else { ("are", "s") };
    let label =
        |missing: &&Undeclared| LabeledSpan::new_with_span(Some("not declared".to_owned()), missing.at);
    Some(
        Diagnosis::error("mech::name::unknown", format!("there {is} no pair{s} {}", quoted.join(" and ")))
            .labels(missing.iter().map(label))
            .fixes(Fix::added(&help))
            .help(help),
    )
}

fn is_driven(text: Text<'_>, name: &str) -> bool {
    text.document.statements.iter().any(|statement| match &statement.node {
        Statement::Drive(drive) => drive.target.tail.is_none() && drive.target.head.node == name,
        _ => false,
    })
}

/// Alternatives, each of lines that belong together.
fn ways(mechanism: &Mechanism, text: Text<'_>, names: &[&str]) -> Vec<Vec<String>> {
    let Lost { ways, drives } = structure::lost(mechanism, names.len());
    let holds_nothing = drives.is_empty();
    let attempt = |bodies: Option<&[BodyState]>| -> Vec<Vec<String>> {
        let of_names = ways.iter().filter(|way| names.is_empty() || names.len() == way.len());
        let lines =
            of_names.filter_map(|pairs| Way { pairs, bodies, names, holds_nothing, mechanism, text }.lines());
        lines.collect()
    };
    let found = attempt(None);
    let Some(drives) = ways.first().and_then(|way| drives.get(..way.len())).filter(|_| found.is_empty())
    else {
        return found;
    };
    let positions = ANGLES.iter().filter_map(|angle| driven(text, drives, angle)).take(MOST_POSITIONS);
    let mut found = positions.map(|bodies| attempt(Some(&bodies)));
    found.find(|found| !found.is_empty()).unwrap_or_default()
}

fn words(ways: &[Vec<String>]) -> String {
    let is_alone = ways.iter().all(|lines| lines.len() == 1);
    let ways = if is_alone { vec![ways.concat()] } else { ways.to_vec() };
    let words = ways.iter().map(|lines| {
        let what = if lines.iter().any(|line| line.starts_with("rope")) { "rope" } else { "cylinder" };
        let several = lines.iter().filter(|line| line.starts_with(what)).count() > 1;
        let what = if several && !is_alone { format!("{what}s") } else { format!("a {what}") };
        let how_many = match lines.len() {
            1 => "the line",
            _ if is_alone => "one of",
            2 => "both lines",
            _ => "all these lines",
        };
        let lines: Vec<String> = lines.iter().map(|line| format!("  {line}")).collect();
        format!("{what} may be missing: add {how_many}\n{}", lines.join("\n"))
    });
    words.collect::<Vec<_>>().join("\nor ")
}

/// Statements that may be lost together.
struct Way<'a> {
    pairs: &'a [LostPair],
    /// Where everything is with drives of links in place of those of the cylinders.
    bodies: Option<&'a [BodyState]>,
    /// The names that the statements have.
    names: &'a [&'a str],
    holds_nothing: bool,
    mechanism: &'a Mechanism,
    text: Text<'a>,
}

impl Way<'_> {
    /// The lines, where the text is right with them.
    fn lines(&self) -> Option<Vec<String>> {
        let mut lines = Vec::new();
        for (pair, (name, line)) in self.pairs.iter().zip(self.statements()) {
            lines.push(line);
            let Some(ends) = pair.cylinder.filter(|_| !self.is_driven(&name)) else { continue };
            let length = Value::Scalar(distance(self.bodies?, ends));
            let length = self.mechanism.display_of(Dimension::LENGTH).text(length, DIGITS);
            let speed = if self.needs_speed() { " at 10 mm/s" } else { "" };
            lines.push(format!("drive {name} = {length}{speed}"));
        }
        self.closing(lines)
    }

    /// The names and the lines of the pairs.
    fn statements(&self) -> Vec<(String, String)> {
        let mut named: Vec<(String, String)> = Vec::new();
        for (i, pair) in self.pairs.iter().enumerate() {
            let (word, letter) = if pair.cylinder.is_some() { ("cylinder", "c") } else { ("rope", "r") };
            let is_free = |name: &String| {
                self.mechanism.pairs.iter().all(|pair| pair.name != *name)
                    && self.mechanism.links.iter().all(|link| link.name != *name)
                    && self.mechanism.values.iter().all(|value| value.name != *name)
                    && self.mechanism.wheels.iter().all(|wheel| wheel.name != *name)
                    && named.iter().all(|other| other.0 != *name)
            };
            let free = || {
                let numbered = (1..).map(|i| format!("{letter}{i}"));
                let alone = (self.pairs.len() == 1).then(|| letter.to_owned());
                alone.into_iter().chain(numbered).find(is_free)
            };
            let given = self.names.get(i).map(|name| (*name).to_owned());
            let name = given.or_else(free).unwrap_or_default();
            let line = format!("{word} {name}: {}", pair.ends);
            named.push((name, line));
        }
        named
    }

    /// A cylinder is driven, or it holds nothing and others are driven.
    fn is_driven(&self, name: &str) -> bool {
        is_driven(self.text, name) || self.holds_nothing
    }

    fn needs_speed(&self) -> bool {
        self.mechanism.drives.iter().any(|drive| drive.speed.is_some())
    }

    /// The lines and those that choose an assembly, where nothing is wrong with the text then.
    fn closing(&self, lines: Vec<String>) -> Option<Vec<String>> {
        let mechanism = super::closing::checked(&lines, self.text)?;
        if structure::structure(&mechanism).is_err() {
            return None;
        }
        // shafts and sliders close wherever they are
        if self.pairs.iter().all(|pair| pair.cylinder.is_none()) {
            return Some(lines);
        }
        chosen(lines, |lines| solved(&super::closing::checked(lines, self.text)?)).map(|(lines, _)| lines)
    }
}

/// Where everything is with drives at this angle.
fn driven(text: Text<'_>, drives: &[String], angle: &str) -> Option<Vec<BodyState>> {
    let drives = drives.iter().map(|line| match line.split_once(" = ") {
        Some((place, value)) if value.contains("deg") => format!("{place} = {angle}"),
        _ => line.clone(),
    });
    let closes = |lines: &[String]| {
        let document = with_lines(lines, text)?;
        solved(&check::sound_part(&document, text.overrides))
    };
    chosen(drives.collect(), closes).map(|(_, bodies)| bodies)
}

fn distance(bodies: &[BodyState], ends: [LinkPoint; 2]) -> f64 {
    let [one, other] = ends.map(|(link, at): (LinkId, _)| bodies[link.index()].position(at));
    (one - other).norm()
}
