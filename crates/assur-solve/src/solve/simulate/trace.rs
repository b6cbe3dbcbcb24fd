//! What a finer run takes over from the run before: where its steps end, and what is much for each work.
//!
//! It goes in steps of half their length, or of two thirds where that is enough. Then its error is that of the coarser run times this
//! part to the power of the order, where a finer tolerance alone may happen to do better or worse.

use super::records::Records;

/// What is left of a step is added to the next one where it is less than this part of half of it.
const REST: f64 = 0.5;
/// A step to where something ended another one goes a little further: it may do so later.
const FURTHER: f64 = 1.01;
/// A step that something ended counts to the one before where it is less than this part of it.
const ENDED: f64 = 0.01;

/// Halves of steps that are as short as this part of their instant would be lost in rounding.
const LEAST: f64 = 100.0 * f64::EPSILON;
/// Room for so many steps is taken at the begin.
const ROOM: usize = 2000;

/// How long the steps of a finer run are beside those of the run before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Fraction {
    Half,
    TwoThirds,
}

impl Fraction {
    const fn of_length(self) -> f64 {
        match self {
            Self::Half => 0.5,
            Self::TwoThirds => 2.0 / 3.0,
        }
    }

    /// What they leave of the error by a method of order 8.
    pub const fn of_error(self) -> f64 {
        match self {
            Self::Half => 1.0 / 256.0,
            Self::TwoThirds => 256.0 / 6561.0,
        }
    }
}

/// What a run leaves to a finer one.
#[derive(Clone, Debug, Default)]
pub(super) struct Trace {
    /// Where steps begin and end, s, in order, and whether something ended them there.
    ends: Vec<(f64, bool)>,
    /// Steps that something had ended.
    ended: usize,
    /// The greatest magnitude of each work, and what is zero of it but for rounding, J.
    pub works: Vec<(f64, f64)>,
    /// When an implicit method took over, s.
    pub stiff: Option<f64>,
}

impl Trace {
    /// Of a run that begins.
    pub fn new() -> Self {
        Self { ends: Vec::with_capacity(ROOM), ..Self::default() }
    }

    /// A step ends here, or the first one begins; with the number of steps that something has ended.
    pub fn note(&mut self, t: f64, ended: usize) {
        let is_ended = ended > std::mem::replace(&mut self.ended, ended);
        match self.ends[..] {
            [.., (before, _), (last, _)] if is_ended && t - last < ENDED * (last - before) => {
                let count = self.ends.len();
                self.ends[count - 1] = (t, true);
            }
            [.., (last, _)] if t <= last => {}
            _ => self.ends.push((t, is_ended)),
        }
    }

    /// With the works at the instants that are kept.
    pub fn with_works(self, records: &Records) -> Self {
        let count = if records.count > 0 { records.works(0).len() } else { 0 };
        let greatest = |id: usize| (0..records.count).map(|i| records.works(i)[id].abs()).fold(0.0, f64::max);
        let works = (0..count).map(|id| (greatest(id), records.nothing[id]));
        Self { works: works.collect(), ..self }
    }

    /// The length of a step from an instant, s, that is this part of the one here; `next` is the place of its end, which goes on.
    pub fn part(&self, part: Fraction, next: &mut usize, t: f64) -> Option<f64> {
        match part {
            Fraction::Half => self.half(next, t),
            Fraction::TwoThirds => self.ahead(part.of_length(), next, t),
        }
    }

    /// The same where the parts do not end with the step: what is left of it, and the rest of the part of the one after it.
    fn ahead(&self, part: f64, next: &mut usize, t: f64) -> Option<f64> {
        let (own, end, is_ended) = self.here(next, t)?;
        let (rest, left) = (end - t, (end - t) / own);
        let after = self.step(*next + 1).unwrap_or(0.0);
        Some(match left / part {
            enough if enough >= 1.0 + REST || (enough >= 1.0 && !is_ended) => part * own,
            // events of both runs differ a little: nothing is left for a step of its own
            little if is_ended && little < REST => FURTHER * (rest + part * after),
            _ if is_ended => FURTHER * rest,
            _ => rest + (part - left) * after,
        })
    }

    /// The length of the step here, its end, and whether something ended it there.
    fn here(&self, next: &mut usize, t: f64) -> Option<(f64, f64, bool)> {
        while self.ends.get(*next).is_some_and(|end| end.0 <= t) {
            *next += 1;
        }
        let (own, (end, is_ended)) = (self.step(*next)?, self.ends[*next]);
        (own > LEAST * end.abs()).then_some((own, end, is_ended))
    }

    /// The length of a step, by the place of its end.
    fn step(&self, end: usize) -> Option<f64> {
        Some(self.ends.get(end)?.0 - self.ends.get(end.checked_sub(1)?)?.0)
    }

    /// The length of a step that is half of the one here.
    fn half(&self, next: &mut usize, t: f64) -> Option<f64> {
        let (own, end, is_ended) = self.here(next, t)?;
        let own = 0.5 * own;
        let rest = end - t;
        if rest > (1.0 + REST) * own {
            return Some(own);
        }
        // events of both runs differ a little: nothing is left for a step of its own
        let beyond =
            if rest < REST * own { self.step(*next + 1).map_or(0.0, |after| 0.5 * after) } else { 0.0 };
        Some(if is_ended { FURTHER * (rest + beyond) } else { rest + beyond })
    }
}
