//! The common normal of a contact at a position.

use super::pose_answers::PoseAnswers;
use crate::math::Vec2;
use crate::model::{PairId, PairKind};
use crate::position::PartingContact;

/// Place of the contact and the unit common normal into the first link. For a slot the normal is the line's left one.
pub(super) fn normal(view: &PoseAnswers<'_>, pair: PairId) -> Option<(Vec2, Vec2)> {
    match &view.mechanism.pair(pair).kind {
        PairKind::Slot(g) => {
            let p = view.body(g.slider).position(g.point);
            Some((p, view.line_of(pair, g).perp()))
        }
        PairKind::Contact { parts: true, .. } => {
            view.state.parting_touch(&PartingContact::of_pair(&view.model(), pair)?)
        }
        PairKind::Contact { first, second, internal, .. } => view.state.touch(
            (first.link.index(), first.shape),
            (second.link.index(), second.shape),
            *internal,
        ),
        _ => None,
    }
}
