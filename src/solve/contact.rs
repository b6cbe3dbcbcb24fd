//! Where two profiles touch, and along which normal.

use super::view::View;
use crate::math::Vec2;
use crate::model::{PairId, PairKind, Profile, ProfileShape};

/// Place of the contact and the unit common normal into the first link: for a slot into the pin's link where the pin
/// bears on the right side of the line, that is the line's left normal.
pub(super) fn normal(view: &View<'_>, pair: PairId) -> Option<(Vec2, Vec2)> {
    match &view.mechanism.pair(pair).kind {
        PairKind::Slot(g) => {
            let p = view.body(g.slider).position(g.point);
            Some((p, view.along(g).perp()))
        }
        PairKind::Contact { first, second, internal } => contact(view, first, second, *internal),
        _ => None,
    }
}

/// A profile in ground axes: a round one by centre and radius, a straight one by a point and direction.
enum Seen {
    Round(Vec2, f64),
    Straight(Vec2, Vec2),
}

fn seen(view: &View<'_>, profile: &Profile) -> Seen {
    let body = view.body(profile.link);
    match profile.shape {
        ProfileShape::Point(p) => Seen::Round(body.position(p), 0.0),
        ProfileShape::Circle(c, r) => Seen::Round(body.position(c), r),
        ProfileShape::Line(p, d) => Seen::Straight(body.position(p), d.turned(body.u)),
    }
}

fn contact(view: &View<'_>, first: &Profile, second: &Profile, internal: bool) -> Option<(Vec2, Vec2)> {
    match (seen(view, first), seen(view, second)) {
        (Seen::Round(c_1, r_1), Seen::Round(c_2, r_2)) => {
            let between = (c_1 - c_2).unit()?;
            if !internal {
                return Some((c_2 + between * r_2, between));
            }
            // the inner circle presses outwards: the normal into it points to the centre of the outer one
            let (into_first, at) =
                if r_1 < r_2 { (-between, c_1 + between * r_1) } else { (between, c_2 - between * r_2) };
            Some((at, into_first))
        }
        (Seen::Round(c, r), Seen::Straight(p, d)) => {
            let n = side(view, first, d, c - p, r);
            Some((c - n * r, n))
        }
        (Seen::Straight(p, d), Seen::Round(c, r)) => {
            let n = side(view, second, d, c - p, r);
            Some((c - n * r, -n))
        }
        (Seen::Straight(..), Seen::Straight(..)) => None,
    }
}

/// The normal of a line towards a round profile; towards its link's origin where the profile is a point on the line.
fn side(view: &View<'_>, round: &Profile, d: Vec2, from_line: Vec2, radius: f64) -> Vec2 {
    let n = d.perp();
    let mut height = n.dot(from_line);
    if height.abs() < 0.5 * radius || radius == 0.0 {
        let point = match round.shape {
            ProfileShape::Point(p) | ProfileShape::Circle(p, _) | ProfileShape::Line(p, _) => p,
        };
        let body = view.body(round.link);
        height = n.dot(body.p - body.position(point));
    }
    if height < 0.0 { -n } else { n }
}
