//! Positions at which the laws of friction or of losses have several solutions, or none.

use super::consistent_error::ConsistentError;
use super::error::{SolveError, label};
use super::format::place;
use crate::model::PairId;
use crate::position::{Consistent, Model, Searched, Wanted};
use miette::LabeledSpan;

/// The first position with several solutions, and how many more there are.
#[derive(Debug, Default)]
pub(crate) struct ConsistentNotes {
    several: Option<(ConsistentError, usize)>,
    /// What searches have taken at the positions so far.
    pub searched: Searched,
}

impl ConsistentNotes {
    /// Notes what the forces of a position came to; an error where they are not found.
    pub fn look(
        &mut self,
        model: &Model<'_>,
        consistent: Consistent,
        pose: &Wanted,
    ) -> Result<(), SolveError> {
        let what = if model.plan.effects.friction { "friction" } else { "losses" };
        let here = || (place(model, pose), labels(model, what));
        match consistent {
            Consistent::Several { count, followed } => {
                let (pose, labels) = here();
                let reported = if followed {
                    format!("the reported one is reached continuously from that without {what}")
                } else {
                    let taken = if model.plan.effects.friction {
                        "the one that loses least power is"
                    } else {
                        "that with the least forces is"
                    };
                    format!("none is reached continuously from that without {what}; {taken} reported")
                };
                let more = String::new();
                let first = ConsistentError::Several { count, what, pose, more, reported, labels };
                match &mut self.several {
                    Some((_, more)) => *more += 1,
                    None => self.several = Some((first, 0)),
                }
                Ok(())
            }
            Consistent::Undecided => {
                let (pose, labels) = here();
                Err(ConsistentError::Undecided { what, pose, labels }.into())
            }
            Consistent::None if !model.plan.effects.friction => {
                let (pose, labels) = here();
                Err(ConsistentError::Blocked { pose, help: blocked(model), labels }.into())
            }
            Consistent::None | Consistent::One => Ok(()),
        }
    }

    pub fn into_warning(self) -> Option<SolveError> {
        let (mut warning, count) = self.several?;
        if let ConsistentError::Several { more, .. } = &mut warning {
            *more = match count {
                0 => String::new(),
                1 => ", and at 1 other pose".to_owned(),
                n => format!(", and at {n} other poses"),
            };
        }
        Some(warning.into())
    }
}

/// The pairs concerned, each once.
fn labels(model: &Model<'_>, what: &str) -> Vec<LabeledSpan> {
    let mut pairs: Vec<PairId> = Vec::new();
    let rubs = model.plan.friction.iter().map(|e| e.pair);
    let loses = model.plan.laws.iter().filter(|l| l.efficiency.is_some()).map(|l| l.pair);
    for pair in rubs.chain(loses) {
        if !pairs.contains(&pair) {
            pairs.push(pair);
        }
    }
    pairs.iter().map(|p| label(format!("{what} here"), model.mechanism.pair(*p).span)).collect()
}

/// Transmissions that let nothing through backwards, and what to change.
fn blocked(model: &Model<'_>) -> String {
    let one_way = model.plan.laws.iter().filter(|l| l.efficiency.is_some_and(|[_, back]| back <= 0.0));
    let mut names: Vec<String> =
        one_way.map(|l| format!("`{}`", model.mechanism.pair(l.pair).name)).collect();
    names.dedup();
    if names.is_empty() {
        return "raise the efficiencies: more power circulates than the losses leave".to_owned();
    }
    format!(
        "raise the efficiency of {} above 0.5, or put the known load on its other side: driven backwards nothing \
         comes out of it",
        names.join(", ")
    )
}
