//! Rates, dampers and loads that depend on speeds, where no drive has one.

use super::format::{four, label, short};
use crate::model::{
    Drive, DriveId, DriveTarget, Expr, LoadId, Mechanism, PairKind, Positions, SpringId, Value,
};
use crate::plan::Level;
use crate::source::Span;
use crate::units::Dimension;
use assur_text::diagnostic::{Diagnosis, Help};
use miette::LabeledSpan;

/// Digits of what a file has written.
const DIGITS: usize = 12;

/// Velocities and accelerations of a mechanism whose drives have no speed.
pub(super) fn needs_speed(
    mechanism: &Mechanism,
    drive: DriveId,
    (level, places): (Level, &[Span]),
) -> Diagnosis {
    let drive = &mechanism.drives[drive.index()];
    let (written, speed) = written(mechanism, drive);
    let name = &drive.name;
    let (what, needs, help) = if level == Level::Velocities {
        let sense = match drive.target {
            _ if speed.ends_with(')') => String::new(),
            _ if speed.ends_with("rpm") => {
                format!("; for velocities as ratios a sense is enough: `drive {name}{written} turning ccw`")
            }
            _ => format!(
                "; for velocities as ratios a sense is enough: `drive {name}{written} moving forward`"
            ),
        };
        ("a velocity", "a speed or a sense", format!("write `drive {name}{written} at {speed}`{sense}"))
    } else {
        ("an acceleration", "a speed", format!("write `drive {name}{written} at {speed}`"))
    };
    let mut labels: Vec<LabeledSpan> =
        places.iter().filter(|s| **s != Span::default()).map(|s| label("needed here", *s)).collect();
    labels.push(label(format!("without {needs}"), drive.span));
    no_drive_has(what, needs, help, labels)
}

/// A range whose ends turn out to be one position.
pub(super) fn empty_range(mechanism: &Mechanism, drive: DriveId, at: f64) -> Diagnosis {
    let drive = &mechanism.drives[drive.index()];
    let from = drive.written.as_deref().and_then(|written| written.split(" .. ").next()).unwrap_or("…");
    let position = mechanism.drive_display(drive.target);
    let line = format!("drive {} = {from}{}", drive.name, rates(mechanism, drive));
    Diagnosis::error(
        "mech::geometry::empty_range",
        format!(
            "the range of `{}` has no length: it ends where it begins, at {}",
            drive.name,
            position.text(Value::Scalar(at), DIGITS)
        ),
    )
    .label(drive.span, "one position, in several steps")
    .help(format!("write `{line}`, or another end of the range"))
    .quoted(drive.span)
}

/// Speed, acceleration and sense of a drive, as they are written.
pub(super) fn rates(mechanism: &Mechanism, drive: &Drive) -> String {
    let turns = turns(mechanism, drive);
    let rate = |rate: &Option<Expr>, word: &str, dimension: Dimension| match rate {
        None => String::new(),
        Some(Expr::Constant(value)) => {
            format!(" {word} {}", mechanism.display_of(dimension).text(*value, DIGITS))
        }
        Some(_) => format!(" {word} …"),
    };
    let [speed, acceleration] = match turns {
        true => [Dimension::ANGULAR_VELOCITY, Dimension::ANGULAR_ACCELERATION],
        false => [Dimension::VELOCITY, Dimension::ACCELERATION],
    };
    let sense = match drive.sense {
        Some(sense) if turns => {
            if sense > 0.0 {
                " turning ccw"
            } else {
                " turning cw"
            }
        }
        Some(sense) => {
            if sense > 0.0 {
                " moving forward"
            } else {
                " moving back"
            }
        }
        None => "",
    };
    rate(&drive.speed, "at", speed) + &rate(&drive.acceleration, "accelerating", acceleration) + sense
}

/// Damping where nothing moves.
pub(super) fn no_damping(
    mechanism: &Mechanism,
    drive: DriveId,
    (springs, loads): (&[SpringId], &[LoadId]),
) -> Diagnosis {
    let (_, help) = speed_for(mechanism, &mechanism.drives[drive.index()]);
    let springs = springs.iter().map(|id| mechanism.springs[id.index()].span);
    let places = springs.chain(loads.iter().map(|id| mechanism.loads[id.index()].span));
    let labels = places.map(|place| label("against a motion without direction", place));
    Diagnosis::warning("mech::request::no_damping", "damping is left out: no drive has a speed")
        .labels(labels)
        .help(help)
}

