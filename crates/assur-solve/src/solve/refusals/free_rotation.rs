//! What is asked of the rotation of a roller that turns freely: nothing says how it turns.

use crate::answer::every_query;
use crate::model::{About, DriveTarget, LinkId, PairId, PairKind, PointRef, Query};
use crate::position::Model;
use crate::solve::refusal::Refusal;

/// Angles, rates and points of rollers that depend on a rotation which is set aside.
pub(super) fn free_rollers(model: &Model<'_>) -> Option<Refusal> {
    let mut asked = Vec::new();
    every_query(model.mechanism, &mut |query, span| {
        let unknown = model.structure.passive.iter().copied().chain(outer_links(model));
        if let Some(link) = unknown.into_iter().find(|&link| depends_on(model, query, link)) {
            asked.push((link, span));
        }
    });
    let (first, _) = *asked.first()?;
    asked.retain(|(roller, _)| *roller == first);
    asked.dedup();
    let places = asked.into_iter().map(|(_, span)| span).collect();
    Some(Refusal::FreeRotation { roller: first, places })
}

/// Links that are driven at a point and have no other pairs.
fn outer_links(model: &Model<'_>) -> impl Iterator<Item = LinkId> {
    model.mechanism.drives.iter().filter_map(|drive| match drive.target {
        DriveTarget::Point(link, _) => Some(link),
        _ => None,
    })
}

fn depends_on(model: &Model<'_>, query: &Query, roller: LinkId) -> bool {
    match query.facts().turned {
        None => false,
        Some(About::Link(link)) => link == roller,
        Some(About::Pair(pair)) => joins(model, pair, roller),
        Some(About::Point(PointRef::Fixed(link, at))) => link == roller && !is_pivot(model, roller, at),
        Some(About::Point(PointRef::Under(link, _))) => link == roller,
    }
}

fn joins(model: &Model<'_>, pair: PairId, roller: LinkId) -> bool {
    model.mechanism.pair(pair).kind.links().contains(&roller)
}

/// The hinge about which the roller turns, or the place of a particle: it stays where it is.
fn is_pivot(model: &Model<'_>, roller: LinkId, at: crate::math::Vec2) -> bool {
    let is_place = |target| match target {
        DriveTarget::Place(link, point, _) | DriveTarget::Point(link, point) => link == roller && point == at,
        DriveTarget::Link(_) | DriveTarget::Pair(_) => false,
    };
    model.mechanism.drives.iter().any(|drive| is_place(drive.target))
        || model.mechanism.pairs.iter().any(|pair| match &pair.kind {
            PairKind::Revolute(pins) => pins.iter().any(|pin| pin.link == roller && pin.at == at),
            _ => false,
        })
}
