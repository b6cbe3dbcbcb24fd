//! What needs no position: dead positions, strokes, functions over the sweep, flywheels.

use super::cycle_answers::{CycleAnswer, FlywheelAnswer};
use super::sizes::Sizes;
use crate::model::{Display, Mechanism, PairId, Situation};
use crate::units::Dimension;
use std::f64::consts::TAU;

/// Extremes of the pairs asked for.
#[derive(Clone, Debug, Default)]
pub struct WholeCycle {
    pub(crate) extremes: Vec<(PairId, Extremes)>,
    /// Values at which locking begins, by index into [`crate::model::Mechanism::criticals`].
    pub criticals: Vec<f64>,
    /// Functions over the sweep, by index into [`crate::model::Mechanism::cycles`].
    pub cycles: Vec<CycleAnswer>,
    /// Instants of the events of a motion under loads, s, or values of the swept drive, rad or m, by index into
    /// [`crate::model::Mechanism::events`].
    pub events: Vec<Vec<f64>>,
    /// The sweep of a file with events.
    pub swept: Option<Swept>,
    /// What such a motion is in, and from when to when, s.
    pub situations: Vec<(Situation, f64, Option<f64>)>,
    /// After what time a steady motion comes again, s, where one is asked for.
    pub period: Option<f64>,
    /// The greatest of what the results of a motion under loads are made of.
    pub(crate) sizes: Sizes,
    /// Flywheels, by index into [`crate::model::Mechanism::flywheels`].
    pub flywheels: Vec<FlywheelAnswer>,
    /// The same without friction, where the file asks for any.
    pub ideal_flywheels: Vec<FlywheelAnswer>,
}

/// A sweep in which events were looked for.
#[derive(Clone, Debug)]
pub struct Swept {
    /// The drive that goes through a range.
    pub drive: usize,
    /// Its first value, rad or m.
    pub from: f64,
    /// Its last: that of the end by `until`, if it comes to one.
    pub to: f64,
    /// Its speed, rad/s or m/s, where it is constant.
    pub speed: Option<f64>,
    /// How near every event comes to happening.
    pub nearest: Vec<Nearest>,
}

/// How near an event comes to happening in a sweep, with the value of the drive there, rad or m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Nearest {
    /// It would happen after the end that `until` makes.
    Later(f64),
    /// Its value is reached where that does not count.
    Reached(f64),
    /// The least magnitude of its number, SI; infinite where it has no value.
    Missing(f64, f64),
}

/// Extremes of one coordinate over a turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremes {
    /// The least coordinate, m or rad.
    pub least: f64,
    pub greatest: f64,
    /// Drive value of the least in [0, 2π), rad.
    pub at_least: f64,
    /// Drive value of the greatest in [0, 2π), rad.
    pub at_greatest: f64,
}

impl WholeCycle {
    pub const EMPTY: Self = Self {
        extremes: Vec::new(),
        criticals: Vec::new(),
        cycles: Vec::new(),
        events: Vec::new(),
        swept: None,
        situations: Vec::new(),
        period: None,
        sizes: Sizes::NONE,
        flywheels: Vec::new(),
        ideal_flywheels: Vec::new(),
    };

    fn of(&self, pair: PairId) -> Option<&Extremes> {
        self.extremes.iter().find(|(p, _)| *p == pair).map(|(_, e)| e)
    }

    /// The least coordinate of a pair.
    #[must_use]
    pub fn least(&self, pair: PairId) -> f64 {
        self.of(pair).map_or(f64::NAN, |e| e.least)
    }

    /// Greatest less least coordinate.
    #[must_use]
    pub fn stroke(&self, pair: PairId) -> f64 {
        self.of(pair).map_or(f64::NAN, |e| e.greatest - e.least)
    }

    /// Drive value of the least (1) or greatest (2) coordinate, in [0, 2π).
    #[must_use]
    pub fn dead(&self, pair: PairId, which: u8) -> f64 {
        self.of(pair).map_or(f64::NAN, |e| if which == 1 { e.at_least } else { e.at_greatest })
    }

    /// Value of a given at which locking begins; NaN where it does not.
    #[must_use]
    pub fn critical(&self, which: usize) -> f64 {
        self.criticals.get(which).copied().unwrap_or(f64::NAN)
    }

    /// The instant, s, at which an event happens, as [`WholeCycle::event`]; in a sweep counted from its first position.
    #[must_use]
    pub fn event_time(&self, event: usize, which: usize) -> f64 {
        let found = self.event(event, which);
        let passed = |swept: &Swept| (found - swept.from) / swept.speed.unwrap_or(f64::NAN);
        self.swept.as_ref().map_or(found, passed)
    }

    /// The instant, s, or the value of the drive, at which an event happens for the given time, counted from 1; NaN where it does not.
    #[must_use]
    pub fn event(&self, event: usize, which: usize) -> f64 {
        let times = self.events.get(event).and_then(|times| times.get(which.wrapping_sub(1)));
        times.copied().unwrap_or(f64::NAN)
    }

    /// How the places of events are printed.
    #[must_use]
    pub fn along(&self, mechanism: &Mechanism) -> Display {
        let drive = self.swept.as_ref().and_then(|swept| mechanism.drives.get(swept.drive));
        drive.map_or_else(
            || mechanism.display_of(Dimension::TIME),
            |drive| mechanism.drive_display(drive.target),
        )
    }

    /// Whether the motion is in a situation at an instant.
    #[must_use]
    pub fn is_in(&self, situation: Situation, time: f64) -> bool {
        let lasts = |(_, begin, end): &&(Situation, f64, Option<f64>)| {
            *begin <= time && end.is_none_or(|end| time < end)
        };
        self.situations.iter().filter(|(which, ..)| *which == situation).any(|found| lasts(&found))
    }

    /// How often an event happens.
    #[must_use]
    #[allow(clippy::cast_precision_loss)] // far below 2^52
    pub fn count(&self, event: usize) -> f64 {
        self.events.get(event).map_or(0.0, |times| times.len() as f64)
    }

    /// Value of a function over the sweep; NaN where it has none.
    #[must_use]
    pub fn cycle(&self, which: usize) -> f64 {
        self.cycles.get(which).map_or(f64::NAN, |c| c.value)
    }

    /// The longer way between the extremes over the shorter.
    #[must_use]
    pub fn time_ratio(&self, pair: PairId) -> f64 {
        self.of(pair).map_or(f64::NAN, |e| {
            let way = (e.at_greatest - e.at_least).abs();
            let other = TAU - way;
            way.max(other) / way.min(other)
        })
    }
}
