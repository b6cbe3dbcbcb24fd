//! What a motion under loads says of itself.

use super::entries::{Entries, Number};
use crate::report::answers::Answers;
use crate::report::simulation::method;
use assur_solve::solve::Energy;
use serde::Serialize;

#[derive(Serialize)]
pub(super) struct SimulationView {
    method: &'static str,
    coordinates: Vec<String>,
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
    ended: EndView,
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

impl SimulationView {
    /// Of a file that follows a motion.
    pub fn of(answers: &Answers<'_>) -> Option<Self> {
        let (mechanism, report) = (answers.model.mechanism, answers.solution.simulation.as_ref()?);
        let times = mechanism.events.iter().zip(&report.events).filter_map(|(event, times)| {
            let name = event.name.clone()?;
            Some((name, times.iter().filter_map(|t| Number::of(*t)).collect()))
        });
        let energy = |e: Energy| EnergyView {
            begin: Number::of(e.begin),
            end: Number::of(e.end),
            work: Number::of(e.work),
            balance: Number::of(e.balance),
        };
        Some(Self {
            method: method(report.method),
            coordinates: report.coordinates.iter().map(|&i| mechanism.drives[i].name.clone()).collect(),
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
            events: Entries(times.collect()),
            ended: EndView { by: report.ended_by.map(|_| "until"), time: Number::of(report.end) },
        })
    }
}
