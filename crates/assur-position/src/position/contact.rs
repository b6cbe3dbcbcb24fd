//! Where two profiles touch, along which normal, and how far apart they are.

use super::body::BodyState;
use super::state::State;
use crate::math::Vec2;
use crate::model::ProfileShape;

/// A profile on the body of this slot.
type Side = (usize, ProfileShape);

/// A profile in ground axes: a round one by centre and radius, a straight one by a point and direction.
enum Seen {
    Round(Vec2, f64),
    Straight(Vec2, Vec2),
    Cam(usize),
}

fn seen(body: &BodyState, shape: ProfileShape) -> Seen {
    match shape {
        ProfileShape::Point(p) => Seen::Round(body.position(p), 0.0),
        ProfileShape::Circle(c, r) => Seen::Round(body.position(c), r),
        ProfileShape::Line(p, d) => Seen::Straight(body.position(p), d.turned(body.u)),
        ProfileShape::Rim(contact) => Seen::Cam(contact),
    }
}

impl State {
    /// Place where two profiles touch and the unit common normal into the first; `None` where it is not determined.
    #[must_use]
    pub fn touch(&self, first: Side, second: Side, internal: bool) -> Option<(Vec2, Vec2)> {
        self.touch_on(0.0, first, second, internal)
    }

    /// The same of profiles that need not touch, a round one on a side of a line: 1 on its left, −1 on its right, or 0 where it is.
    pub(super) fn touch_on(
        &self,
        on: f64,
        first: Side,
        second: Side,
        internal: bool,
    ) -> Option<(Vec2, Vec2)> {
        let of = |side: Side| seen(&self.motion.bodies[side.0], side.1);
        match (of(first), of(second)) {
            (Seen::Cam(_), Seen::Cam(_)) => None,
            (Seen::Cam(contact), _) => self.motion.touches.get(contact).map(|(p, n)| (*p, -*n)),
            (_, Seen::Cam(contact)) => self.motion.touches.get(contact).copied(),
            (Seen::Round(c_1, r_1), Seen::Round(c_2, r_2)) => {
                let between = (c_1 - c_2).unit()?;
                if !internal {
                    return Some((c_2 + between * r_2, between));
                }
                // the inner circle presses outwards: the normal into it points to the centre of the outer one
                Some(if r_1 < r_2 { (c_1 + between * r_1, -between) } else { (c_2 - between * r_2, between) })
            }
            (Seen::Round(c, r), Seen::Straight(p, d)) => {
                let n = if on == 0.0 { self.side(first, d, c - p, r) } else { d.perp() * on };
                Some((c - n * r, n))
            }
            (Seen::Straight(p, d), Seen::Round(c, r)) => {
                let n = if on == 0.0 { self.side(second, d, c - p, r) } else { d.perp() * on };
                Some((c - n * r, -n))
            }
            (Seen::Straight(..), Seen::Straight(..)) => None,
        }
    }

    /// The normal of a line towards a round profile; towards the origin of its body where the profile is a point.
    fn side(&self, round: Side, d: Vec2, from_line: Vec2, radius: f64) -> Vec2 {
        let n = d.perp();
        let mut height = n.dot(from_line);
        if (height.abs() < 0.5 * radius || radius == 0.0)
            && let ProfileShape::Point(p) | ProfileShape::Circle(p, _) = round.1
        {
            let body = &self.motion.bodies[round.0];
            height = n.dot(body.p - body.position(p));
        }
        if height < 0.0 { -n } else { n }
    }
}
