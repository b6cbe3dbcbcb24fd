//! What a picture shows, in words.

use crate::figures::{cleared, value_in_digits};
use crate::scene::{Scene, Subject};
use assur_model::model::{Drive, DriveTarget, LinkId, Mechanism, PairKind, Value};
use assur_solve::solve::{DriveValue, MotionScales, PoseOrigin};

/// Digits of numbers in a description.
const DIGITS: usize = 5;
/// The most entries of a list in a description.
const MOST_DESCRIBED: usize = 40;
/// The same in a help.
const MOST_OFFERED: usize = 12;

/// The letter of a drive's coordinate with its index: φ of a link that turns, s of a slide, with the link's number, or its name.
#[must_use]
pub fn drive_letter<'a>(mechanism: &'a Mechanism, drive: &'a Drive) -> (&'static str, &'a str) {
    let turns = match drive.target {
        DriveTarget::Link(_) => true,
        DriveTarget::Pair(pair) => matches!(mechanism.pair(pair).kind, PairKind::Revolute(_)),
        DriveTarget::Point(..) | DriveTarget::Place(..) => false,
    };
    let link = mechanism.links.iter().find(|link| link.name == drive.name);
    let number = link.and_then(|link| link.number.as_deref());
    (if turns { "φ" } else { "s" }, number.unwrap_or(&drive.name))
}

/// The coordinate of a drive in words: `φ₁`, `φ`, `s_ram`. A name is no index where there is one drive.
#[must_use]
pub fn drive_name(mechanism: &Mechanism, drive: &Drive) -> String {
    if matches!(drive.target, DriveTarget::Place(..)) {
        return drive.name.clone();
    }
    let (letter, index) = drive_letter(mechanism, drive);
    let lowered = |c: char| char::from_u32(c as u32 - '0' as u32 + '₀' as u32).unwrap_or(c);
    match index {
        _ if index.chars().all(|c| c.is_ascii_digit()) => {
            format!("{letter}{}", index.chars().map(lowered).collect::<String>())
        }
        _ if mechanism.drives.len() == 1 => letter.to_owned(),
        _ => format!("{letter}_{index}"),
    }
}

/// Where the drives are, with five digits: `φ₁ = 45°`. A name is no index where there is one drive.
#[must_use]
pub fn drive_words(mechanism: &Mechanism, values: &[DriveValue], greatest: &MotionScales) -> Vec<String> {
    let said = mechanism.drives.iter().zip(values).filter_map(|(drive, value)| {
        let display = mechanism.drive_display(drive.target);
        let value = match value {
            DriveValue::Scalar(x) => cleared(*x, greatest.in_si(display.dimension)),
            DriveValue::Point(p) => {
                return Some(format!("{} = {}", drive.name, display.text(Value::Vector(*p), DIGITS)));
            }
            DriveValue::None => return None,
        };
        Some(format!("{} = {}", drive_name(mechanism, drive), value_in_digits(&display, value, DIGITS)))
    });
    said.collect()
}

/// Where the drives of a position are.
pub fn drives(scene: &Scene<'_>) -> String {
    drive_words(scene.mechanism(), &scene.pose.drives, &scene.greatest).join(", ")
}

/// The title of the problem, or the name of its file.
pub fn title(scene: &Scene<'_>) -> String {
    Subject::from(scene).title().to_owned()
}

/// The position in words; nothing where there is one alone and no drive has a value.
pub fn position(scene: &Scene<'_>) -> String {
    let drives = drives(scene);
    let named = match scene.pose.origin {
        PoseOrigin::Sweep(_) if scene.solution.positions == 1 => None,
        PoseOrigin::Expected(_) => None,
        _ => Some(format!("pose {}", scene.pose.name)),
    };
    match (named, drives.is_empty()) {
        (Some(named), true) => named,
        (Some(named), false) => format!("{named}, {drives}"),
        (None, _) => drives,
    }
}

/// ` at φ₁ = 45°`
pub fn at_position(scene: &Scene<'_>) -> String {
    let position = position(scene);
    if position.is_empty() { position } else { format!(" at {position}") }
}

/// The begin of the ids of a picture.
pub fn id(scene: &Scene<'_>, kind: &str) -> String {
    Subject::from(scene).id(kind)
}

/// Sentences about links and pairs.
pub fn mechanism(scene: &Scene<'_>) -> String {
    let mechanism = scene.mechanism();
    let links = mechanism.links.iter().skip(1).map(|link| match &link.number {
        Some(number) if *number != link.name => format!("{number} {}", link.name),
        _ => link.name.clone(),
    });
    let count = mechanism.links.len().saturating_sub(1);
    let drawn = || mechanism.pairs.iter().filter(|p| p.bearing.is_none());
    let pairs = drawn().map(|pair| {
        let mut joined = pair.kind.links();
        joined.dedup();
        let names: Vec<&str> = joined.iter().map(|l| name(scene, *l)).collect();
        format!("{} ({} {})", pair.name, kind(&pair.kind), names.join("–"))
    });
    let mut said = String::new();
    if count > 0 {
        said += &format!("Links: {}. ", listed(links, count, MOST_DESCRIBED));
    }
    let count = drawn().count();
    if count > 0 {
        said += &format!("Pairs: {}. ", listed(pairs, count, MOST_DESCRIBED));
    }
    said
}

/// A list of names in a help.
pub fn offered(names: &[String]) -> String {
    listed(names.iter().map(|name| format!("`{name}`")), names.len(), MOST_OFFERED)
}

/// A list that does not become too long, of so many.
fn listed(all: impl Iterator<Item = String>, count: usize, most: usize) -> String {
    let first = all.take(most).collect::<Vec<_>>().join(", ");
    if count > most { format!("{first} and {} more", count - most) } else { first }
}

fn name<'a>(scene: &Scene<'a>, link: LinkId) -> &'a str {
    &scene.mechanism().link(link).name
}

const fn kind(kind: &PairKind) -> &'static str {
    match kind {
        PairKind::Revolute(_) => "hinge",
        PairKind::Prismatic(_) => "slider",
        PairKind::Slot(_) => "pin in slot",
        PairKind::Contact { .. } => "contact",
        PairKind::Cylinder { .. } => "cylinder",
        PairKind::Weld { .. } => "weld",
        PairKind::Transmission(t) => t.kind.word(),
    }
}
