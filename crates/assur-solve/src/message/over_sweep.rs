//! What is said of results over the sweep that do not exist.

use super::format::{four, label, short, with_unit};
use super::gap::gap_text;
use super::speeds::rates;
use crate::answer::{NoExtreme, NoFlywheel, NoSweep, SweepPlace, Undefined};
use crate::language::Function;
use crate::message::speeds::no_drive_has;
use crate::model::{Drive, Expr, Flywheel, PairId, Positions, Value};
use crate::position::{Model, turns};
use crate::solve::TurnGap;
use crate::units::Dimension;
use assur_text::diagnostic::Diagnosis;
use miette::LabeledSpan;

/// Why a function over the sweep has no value.
#[must_use]
pub fn undefined(model: &Model<'_>, why: Undefined) -> String {
    let place = |at: SweepPlace| match model.mechanism.drives.as_slice() {
        [drive] if turns(model, drive) => {
            format!(" at {} = {} deg", drive.name, short(at.drive.to_degrees()))
        }
        [drive] => format!(" at {} = {} mm", drive.name, four(at.drive * 1e3)),
        _ => format!(" at {} % of the sweep", short(100.0 * at.share)),
    };
    match why {
        Undefined::At(s) => format!("the quantity is not defined{}", place(s)),
        Undefined::Locked(s) => format!("friction locks the mechanism{}", place(s)),
        Undefined::Open(s) => format!("the mechanism does not close{}", place(s)),
        Undefined::Then(t) => {
            let shown = model.mechanism.display_of(Dimension::TIME);
            format!("the quantity is not defined at {} {}", four(t / shown.factor), shown.unit)
        }
        Undefined::Unbounded(s) => format!("the quantity grows without bound{}", place(s)),
        Undefined::Unresolved => "the quantity changes too often over the sweep".to_owned(),
    }
}

/// The extremes of a pair do not exist; the function asks for them, or for one of them.
pub(super) fn no_extreme(
    model: &Model<'_>,
    pair: PairId,
    (function, which): (Function, Option<u8>),
    (reason, gap): (NoExtreme, Option<&TurnGap>),
) -> Diagnosis {
    let pair = model.mechanism.pair(pair);
    let which = which.map_or_else(String::new, |which| format!(", {which}"));
    let what = format!("{}({}{which})", function.name(), pair.name);
    let drives = &model.mechanism.drives;
    let name = drives.first().map_or("", |d| d.name.as_str());
    let mut labels = vec![label("this pair", pair.span)];
    let mut mark = |text: &str| labels.extend(drives.iter().map(|d| label(text, d.span)));
    let (why, help) = match reason {
        NoExtreme::Slides => {
            mark("slides");
            (
                format!("it needs a drive that turns, but `{name}` slides"),
                "drive the crank: the extremes are found over one turn of it".to_owned(),
            )
        }
        NoExtreme::Drives => {
            mark("one of the drives");
            (
                format!("it needs exactly one drive that turns, but there are {}", drives.len()),
                "use one drive: with several drives the extremes over one turn are not defined".to_owned(),
            )
        }
        NoExtreme::NoTurn(limit) => {
            mark("does not turn fully");
            not_fully(model, (function, &pair.name), limit, gap)
        }
        NoExtreme::Monotonic => (
            format!("the coordinate of `{}` does not move back and forth", pair.name),
            "name the pair of a link that swings or slides between two ends".to_owned(),
        ),
    };
    Diagnosis::error("mech::solve::no_extreme", format!("`{what}` is not defined: {why}"))
        .labels(labels)
        .help(help)
}

/// A drive that does not turn fully: where it can be, and what to write instead.
fn not_fully(
    model: &Model<'_>,
    (function, pair): (Function, &str),
    limit: Option<[f64; 2]>,
    gap: Option<&TurnGap>,
) -> (String, String) {
    let drive = model.mechanism.drives.first();
    let name = drive.map_or("", |d| d.name.as_str());
    let (gap, change) = missing(model, name, gap);
    let Some([from, to]) = limit.map(|ends| ends.map(f64::to_degrees)) else {
        return (
            format!("`{name}` cannot turn fully: the mechanism does not close at any angle of it{gap}"),
            change,
        );
    };
    // the ends themselves are dead positions
    let (first, last) = ((from + 0.5).ceil(), (to - 0.5).floor());
    let rates = drive.map_or_else(String::new, |d| rates(model.mechanism, d));
    let also = match function {
        Function::Stroke => {
            format!(
                ", and `max(displacement({pair})) - min(displacement({pair}))` in place of `stroke({pair})`"
            )
        }
        _ => String::new(),
    };
    let range = match first < last {
        true => {
            format!("write `drive {name} = {first} deg .. {last} deg in 12 steps{rates}`{also}; or {change}")
        }
        false => change,
    };
    (
        format!(
            "`{name}` cannot turn fully: the mechanism closes from {} deg to {} deg only{gap}",
            four(from),
            four(to)
        ),
        range,
    )
}

