//! Sentences about a motion under loads that cannot go on.

use super::clause::clause;
use super::format::{four, label, labels, length, links, short, with_unit};
use super::impossible::spring_at_zero;
use super::opens::opens;
use super::parallel::turn_the_face;
use crate::message::refusal::not_supported_yet;
use crate::model::{Drive, DriveTarget, PairId, PairKind, Value};
use crate::position::{Model, turns};
use crate::solve::{Clause, Halt, NoCycle, SimulationReport};
use crate::source::Span;
use crate::units::Dimension;
use assur_text::diagnostic::Diagnosis;

/// What changes faster than this, 1/s, is no motion of a machine.
const FAST: f64 = 1e4;

pub(super) fn halted(model: &Model<'_>, time: f64, halt: &Halt) -> Diagnosis {
    let instant = |t: f64| with_unit(model, t, Dimension::TIME);
    let simulation = model.mechanism.simulation.as_ref();
    let span = simulation.map_or_else(Span::default, |s| s.span);
    let end = instant(simulation.map_or(time, |s| s.to));
    let at = time;
    let time = instant(time);
    match halt {
        Halt::Dead { group, condition } => dead(model, *group, Some(*condition), at),
        Halt::Open { group } => dead(model, *group, None, at),
        Halt::NoRate { drive, other, value } => no_rate(model, *drive, (*other, *value)),
        Halt::TwoMotions { drive, value, rate, group, ways } => {
            two_motions(model, (*drive, *value, *rate), (*group, ways))
        }
        Halt::NoInertia => no_inertia(model, time),
        Halt::Jam => jam(model, time),
        Halt::Opens { pair, bond } => {
            let at_start = simulation.is_some_and(|s| s.from == at);
            opens(model, (*pair, *bond), (time, at_start))
        }
        Halt::NothingTouches => nothing_touches(model),
        Halt::Rolls { pair } => rolls(model, *pair, time),
        Halt::NoCycle(why) => no_cycle(*why, span),
        Halt::StopPassed { stop, by } => stop_passed(model, *stop, *by, time),
        Halt::StopsAtOnce { stops } => stops_at_once(model, stops, time),
        Halt::Shaken { stop } => shaken(model, *stop, time),
        Halt::NothingFree { stop } => nothing_free(model, *stop),
        Halt::SpringAtZero { spring } => spring_at_zero(model, *spring, &format!(" at {time}")),
        Halt::NotANumber => {
            let loads = model.mechanism.loads.iter().map(|load| label("a load", load.span));
            Diagnosis::error("mech::simulate::no_value", format!("a load has no value at {time}"))
                .labels(loads)
                .help(
                    "look for a root of a negative number, a division by zero or a curve that \
                     is left: the loads are expressions of time, positions and velocities",
                )
        }
        Halt::TooManySteps { steps, rate } => too_many(model, (*steps, *rate), (time, end), span),
        Halt::NoStep => Diagnosis::error(
            "mech::simulate::too_many_steps",
            format!("no step of the motion is short enough at {time}"),
        )
        .label(span, format!("only to {time}"))
        .help(
            "look for a `start` so large that its last digit is longer than a step, or for a \
             load that changes without bound there",
        ),
        Halt::Unbounded { drive } => unbounded(model, *drive, time),
        Halt::Interrupted => Diagnosis::error(
            "",
            format!(
                "the motion was stopped at {time}, before its end at {end}: what it did \
                 until then is printed"
            ),
        )
        .label(span, format!("only to {time}"))
        .help("let `simulate` end earlier, or ask for less accuracy with `within`"),
        Halt::Accuracy { wanted, reached } => accuracy(*wanted, *reached, span),
    }
}

/// A run that is long, or made of steps that something fast makes short.
fn too_many(
    model: &Model<'_>,
    (steps, rate): (usize, f64),
    (time, end): (String, String),
    span: Span,
) -> Diagnosis {
    let mechanism = model.mechanism;
    let damped = mechanism.springs.iter().any(|spring| spring.damping > 0.0);
    let mut help = "let `simulate` end earlier, or ask for less accuracy with `within`".to_owned();
    if !mechanism.springs.is_empty() && rate > FAST {
        help += &format!(
            "; something changes at a rate of {} 1/s: look for a spring or damper that is far stiffer than the motion",
            four(rate)
        );
    } else if damped || mechanism.loads.iter().any(|load| load.expressions().next().is_some()) {
        help += "; where the motion repeats, `simulate steady` follows one period";
    }
    Diagnosis::error(
        "mech::simulate::too_many_steps",
        format!("the motion takes too many steps: {steps} have reached {time} of {end}"),
    )
    .label(span, format!("only to {time}"))
    .help(help)
}

