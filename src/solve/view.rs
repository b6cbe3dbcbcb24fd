//! Answers questions about one position: from the state of the bodies to the results of the language.

use super::extremes::Statics;
use super::solution::Scene;
use super::state::State;
use crate::math::Vec2;
use crate::model::{
    BalanceKind, Guide, LinkId, LoadKind, Mechanism, PairId, PairKind, Place, PointRef, QuantityId, Query,
    Value,
};
use crate::plan::Plan;
use crate::structure::{BodyId, EffortSource, GroupKind, JointKind, Structure};

/// One position, seen from the language. Angles of bodies are those followed over the sweep, by body slot.
#[derive(Clone, Copy)]
pub struct View<'a> {
    /// The mechanism.
    pub mechanism: &'a Mechanism,
    /// Its structure.
    pub structure: &'a Structure,
    /// Its plan.
    pub plan: &'a Plan,
    /// The position.
    pub state: &'a State,
    /// Angles of the bodies, continuous, rad.
    pub angles: &'a [f64],
    /// What needs no position: dead positions, strokes.
    pub statics: &'a Statics,
    /// The same position without friction, where the file declares any.
    pub frictionless: Option<&'a State>,
}

const NAN_VECTOR: Vec2 = Vec2::new(f64::NAN, f64::NAN);

impl<'a> View<'a> {
    /// A state seen from the language.
    #[must_use]
    pub fn new(scene: &Scene<'a>, state: &'a State, angles: &'a [f64], statics: &'a Statics) -> Self {
        Self {
            mechanism: scene.mechanism,
            structure: scene.structure,
            plan: scene.plan,
            state,
            angles,
            statics,
            frictionless: None,
        }
    }
}

