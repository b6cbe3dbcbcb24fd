//! Numbers, units and the drive's name as they stand in a diagram.

use super::curve::Line;
use crate::figures::unit_text;
use crate::scene::Scene;
use assur_drawing::{Level, Text};
use assur_model::model::{Display, DriveTarget, PairKind};
use assur_text::units::Dimension;

/// The letter of what the numbers run over: t of a motion under loads; of a sweep φ of a link or a hinge, s of a slider; the share of the sweep where the drive moves a
/// point.
#[must_use]
pub fn drive_label(scene: &Scene<'_>) -> Text {
    let mechanism = scene.mechanism();
    if mechanism.simulation.is_some() {
        return Text::italic("t");
    }
    match mechanism.drives.first().map(|d| d.target) {
        Some(DriveTarget::Link(link)) => scene.indexed("φ", link),
        Some(DriveTarget::Pair(pair)) => {
            let pair = mechanism.pair(pair);
            let turns = matches!(pair.kind, PairKind::Revolute(_));
            Text::italic(if turns { "φ" } else { "s" }).lowered(&pair.name)
        }
        _ => Text::upright("share of the sweep"),
    }
}

/// How the drive's value, or the instant, is printed.
#[must_use]
pub fn drive_axis(scene: &Scene<'_>) -> Display {
    let mechanism = scene.mechanism();
    if mechanism.simulation.is_some() {
        return mechanism.display_of(Dimension::TIME);
    }
    let drive = mechanism.drives.first().filter(|d| !matches!(d.target, DriveTarget::Point(..)));
    drive.map_or_else(Display::default, |drive| mechanism.drive_display(drive.target))
}

/// A name, a comma and a unit.
#[must_use]
pub fn with_unit(name: Text, power: &str, unit: &str) -> Text {
    let unit = format!("{power}{}", unit_text(unit));
    if unit.is_empty() { name } else { name.and(&format!(", {unit}"), false, Level::Base) }
}

/// An SI number in the unit of a display.
#[must_use]
pub fn printed(display: &Display, si: f64) -> f64 {
    display.of_si(si)
}

/// A line in the units of its axes.
#[must_use]
pub fn scaled(line: &Line, along: &Display, display: &Display) -> Line {
    line.iter().map(|(x, y)| (printed(along, *x), printed(display, *y))).collect()
}
