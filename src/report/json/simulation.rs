//! What a motion under loads says of itself.

use super::entries::{Entries, Number};
use crate::report::answers::Answers;
use crate::report::simulation::{coordinates, method, why};
use assur_model::model::{DriveTarget, Stop};
use assur_solve::solve::{Energy, Holder};
use serde::Serialize;

#[derive(Serialize)]
pub(super) struct SimulationView {
    method: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
    coordinates: Vec<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    changes: Vec<ChangeView>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    change_points: Vec<Number>,
    steps: usize,
    rejected: usize,
    evaluations: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    within: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<Number>,
    worst: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    energy: Option<EnergyView>,
    #[serde(skip_serializing_if = "Option::is_none")]
    worst_condition: Option<ConditionView>,
    #[serde(skip_serializing_if = "Entries::is_empty")]
    events: Entries<Vec<Number>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    rests: Vec<RestView>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    stops: Vec<RestView>,
    #[serde(skip_serializing_if = "Option::is_none")]
    steady: Option<SteadyView>,
    ended: EndView,
}

/// Other coordinates from an instant on.
#[derive(Serialize)]
struct ChangeView {
    time: Option<Number>,
    coordinates: Vec<String>,
}

/// A rest, at a stop or by friction; without an end where it lasts.
#[derive(Serialize)]
struct RestView {
    #[serde(skip_serializing_if = "Option::is_none")]
    name: Option<String>,
    from: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    to: Option<Number>,
}

impl RestView {
    fn of(name: Option<&str>, (from, to): (f64, Option<f64>)) -> Self {
        Self { name: name.map(str::to_owned), from: Number::of(from), to: to.and_then(Number::of) }
    }
}

/// How a motion that comes again was found.
#[derive(Serialize)]
struct SteadyView {
    period: Option<Number>,
    trials: usize,
    error: Option<Number>,
}

#[derive(Serialize)]
struct EnergyView {
    begin: Option<Number>,
    end: Option<Number>,
    work: Option<Number>,
    balance: Option<Number>,
}

#[derive(Serialize)]
struct ConditionView {
    condition: Option<Number>,
    time: Option<Number>,
}

#[derive(Serialize)]
struct EndView {
    #[serde(skip_serializing_if = "Option::is_none")]
    by: Option<&'static str>,
    time: Option<Number>,
}

/// Where every event happens, by its name: instants, s, or values of the swept drive, rad or m.
pub(super) fn events(answers: &Answers<'_>) -> Entries<Vec<Number>> {
    let all = answers.model.mechanism.events.iter().zip(&answers.solution.statics.events);
    let named = all.filter_map(|(event, places)| {
        let name = event.name.clone()?;
        Some((name, places.iter().filter_map(|at| Number::of(*at)).collect()))
    });
    Entries(named.collect())
}

impl SimulationView {
    /// Of a file that follows a motion.
    pub fn of(answers: &Answers<'_>) -> Option<Self> {
        let (mechanism, report) = (answers.model.mechanism, answers.solution.simulation.as_ref()?);
        let energy = |e: Energy| EnergyView {
            begin: Number::of(e.begin),
            end: Number::of(e.end),
            work: Number::of(e.work),
            balance: Number::of(e.balance),
        };
        let change = |(time, targets): &(f64, Vec<DriveTarget>)| ChangeView {
            time: Number::of(*time),
            coordinates: coordinates(mechanism, targets).map(str::to_owned).collect(),
        };
        let stops = mechanism.stops.iter().zip(&report.closed);
        let closed = |(stop, times): (&Stop, &Vec<(f64, Option<f64>)>)| {
            let name = mechanism.pair(stop.pair).name.as_str();
            times.iter().map(|rest| RestView::of(Some(name), *rest)).collect::<Vec<_>>()
        };
        let name = |holder: &Holder| match holder {
            Holder::Pair(pair) => Some(mechanism.pair(*pair).name.as_str()),
            Holder::Load(load) => mechanism.loads[load.index()].name.as_deref(),
        };
        let held = report.held.iter().map(|(holder, begin, end)| RestView::of(name(holder), (*begin, *end)));
        Some(Self {
            method: method(report.method),
            reason: why(mechanism, report),
            coordinates: report.coordinates.iter().map(|&i| mechanism.drives[i].name.clone()).collect(),
            changes: report.changes.iter().map(change).collect(),
            change_points: report.crossed.iter().filter_map(|t| Number::of(*t)).collect(),
            steps: report.steps,
            rejected: report.rejected,
            evaluations: report.evaluations,
            within: Number::of(report.within),
            error: Number::of(report.error),
            worst: report.worst,
            energy: report.energy.map(energy),
            worst_condition: Some(ConditionView {
                condition: Number::of(report.worst_condition.0),
                time: Number::of(report.worst_condition.1),
            }),
            events: events(answers),
            rests: held.collect(),
            stops: stops.flat_map(closed).collect(),
            steady: report.steady.map(|steady| SteadyView {
                period: Number::of(steady.period),
                trials: steady.trials,
                error: Number::of(steady.error),
            }),
            ended: EndView { by: report.ended_by.map(|_| "until"), time: Number::of(report.end) },
        })
    }
}
