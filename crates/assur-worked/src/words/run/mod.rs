//! Sentences about a motion under loads.

mod chinese;
mod english;
mod russian;

use super::{Language, Sentence};

/// A message; its parts are numbered in the sentences of the languages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RunMessage {
    /// Heading: a motion under loads.
    Run,
    EnergyHere,
    /// Reduced mass and load.
    Reduced,
    /// The equation of motion.
    ReducedMotion,
    EnergyOfRun,
    EventsOfRun,
    Event,
    Instants,
    /// How a run was integrated; 0: method, 1: steps, 2: evaluations, 3: error.
    RunMethod,
    /// The method of energy, as a name.
    ByEnergy,
    /// Reduced masses of several free coordinates.
    ReducedSeveral,
    /// The kinetic energy by these.
    EnergyReduced,
}

impl Sentence for RunMessage {
    fn template(self, language: Language) -> &'static str {
        match language {
            Language::English => english::template(self),
            Language::Chinese => chinese::template(self),
            Language::Russian => russian::template(self),
        }
    }
}
