//! What a motion under loads says of itself.

use super::accuracy::order_of;
use super::answers::{Answers, NONE, with_unit};
use super::document::{Column, Report, Section, Table};
use assur_model::model::{DriveTarget, Mechanism, PairKind, Value};
use assur_solve::solve::{Holder, Method, NotByEnergy, On, Pose, SimulationReport};
use assur_text::units::{Dimension, significant};

/// A rest that is shorter than this part of the run is no more than a turn.
const TOUCH: f64 = 1e-9;
/// So many instants of an event are shown.
const MOST: usize = 8;
/// Digits of energies and conditions.
const DIGITS: usize = 3;

/// Whether a column says which events happen at the instants that are printed.
pub(super) fn names_events(mechanism: &Mechanism) -> bool {
    mechanism.events.iter().any(|event| event.name.is_some())
}

/// The events that happen at a pose, by their names.
pub(super) fn events_at(answers: &Answers<'_>, pose: &Pose) -> String {
    let names = answers.solution.events_at(answers.model.mechanism, pose);
    names.join(", ")
}

/// Where every event happens, and when what is held.
pub(super) fn section(answers: &Answers<'_>, report: &mut Report) {
    let (mechanism, statics) = (answers.model.mechanism, &answers.solution.statics);
    let along = statics.along(mechanism);
    let mut table = Table::new(vec![Column::words("event"), Column::numbers("count")], 1);
    let most = statics.events.iter().map(Vec::len).max().unwrap_or(0).min(MOST);
    for which in 0..most {
        table.columns.push(Column::numbers(with_unit(&format!("{}.", which + 1), &along.unit)));
    }
    for (event, places) in mechanism.events.iter().zip(&statics.events) {
        let mut cells = vec![event.name.clone().unwrap_or_else(|| "until".into()), places.len().to_string()];
        let shown = (0..most).map(|which| {
            places.get(which).map_or_else(
                || NONE.to_owned(),
                |t| along.figures(Value::Scalar(*t), answers.precision.digits),
            )
        });
        cells.extend(shown);
        table.row(cells);
    }
    let mut section = Section::new("Events");
    if !mechanism.events.is_empty() {
        section.table(table);
    }
    if let Some(run) = &answers.solution.simulation {
        rests(answers, run, &mut section);
    }
    report.section(section);
}

/// When pairs are held by friction or rest on their stops.
fn rests(answers: &Answers<'_>, run: &SimulationReport, section: &mut Section) {
    let mechanism = answers.model.mechanism;
    let time = mechanism.display_of(Dimension::TIME);
    let instant =
        |t: f64| format!("{} {}", time.figures(Value::Scalar(t), answers.precision.digits), time.unit);
    let lasts = |(begin, end): (f64, Option<f64>), what: &str| match end {
        Some(end) => format!("{what} from {} to {}", instant(begin), instant(end)),
        None => format!("{what} from {} on", instant(begin)),
    };
    let name = |pair| &mechanism.pair(pair).name;
    let holds = |holder: &Holder| match holder {
        Holder::Pair(pair) => format!("{} held by friction", name(*pair)),
        Holder::Load(load) => {
            format!("{} holds", mechanism.loads[load.index()].name.as_deref().unwrap_or("a load"))
        }
    };
    let held = run.held.iter().map(|(holder, begin, end)| ((*begin, *end), holds(holder)));
    let long = |rest: &(f64, Option<f64>)| rest.1.is_none_or(|end| end - rest.0 > TOUCH * run.end);
    for (rest, what) in held.filter(|(rest, _)| long(rest)).take(MOST) {
        section.text(lasts(rest, &what));
    }
    for (holder, time) in run.jammed.iter().take(MOST) {
        let Holder::Pair(pair) = holder else { continue };
        let what = format!("{} stops at once at {}", name(*pair), instant(*time));
        section.text(format!("{what}: its friction admits no acceleration (Painlevé)"));
    }
    for (stop, times) in mechanism.stops.iter().zip(&run.closed) {
        for rest in times.iter().take(MOST) {
            let is_contact = matches!(mechanism.pair(stop.pair).kind, PairKind::Contact { .. });
            let what = if is_contact { "closed" } else { "rests on its stop" };
            section.text(lasts(*rest, &format!("{} {what}", name(stop.pair))));
        }
    }
}

/// How it was integrated, and how accurately.
pub(super) fn lines(answers: &Answers<'_>) -> Vec<String> {
    let Some(report) = &answers.solution.simulation else { return Vec::new() };
    let order = |x: f64| order_of(x, answers.precision);
    let wanted = significant(report.within, DIGITS);
    let estimated = if report.error < SimulationReport::NOTHING {
        format!(
            "estimated error {} of the greatest of its kind ({}); wanted {wanted}",
            order(report.error),
            report.worst
        )
    } else {
        format!("the error is not known; wanted {wanted}")
    };
    let mut lines = vec![
        format!(
            "integrated by {}: {} steps, {} rejected, {} evaluations in all runs",
            taken(answers.model.mechanism, report),
            report.steps,
            report.rejected,
            report.evaluations
        ),
        estimated,
    ];
    if let Some(steady) = report.steady {
        lines.push(format!(
            "the motion comes again after {} s: found by following {} periods, its begin to {}",
            significant(steady.period, answers.precision.digits),
            steady.trials,
            order(steady.error)
        ));
    }
    if let Some(energy) = report.energy {
        let greatest = energy.begin.max(energy.end).max(energy.work.abs());
        let joules = |x: f64| significant(if x.abs() <= f64::EPSILON * greatest { 0.0 } else { x }, DIGITS);
        lines.push(format!(
            "kinetic energy {} J at the begin, {} J at the end; work of all loads {} J; missing {} of the greatest",
            joules(energy.begin),
            joules(energy.end),
            joules(energy.work),
            order(energy.balance)
        ));
    }
    lines.extend(condition(report));
    lines.extend(changes(answers.model.mechanism, report));
    lines.extend(crossed(report));
    lines
}

