//! What a motion under loads says of itself.

use super::accuracy::order_of;
use super::answers::Answers;
use assur_solve::solve::{Method, SimulationReport};
use assur_text::units::significant;

/// Digits of energies and conditions.
const DIGITS: usize = 3;

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
