//! The coordinate of a pair and its derivatives.

use super::pose_answers::{NAN_VECTOR, PoseAnswers};
use crate::math::Vec2;
use crate::model::{Guide, LinkId, PairId, PairKind, PointRef};
use crate::position::PartingContact;
use std::borrow::Cow;
use std::f64::consts::TAU;

impl PoseAnswers<'_> {
    /// The guide of a pair with a coordinate along a line; barrel and rod of a cylinder.
    #[must_use]
    pub fn guide(&self, pair: PairId) -> Option<Cow<'_, Guide>> {
        match &self.mechanism.pair(pair).kind {
            PairKind::Prismatic(g) | PairKind::Slot(g) => Some(Cow::Borrowed(g)),
            PairKind::Cylinder { barrel, rod, .. } => Some(Cow::Owned(Guide {
                slider: *rod,
                point_name: String::new(),
                point: Vec2::zero(),
                direction: Vec2::new(1.0, 0.0),
                own_line: None,
                guide: *barrel,
                line_name: String::new(),
                through: Vec2::zero(),
                along: Vec2::new(1.0, 0.0),
                contacts: None,
                guide_first: true,
            })),
            PairKind::Revolute(_)
            | PairKind::Contact { .. }
            | PairKind::Weld { .. }
            | PairKind::Transmission(_) => None,
        }
    }

    /// Direction of a guide's line in ground axes.
    #[must_use]
    pub fn along(&self, guide: &Guide) -> Vec2 {
        guide.along.turned(self.body(guide.guide).u)
    }

    /// Direction of the line on which a pair's block slides: of a Geneva wheel that of the slot the pin is in.
    #[must_use]
    pub fn line_of(&self, pair: PairId, guide: &Guide) -> Vec2 {
        let by_law = self.mechanism.genevas.iter().any(|g| g.pair == pair);
        match self.block(pair) {
            Some(block) if by_law => self.state.motion.bodies[block.0].u,
            _ => self.along(guide),
        }
    }

    /// The same as far as the pair has a coordinate: the pin of a Geneva wheel has none between two slots.
    fn coordinate_line(&self, pair: PairId, guide: &Guide) -> Vec2 {
        match self.plan.genevas.iter().find(|step| step.pair.pair == pair) {
            Some(step) if !self.state.is_in_slot(step) => NAN_VECTOR,
            _ => self.line_of(pair, guide),
        }
    }

    /// First and second link of a revolute of two links.
    pub(super) fn hinge(&self, pair: PairId) -> Option<(LinkId, LinkId)> {
        match &self.mechanism.pair(pair).kind {
            PairKind::Revolute(pins) => Some((pins.first()?.link, pins.get(1)?.link)),
            _ => None,
        }
    }

    /// Coordinate of a pair: m, or rad for a revolute.
    #[must_use]
    pub fn displacement(&self, pair: PairId) -> f64 {
        if let Some((first, second)) = self.hinge(pair) {
            let turns =
                self.angles.get(self.state.motion.bodies.len() + pair.index()).copied().unwrap_or(0.0);
            return self.angles[second.index()] - self.angles[first.index()] + turns;
        }
        if let Some(contact) = PartingContact::of_pair(&self.model(), pair) {
            return self.state.gap(&contact);
        }
        let Some(g) = self.guide(pair) else { return f64::NAN };
        let from = self.body(g.guide).position(g.through);
        (self.body(g.slider).position(g.point) - from).dot(self.coordinate_line(pair, &g))
    }

    /// The coordinate from its least value. A hinge that goes to and fro by less than a turn is followed from another place
    /// than its extremes, so that whole turns between the two are left out.
    pub(super) fn travel(&self, pair: PairId) -> f64 {
        let (travel, stroke) =
            (self.displacement(pair) - self.statics.least(pair), self.statics.stroke(pair));
        let turns = ((travel - stroke / 2.0) / TAU).round();
        if turns != 0.0 && stroke < TAU && self.hinge(pair).is_some() { travel - turns * TAU } else { travel }
    }

    /// First derivative of the coordinate.
    #[must_use]
    pub fn relative_velocity(&self, pair: PairId) -> f64 {
        if let Some((first, second)) = self.hinge(pair) {
            return self.body(second).omega - self.body(first).omega;
        }
        if let Some(contact) = PartingContact::of_pair(&self.model(), pair) {
            return self.state.gap_rate(&contact);
        }
        let Some(g) = self.guide(pair) else { return f64::NAN };
        let point = PointRef::Fixed(g.slider, g.point);
        let under = PointRef::Under(g.guide, (g.slider, g.point));
        (self.velocity(&point) - self.velocity(&under)).dot(self.coordinate_line(pair, &g))
    }

    /// Second derivative of the coordinate.
    #[must_use]
    pub fn relative_acceleration(&self, pair: PairId) -> f64 {
        if let Some((first, second)) = self.hinge(pair) {
            return self.body(second).alpha - self.body(first).alpha;
        }
        if let Some(contact) = PartingContact::of_pair(&self.model(), pair) {
            return self.state.gap_acceleration(&contact);
        }
        let Some(g) = self.guide(pair) else { return f64::NAN };
        let point = PointRef::Fixed(g.slider, g.point);
        let under = PointRef::Under(g.guide, (g.slider, g.point));
        (self.acceleration(&point) - self.acceleration(&under)).dot(self.coordinate_line(pair, &g))
    }

    /// Third derivative of the coordinate.
    #[must_use]
    pub fn relative_jerk(&self, pair: PairId) -> f64 {
        if let Some((first, second)) = self.hinge(pair) {
            return self.body(second).zeta - self.body(first).zeta;
        }
        let Some(g) = self.guide(pair) else { return f64::NAN };
        let point = PointRef::Fixed(g.slider, g.point);
        let under = PointRef::Under(g.guide, (g.slider, g.point));
        // of the jerk of sliding along a turning line this much is along it
        let turning = self.body(g.guide).omega * self.body(g.guide).omega * self.relative_velocity(pair);
        (self.jerk(&point) - self.jerk(&under)).dot(self.coordinate_line(pair, &g)) + 3.0 * turning
    }

    pub(super) fn coriolis(&self, pair: PairId) -> Vec2 {
        let Some(g) = self.guide(pair) else { return NAN_VECTOR };
        self.coordinate_line(pair, &g).perp()
            * (2.0 * self.body(g.guide).omega * self.relative_velocity(pair))
    }
}
