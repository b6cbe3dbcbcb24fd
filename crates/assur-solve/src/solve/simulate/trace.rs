//! What a finer run takes over from the run before: where its steps end, and what is much for each work.
//!
//! It goes in steps of half their length. Then its error is that of the coarser run over two to the power of the order, where a
//! finer tolerance alone may happen to do better or worse.

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

/// What a run leaves to a finer one.
#[derive(Clone, Debug, Default)]
pub(super) struct Trace {
    /// Where steps begin and end, s, in order, and whether something ended them there.
    ends: Vec<(f64, bool)>,
    /// Steps that something had ended.
    ended: usize,
    /// The greatest magnitude of each work, J.
    pub works: Vec<f64>,
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
        Self { works: (0..count).map(greatest).collect(), ..self }
    }

    /// The length of a step from an instant, s, that is half of the one here; `next` is the place of its end, which goes on.
    pub fn half(&self, next: &mut usize, t: f64) -> Option<f64> {
        while self.ends.get(*next).is_some_and(|end| end.0 <= t) {
            *next += 1;
        }
        let half = |end: usize| Some(0.5 * (self.ends.get(end)?.0 - self.ends.get(end.checked_sub(1)?)?.0));
        let (own, (end, is_ended)) = (half(*next)?, self.ends[*next]);
        if own <= LEAST * end.abs() {
            return None;
        }
        let rest = end - t;
        if rest > (1.0 + REST) * own {
            return Some(own);
        }
        // events of both runs differ a little: nothing is left for a step of its own
        let beyond = if rest < REST * own { half(*next + 1).unwrap_or(0.0) } else { 0.0 };
        Some(if is_ended { FURTHER * (rest + beyond) } else { rest + beyond })
    }
}
