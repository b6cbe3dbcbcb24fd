//! Pins whose ends have two letters, though a point of one of their letters is free on the other link: most often a wrong end.

use super::order::Named;
use super::roller::label;
use super::uses::Uses;
use super::words::{line, statement};
use crate::model::{LinkId, Mechanism, Pair, PairId, PairKind, Pin, Point};
use assur_text::diagnostic::Diagnosis;

/// A warning for each such pin.
pub(super) fn wrong_ends(mechanism: &Mechanism) -> Vec<Diagnosis> {
    let (uses, named) = (Uses::of(mechanism, None), Named::of(mechanism));
    let is_free =
        |link: LinkId, point: &Point| uses.count(link, &point.name) == 0 && !named.has_point(link, point.at);
    let pairs = mechanism.pairs.iter().enumerate();
    pairs.filter_map(|(i, pair)| wrong_end(mechanism, PairId::at(i), pair, &is_free)).collect()
}

fn wrong_end(
    mechanism: &Mechanism,
    id: PairId,
    pair: &Pair,
    is_free: &impl Fn(LinkId, &Point) -> bool,
) -> Option<Diagnosis> {
    let PairKind::Revolute(pins) = &pair.kind else { return None };
    let (wrong, other, point) = pins.iter().enumerate().find_map(|(i, pin)| {
        let others = pins.iter().filter(|other| other.name != pin.name);
        others.into_iter().find_map(|other| {
            let mut points = mechanism.link(pin.link).points.iter();
            let point = points.find(|point| point.name == other.name && is_free(pin.link, point))?;
            Some((i, other, point))
        })
    })?;
    let spelled = |link: LinkId, name: &str| format!("`{}.{name}`", mechanism.link(link).name);
    let own = &pins[wrong];
    let mut meant = pins.clone();
    meant[wrong] = Pin { link: own.link, name: point.name.clone(), at: point.at };
    let line = line(mechanism, &pair.name, &PairKind::Revolute(meant))?;
    let free = spelled(own.link, &point.name);
    Some(
        Diagnosis::warning(
            "mech::determinacy::two_letters",
            format!(
                "{} joins {} and {}, and nothing uses {free}",
                statement(mechanism, id),
                spelled(own.link, &own.name),
                spelled(other.link, &other.name)
            ),
        )
        .labels([label("two letters", pair.span)])
        .help(format!("if {free} is meant, write `{line}`")),
    )
}
