//! What a motion under loads says of itself.

use super::accuracy::order_of;
use super::answers::{Answers, NONE, with_unit};
use super::document::{Column, Report, Section, Table};
use assur_model::model::{Mechanism, Value};
use assur_solve::solve::{Method, Pose, SimulationReport};
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

/// The events that happen at the instant of a pose, by their names.
pub(super) fn events_at(answers: &Answers<'_>, pose: &Pose) -> Option<String> {
    let (mechanism, report) = (answers.model.mechanism, answers.solution.simulation.as_ref()?);
    let time = pose.outcome.as_ref().ok()?.state.motion.time;
    let all = mechanism.events.iter().zip(&report.events);
    let here = all.filter(|(_, times)| times.contains(&time));
    let names = here.map(|(event, _)| event.name.as_deref().unwrap_or("end"));
    Some(names.collect::<Vec<_>>().join(", "))
}

/// The instants of every event.
pub(super) fn section(answers: &Answers<'_>, report: &mut Report) {
    let Some(run) = &answers.solution.simulation else { return };
    let mechanism = answers.model.mechanism;
    let time = mechanism.display_of(Dimension::TIME);
    let mut table = Table::new(vec![Column::words("event"), Column::numbers("count")], 1);
    let most = run.events.iter().map(Vec::len).max().unwrap_or(0).min(MOST);
    for which in 0..most {
        table.columns.push(Column::numbers(with_unit(&format!("{}.", which + 1), &time.unit)));
    }
    for (event, times) in mechanism.events.iter().zip(&run.events) {
        let mut cells = vec![event.name.clone().unwrap_or_else(|| "until".into()), times.len().to_string()];
        let shown = (0..most).map(|which| {
            times.get(which).map_or_else(
                || NONE.to_owned(),
                |t| time.figures(Value::Scalar(*t), answers.precision.digits),
            )
        });
        cells.extend(shown);
        table.row(cells);
    }
    let mut section = Section::new("Events");
    if !mechanism.events.is_empty() {
        section.table(table);
    }
    let instant =
        |t: f64| format!("{} {}", time.figures(Value::Scalar(t), answers.precision.digits), time.unit);
    let lasting = |rest: &&(f64, Option<f64>)| rest.1.is_none_or(|end| end - rest.0 > TOUCH * run.end);
    for (begin, end) in run.rests.iter().filter(lasting).take(MOST) {
        section.text(match end {
            Some(end) => format!("held at rest by friction from {} to {}", instant(*begin), instant(*end)),
            None => format!("held at rest by friction from {} on", instant(*begin)),
        });
    }
    report.section(section);
}

/// How it was integrated, and how accurately.
pub(super) fn lines(answers: &Answers<'_>) -> Vec<String> {
    let Some(report) = &answers.solution.simulation else { return Vec::new() };
    let order = |x: f64| order_of(x, answers.precision);
    let mut lines = vec![
        format!(
            "integrated by {}: {} steps, {} rejected, {} evaluations in all runs",
            method(report.method),
            report.steps,
            report.rejected,
            report.evaluations
        ),
        format!(
            "estimated error {} of the greatest of its kind ({}); wanted {}",
            order(report.error),
            report.worst,
            significant(report.within, DIGITS)
        ),
    ];
    if let Some(energy) = report.energy {
        lines.push(format!(
            "kinetic energy {} J at the begin, {} J at the end; work of all loads {} J; missing {} of the greatest",
            significant(energy.begin, DIGITS),
            significant(energy.end, DIGITS),
            significant(energy.work, DIGITS),
            order(energy.balance)
        ));
    }
    lines.extend(condition(report));
    lines
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
        Method::Radau => "Radau IIA of order 5, from where DOP853 was held up",
    }
}
