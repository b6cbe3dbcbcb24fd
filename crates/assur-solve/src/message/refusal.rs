//! The sentence about what is refused before any position is looked at.

use super::format::label;
use super::open_places::{friction_without_place, no_place, no_position};
use super::speeds::{empty_range, needs_speed};
use crate::model::{Drive, DriveTarget, LinkId, Mechanism, PairId};
use crate::position::Model;
use crate::solve::Refusal;
use assur_text::diagnostic::Diagnosis;
use miette::LabeledSpan;

/// What cannot be answered at any position.
pub(super) fn refused(model: &Model<'_>, refusal: &Refusal) -> Diagnosis {
    let mechanism = model.mechanism;
    let at = |pairs: &[PairId], text: &str| -> Vec<LabeledSpan> {
        pairs.iter().map(|id| label(text, mechanism.pair(*id).span)).collect()
    };
    let unsupported = |what: &str, labels| not_supported_yet(what, labels);
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
        Refusal::FreeRotation { roller, places } => Diagnosis::error(
            "mech::request::free_rotation",
            format!("`{}` turns freely: its rotation is not determined", mechanism.link(*roller).name),
        )
        .labels(places.iter().map(|place| label("depends on its rotation", *place)))
        .help(of_free_rotation(mechanism, *roller)),
        Refusal::NoPosition { drive, what } => no_position(model, *drive, *what),
        Refusal::NoPlace { pair, place } => no_place(mechanism, *pair, *place),
        Refusal::OpenCouple(pairs) => {
            let names: Vec<String> =
                pairs.iter().map(|id| format!("`{}`", mechanism.pair(*id).name)).collect();
            Diagnosis::error(
                "mech::friction::open_couple",
                format!(
                    "the friction in {} depends on how the load is shared between two \
                     contacts, which is statically indeterminate: {} a chain of prismatic \
                     pairs",
                    names.join(" and "),
                    if pairs.len() == 1 { "it closes" } else { "they close" }
                ),
            )
            .labels(at(pairs, "not determined"))
            .help(
                "leave `contacts` out, so that friction depends on the normal force, or \
                 make one of the pairs a revolute pair",
            )
        }
    }
}

fn of_free_rotation(mechanism: &Mechanism, link: LinkId) -> String {
    let is_outer = |drive: &&Drive| matches!(drive.target, DriveTarget::Point(on, _) if on == link);
    if let Some(drive) = mechanism.drives.iter().find(is_outer) {
        let name = &mechanism.link(link).name;
        return format!("give its angle too: `drive {name} = 0 deg`, or ask for `{}` alone", drive.name);
    }
    let stands_freely = |drive: &Drive| matches!(drive.target, DriveTarget::Place(on, ..) if on == link);
    if let Some(drive) = mechanism.drives.iter().find(|drive| stands_freely(drive)) {
        let (name, point) = (&mechanism.link(link).name, drive.written_name());
        return format!(
            "ask for `{point}`; or give its angle too, as in `start {name} = 0 deg`, and its `inertia`"
        );
    }
    "ask for points of its axis, or of the link that carries it; or give the circle to that link, so that it slides instead \
     of rolling"
        .to_owned()
}

/// A construct that cannot be solved yet.
pub fn not_supported_yet(what: &str, labels: Vec<LabeledSpan>) -> Diagnosis {
    Diagnosis::error("mech::request::not_supported_yet", format!("{what} cannot be solved yet"))
        .labels(labels)
        .help(
            "remove it to solve the rest of the file; `assur check` shows the \
             structure of the whole file",
        )
}