/// Dampers and loads that depend on speeds, where the drive has a sense alone.
pub(super) fn unit_speed(
    mechanism: &Mechanism,
    drive: DriveId,
    (springs, loads): (&[SpringId], &[LoadId]),
) -> Diagnosis {
    let drive = &mechanism.drives[drive.index()];
    let (speed, help) = speed_for(mechanism, drive);
    let springs = springs.iter().map(|id| &mechanism.springs[id.index()]);
    let loads = loads.iter().map(|id| &mechanism.loads[id.index()]);
    let named = |name: &Option<String>| name.as_ref().map_or("a load".to_owned(), |n| format!("`{n}`"));
    let springs = springs.map(|s| (format!("`{}`", s.name), s.span));
    let all: Vec<(String, Span)> = springs.chain(loads.map(|l| (named(&l.name), l.span))).collect();
    let names: Vec<&str> = all.iter().map(|(name, _)| name.as_str()).collect();
    let text = |i: usize| if i == 0 { "needs a speed" } else { "and this" };
    let mut labels: Vec<LabeledSpan> =
        all.iter().enumerate().map(|(i, (_, span))| label(text(i), *span)).collect();
    labels.push(label("a sense alone", drive.span));
    let unit = if speed.ends_with("rpm") { "1 rad/s" } else { "1 m/s" };
    Diagnosis::warning(
        "mech::request::unit_speed",
        format!(
            "{} {} on speeds, but no drive has one: the result is for unit speed, \
             {unit} of `{}`",
            names.join(" and "),
            if names.len() == 1 { "depends" } else { "depend" },
            drive.name
        ),
    )
    .labels(labels)
    .help(help)
}

/// A speed for a drive, and what to write.
fn speed_for(mechanism: &Mechanism, drive: &Drive) -> (&'static str, String) {
    let (written, speed) = written(mechanism, drive);
    (speed, format!("give it a speed: `drive {}{written} at {speed}`", drive.name))
}

fn turns(mechanism: &Mechanism, drive: &Drive) -> bool {
    match drive.target {
        DriveTarget::Link(_) => true,
        DriveTarget::Pair(pair) => matches!(mechanism.pair(pair).kind, PairKind::Revolute(_)),
        DriveTarget::Point(..) | DriveTarget::Place(..) => false,
    }
}

/// The positions of a drive as they may have been written, and a speed for it.
fn written(mechanism: &Mechanism, drive: &Drive) -> (String, &'static str) {
    let turns = turns(mechanism, drive);
    let speed = match drive.target {
        _ if turns => "60 rpm",
        DriveTarget::Point(..) => "(0.1 m/s, 0)",
        _ => "0.1 m/s",
    };
    if let Some(text) = &drive.written {
        return (format!(" = {text}"), speed);
    }
    let value = |e: &Expr| match e {
        Expr::Constant(Value::Scalar(x)) if turns => Some(format!("{} deg", short(x.to_degrees()))),
        Expr::Constant(Value::Scalar(x)) => Some(format!("{} mm", four(x * 1e3))),
        _ => None,
    };
    let text = match &drive.positions {
        Positions::List(list) => {
            list.iter().map(value).collect::<Option<Vec<_>>>().map(|values| values.join(", "))
        }
        Positions::Range { from, to, steps } => {
            value(from).zip(value(to)).map(|(from, to)| format!("{from} .. {to} in {steps} steps"))
        }
        Positions::None | Positions::Numbers(_) => None,
    };
    (format!(" = {}", text.unwrap_or_else(|| "…".to_owned())), speed)
}

/// Asked for velocities of a drive without speed.
pub fn no_drive_has(
    what: &'static str,
    needs: &'static str,
    help: impl Into<Help>,
    labels: Vec<LabeledSpan>,
) -> Diagnosis {
    Diagnosis::error("mech::request::needs_speed", format!("{what} is needed, but no drive has {needs}"))
        .labels(labels)
        .help(help)
}