/// The other coordinates that were taken near dead positions.
fn changes(mechanism: &Mechanism, report: &SimulationReport) -> Option<String> {
    let shown = report.changes.iter().take(MOST).map(|(time, targets)| {
        let names: Vec<&str> = coordinates(mechanism, targets).collect();
        format!("{} from {} s", names.join(" and "), significant(*time, DIGITS))
    });
    let shown: Vec<String> = shown.collect();
    let more = report.changes.len() - shown.len();
    let more = if more > 0 { format!(", and {more} times more") } else { String::new() };
    (!shown.is_empty()).then(|| format!("other coordinates near dead positions: {}{more}", shown.join(", ")))
}

/// The change points that were passed, each before the instant that is shown.
fn crossed(report: &SimulationReport) -> Option<String> {
    let shown = report.crossed.iter().take(MOST).map(|time| format!("{} s", significant(*time, DIGITS)));
    let shown: Vec<String> = shown.collect();
    let more = report.crossed.len() - shown.len();
    let more = if more > 0 { format!(" and {more} times more") } else { String::new() };
    let line = format!(
        "change points passed before {}{more}, where the links could go on in two ways: they go on smoothly",
        shown.join(", ")
    );
    (!shown.is_empty()).then_some(line)
}

/// The names of coordinates.
pub(super) fn coordinates<'m>(
    mechanism: &'m Mechanism,
    targets: &'m [DriveTarget],
) -> impl Iterator<Item = &'m str> {
    targets.iter().map(|target| match target {
        DriveTarget::Link(link) | DriveTarget::Point(link, _) | DriveTarget::Place(link, ..) => {
            mechanism.link(*link).name.as_str()
        }
        DriveTarget::Pair(pair) => mechanism.pair(*pair).name.as_str(),
    })
}

/// The least condition on the way, where it is not that of one position alone.
fn condition(report: &SimulationReport) -> Option<String> {
    let (condition, time) = report.worst_condition;
    let time = format!("{} s", significant(time, DIGITS));
    (condition < 1.0)
        .then(|| format!("least condition on the way {} at {time}", significant(condition, DIGITS)))
}

/// The method by its name.
pub(super) const fn method(method: Method) -> &'static str {
    match method {
        Method::Dop853 => "DOP853",
        Method::Energy => "energy and quadrature",
        Method::Radau => "Radau IIA of order 5, from where DOP853 was held up",
    }
}

/// The method that was taken, and why.
pub(super) fn taken(mechanism: &Mechanism, report: &SimulationReport) -> String {
    let since = why(mechanism, report).map_or_else(String::new, |why| format!(", since {why}"));
    format!("{}{since}", method(report.method))
}

/// Why that method was taken.
pub(super) fn why(mechanism: &Mechanism, report: &SimulationReport) -> Option<String> {
    let name = |pair| &mechanism.pair(pair).name;
    Some(match report.why {
        _ if report.method == Method::Energy => "the one coordinate decides on all forces".to_owned(),
        // what held up the other method is said
        None => return None,
        _ if report.method == Method::Radau => return None,
        // drives say the whole motion
        Some(NotByEnergy::Coordinates(0)) => return None,
        Some(NotByEnergy::Coordinates(count)) => format!("{count} coordinates are free"),
        Some(NotByEnergy::Drive(target)) => {
            format!("`drive {}` moves", coordinates(mechanism, &[target]).collect::<String>())
        }
        Some(NotByEnergy::Friction(pair)) => format!("there is friction in `{}`", name(pair)),
        Some(NotByEnergy::Losses(pair)) => format!("`{}` loses power", name(pair)),
        Some(NotByEnergy::Damper(spring)) => format!("`{}` is damped", mechanism.springs[spring].name),
        Some(NotByEnergy::Geneva(pair)) => format!("`{}` moves in steps", name(pair)),
        Some(NotByEnergy::Stop(stop)) => format!("`stop {}` is hit", name(mechanism.stops[stop].pair)),
        Some(NotByEnergy::Beyond) => "the mechanism ends near where it is".to_owned(),
        Some(NotByEnergy::Load(load, on)) => {
            let of = match &mechanism.loads[load.index()].name {
                Some(name) => format!("`{name}`"),
                None => "a load".to_owned(),
            };
            let on = match on {
                On::Sense => "acts against the motion",
                On::Time => "depends on time",
                On::Speeds => "depends on speeds",
            };
            format!("{of} {on}")
        }
    })
}
