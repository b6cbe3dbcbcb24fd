//! Motion under given loads.

use super::expr::compare;
use super::walk::{P, Parts, span};
use crate::document::{
    Balanced, Event, Passing, PassingSense, Simulate, Sought, Start, Steady, Stop, TimeCourse, Until,
};
use crate::words::Rule;
use assur_text::diagnostic::Problems;
use assur_text::source::Spanned;
use std::collections::BTreeSet;

impl Lower<'_> {
    pub(super) fn start(&mut self, pair: P<'_>) -> Option<Start> {
        let mut parts = Parts::of(pair);
        parts.any()?;
        let target = self.path(parts.any()?)?;
        let value = match parts.take(Rule::sensed) {
            Some(value) => Some(self.sensed(value)?),
            None => None,
        };
        Some(Start { target, value, rate: self.sensed_behind(&mut parts, Rule::rate)? })
    }

    pub(super) fn equilibrium(&mut self, pair: P<'_>) -> Option<Vec<Balanced>> {
        let mut parts = Parts::of(pair);
        parts.any()?;
        let mut all = Vec::new();
        while let Some(one) = parts.any() {
            let mut parts = Parts::of(one);
            let target = self.path(parts.any()?)?;
            let sought = if parts.word(Rule::w_near) {
                Sought::Near(self.expr(parts.any()?)?)
            } else if parts.word(Rule::w_in) {
                let from = self.expr(parts.any()?)?;
                let mut last = Parts::of(parts.any()?);
                Sought::Between(from, self.expr(last.any()?)?)
            } else {
                Sought::Anywhere
            };
            all.push(Balanced { target, sought, rate: self.sensed_behind(&mut parts, Rule::rate)? });
        }
        Some(all)
    }

    pub(super) fn simulate(&mut self, pair: P<'_>) -> Option<Simulate> {
        let mut parts = Parts::of(pair);
        parts.any()?;
        let course = self.time_course(&mut parts)?;
        let steps = match parts.take(Rule::in_steps) {
            Some(steps) => {
                let mut inner = Parts::of(steps);
                inner.any()?;
                Some(self.expr(inner.any()?)?)
            }
            None => None,
        };
        Some(Simulate { course, steps, within: self.within(&mut parts)? })
    }

    fn time_course(&mut self, parts: &mut Parts<'_>) -> Option<TimeCourse> {
        if let Some(steady) = parts.take(Rule::steady) {
            return Some(TimeCourse::Steady(self.steady(steady)?));
        }
        let first = self.expr(parts.any()?)?;
        let Some(last) = parts.take(Rule::last) else {
            return Some(TimeCourse::Between { from: None, to: first });
        };
        let to = self.expr(Parts::of(last).any()?)?;
        Some(TimeCourse::Between { from: Some(first), to })
    }

    fn steady(&mut self, pair: P<'_>) -> Option<Steady> {
        let span = span(&pair);
        let mut parts = Parts::of(pair);
        parts.any()?;
        let count = parts.take(Rule::count);
        let cycle = parts.word(Rule::w_cycle);
        if !cycle {
            parts.any()?;
        }
        // more digits than a number has are more turns than are followed
        let turns = count.map_or(1, |count| count.as_str().parse().unwrap_or(usize::MAX));
        parts.word(Rule::w_of);
        let of = self.path(parts.any()?)?;
        Some(Steady { span, turns: (!cycle).then_some(turns), of })
    }

    pub(super) fn event(&mut self, pair: P<'_>) -> Option<Event> {
        let mut parts = Parts::of(pair);
        parts.any()?;
        Some(Event { name: parts.name()?, passing: self.passing(parts.any()?)? })
    }

    pub(super) fn until(&mut self, pair: P<'_>) -> Option<Until> {
        let mut parts = Parts::of(pair);
        parts.any()?;
        Some(Until { passing: self.passing(parts.any()?)? })
    }

    pub(super) fn stop(&mut self, pair: P<'_>) -> Option<Stop> {
        let mut parts = Parts::of(pair);
        parts.any()?;
        let pair = parts.name()?;
        let op = compare(&parts.any()?)?;
        let bound = self.expr(parts.any()?)?;
        Some(Stop { pair, op, bound, properties: self.properties(&mut parts) })
    }

    fn passing(&mut self, pair: P<'_>) -> Option<Passing> {
        let mut parts = Parts::of(pair);
        let what = self.expr(parts.any()?)?;
        let mut way = passage(&mut parts);
        let value = match parts.any() {
            Some(value) => Some(self.expr(value)?),
            None => None,
        };
        way = way.or_else(|| passage(&mut parts));
        Some(Passing { what, value, way })
    }
}

fn passage(parts: &mut Parts<'_>) -> Option<Spanned<PassingSense>> {
    let rising = parts.take(Rule::w_rising).map(|p| Spanned::new(PassingSense::Rising, span(&p)));
    rising.or_else(|| parts.take(Rule::w_falling).map(|p| Spanned::new(PassingSense::Falling, span(&p))))
}

// The state of the walk.

/// The state of the walk.
pub struct Lower<'a> {
    pub text: &'a str,
    /// The text that the grammar read, of the same length.
    pub read: &'a str,
    pub problems: Problems,
    /// Words of the language that were meant as names, and reported.
    pub reserved: BTreeSet<String>,
    /// Closing braces after a statement that stands within them, which is reported.
    pub closing: BTreeSet<usize>,
}

impl<'a> Lower<'a> {
    /// The state at the start.
    pub fn new(text: &'a str, read: &'a str) -> Self {
        Self { text, read, problems: Problems::new(), reserved: BTreeSet::new(), closing: BTreeSet::new() }
    }
}
