//! The angle between the force that a follower receives without friction and the motion of the point that receives it.

use super::pose_answers::PoseAnswers;
use crate::math::Vec2;
use crate::model::{LinkId, PairId, PairKind, ProfileShape};
use assur_math::math::ROUNDING;

/// How the point of a follower that receives the force of a contact may move, in the frame of the follower.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FollowerWay {
    /// Along this direction, whichever the point.
    Along(Vec2),
    /// Across the arm from a hinge to the point.
    About {
        /// The hinge, m.
        hinge: Vec2,
        /// The point, m.
        point: Vec2,
    },
}

impl PoseAnswers<'_> {
    /// The follower of a contact and the way of its point, as far as the frame and the follower alone give it.
    #[must_use]
    pub fn way_of_follower(&self, pair: PairId) -> Option<(LinkId, FollowerWay)> {
        let follower = self.follower(pair)?;
        let body = self.body(follower);
        let point = self.received_at(pair, follower).or_else(|| self.pin_of_slot(pair, follower));
        let designed = self.mechanism.cam_contacts.iter().find(|c| c.pair == pair);
        let frame = designed.map_or(LinkId::GROUND, |c| c.frame);
        let way = self.mechanism.pairs.iter().find_map(|other| match &other.kind {
            PairKind::Revolute(pins) => {
                let own = pins.iter().find(|pin| pin.link == follower)?;
                pins.iter().find(|pin| pin.link == frame)?;
                let point = (point? - body.p).turned_back(body.u);
                Some(FollowerWay::About { hinge: own.at, point })
            }
            PairKind::Prismatic(g) => {
                let joins = [(g.slider, g.guide), (g.guide, g.slider)].contains(&(follower, frame));
                joins.then(|| FollowerWay::Along(self.along(g).turned_back(body.u)))
            }
            _ => None,
        })?;
        Some((follower, way))
    }

    /// The pin of a slot, where its link is the follower.
    fn pin_of_slot(&self, pair: PairId, follower: LinkId) -> Option<Vec2> {
        match &self.mechanism.pair(pair).kind {
            PairKind::Slot(g) if g.slider == follower => Some(self.body(follower).position(g.point)),
            _ => None,
        }
    }

    /// Between the common normal of a contact (or the normal of a slot) and the way of the follower's point, 0 to 90°. That
    /// point is the follower's own point or the centre of its circle, of a straight face the place of the contact. Its way is
    /// perpendicular to the arm from the hinge, or along the guide, by which the follower stands on the frame; so it is
    /// known where the follower rests too. Otherwise it is that of the velocity, and NaN where there is none. The follower
    /// is the link that is solved later, or the designed one of a cam.
    pub(super) fn pressure_angle(&self, pair: PairId) -> f64 {
        let Some((place, normal)) = self.contact_normal(pair) else { return f64::NAN };
        let Some(follower) = self.follower(pair) else { return f64::NAN };
        let point = self.received_at(pair, follower).unwrap_or(place);
        let way = self.guided(pair, follower, point).or_else(|| self.moved(pair, follower, point));
        way.map_or(f64::NAN, |way| libm::atan2(normal.cross(way).abs(), normal.dot(way).abs()))
    }

    fn follower(&self, pair: PairId) -> Option<LinkId> {
        let rank = |link: LinkId| {
            let body = self.structure.replaced.body_of(link);
            self.structure.motion.iter().position(|g| g.bodies.contains(&body)).map_or(0, |r| r + 1)
        };
        let disk = self.mechanism.cam_contacts.iter().find(|c| c.pair == pair).map(|c| c.disk);
        let links = self.mechanism.pair(pair).kind.links().into_iter();
        links.filter(|l| Some(*l) != disk).max_by_key(|l| rank(*l))
    }

    /// The follower's own point, or the centre of its circle.
    fn received_at(&self, pair: PairId, follower: LinkId) -> Option<Vec2> {
        let PairKind::Contact { first, second, .. } = &self.mechanism.pair(pair).kind else { return None };
        match [first, second].into_iter().find(|p| p.link == follower)?.shape {
            ProfileShape::Point(at) | ProfileShape::Circle(at, _) => Some(self.body(follower).position(at)),
            ProfileShape::Line(..) | ProfileShape::Rim(_) => None,
        }
    }

    /// The way on which the frame lets the point go: of a designed cam the link on which cam and follower stand, else the
    /// ground.
    fn guided(&self, pair: PairId, follower: LinkId, point: Vec2) -> Option<Vec2> {
        let designed = self.mechanism.cam_contacts.iter().find(|c| c.pair == pair);
        let frame = designed.map_or(LinkId::GROUND, |c| c.frame);
        self.mechanism.pairs.iter().find_map(|other| match &other.kind {
            PairKind::Revolute(hinge) => {
                let own = hinge.iter().find(|pin| pin.link == follower)?;
                hinge.iter().find(|pin| pin.link == frame)?;
                (point - self.body(follower).position(own.at)).perp().unit()
            }
            PairKind::Prismatic(g) => {
                let joins = [(g.slider, g.guide), (g.guide, g.slider)].contains(&(follower, frame));
                joins.then(|| self.along(g))
            }
            _ => None,
        })
    }

    /// The direction of the point's velocity.
    fn moved(&self, pair: PairId, follower: LinkId, point: Vec2) -> Option<Vec2> {
        let speed = |link: LinkId| {
            let body = self.body(link);
            body.v + (point - body.p).perp() * body.omega
        };
        let links = self.mechanism.pair(pair).kind.links();
        let greatest = links.iter().map(|l| speed(*l).norm()).fold(0.0, f64::max);
        let v = speed(follower);
        (v.norm() > ROUNDING * greatest).then_some(v)
    }
}