fn unbounded(model: &Model<'_>, drive: usize, time: String) -> Diagnosis {
    let drive = &model.mechanism.drives[drive];
    let loads = model.mechanism.loads.iter().filter(|load| load.expressions().next().is_some());
    Diagnosis::error(
        "mech::simulate::too_many_steps",
        format!("`{}` grows without bound at {time}", drive.written_name()),
    )
    .label(drive.span, "started here")
    .labels(loads.map(|load| label("a load", load.span)))
    .help(format!(
        "let `simulate` end before {time}, or look for a load that grows with the motion it drives"
    ))
}

/// An end that does not come.
pub(super) fn never_ended(model: &Model<'_>, event: usize, at: f64) -> Diagnosis {
    let span = model.mechanism.events[event].span;
    let (what, last, help) = match model.mechanism.swept_drive().map(|drive| &model.mechanism.drives[drive]) {
        Some(drive) => {
            let at = model.mechanism.drive_display(drive.target).text(Value::Scalar(at), 4);
            let help = format!("let `{}` go on for longer, or leave `until` out", drive.name);
            ("the sweep", format!("{at}, its last position"), help)
        }
        None => {
            let at = with_unit(model, at, Dimension::TIME);
            let help = "let `simulate` go on for longer, or leave `until` out".to_owned();
            ("the motion", format!("{at}, its last instant"), help)
        }
    };
    Diagnosis::warning(
        "mech::simulate::never_ended",
        format!("{what} does not come to this end until {last}"),
    )
    .label(span, "does not happen")
    .help(help)
}

fn accuracy(wanted: f64, reached: f64, span: Span) -> Diagnosis {
    let known = reached < SimulationReport::NOTHING;
    let wanted = power(wanted);
    let (known, help) = if known {
        let enough = power(enough(reached));
        (
            format!(
                "the motion is known to {} of the greatest of its kind; wanted was {wanted}",
                power(reached)
            ),
            format!("write `within {enough}`, which is reached"),
        )
    } else {
        (
            format!("nothing is known of the motion at its end: runs in different steps do not agree; wanted was {wanted}"),
            "let `simulate` end earlier, as where the least change of a start grows to another motion, or look for an instant from which the motion may go on in two ways, or for a coordinate whose last \
             digit is greater than that"
                .to_owned(),
        )
    };
    Diagnosis::error("mech::simulate::tolerance", known).label(span, "not reached").help(help)
}

/// An accuracy in words of a file.
fn power(x: f64) -> String {
    format!("{x:.1e}").replace(".0e", "e")
}

/// A power of ten above twice an error.
fn enough(reached: f64) -> f64 {
    let mut enough = 1e-14;
    while enough < 2.0 * reached && enough < 0.1 {
        enough *= 10.0;
    }
    enough
}

/// One per statement, which may give two coordinates.
fn starts<'m>(model: &Model<'m>) -> impl Iterator<Item = &'m Drive> {
    let drives = &model.mechanism.drives;
    let repeats = |i: usize| i > 0 && drives[i - 1].span == drives[i].span;
    drives.iter().enumerate().filter(move |(i, d)| d.free && !repeats(*i)).map(|(_, d)| d)
}

fn dead(model: &Model<'_>, group: usize, condition: Option<f64>, time: f64) -> Diagnosis {
    let group = &model.structure.motion[group];
    let mut all = labels(model, group, "in a dead position");
    all.extend(starts(model).map(|d| label("started here", d.span)));
    let timed = model.mechanism.drives.iter().filter(|drive| drive.of_time);
    all.extend(timed.map(|drive| label("moves it there", drive.span)));
    let rubs = model.plan.effects.loses();
    let passed = if rubs {
        "no other coordinates move it past this place, and a change point, with links in line, is only passed where nothing rubs"
    } else {
        "no other coordinates move it past this place"
    };
    let at_start = model.mechanism.simulation.as_ref().is_some_and(|s| s.from == time);
    let time = with_unit(model, time, Dimension::TIME);
    let help = if let Some(help) = turn_the_face(model, group) {
        help
    } else if at_start {
        format!("{passed}: start the motion farther from it")
    } else {
        format!("{passed}: let `simulate` end before {time}")
    };
    Diagnosis::error(
        "mech::simulate::dead_position",
        format!(
            "the motion cannot go on at {time}: {} in a dead position, |σ| = {}",
            links(model, group),
            condition.map_or_else(|| "0".into(), four)
        ),
    )
    .labels(all)
    .help(help)
}

