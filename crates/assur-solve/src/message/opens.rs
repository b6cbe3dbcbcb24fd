//! Sentences about a motion that ends since a pair does not take the forces there.

use super::format::{four, with_unit};
use super::simulate_error::SimulateError;
use crate::model::{Bond, Grip, PairId, PairKind, Transmission};
use crate::position::Model;
use crate::units::Dimension;

/// From an instant on a pair does no more what it has done.
pub(super) fn opens(model: &Model<'_>, (pair, bond): (PairId, Bond), time: String) -> SimulateError {
    let pair = model.mechanism.pair(pair);
    let name = &pair.name;
    let (what, text, help) = match (&pair.kind, bond) {
        (PairKind::Contact { second, .. }, _) => {
            let link = &model.mechanism.link(second.link).name;
            (
                format!("contact `{name}` would have to pull from {time} on"),
                "opens here",
                format!(
                    "end the motion there with `until normal({name}, {link}) < 0 N`, or press the profiles together by a spring or a load"
                ),
            )
        }
        (PairKind::Transmission(t), Bond::Drives) => driven_backwards(t, name, &time),
        (PairKind::Transmission(t), Bond::Grips) => grips_no_more(model, t, name, &time),
        _ => (
            format!("rope `{name}` would have to push from {time} on"),
            "slack here",
            format!(
                "end the motion there with `until tension({name}) < 0 N`, or let a load keep the rope tight"
            ),
        ),
    };
    SimulateError::Opens { what, text, help, span: pair.span }
}

fn driven_backwards(t: &Transmission, name: &str, time: &str) -> (String, &'static str, String) {
    let kept = t.laws.iter().filter_map(|law| law.efficiency).map(|[there, _]| there);
    let kept = four(kept.fold(1.0, f64::min));
    let first = &t.ends[0];
    (
        format!(
            "power would run backwards through belt `{name}` from {time} on: its slip is of the speed that `{first}` gives"
        ),
        "the first wheel must drive",
        format!(
            "write `efficiency {kept}` in place of `slip`: then power may run either way; or end the motion before"
        ),
    )
}

fn grips_no_more(
    model: &Model<'_>,
    t: &Transmission,
    name: &str,
    time: &str,
) -> (String, &'static str, String) {
    let (dimension, transmitted, firmer) = match t.grip {
        Some(Grip::Clutch(_)) => {
            let shaft = &model.mechanism.link(t.links[0]).name;
            (Dimension::TORQUE, format!("abs(moment({name}, {shaft}))"), "press its faces harder")
        }
        _ => {
            let firmer = "raise the pretension, the friction or the angle of contact";
            (Dimension::FORCE, format!("tangential_force({name})"), firmer)
        }
    };
    let capacity = with_unit(model, t.grip.map_or(f64::NAN, Grip::capacity), dimension);
    (
        format!(
            "{} `{name}` would slip from {time} on: its friction can transmit {capacity} at most",
            t.kind.word()
        ),
        "slips here",
        format!("{firmer}, or end the motion there with `until {transmitted} > capacity({name})`"),
    )
}