impl View<'_> {
    /// The value of a quantity of the file at this position.
    #[must_use]
    pub fn quantity(&self, id: QuantityId) -> Value {
        self.mechanism.quantities.get(id.index()).map_or(Value::Scalar(f64::NAN), |q| self.value(&q.expr))
    }

    /// The answer to a question. NaN where there is none.
    #[must_use]
    pub fn query(&self, query: &Query) -> Value {
        match query {
            Query::Position(p) => Value::Vector(self.position(p)),
            Query::Velocity(p) => Value::Vector(self.velocity(p)),
            Query::Acceleration(p) => Value::Vector(self.acceleration(p)),
            Query::Angle(link) => Value::Scalar(self.angles.get(link.index()).copied().unwrap_or(f64::NAN)),
            Query::Omega(link) => Value::Scalar(self.body(*link).omega),
            Query::Alpha(link) => Value::Scalar(self.body(*link).alpha),
            Query::LinkDirection(link) => Value::Vector(self.body(*link).u),
            Query::Displacement(pair) => Value::Scalar(self.displacement(*pair)),
            Query::RelativeVelocity(pair) => Value::Scalar(self.relative_velocity(*pair)),
            Query::RelativeAcceleration(pair) => Value::Scalar(self.relative_acceleration(*pair)),
            Query::Coriolis(pair) => Value::Vector(self.coriolis(*pair)),
            Query::Reaction(pair, link) => Value::Vector(self.reaction(*pair, *link)),
            Query::Moment(pair, link) => Value::Scalar(self.moment(*pair, *link)),
            Query::Normal(pair, link) => Value::Scalar(self.normal(*pair, *link)),
            Query::Friction(pair, link) => Value::Scalar(self.friction(*pair, *link)),
            Query::FrictionPower(pair) => Value::Scalar(self.friction_power(*pair)),
            Query::Efficiency => Value::Scalar(self.efficiency()),
            Query::Locked => Value::Truth(self.efficiency() <= 0.0),
            Query::Critical(which) => Value::Scalar(self.statics.critical(*which)),
            Query::ContactForce(pair, which) => {
                Value::Scalar(self.contact_forces(*pair).map_or(f64::NAN, |r| r[usize::from(*which == 2)]))
            }
            Query::LineOffset(pair) => Value::Scalar(self.line_offset(*pair)),
            Query::InertiaForce(link) => Value::Vector(self.inertia_force(*link)),
            Query::InertiaTorque(link) => Value::Scalar(self.inertia_torque(*link)),
            Query::InertiaArm(link) => {
                let force = self.inertia_force(*link);
                Value::Scalar(self.inertia_torque(*link).abs() / libm::hypot(force.x, force.y))
            }
            Query::StaticSubstitution(link, p_1, p_2, part) => {
                super::substitution::of_static(self, *link, *p_1, *p_2, *part)
            }
            Query::DynamicSubstitution(link, p, part) => {
                super::substitution::of_dynamic(self, *link, *p, *part)
            }
            Query::TransmissionAngle(group) => Value::Scalar(self.transmission_angle(*group)),
            Query::PressureAngle(pair) => Value::Scalar(self.pressure_angle(*pair)),
            Query::Balance(id) => Value::Scalar(self.effort(EffortSource::Balance(*id))),
            Query::Effort(id) => Value::Scalar(self.effort(EffortSource::Drive(*id))),
            Query::Load(id) => self.load(id.index()),
            Query::BalancePower(id) => Value::Scalar(self.effort_power(EffortSource::Balance(*id))),
            Query::EffortPower(id) => Value::Scalar(self.effort_power(EffortSource::Drive(*id))),
            Query::LoadPower(id) => Value::Scalar(self.load_power(id.index())),
            Query::Travel(pair) => Value::Scalar(self.displacement(*pair) - self.statics.least(*pair)),
            Query::Stroke(pair) => Value::Scalar(self.statics.stroke(*pair)),
            Query::TimeRatio(pair) => Value::Scalar(self.statics.time_ratio(*pair)),
            Query::Dead(pair, which) => Value::Scalar(self.statics.dead(*pair, *which)),
        }
    }

    /// State of a link.
    #[must_use]
    pub fn body(&self, link: LinkId) -> &super::state::BodyState {
        &self.state.bodies[link.index()]
    }

    /// A point and the place it has in the frame of the link whose motion is asked.
    fn local(&self, point: &PointRef) -> (LinkId, Vec2) {
        match point {
            PointRef::Fixed(link, at) => (*link, *at),
            PointRef::Under(link, (other, at)) => {
                let body = self.body(*link);
                (*link, (self.body(*other).position(*at) - body.p).turned_back(body.u))
            }
        }
    }

    fn position(&self, point: &PointRef) -> Vec2 {
        let (link, at) = self.local(point);
        self.body(link).position(at)
    }

    fn velocity(&self, point: &PointRef) -> Vec2 {
        let (link, at) = self.local(point);
        self.body(link).velocity(at)
    }

    fn acceleration(&self, point: &PointRef) -> Vec2 {
        let (link, at) = self.local(point);
        self.body(link).acceleration(at)
    }

    /// The guide of a pair with a coordinate along a line; barrel and rod of a cylinder.
    #[must_use]
    pub fn guide(&self, pair: PairId) -> Option<Guide> {
        match &self.mechanism.pair(pair).kind {
            PairKind::Prismatic(g) | PairKind::Slot(g) => Some(g.clone()),
            PairKind::Cylinder { barrel, rod, .. } => Some(Guide {
                slider: *rod,
                point_name: String::new(),
                point: Vec2::zero(),
                direction: Vec2::new(1.0, 0.0),
                guide: *barrel,
                line_name: String::new(),
                through: Vec2::zero(),
                along: Vec2::new(1.0, 0.0),
                contacts: None,
                guide_first: true,
            }),
            PairKind::Revolute(_) | PairKind::Contact { .. } => None,
        }
    }

    /// Direction of a guide's line in ground axes.
    #[must_use]
    pub fn along(&self, guide: &Guide) -> Vec2 {
        guide.along.turned(self.body(guide.guide).u)
    }

    /// First and second link of a revolute of two links.
    fn hinge(&self, pair: PairId) -> Option<(LinkId, LinkId)> {
        match &self.mechanism.pair(pair).kind {
            PairKind::Revolute(pins) => Some((pins.first()?.link, pins.get(1)?.link)),
            _ => None,
        }
    }

    /// Coordinate of a pair: m, or rad for a revolute.
    #[must_use]
    pub fn displacement(&self, pair: PairId) -> f64 {
        if let Some((first, second)) = self.hinge(pair) {
            return self.angles[second.index()] - self.angles[first.index()];
        }
        let Some(g) = self.guide(pair) else { return f64::NAN };
        let from = self.body(g.guide).position(g.through);
        (self.body(g.slider).position(g.point) - from).dot(self.along(&g))
    }

    /// First derivative of the coordinate.
    #[must_use]
    pub fn relative_velocity(&self, pair: PairId) -> f64 {
        if let Some((first, second)) = self.hinge(pair) {
            return self.body(second).omega - self.body(first).omega;
        }
        let Some(g) = self.guide(pair) else { return f64::NAN };
        let point = PointRef::Fixed(g.slider, g.point);
        let under = PointRef::Under(g.guide, (g.slider, g.point));
        (self.velocity(&point) - self.velocity(&under)).dot(self.along(&g))
    }

    fn relative_acceleration(&self, pair: PairId) -> f64 {
        if let Some((first, second)) = self.hinge(pair) {
            return self.body(second).alpha - self.body(first).alpha;
        }
        let Some(g) = self.guide(pair) else { return f64::NAN };
        let point = PointRef::Fixed(g.slider, g.point);
        let under = PointRef::Under(g.guide, (g.slider, g.point));
        (self.acceleration(&point) - self.acceleration(&under)).dot(self.along(&g))
    }

    fn coriolis(&self, pair: PairId) -> Vec2 {
        let Some(g) = self.guide(pair) else { return NAN_VECTOR };
        self.along(&g).perp() * (2.0 * self.body(g.guide).omega * self.relative_velocity(pair))
    }

    fn inertia_force(&self, link: LinkId) -> Vec2 {
        self.mechanism
            .link(link)
            .mass
            .map_or(Vec2::zero(), |m| self.body(link).acceleration(m.centre) * -m.mass)
    }

    fn inertia_torque(&self, link: LinkId) -> f64 {
        self.mechanism.link(link).mass.map_or(0.0, |m| -m.inertia * self.body(link).alpha)
    }

    /// Signed condition of a named group, turned into an angle in [0, 90°].
    fn transmission_angle(&self, group: usize) -> f64 {
        let Some(assertion) = self.mechanism.groups.get(group) else { return f64::NAN };
        let found = self
            .structure
            .motion
            .iter()
            .enumerate()
            .find(|(_, g)| g.name.as_deref() == Some(assertion.name.as_str()));
        let Some((index, group)) = found else { return f64::NAN };
        if let (GroupKind::Dyad(crate::structure::Dyad::Rrr), [a, b]) = (group.kind, group.bodies.as_slice())
        {
            // the angle between the links, accurate near 90° too
            if let Some([r_1, r_2]) = self.legs(index, [*a, *b]) {
                return libm::atan2(r_1.cross(r_2).abs(), r_1.dot(r_2).abs());
            }
        }
        libm::asin(self.state.sines[index].abs().min(1.0))
    }

    fn legs(&self, step: usize, bodies: [BodyId; 2]) -> Option<[Vec2; 2]> {
        let crate::plan::MotionStep::Rrr { legs, .. } = self.plan.motion.get(step)? else { return None };
        Some([0, 1].map(|i| legs[i].direction.turned(self.state.bodies[bodies[i].0].u)))
    }

    /// Between the common normal of a contact (or the normal of a slot) and the velocity of the follower's point, 0 to
    /// 90°. The follower is the link that is solved later.
    fn pressure_angle(&self, pair: PairId) -> f64 {
        let Some(normal) = self.contact_normal(pair) else { return f64::NAN };
        let links = self.mechanism.pair(pair).kind.links();
        let rank = |link: LinkId| {
            let body = BodyId(link.index());
            self.structure.motion.iter().position(|g| g.bodies.contains(&body)).map_or(0, |r| r + 1)
        };
        let Some(&follower) = links.iter().max_by_key(|l| rank(**l)) else { return f64::NAN };
        let body = self.body(follower);
        let v = body.v + (normal.0 - body.p).perp() * body.omega;
        libm::atan2(normal.1.cross(v).abs(), normal.1.dot(v).abs())
    }

    /// The reaction's force on a link in a pair: all joints that stand for the pair.
    #[must_use]
    pub fn reaction(&self, pair: PairId, link: LinkId) -> Vec2 {
        let rubbing = self.friction_force(pair, link);
        self.slots(pair, link)
            .fold(rubbing, |sum, (slot, sign)| sum + self.state.reactions[slot].force * sign)
    }

    /// The couple on a link in a pair about the pair's reference point; NaN where it is not determined.
    #[must_use]
    pub fn moment(&self, pair: PairId, link: LinkId) -> f64 {
        if self.structure.undetermined_couples.contains(&pair) {
            return f64::NAN;
        }
        let couples = self.slots(pair, link).map(|(slot, sign)| self.state.reactions[slot].couple * sign);
        couples.sum::<f64>() + self.friction_couple(pair, link)
    }

    /// Slots of reactions that act on a link in a pair, with their signs.
    fn slots(&self, pair: PairId, link: LinkId) -> impl Iterator<Item = (usize, f64)> + '_ {
        let body = BodyId(link.index());
        self.plan.reactions.iter().enumerate().filter_map(move |(slot, joint)| {
            if self.structure.replaced.joint(joint.joint).pair != pair {
                return None;
            }
            if joint.body == body {
                Some((slot, 1.0))
            } else if joint.base == body {
                Some((slot, -1.0))
            } else {
                None
            }
        })
    }

    fn normal(&self, pair: PairId, link: LinkId) -> f64 {
        let force = self.reaction(pair, link);
        match &self.mechanism.pair(pair).kind {
            PairKind::Prismatic(g) | PairKind::Slot(g) => force.dot(self.along(g).perp()),
            PairKind::Contact { first, .. } => {
                let Some((_, into_first)) = self.contact_normal(pair) else { return f64::NAN };
                force.dot(if first.link == link { into_first } else { -into_first })
            }
            PairKind::Revolute(_) | PairKind::Cylinder { .. } => f64::NAN,
        }
    }

    /// Place of a contact and the common normal into the first link.
    #[must_use]
    pub fn contact_normal(&self, pair: PairId) -> Option<(Vec2, Vec2)> {
        super::contact::normal(self, pair)
    }

    /// Forces at the two contact points of a prismatic pair along the left normal, on the sliding link.
    #[must_use]
    pub fn contact_forces(&self, pair: PairId) -> Option<[f64; 2]> {
        let g = self.guide(pair)?;
        let [a, b] = g.contacts?;
        let normal = self.reaction(pair, g.slider).dot(self.along(&g).perp());
        let moment = self.moment(pair, g.slider);
        Some([(moment - normal * b) / (a - b), (normal * a - moment) / (a - b)])
    }

    /// Where the resultant of a prismatic reaction crosses the guide, in the pair's coordinate, m.
    fn line_offset(&self, pair: PairId) -> f64 {
        let Some(g) = self.guide(pair) else { return f64::NAN };
        let normal = self.reaction(pair, g.slider).dot(self.along(&g).perp());
        self.displacement(pair) + self.moment(pair, g.slider) / normal
    }

    fn effort_slot(&self, source: EffortSource) -> Option<usize> {
        self.structure.efforts.iter().position(|e| e.source == source)
    }

    /// Value of an unknown effort.
    #[must_use]
    pub fn effort(&self, source: EffortSource) -> f64 {
        self.effort_slot(source).map_or(f64::NAN, |slot| self.state.efforts[slot])
    }

    /// Power of an unknown effort, W.
    #[must_use]
    pub fn effort_power(&self, source: EffortSource) -> f64 {
        use crate::structure::EffortKind;
        let Some(slot) = self.effort_slot(source) else { return f64::NAN };
        let value = self.state.efforts[slot];
        match self.structure.efforts[slot].kind {
            EffortKind::Angle(body) => value * self.state.bodies[body.0].omega,
            EffortKind::RelativeAngle { first, second, .. } => {
                value * (self.state.bodies[second.0].omega - self.state.bodies[first.0].omega)
            }
            EffortKind::Coordinate(joint) => {
                value * self.relative_velocity(self.structure.replaced.joint(joint).pair)
            }
            EffortKind::Line(body) => {
                let (at, n) = self.state.lines[slot];
                let b = &self.state.bodies[body.0];
                value * (b.v + (at - b.p).perp() * b.omega).dot(n)
            }
            EffortKind::Point(_) => f64::NAN,
        }
    }

    /// Line of a balance force: a point and its unit direction in ground axes.
    #[must_use]
    pub fn balance_line(&self, kind: &BalanceKind) -> Option<(Vec2, Vec2)> {
        let BalanceKind::Force { on, at, along, frame } = kind else { return None };
        let direction = frame.map_or(*along, |f| along.turned(self.body(f).u));
        Some((self.place(*on, at), direction))
    }

    /// A place on a link in ground axes, m.
    #[must_use]
    pub fn place(&self, link: LinkId, place: &Place) -> Vec2 {
        match place {
            Place::Local(at) => self.body(link).position(*at),
            Place::Ground(expr) => self.vector(expr),
        }
    }

    /// An applied load as it acts now: null where its condition does not hold.
    fn load(&self, index: usize) -> Value {
        let load = &self.mechanism.loads[index];
        let scalar = matches!(load.kind, LoadKind::Torque { .. } | LoadKind::InPair { .. });
        if load.when.as_ref().is_some_and(|w| !self.truth(w)) {
            return if scalar { Value::Scalar(0.0) } else { Value::Vector(Vec2::zero()) };
        }
        match &load.kind {
            LoadKind::Force { value, frame, .. } => {
                let force = self.vector(value);
                Value::Vector(frame.map_or(force, |f| force.turned(self.body(f).u)))
            }
            LoadKind::ForceAgainstMotion { on, at, value } => {
                let p = self.place(*on, at);
                let body = self.body(*on);
                let v = body.v + (p - body.p).perp() * body.omega;
                Value::Vector(v.unit().map_or(Vec2::zero(), |d| d * -self.scalar(value)))
            }
            LoadKind::Torque { on, value, against_motion } => {
                let omega = self.body(*on).omega;
                let sign = match (*against_motion, omega) {
                    (false, _) => 1.0,
                    (true, 0.0) => 0.0,
                    (true, w) => -w.signum(),
                };
                Value::Scalar(sign * self.scalar(value))
            }
            LoadKind::InPair { value, .. } => Value::Scalar(self.scalar(value)),
        }
    }

    fn load_power(&self, index: usize) -> f64 {
        match (&self.mechanism.loads[index].kind, self.load(index)) {
            (
                LoadKind::Force { on, at, .. } | LoadKind::ForceAgainstMotion { on, at, .. },
                Value::Vector(force),
            ) => {
                let p = self.place(*on, at);
                let body = self.body(*on);
                force.dot(body.v + (p - body.p).perp() * body.omega)
            }
            (LoadKind::Torque { on, .. }, Value::Scalar(torque)) => torque * self.body(*on).omega,
            (LoadKind::InPair { pair, .. }, Value::Scalar(effort)) => effort * self.relative_velocity(*pair),
            _ => f64::NAN,
        }
    }

    /// The joint's prismatic guide that stands for a pair, if any.
    #[must_use]
    pub fn prismatic_joint(&self, pair: PairId) -> Option<&JointKind> {
        let mut joints = self.structure.replaced.joints_of(pair);
        joints
            .find(|&j| matches!(self.structure.replaced.joint(j).kind, JointKind::Prismatic { .. }))
            .map(|j| &self.structure.replaced.joint(j).kind)
    }
}