/// `start crank = 30 deg at 1 rad/s`
fn start_line(model: &Model<'_>, name: &str, (turns, value, rate): (bool, f64, Option<f64>)) -> String {
    let value = if turns { format!("{} deg", short(value.to_degrees())) } else { length(model, value) };
    let dimension = if turns { Dimension::ANGULAR_VELOCITY } else { Dimension::VELOCITY };
    match rate {
        Some(0.0) => format!("start {name} = {value}"),
        Some(rate) => format!("start {name} = {value} at {}", with_unit(model, rate, dimension)),
        None => format!("start {name} = {value} at {}", if turns { "1 rad/s" } else { "0.1 m/s" }),
    }
}

fn no_rate(model: &Model<'_>, drive: usize, (other, value): (DriveTarget, f64)) -> Diagnosis {
    let mechanism = model.mechanism;
    let drive = &mechanism.drives[drive];
    let name = match other {
        DriveTarget::Link(link) | DriveTarget::Point(link, _) | DriveTarget::Place(link, ..) => {
            &mechanism.link(link).name
        }
        DriveTarget::Pair(pair) => &mechanism.pair(pair).name,
    };
    let turns = turns(model, &Drive { target: other, ..drive.clone() });
    let line = start_line(model, name, (turns, value, None));
    let help = format!(
        "start what can move there, as in `{line}`, or leave out the speed of `{}`",
        drive.written_name()
    );
    Diagnosis::error(
        "mech::simulate::dead_position",
        format!(
            "`{}` can have no speed where it starts: it is in its dead position there",
            drive.written_name()
        ),
    )
    .label(drive.span, "no motion of the links gives it this speed")
    .help(help)
}

fn two_motions(
    model: &Model<'_>,
    (drive, value, rate): (usize, f64, f64),
    (group, ways): (usize, &[Clause]),
) -> Diagnosis {
    let drive = &model.mechanism.drives[drive];
    let line = start_line(model, &drive.name, (turns(model, drive), value, Some(rate)));
    let ways: Vec<String> = ways.iter().map(|way| format!("\n  {}", clause(model, way))).collect();
    let group = &model.structure.motion[group];
    let links = links(model, group);
    let help = format!(
        "start a little away from it, and choose how {links} stand there: write\n  {line}\nand one of{}",
        ways.concat()
    );
    let mut all = labels(model, group, "in line");
    all.push(label("starts in a change point", drive.span));
    Diagnosis::error(
        "mech::simulate::two_motions",
        format!("two motions begin where `{}` starts, and nothing says which is meant", drive.name),
    )
    .labels(all)
    .help(help)
}

fn rubbing(model: &Model<'_>, text: &str) -> Vec<miette::LabeledSpan> {
    let pairs = model.mechanism.pairs.iter().filter(|p| p.friction.is_some_and(|f| f.is_some()));
    pairs.map(|pair| label(text, pair.span)).collect()
}

fn jam(model: &Model<'_>, time: String) -> Diagnosis {
    Diagnosis::error(
        "mech::simulate::jam",
        format!("friction jams the motion at {time}: no acceleration satisfies its law (Painlevé)"),
    )
    .labels(rubbing(model, "rubs"))
    .help("with less friction, or from another position, the motion goes on")
}

fn nothing_touches(model: &Model<'_>) -> Diagnosis {
    let mechanism = model.mechanism;
    let parts = mechanism.pairs.iter().filter(|p| matches!(p.kind, PairKind::Contact { parts: true, .. }));
    let starts: Vec<String> = mechanism
        .touching
        .iter()
        .map(|drive| format!("`start {} = …`", mechanism.drives[*drive].name))
        .collect();
    Diagnosis::error(
        "mech::simulate::nothing_touches",
        format!(
            "{} of the contacts that part must be closed at the first instant, and none can be",
            starts.len()
        ),
    )
    .labels(parts.map(|pair| label("open", pair.span)))
    .help(format!("add {}, or change the other starts so that profiles touch", starts.join(", ")))
}

