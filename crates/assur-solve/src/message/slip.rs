//! The sentences about belts and clutches that slip.

use super::format::{and_at, place, with_unit};
use crate::model::{FrictionLimit, PairId, PairKind, Transmission, TransmissionKind};
use crate::position::Model;
use crate::solve::Pull;
use crate::units::Dimension;
use assur_text::diagnostic::Diagnosis;

fn transmission<'a>(model: &Model<'a>, pair: PairId) -> Option<&'a Transmission> {
    match &model.mechanism.pair(pair).kind {
        PairKind::Transmission(t) => Some(t),
        _ => None,
    }
}

/// One that must transmit more than it can.
pub(super) fn slips(model: &Model<'_>, pull: &Pull) -> Option<Diagnosis> {
    let pair = model.mechanism.pair(pull.pair);
    let transmission = transmission(model, pull.pair)?;
    let grip = transmission.grip?;
    let (capacity, firmer) = capacity(model, grip);
    let error = Diagnosis::warning(
        "mech::train::slips",
        format!(
            "{} `{}` slips{}{}: it must transmit {}, and its friction {capacity} at most",
            transmission.kind.word(),
            pair.name,
            place(model, &pull.pose),
            and_at(pull.poses - 1),
            with_unit(model, -pull.least, dimension(grip))
        ),
    )
    .label(pair.span, "slips")
    .help(format!("{firmer}, or lower the load"));
    Some(error)
}

const fn dimension(grip: FrictionLimit) -> Dimension {
    match grip {
        FrictionLimit::Belt { .. } => Dimension::FORCE,
        FrictionLimit::Clutch(_) => Dimension::TORQUE,
    }
}

/// What a grip can transmit at most, and what lets it transmit more.
pub(super) fn capacity(model: &Model<'_>, grip: FrictionLimit) -> (String, &'static str) {
    let firmer = match grip {
        FrictionLimit::Belt { .. } => "raise the pretension, the friction or the angle of contact",
        FrictionLimit::Clutch(_) => "press its faces harder",
    };
    (with_unit(model, grip.capacity(), dimension(grip)), firmer)
}

/// A belt with a slip through which the power runs backwards.
pub(super) fn slip_backwards(model: &Model<'_>, pair: PairId, pose: String) -> Diagnosis {
    let declared = model.mechanism.pair(pair);
    let ends = transmission(model, pair).map_or(&[][..], |t| &t.ends);
    let (first, second) =
        (ends.first().cloned().unwrap_or_default(), ends.last().cloned().unwrap_or_default());
    let (word, name) = (TransmissionKind::Belt.word(), declared.name.clone());
    let help = format!(
        "write the wheel that drives first, `{word} {name}: {second} - {first}`, or check the sign of the load: here it drives"
    );
    Diagnosis::error(
        "mech::train::slip_backwards",
        format!(
            "power runs backwards through belt `{name}`{pose}: its slip is of the \
             speed that `{first}` gives"
        ),
    )
    .label(declared.span, "the first wheel must drive")
    .help(help)
}
