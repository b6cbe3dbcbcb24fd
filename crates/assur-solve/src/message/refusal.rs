//! The sentence about what is refused before any position is looked at.

use super::error::SolveError;
use super::format::label;
use super::open_places::{friction_without_place, no_place, no_position};
use super::speeds::{empty_range, needs_speed};
use crate::model::PairId;
use crate::position::Model;
use crate::solve::Refusal;
use miette::LabeledSpan;

/// What cannot be answered at any position.
pub(super) fn refused(model: &Model<'_>, refusal: &Refusal) -> SolveError {
    let mechanism = model.mechanism;
    let at = |pairs: &[PairId], text: &str| -> Vec<LabeledSpan> {
        pairs.iter().map(|id| label(text, mechanism.pair(*id).span)).collect()
    };
    let unsupported = |what: &str, labels| SolveError::NotSupportedYet { what: what.to_owned(), labels };
    let not_yet = |what: &str, pairs: &[PairId]| unsupported(what, at(pairs, "not supported yet"));
    match refusal {
        Refusal::Unsupported { what, places } => {
            unsupported(what, places.iter().map(|place| label("not supported yet", *place)).collect())
        }
        Refusal::CamFollower(pair) => {
            not_yet("a cam that neither moves its follower alone nor is turned by it alone", &[*pair])
        }
        Refusal::CamForces(pair) => {
            not_yet("forces through the contact of a cam in this direction", &[*pair])
        }
        Refusal::FrictionWithoutPlace(pairs) => friction_without_place(mechanism, pairs),
        Refusal::GenevaWheel(pair) => not_yet("a Geneva wheel that its crank does not move alone", &[*pair]),
        Refusal::GenevaForces(pair) => {
            not_yet("a Geneva wheel whose crank is balanced through the wheel", &[*pair])
        }
        Refusal::EmptyRange { drive, at } => empty_range(mechanism, *drive, *at),
        Refusal::NeedsSpeed { drive, level, places } => needs_speed(mechanism, *drive, (*level, places)),
        Refusal::FreeRotation { roller, places } => SolveError::FreeRotation {
            name: mechanism.link(*roller).name.clone(),
            labels: places.iter().map(|place| label("depends on its rotation", *place)).collect(),
        },
        Refusal::NoPosition { drive, what } => no_position(model, *drive, *what),
        Refusal::NoPlace { pair, place } => no_place(mechanism, *pair, *place),
        Refusal::OpenCouple(pairs) => {
            let names: Vec<String> =
                pairs.iter().map(|id| format!("`{}`", mechanism.pair(*id).name)).collect();
            SolveError::OpenCouple {
                pairs: names.join(" and "),
                chain: if pairs.len() == 1 { "it closes" } else { "they close" },
                labels: at(pairs, "not determined"),
            }
        }
    }
}
