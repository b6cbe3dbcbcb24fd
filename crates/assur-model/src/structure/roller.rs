//! Links that turn freely: what would turn them is balanced by nothing.

use super::words::{label, listed};
use crate::math::Vec2;
use crate::model::{Drive, Link, LinkId, LoadKind, Mechanism, Pair, PairKind, Place};
use crate::source::Span;
use assur_text::diagnostic::Diagnosis;

/// A place this close to the hinge, as a part of both distances, is on it.
const ROUNDING: f64 = 1e-9;

/// One defect per roller that something would turn.
pub(super) fn turned(mechanism: &Mechanism, rollers: &[LinkId]) -> Vec<Diagnosis> {
    rollers.iter().filter_map(|roller| describe(mechanism, *roller)).collect()
}

fn describe(mechanism: &Mechanism, roller: LinkId) -> Option<Diagnosis> {
    let link = mechanism.link(roller);
    let (pair, hinge) = hinge(mechanism, roller)?;
    let beside = |at: Vec2| (at - hinge).norm() > ROUNDING * (at.norm() + hinge.norm());
    let mut found = loads(mechanism, roller, &beside);
    for pair in mechanism.pairs.iter().filter(|p| p.kind.links().contains(&roller)) {
        if pair.friction.is_some_and(|f| f.is_some()) {
            found.push((format!("the friction in `{}`", pair.name), pair.span));
        }
    }
    if weighs(mechanism, link) && link.mass.is_some_and(|m| m.mass > 0.0 && beside(m.centre)) {
        found.push(("its mass, which is not at the hinge".to_owned(), link.span));
    }
    if found.is_empty() {
        return None;
    }
    let words: Vec<String> = found.iter().map(|f| f.0.clone()).collect();
    let mut labels = vec![label("turns freely here", pair.span)];
    labels.retain(|_| found.iter().all(|f| f.1 != pair.span));
    labels.extend(found.into_iter().map(|(_, span)| label("acts on its rotation", span)));
    Some({
        let name = link.name.clone();
        Diagnosis::error(
            "mech::determinacy::free_roller",
            format!("`{name}` turns freely in `{}`: nothing balances {}", pair.name, listed(&words, "and")),
        )
        .labels(labels)
        .help(format!(
            "leave that out, or give the circle to the link that carries `{name}`, so \
             that it slides instead of rolling: the rotation of a free roller is not \
             solved"
        ))
    })
}

/// The pair on which it turns, and the hinge in its frame.
fn hinge(mechanism: &Mechanism, roller: LinkId) -> Option<(&Pair, Vec2)> {
    mechanism.pairs.iter().find_map(|pair| match &pair.kind {
        PairKind::Revolute(pins) => pins.iter().find(|p| p.link == roller).map(|p| (pair, p.at)),
        _ => None,
    })
}

/// Loads and springs that have a moment about the hinge.
fn loads(mechanism: &Mechanism, roller: LinkId, beside: &impl Fn(Vec2) -> bool) -> Vec<(String, Span)> {
    let mut found = Vec::new();
    for load in &mechanism.loads {
        let what = match &load.kind {
            LoadKind::Torque { on, .. } if *on == roller => "the torque on it".to_owned(),
            LoadKind::Force { on, at, .. } | LoadKind::ForceAgainstMotion { on, at, .. } if *on == roller => {
                match at {
                    Place::Local(at) if !beside(*at) => continue,
                    _ => "the force on it, which does not act at the hinge".to_owned(),
                }
            }
            LoadKind::InPair { pair, .. } if mechanism.pair(*pair).kind.links().contains(&roller) => {
                format!("the torque in `{}`", mechanism.pair(*pair).name)
            }
            _ => continue,
        };
        found.push((what, load.span));
    }
    for spring in &mechanism.springs {
        if [spring.from, spring.to].iter().any(|(link, at)| *link == roller && beside(*at)) {
            found.push(("the spring on it, which is not joined at the hinge".to_owned(), spring.span));
        }
    }
    found
}

/// Gravity or inertia acts on the link.
fn weighs(mechanism: &Mechanism, link: &Link) -> bool {
    let moves = |d: &Drive| d.speed.is_some();
    link.mass.is_some() && (mechanism.gravity.is_some() || mechanism.drives.iter().any(moves))
}
