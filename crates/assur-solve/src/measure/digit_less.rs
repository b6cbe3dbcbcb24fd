//! What an accuracy took, and what a digit less would: counts, which are the same on every machine.

use super::accuracy::sampled;
use super::runs::bounded;
use crate::plan::Settings;
use crate::position::Model;
use crate::solve::{IntegrationOptions, Method, Solution, Trials};

/// Counts of the same answers for two accuracies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DigitLess {
    pub within: f64,
    /// Evaluations of the equations of a motion in all its runs; samples of functions over a sweep.
    pub took: usize,
    /// The same for ten times the error; nothing where that takes too many steps too.
    pub less: Option<usize>,
}

/// Of a motion under loads: it is integrated once more, for ten times the error.
#[must_use]
pub fn run_with_a_digit_less(model: &Model<'_>, solution: &Solution) -> Option<DigitLess> {
    let run = solution.simulation.as_ref()?;
    // by the same method, also where another had been chosen
    let method = Some(run.method).filter(|method| *method == Method::Dop853);
    let trials = Trials::new(model, &solution.statics).ok()??;
    let less =
        bounded(&trials, 10.0 * run.within, IntegrationOptions { method, ..IntegrationOptions::default() })
            .ok()?;
    let less = less.map(|trial| trial.report().evaluations);
    Some(DigitLess { within: run.within, took: run.evaluations, less })
}

/// Of functions over a sweep: they are sampled once more.
#[must_use]
pub fn samples_with_a_digit_less(model: &Model<'_>, solution: &Solution) -> Option<DigitLess> {
    let found = &solution.statics;
    let wheels = found.flywheels.iter().map(|wheel| wheel.samples);
    let took = found.cycles.iter().map(|cycle| cycle.samples).chain(wheels).max()?;
    let within = model.plan.settings.samples;
    let (_, less) = sampled(model, found, Settings { samples: 10.0 * within, ..model.plan.settings });
    Some(DigitLess { within, took, less })
}
