//! What is determined where pairs share by friction what one of them could hold: the state has two ways to share it, and what both
//! have in common no other way changes.

use super::PoseAnswers;
use super::pose_answers::NAN_VECTOR;
use super::sizes::Sizes;
use crate::model::{PairId, Query, Value};
use crate::position::Action;

/// What two ways have in common differs by less than this part of its size.
const COMMON: f64 = 1e-8;

impl PoseAnswers<'_> {
    /// The position with one way to share and with another, if there are several.
    pub(super) fn both(&self) -> Option<[Self; 2]> {
        let other = self.other?;
        Some([self.state, other].map(|state| Self { state, other: None, ..*self }))
    }

    /// The position with the way to share that its state has.
    pub(super) const fn first_way(&self) -> Self {
        Self { other: None, ..*self }
    }

    /// The answer to a question; NaN where it is not determined, or there is none.
    #[must_use]
    pub fn query(&self, query: &Query) -> Value {
        let Some(both) = self.both() else { return self.queried(query) };
        match both[0].queried(query) {
            Value::Scalar(_) if differ(&both, query) => Value::Scalar(f64::NAN),
            Value::Vector(_) if differ(&both, query) => Value::Vector(NAN_VECTOR),
            same => same,
        }
    }

    /// Whether the reaction of a pair depends on how others share what friction holds.
    #[must_use]
    pub fn shares_friction(&self, pair: PairId) -> bool {
        let Some(both) = self.both() else { return false };
        self.mechanism.pair(pair).kind.links().into_iter().any(|link| {
            differ(&both, &Query::Reaction(pair, link)) || differ(&both, &Query::Moment(pair, link))
        })
    }

    /// Whether one of the forces on a body does.
    #[must_use]
    pub fn shares_friction_on(&self, body: usize) -> bool {
        let Some(both) = self.both() else { return false };
        let (sizes, [here, there]) = (sizes(&both), both.map(|view| view.actions(&[body])));
        let differs = |(a, b): (&Action, &Action)| {
            let apart = (a.force - b.force).norm();
            common([0.0, apart], sizes.all_force()).is_nan()
                || common([a.couple, b.couple], sizes.all_moment()).is_nan()
        };
        here.len() != there.len() || here.iter().zip(&there).any(differs)
    }
}

/// The greatest of what the numbers of both are made of.
pub(super) fn sizes(both: &[PoseAnswers<'_>; 2]) -> Sizes {
    let mut sizes = Sizes::new(both[0].mechanism.quantities.len());
    both.iter().for_each(|view| sizes.update_max(view));
    sizes
}

/// Whether two ways to share have other answers to a question.
fn differ(both: &[PoseAnswers<'_>; 2], query: &Query) -> bool {
    let numbers = match both.each_ref().map(|view| view.queried(query)) {
        [here, there] if here == there || !(here.is_defined() || there.is_defined()) => return false,
        [Value::Scalar(here), Value::Scalar(there)] => [here, there],
        [Value::Vector(here), Value::Vector(there)] => [0.0, (here - there).norm()],
        _ => return false,
    };
    let sizes = sizes(both);
    let size = both.iter().map(|view| view.query_size(query, &sizes)).fold(0.0, f64::max);
    common(numbers, size).is_nan()
}

/// What two ways have in common of a number of this size; NaN where they differ, or one was not found.
pub(super) fn common([here, there]: [f64; 2], size: f64) -> f64 {
    if (here - there).abs() <= COMMON * size { here } else { f64::NAN }
}