/// What keeps a drive from turning fully at its worst position, and what to change.
fn missing(model: &Model<'_>, name: &str, gap: Option<&TurnGap>) -> (String, String) {
    let Some(TurnGap { at, group, gap }) = gap else {
        return (String::new(), "change the lengths so that the shortest link turns fully".to_owned());
    };
    let (text, help) = gap_text(model, *group, gap);
    // with just so much it would stop in a dead position
    let more = help.replace(" by ", " by more than ");
    (
        format!("; at {name} = {} deg {text}", short(at.to_degrees().round())),
        format!("for a full turn {more}"),
    )
}

/// A range over this number of turns from the first value of the drive, with its steps and its speed.
fn whole_turns(model: &Model<'_>, drive: Option<&Drive>, number: f64) -> String {
    let [turn, steps] = [360.0, 12.0].map(|x| x * number);
    let plain = format!("0 deg .. {turn} deg in {steps} steps");
    let Some(drive) = drive.filter(|drive| turns(model, drive)) else { return plain };
    let degrees = |e: &Expr| match e {
        Expr::Constant(Value::Scalar(x)) => Some(x.to_degrees()),
        _ => None,
    };
    let range = match &drive.positions {
        Positions::Range { from, to, steps: written } => {
            degrees(from).zip(degrees(to)).filter(|(from, to)| from != to).map(|(from, to)| {
                let part = turn / (to - from).abs();
                #[allow(clippy::cast_precision_loss)] // at most a million
                let steps = (*written as f64 * part).round().clamp(steps, turn);
                format!(
                    "{} deg .. {} deg in {steps} steps",
                    short(from),
                    short(from + turn.copysign(to - from))
                )
            })
        }
        _ => None,
    };
    range.unwrap_or(plain) + &rates(model.mechanism, drive)
}

/// There is no sweep to take functions over.
pub(super) fn no_sweep(model: &Model<'_>, reason: NoSweep) -> Diagnosis {
    let drives = &model.mechanism.drives;
    let drive = drives.first();
    let turning = |which: &[_]| matches!(which, [drive] if turns(model, drive));
    let mut labels = asked(model);
    let (why, help) = match reason {
        NoSweep::OnePosition => {
            labels.extend(drive.map(|d| label("one position", d.span)));
            let (name, range) = match drive {
                Some(d) if turns(model, d) => (d.name.as_str(), "0 deg .. 360 deg in 12 steps"),
                Some(d) => (d.name.as_str(), "0 mm .. 200 mm in 10 steps"),
                None => ("crank", "0 deg .. 360 deg in 12 steps"),
            };
            ("the file has one position".to_owned(), format!("write a sweep: `drive {name} = {range}`"))
        }
        NoSweep::TooLong => {
            labels.extend(drives.iter().map(|d| label("swept that far", d.span)));
            let (most, help) = if turning(drives) {
                ("111 turns", "check the unit, or sweep over one cycle: `0 deg .. 360 deg in 12 steps`")
            } else {
                ("400 times the length of the mechanism", "check the unit, or use a shorter sweep")
            };
            (format!("the sweep is longer than {most}"), help.to_owned())
        }
        NoSweep::Unordered(drive) => {
            labels.push(label("listed positions", drives[drive].span));
            let help = "list the values of one drive in their order, or write a range: `0 deg .. 360 deg in 12 steps`";
            ("the listed positions do not all go in one direction".to_owned(), help.to_owned())
        }
        NoSweep::PartOfTurn { turns, two } => return part_of_turn(model, turns, two),
    };
    Diagnosis::error("mech::solve::no_sweep", format!("no function over the sweep can be found: {why}"))
        .labels(labels)
        .help(help)
}

