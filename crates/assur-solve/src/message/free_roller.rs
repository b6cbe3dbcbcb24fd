//! What is asked of the rotation of a roller that turns freely: nothing says how it turns.

use super::error::{SolveError, label};
use crate::answer::every_query;
use crate::model::{About, LinkId, PairId, PairKind, PointRef, Query};
use crate::position::Scene;

/// Angles, rates and points of rollers that depend on a rotation which is set aside.
pub(crate) fn free_rollers(scene: &Scene<'_>) -> Option<SolveError> {
    let mut asked = Vec::new();
    every_query(scene.mechanism, &mut |query, span| {
        if let Some(roller) = scene.structure.passive.iter().find(|&&roller| hangs_on(scene, query, roller)) {
            asked.push((*roller, span));
        }
    });
    let (first, _) = *asked.first()?;
    asked.retain(|(roller, _)| *roller == first);
    asked.dedup();
    let labels = asked.into_iter().map(|(_, span)| label("hangs on how it turns", span)).collect();
    Some(SolveError::FreeRotation { name: scene.mechanism.link(first).name.clone(), labels })
}

fn hangs_on(scene: &Scene<'_>, query: &Query, roller: LinkId) -> bool {
    match query.facts().turned {
        None => false,
        Some(About::Link(link)) => link == roller,
        Some(About::Pair(pair)) => joins(scene, pair, roller),
        Some(About::Point(PointRef::Fixed(link, at))) => link == roller && !is_pivot(scene, roller, at),
        Some(About::Point(PointRef::Under(link, _))) => link == roller,
    }
}

fn joins(scene: &Scene<'_>, pair: PairId, roller: LinkId) -> bool {
    scene.mechanism.pair(pair).kind.links().contains(&roller)
}

/// The hinge about which the roller turns: it stays where it is.
fn is_pivot(scene: &Scene<'_>, roller: LinkId, at: crate::math::Vec2) -> bool {
    scene.mechanism.pairs.iter().any(|pair| match &pair.kind {
        PairKind::Revolute(pins) => pins.iter().any(|pin| pin.link == roller && pin.at == at),
        _ => false,
    })
}