fn rolls(model: &Model<'_>, pair: PairId, time: String) -> Diagnosis {
    let pair = model.mechanism.pair(pair);
    Diagnosis::error(
        "mech::simulate::rolls",
        format!("from {time} on friction would hold `{}`, so that the cam rolls on its follower", pair.name),
    )
    .label(pair.span, "comes to rest")
    .help(format!("let `simulate` end before {time}, or give the contact less friction"))
}

fn no_cycle(why: NoCycle, span: Span) -> Diagnosis {
    let (what, help) = match why {
        NoCycle::NotReached(time) => (
            format!(
                "the motion does not repeat: from the starts its end is not reached within {} s",
                four(time)
            ),
            "start with a greater speed, or look for a load that stops the motion",
        ),
        NoCycle::Differs { trials, by } => (
            format!(
                "no motion was found that repeats: after {trials} trials the end still differs from the start by {} of the greatest",
                four(by)
            ),
            "start nearer to the steady motion, with its mean speed; loads must brake more at a greater speed",
        ),
    };
    Diagnosis::error("mech::simulate::no_cycle", what).label(span, "does not repeat").help(help)
}

fn stop_passed(model: &Model<'_>, stop: usize, by: f64, time: String) -> Diagnosis {
    let stop = &model.mechanism.stops[stop];
    let dimension = if stop.turns { Dimension::ANGLE } else { Dimension::LENGTH };
    let name = model.mechanism.pair(stop.pair).name.clone();
    let side = if stop.side > 0.0 { "below" } else { "above" };
    let help = format!("start the motion where `displacement({name})` is on the other side of the stop");
    Diagnosis::error(
        "mech::simulate::stop_passed",
        format!("`{name}` is {} {side} its stop at {time}", with_unit(model, by, dimension)),
    )
    .label(stop.span, "passed")
    .help(help)
}

fn stops_at_once(model: &Model<'_>, stops: &[usize], time: String) -> Diagnosis {
    let names = stops.iter().map(|stop| {
        let pair = model.mechanism.stops[*stop].pair;
        format!("`{}`", model.mechanism.pair(pair).name)
    });
    let names = names.collect::<Vec<_>>().join(" and ");
    let labels = stops.iter().map(|stop| label("hit", model.mechanism.stops[*stop].span));
    Diagnosis::error(
        "mech::simulate::stops_at_once",
        format!("the stops of {names} are hit at once at {time}: too many for one impact"),
    )
    .labels(labels)
    .help(format!("let the starts differ a little, so that no more than 8 are hit at once, or let `simulate` end before {time}"))
}

fn shaken(model: &Model<'_>, stop: usize, time: String) -> Diagnosis {
    let stop = &model.mechanism.stops[stop];
    let name = model.mechanism.pair(stop.pair).name.clone();
    let mut labels = vec![label("rebounds", stop.span)];
    labels.extend(rubbing(model, "rubs"));
    Diagnosis::error(
        "mech::simulate::shaken",
        format!(
            "from {time} on the rebounds at the stop of `{name}` are too low to be \
             followed, and pairs that rub stick and slip in them"
        ),
    )
    .labels(labels)
    .help(format!(
        "leave out `restitution` of the stop: it then stays closed after its \
         first impact; or let `simulate` end before {time}"
    ))
}

fn nothing_free(model: &Model<'_>, stop: usize) -> Diagnosis {
    let labels = vec![label("bounds what is driven", model.mechanism.stops[stop].span)];
    not_supported_yet("a stop of what drives alone move", labels)
}

fn no_inertia(model: &Model<'_>, time: String) -> Diagnosis {
    let mechanism = model.mechanism;
    let names = starts(model).map(|d| format!("`{}`", d.written_name())).collect::<Vec<_>>();
    let light = mechanism.links.iter().skip(1).filter(|l| l.mass.is_none());
    let light = light.map(|l| format!("`{}`", l.name)).collect::<Vec<_>>();
    let what = if names.len() == 1 { "it moves links" } else { "they move links" };
    let help = if light.is_empty() {
        "give a link that turns an inertia: `inertia 0.02 kg*m^2`".to_owned()
    } else {
        format!("give {} a mass, as in `mass 2 kg at S`, or an inertia", light.join(" or "))
    };
    let labels = starts(model).map(|d| label("moves no mass", d.span));
    Diagnosis::error(
        "mech::simulate::no_inertia",
        format!("nothing resists the acceleration of {} at {time}: {what} without inertia", names.join(", ")),
    )
    .labels(labels)
    .help(help)
}
