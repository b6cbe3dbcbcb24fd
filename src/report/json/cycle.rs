//! Flywheels and the accuracy of functions over the sweep.

use serde::Serialize;

use super::entries::{Entries, Number};
use crate::report::answers::Answers;
use crate::report::cycle::{all_flywheels, named};
use assur_model::model::FlywheelPart;
use assur_solve::solve::{CycleAnswer, PoseAnswers, State};

#[derive(Serialize)]
pub(super) struct FlywheelView {
    #[serde(skip_serializing_if = "Option::is_none")]
    inertia: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    fluctuation: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    mean_torque: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    speed: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    least_at: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    greatest_at: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    links_inertia: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    rim: Option<RimView>,
}

#[derive(Serialize)]
struct RimView {
    width: Number,
    height: Number,
    mass: Number,
}

#[derive(Serialize)]
pub(super) struct AccuracyView {
    error: Number,
    positions: usize,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    splits: Vec<Number>,
}

/// The flywheels by their names.
pub(super) fn flywheels(answers: &Answers<'_>) -> Entries<FlywheelView> {
    let plan = answers.model.plan;
    let state = State::new(plan);
    let angles = vec![0.0; plan.bodies];
    let view = PoseAnswers::new(&answers.model, &state, &angles, &answers.solution.statics);
    let all = all_flywheels(answers).enumerate().map(|(index, (wheel, found))| {
        let part = |part| Number::of(view.flywheel(index, part));
        let rim = || {
            Some(RimView {
                width: part(FlywheelPart::RimWidth)?,
                height: part(FlywheelPart::RimHeight)?,
                mass: part(FlywheelPart::RimMass)?,
            })
        };
        let entry = FlywheelView {
            inertia: Number::of(found.inertia),
            fluctuation: Number::of(found.fluctuation),
            mean_torque: Number::of(found.mean_torque),
            speed: Number::of(found.speed),
            least_at: Number::of(found.extremes[0]),
            greatest_at: Number::of(found.extremes[1]),
            links_inertia: Number::of(found.links[0]),
            rim: wheel.rim.and_then(|_| rim()),
        };
        (wheel.name.clone(), entry)
    });
    Entries(all.collect())
}

/// The effort of functions over the sweep, by the names of the questions.
pub(super) fn accuracy(answers: &Answers<'_>) -> Entries<AccuracyView> {
    let entry = |(name, cycle): (&str, &CycleAnswer)| {
        let error = Number::of(cycle.error).filter(|_| cycle.value.is_finite())?;
        let splits = cycle.splits.iter().filter_map(|x| Number::of(*x)).collect();
        Some((name.to_owned(), AccuracyView { error, positions: cycle.samples, splits }))
    };
    let mut all: Vec<(String, AccuracyView)> = Vec::new();
    for (name, view) in named(answers).into_iter().filter_map(entry) {
        if !all.iter().any(|(n, _)| *n == name) {
            all.push((name, view));
        }
    }
    Entries(all)
}