/// A Fourier series is one over whole turns.
fn part_of_turn(model: &Model<'_>, turns: Option<f64>, two: bool) -> Diagnosis {
    let mechanism = model.mechanism;
    let name = mechanism.drives.first().map_or("crank", |drive| drive.name.as_str());
    let why = match turns {
        None => format!("`{name}` does not turn"),
        Some(turns) if turns.abs() == 1.0 => format!("`{name}` sweeps over one"),
        Some(turns) => format!("`{name}` sweeps over {}", short(turns.abs())),
    };
    let (wanted, number) = if two {
        ("terms of a half order need an even number of turns", 2.0)
    } else {
        ("a Fourier series needs whole turns", 1.0)
    };
    let range = whole_turns(model, mechanism.drives.first(), number);
    let terms = mechanism
        .cycles
        .iter()
        .filter(|c| c.how.harmonic().is_some_and(|term| !two || !term.halves.is_multiple_of(2)));
    let mut spans: Vec<_> = terms.map(|c| c.span).collect();
    spans.dedup();
    let labels = spans.into_iter().map(|span| label("this question", span));
    Diagnosis::error("mech::solve::no_sweep", format!("{wanted}, and {why}"))
        .labels(labels.chain(mechanism.drives.iter().map(|d| label("drive", d.span))))
        .help(format!("write a sweep over whole turns: `drive {name} = {range}`"))
}

/// The functions that need a sweep.
fn asked(model: &Model<'_>) -> Vec<LabeledSpan> {
    let mechanism = model.mechanism;
    let cycles = mechanism.cycles.iter().map(|c| label("taken over the sweep", c.span));
    let flywheels = mechanism.flywheels.iter().map(|f| label("found over a cycle", f.span));
    cycles.chain(flywheels).collect()
}

/// A flywheel cannot be found.
pub(super) fn no_flywheel(model: &Model<'_>, wheel: usize, reason: NoFlywheel) -> Diagnosis {
    let wheel = &model.mechanism.flywheels[wheel];
    let drives = &model.mechanism.drives;
    let name = drives.first().map_or("", |d| d.name.as_str());
    let (why, help) = match reason {
        NoFlywheel::NeedsSpeed => return flywheel_needs_speed(model, wheel),
        NoFlywheel::Efforts => (
            "several efforts are unknown, and `for` names none of them".to_owned(),
            "name the effort: `flywheel J on crank for Mb { … }`".to_owned(),
        ),
        NoFlywheel::Drives => (
            format!("it needs exactly one drive, but there are {}", drives.len()),
            "let one crank drive the mechanism".to_owned(),
        ),
        NoFlywheel::NoCycle(turns) => {
            let why = match turns {
                Some(turns) => {
                    format!("`{name}` sweeps over {} turns, which is not a whole cycle", short(turns))
                }
                None => format!("`{name}` does not turn"),
            };
            let range = whole_turns(model, drives.first(), 1.0);
            (why, format!("sweep over whole turns: `drive {name} = {range}`"))
        }
        NoFlywheel::StandsStill => {
            (format!("`{name}` does not move"), "give the drive its mean speed".to_owned())
        }
        NoFlywheel::Uneven([least, greatest]) => {
            let shaft = &model.mechanism.link(wheel.on).name;
            let range = format!(
                "its speed divided by that of the drive varies from {} to {}",
                four(least),
                four(greatest)
            );
            (
                format!("`{shaft}` does not turn evenly with the drive: {range}"),
                "put it on the crank, or on a shaft that turns in constant ratio".to_owned(),
            )
        }
        NoFlywheel::Undefined(why) => (
            undefined(model, why),
            "check the poses there: `assur solve` reports the error of each".to_owned(),
        ),
    };
    let mut labels = vec![label("this flywheel", wheel.span)];
    labels.extend(drives.iter().map(|d| label("drive", d.span)));
    Diagnosis::error("mech::solve::no_flywheel", format!("flywheel `{}` cannot be found: {why}", wheel.name))
        .labels(labels)
        .help(help)
}

fn flywheel_needs_speed(model: &Model<'_>, wheel: &Flywheel) -> Diagnosis {
    let mut labels = vec![label("needed here", wheel.span)];
    labels.extend(model.mechanism.drives.iter().map(|d| label("without a speed", d.span)));
    no_drive_has(
        "the mean speed of a flywheel",
        "a speed",
        "write `at 80 rpm` after the drive, or `turning ccw` and `speed 80 rpm` in the flywheel's braces",
        labels,
    )
}

/// The links alone, of this reduced moment of inertia, run as evenly as `needed` would make them.
pub(super) fn needless_flywheel(model: &Model<'_>, wheel: usize, have: f64, needed: f64) -> Diagnosis {
    let wheel = &model.mechanism.flywheels[wheel];
    Diagnosis::warning(
        "mech::solve::needless_flywheel",
        format!(
            "flywheel `{}` is not needed: the links alone have {} of {}",
            wheel.name,
            with_unit(model, have, Dimension::INERTIA),
            with_unit(model, needed, Dimension::INERTIA)
        ),
    )
    .label(wheel.span, "asked for here")
    .help(
        "ask for a smaller `fluctuation`, or leave the flywheel out; its moment \
         of inertia is given as 0",
    )
}
