//! What a picture shows, in words.

use crate::figures::cleared;
use crate::scene::{Scene, Subject};
use assur_model::model::{LinkId, PairKind, Value};
use assur_solve::solve::{DriveValue, PoseOrigin};

/// Digits of numbers in a description.
const DIGITS: usize = 5;
/// The most entries of a list in a description.
const MOST_DESCRIBED: usize = 40;
/// The same in a help.
const MOST_OFFERED: usize = 12;

/// Where the drives are: `crank = 45 deg`.
pub fn drives(scene: &Scene<'_>) -> String {
    let mechanism = scene.mechanism();
    let said = mechanism.drives.iter().zip(&scene.pose.drives).filter_map(|(drive, value)| {
        let display = mechanism.drive_display(drive.target);
        let large = scene.greatest.in_si(display.dimension);
        let value = match value {
            DriveValue::Scalar(x) => Value::Scalar(cleared(*x, large)),
            DriveValue::Point(p) => Value::Vector(*p),
            DriveValue::None => return None,
        };
        let text = display.text(value, DIGITS);
        Some(format!("{} = {}", drive.name, text))
    });
    said.collect::<Vec<_>>().join(", ")
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

/// ` at crank = 45 deg`
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
