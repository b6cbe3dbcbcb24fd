//! A truss whose links are written in the coordinates of the ground, all but one point: that is a slip of the pen, and not one of many
//! assemblies.

use super::format::length;
use crate::math::Vec2;
use crate::model::{LinkId, PairKind, Pin};
use crate::position::{Model, SAME, extent};
use assur_text::diagnostic::Diagnosis;

/// Pins whose ends have one place, before another one is odd.
const FEWEST: usize = 3;

/// The one point that is not where the others of its pin are.
pub(super) fn odd_point(model: &Model<'_>) -> Option<Diagnosis> {
    let mechanism = model.mechanism;
    let near = |a: Vec2, b: Vec2| (a - b).norm() <= SAME * extent(model);
    let pins = mechanism.pairs.iter().filter_map(|pair| match &pair.kind {
        PairKind::Revolute(pins) if pins.len() > 1 => Some(pins.as_slice()),
        _ => None,
    });
    let (whole, split): (Vec<&[Pin]>, Vec<&[Pin]>) =
        pins.partition(|pins| pins.iter().all(|pin| near(pin.at, pins[0].at)));
    let [pins] = split.as_slice() else { return None };
    if !mechanism.drives.is_empty() || whole.len() < FEWEST {
        return None;
    }
    let rest = |odd: usize| pins.iter().enumerate().filter(move |(i, _)| *i != odd).map(|(_, pin)| pin);
    let is_odd = |i: usize| {
        let first = rest(i).next();
        first.is_some_and(|first| rest(i).all(|pin| near(pin.at, first.at)))
    };
    // of two ends either may be wrong: the ground is rather right, and what is written first
    let odd = (0..pins.len()).rev().find(|i| pins[*i].link != LinkId::GROUND && is_odd(*i))?;
    let (pin, right) = (&pins[odd], rest(odd).next()?);
    let at = |at: Vec2| format!("({}, {})", length(model, at.x), length(model, at.y));
    let link = mechanism.link(pin.link);
    let others: Vec<String> =
        rest(odd).map(|pin| format!("`{}.{}`", mechanism.link(pin.link).name, pin.name)).collect();
    let verb = if others.len() == 1 { "is" } else { "are" };
    Some(
        Diagnosis::error(
            "mech::assembly::odd_point",
            format!(
                "`{}.{}` is {} from where {} {verb}: all other points of the truss have one place for each pin",
                link.name,
                pin.name,
                length(model, (pin.at - right.at).norm()),
                others.join(" and "),
            ),
        )
        .label(link.span, format!("has {} at {}", pin.name, at(pin.at)))
        .label(mechanism.link(right.link).span, format!("has {} at {}", right.name, at(right.at)))
        .help(format!("write `{} {}` in `{}`", pin.name, at(right.at), link.name)),
    )
}
