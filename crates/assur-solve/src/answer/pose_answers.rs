//! Answers questions about one position: from the state of the bodies to the results of the language.

use super::sizes::Sizes;
use super::switch::Switch;
use super::whole_cycle::WholeCycle;
use crate::math::Vec2;
use crate::model::{
    BalanceKind, CamContact, Equilibrium, Expr, FindKind, LinkId, Mechanism, ModePart, PairId, PairKind,
    PointRef, QuantityId, Query, Value,
};
use crate::plan::Plan;
use crate::position::{Model, PartingContact, State};
use crate::structure::{BodyId, EffortSource, GroupKind, JointKind, Structure};

/// One position, seen from the language. Angles are those followed over the sweep.
#[derive(Clone, Copy)]
pub struct PoseAnswers<'a> {
    pub mechanism: &'a Mechanism,
    pub structure: &'a Structure,
    pub plan: &'a Plan,
    pub state: &'a State,
    /// Angles of the bodies by slot, continuous, rad; after them the whole turns of each pair, as `first_angles` gives them.
    pub angles: &'a [f64],
    /// What needs no position: dead positions, strokes.
    pub statics: &'a WholeCycle,
    /// Values of the file's quantities as far as they are known, in the order of the mechanism's.
    pub quantities: &'a [Value],
    /// The same position without friction and its quantities, where the file declares any.
    pub frictionless: Option<(&'a State, &'a [Value])>,
    pub ideal: bool,
    /// The same position with other forces that are as possible.
    pub other: Option<&'a State>,
    /// Parts of expressions that are taken on one side of their corners.
    pub switches: &'a [Switch<'a>],
    /// What differs by rounding of these is equal in a comparison.
    pub sizes: &'a Sizes,
}

pub(super) const NAN_VECTOR: Vec2 = Vec2::new(f64::NAN, f64::NAN);

impl<'a> PoseAnswers<'a> {
    /// A state seen from the language.
    #[must_use]
    pub fn new(model: &Model<'a>, state: &'a State, angles: &'a [f64], statics: &'a WholeCycle) -> Self {
        Self {
            mechanism: model.mechanism,
            structure: model.structure,
            plan: model.plan,
            state,
            angles,
            statics,
            quantities: &[],
            frictionless: None,
            ideal: false,
            other: state.other.as_deref(),
            switches: &[],
            sizes: &statics.sizes,
        }
    }

    /// Of a position alone: without angles, and nothing known that needs no position.
    #[must_use]
    pub fn bare(model: &Model<'a>, state: &'a State) -> Self {
        static NOTHING: WholeCycle = WholeCycle::EMPTY;
        Self::new(model, state, &[], &NOTHING)
    }

    /// Values of all quantities of the file at this position. They stand in the order in which one depends on another, so
    /// that none is evaluated twice, however long the chain.
    #[must_use]
    pub fn all_quantities(&self) -> Vec<Value> {
        self.all_quantities_in(Vec::with_capacity(self.mechanism.quantities.len()))
    }

    /// As [`PoseAnswers::all_quantities`], in the memory of a list.
    #[must_use]
    pub fn all_quantities_in(&self, mut done: Vec<Value>) -> Vec<Value> {
        done.clear();
        for quantity in &self.mechanism.quantities {
            let value = PoseAnswers { quantities: &done, ..*self }.value(&quantity.expr);
            done.push(value);
        }
        done
    }
}

impl PoseAnswers<'_> {
    /// The value of a quantity of the file at this position; NaN where it is not known yet.
    #[must_use]
    pub fn quantity(&self, id: QuantityId) -> Value {
        self.quantities.get(id.index()).copied().unwrap_or(Value::Scalar(f64::NAN))
    }

    /// The value of an item of `find`; `None` where it has none, or is no value.
    #[must_use]
    pub fn found(&self, index: usize) -> Option<Value> {
        match &self.mechanism.finds.get(index)?.kind {
            FindKind::Value { expr, .. } => Some(self.value(expr)).filter(Value::is_defined),
            FindKind::Reactions | FindKind::Table(_) => None,
        }
    }

    /// The answer to a question as the state has it. NaN where there is none.
    pub(super) fn queried(&self, query: &Query) -> Value {
        match query {
            Query::Position(p) => Value::Vector(self.position(p)),
            Query::Velocity(p) => Value::Vector(self.velocity(p)),
            Query::Acceleration(p) => Value::Vector(self.acceleration(p)),
            Query::Jerk(p) => Value::Vector(self.jerk(p)),
            Query::CurvatureRadius(p) => Value::Scalar(self.curvature_radius(p)),
            Query::CurvatureCentre(p) => Value::Vector(self.curvature_centre(p)),
            Query::Angle(link) => Value::Scalar(self.angles.get(link.index()).copied().unwrap_or(f64::NAN)),
            Query::EventTime(event, which) => Value::Scalar(self.statics.event_time(*event, *which)),
            Query::EventDrive(event, which) => Value::Scalar(self.statics.event(*event, *which)),
            Query::EventCount(event) => Value::Scalar(self.statics.count(*event)),
            Query::Period => Value::Scalar(self.statics.period.unwrap_or(f64::NAN)),
            Query::In(situation) => Value::Bool(self.statics.is_in(*situation, self.state.motion.time)),
            Query::Work(id) => Value::Scalar(self.state.motion.works.get(*id).copied().unwrap_or(f64::NAN)),
            Query::SpringPower(id) => Value::Scalar(self.state.spring_power(&self.mechanism.springs[*id])),
            Query::StopEffort(stop) => {
                Value::Scalar(self.state.motion.stops.get(*stop).copied().unwrap_or(0.0))
            }
            Query::StopsEffort(pair) => Value::Scalar(self.stop_effort(*pair)),
            Query::Impulse(pair) => Value::Scalar(self.of_stops(*pair, &self.state.motion.impulses)),
            Query::KineticEnergy => Value::Scalar(self.state.kinetic_energy(self.mechanism)),
            Query::PotentialEnergy => Value::Scalar(self.state.potential_energy(self.mechanism)),
            Query::TorsionEnergy(spring, pair) => {
                let wound = self.mechanism.torsion_springs.get(*spring).map_or(f64::NAN, |spring| {
                    spring.stiffness.sqrt() * (self.displacement(*pair) - spring.free_angle)
                });
                Value::Scalar(0.5 * wound * wound)
            }
            Query::Time => Value::Scalar(self.state.motion.time),
            Query::Omega(link) => Value::Scalar(self.body(*link).omega),
            Query::Turning(link, seen_from) => {
                Value::Scalar(super::turning::turning(self, *link, *seen_from))
            }
            Query::Alpha(link) => Value::Scalar(self.body(*link).alpha),
            Query::AngularJerk(link) => Value::Scalar(self.body(*link).zeta),
            Query::LinkDirection(link) => Value::Vector(self.body(*link).u),
            Query::Displacement(pair) => Value::Scalar(self.displacement(*pair)),
            Query::RelativeVelocity(pair) => Value::Scalar(self.relative_velocity(*pair)),
            Query::Sliding(pair) => Value::Scalar(self.sliding(*pair)),
            Query::RelativeAcceleration(pair) => Value::Scalar(self.relative_acceleration(*pair)),
            Query::RelativeJerk(pair) => Value::Scalar(self.relative_jerk(*pair)),
            Query::Coriolis(pair) => Value::Vector(self.coriolis(*pair)),
            Query::Reaction(pair, link) => Value::Vector(self.whole_force(*pair, *link)),
            Query::Axial(link) => Value::Scalar(self.axial(*link)),
            Query::Internal(asked) => Value::Scalar(self.internal(*asked)),
            Query::Moment(pair, link) => Value::Scalar(self.couple(*pair, *link)),
            Query::Normal(pair, link) => Value::Scalar(self.normal(*pair, *link)),
            Query::Friction(pair, link) => Value::Scalar(self.friction(*pair, *link)),
            Query::FrictionPower(pair) => Value::Scalar(self.friction_power(*pair)),
            Query::Efficiency => Value::Scalar(self.efficiency()),
            Query::Locked => Value::Bool(self.efficiency() <= 0.0),
            Query::Stable => Value::Bool(self.equilibrium().is_some_and(|here| here.stable)),
            Query::Vibration(which, part) => Value::Scalar(self.vibration(*which, *part)),
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
            Query::Balance(id) => Value::Scalar(self.effort_of(EffortSource::Balance(*id))),
            Query::Effort(id) => Value::Scalar(self.effort_of(EffortSource::Drive(*id))),
            Query::Load(id) => self.load(id.index()),
            Query::BalancePower(id) => Value::Scalar(self.effort_power(EffortSource::Balance(*id))),
            Query::EffortPower(id) => Value::Scalar(self.effort_power(EffortSource::Drive(*id))),
            Query::LoadPower(id) => Value::Scalar(self.load_power(id.index())),
            Query::Travel(pair) => Value::Scalar(self.travel(*pair)),
            Query::Stroke(pair) => Value::Scalar(self.statics.stroke(*pair)),
            Query::TimeRatio(pair) => Value::Scalar(self.statics.time_ratio(*pair)),
            Query::Dead(pair, which) => Value::Scalar(self.statics.dead(*pair, *which)),
            Query::TangentialForce(pair, on) => Value::Scalar(self.force_on(*pair, *on)),
            Query::ToothForce(pair, on) => Value::Scalar(self.tooth_force(*pair, *on)),
            Query::Tension(pair, part, end) => Value::Scalar(self.pull_at(*pair, *part, *end)),
            Query::TightSide(pair) => Value::Scalar(self.belt_pulls(*pair)[0]),
            Query::SlackSide(pair) => Value::Scalar(self.belt_pulls(*pair)[1]),
            Query::Capacity(pair) => Value::Scalar(self.capacity(*pair)),
            Query::Slips(pair) => Value::Bool(self.slips(*pair)),
            Query::Cycle(which) => Value::Scalar(self.statics.cycle(*which)),
            Query::Flywheel(which, part) => Value::Scalar(self.flywheel(*which, *part)),
        }
    }

    /// The equilibrium of those sought that this position is.
    fn equilibrium(&self) -> Option<&Equilibrium> {
        let inputs = &self.state.motion.inputs;
        let here = |at: &[f64]| at.iter().zip(inputs).all(|(x, input)| *x == input.value);
        self.mechanism.equilibria.iter().find(|equilibrium| here(&equilibrium.at))
    }

    fn vibration(&self, which: usize, part: ModePart) -> f64 {
        let mode = self.equilibrium().and_then(|here| here.modes.get(which));
        mode.map_or(f64::NAN, |mode| match part {
            ModePart::Natural => mode.natural,
            ModePart::Ratio => mode.ratio,
            ModePart::Damped => mode.damped,
        })
    }

    /// State of a link.
    #[must_use]
    pub fn body(&self, link: LinkId) -> &crate::position::BodyState {
        &self.state.motion.bodies[link.index()]
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

    pub(super) fn position(&self, point: &PointRef) -> Vec2 {
        let (link, at) = self.local(point);
        self.body(link).position(at)
    }

    pub(super) fn velocity(&self, point: &PointRef) -> Vec2 {
        let (link, at) = self.local(point);
        self.body(link).velocity(at)
    }

    pub(super) fn acceleration(&self, point: &PointRef) -> Vec2 {
        let (link, at) = self.local(point);
        self.body(link).acceleration(at)
    }

    pub(super) fn jerk(&self, point: &PointRef) -> Vec2 {
        let (link, at) = self.local(point);
        self.body(link).jerk(at)
    }

    /// Of a contact the part of the relative velocity across the common normal.
    fn sliding(&self, pair: PairId) -> f64 {
        let PairKind::Contact { first, second, .. } = &self.mechanism.pair(pair).kind else {
            return self.relative_velocity(pair);
        };
        let Some((place, normal)) = self.contact_normal(pair) else { return f64::NAN };
        let [v_1, v_2] = [first.link, second.link].map(|link| {
            let body = self.body(link);
            body.v + (place - body.p).perp() * body.omega
        });
        (v_1 - v_2).dot(normal.perp())
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
        libm::asin(self.state.motion.conditions[index].abs().min(1.0))
    }

    fn legs(&self, step: usize, bodies: [BodyId; 2]) -> Option<[Vec2; 2]> {
        let crate::plan::MotionStep::Rrr { legs, .. } = self.plan.motion.get(step)? else { return None };
        Some([0, 1].map(|i| legs[i].direction.turned(self.state.motion.bodies[bodies[i].0].u)))
    }

    /// The reaction's force on a link in a pair; NaN where it is not determined.
    #[must_use]
    pub fn reaction(&self, pair: PairId, link: LinkId) -> Vec2 {
        match self.query(&Query::Reaction(pair, link)) {
            Value::Vector(force) => force,
            Value::Scalar(_) | Value::Bool(_) => NAN_VECTOR,
        }
    }

    /// The force of all joints that stand for a pair on a link.
    fn whole_force(&self, pair: PairId, link: LinkId) -> Vec2 {
        if matches!(self.mechanism.pair(pair).kind, PairKind::Transmission(_)) {
            return self.mesh_force(pair, link);
        }
        let Some((contact, hinge)) = self.roller_of(pair) else {
            return self.on_pin(pair, link).fold(self.joint_force(pair, link), |sum, force| sum + force);
        };
        let (roller, follower) = (contact.roller.map(|r| r.0), contact.follower);
        // the cam presses on the roller, and the roller on its pin
        let pressed = self.joint_force(contact.pair, follower);
        match (pair == hinge, roller == Some(link)) {
            (false, true) => pressed,
            (false, false) => self.joint_force(pair, link),
            (true, true) => self.joint_force(pair, link) - pressed,
            (true, false) => self.joint_force(pair, link) + pressed,
        }
    }

    /// The forces from outside on a pin, as far as it passes them on to this link: to its first one all of them.
    pub(super) fn on_pin(&self, pair: PairId, link: LinkId) -> impl Iterator<Item = Vec2> + '_ {
        let loads = self.mechanism.loads.iter().enumerate();
        let loads = loads.filter(move |(_, load)| load.pin == Some(pair) && load.link() == Some(link));
        let efforts = self.structure.efforts.iter().enumerate();
        let efforts = efforts.filter(move |(_, effort)| match effort.source {
            EffortSource::Balance(id) => {
                let balance = &self.mechanism.balances[id.index()];
                let on = matches!(&balance.kind, BalanceKind::Force { on, .. } if *on == link);
                on && balance.pin == Some(pair)
            }
            _ => false,
        });
        let lines = &self.state.forces;
        loads
            .filter_map(|(i, _)| if let Value::Vector(force) = self.load(i) { Some(force) } else { None })
            .chain(efforts.map(|(slot, _)| lines.lines[slot].1 * lines.efforts[slot]))
    }

    /// The contact of a designed cam with a roller that is a link of its own, if the pair is that contact or the roller's
    /// hinge, and the hinge.
    pub(super) fn roller_of(&self, pair: PairId) -> Option<(&CamContact, PairId)> {
        self.mechanism.cam_contacts.iter().find_map(|contact| {
            let (_, hinge) = contact.roller?;
            (contact.pair == pair || hinge == pair).then_some((contact, hinge))
        })
    }

    /// The force on a link of all joints that stand for the pair.
    fn joint_force(&self, pair: PairId, link: LinkId) -> Vec2 {
        let rubbing = self.friction_force(pair, link) + self.stop_force(pair, link);
        self.slots(pair, link)
            .fold(rubbing, |sum, (slot, sign)| sum + self.state.forces.reactions[slot].force * sign)
    }

    /// What closed stops of a pair bear along its coordinate, N or N m.
    fn stop_effort(&self, pair: PairId) -> f64 {
        self.of_stops(pair, &self.state.motion.stops)
    }

    /// The sum of what the stops of a pair have, of a list of all.
    fn of_stops(&self, pair: PairId, all: &[f64]) -> f64 {
        let stops = self.mechanism.stops.iter().zip(all);
        let sum: f64 = stops.filter(|(stop, _)| stop.pair == pair).map(|(_, effort)| effort).sum();
        let contact = PartingContact::of_pair(&self.model(), pair);
        contact.map_or(sum, |contact| sum * self.state.pressed_by_effort(&contact))
    }

    /// The force of closed stops on a link of a guide, or in a contact that parts.
    fn stop_force(&self, pair: PairId, link: LinkId) -> Vec2 {
        match &self.mechanism.pair(pair).kind {
            PairKind::Prismatic(g) | PairKind::Slot(g) if !self.mechanism.stops.is_empty() => {
                let sign = if link == g.slider { 1.0 } else { -1.0 };
                self.line_of(pair, g) * (sign * self.stop_effort(pair))
            }
            PairKind::Contact { first, parts: true, .. } => {
                let Some((_, into_first)) = self.contact_normal(pair) else { return Vec2::zero() };
                into_first * (if link == first.link { 1.0 } else { -1.0 } * self.stop_effort(pair))
            }
            _ => Vec2::zero(),
        }
    }

    /// The torque of closed stops on a link of a hinge.
    fn stop_torque(&self, pair: PairId, link: LinkId) -> f64 {
        match &self.mechanism.pair(pair).kind {
            PairKind::Revolute(pins) if !self.mechanism.stops.is_empty() => {
                let sign = if pins.first().is_some_and(|pin| pin.link == link) { -1.0 } else { 1.0 };
                sign * self.stop_effort(pair)
            }
            _ => 0.0,
        }
    }

    /// The couple on a link in a pair about the pair's reference point; NaN where it is not determined.
    #[must_use]
    pub fn moment(&self, pair: PairId, link: LinkId) -> f64 {
        self.scalar(&Expr::Query(Query::Moment(pair, link)))
    }

    fn couple(&self, pair: PairId, link: LinkId) -> f64 {
        if self.structure.undetermined_couples.binary_search(&pair).is_ok() {
            return f64::NAN;
        }
        if matches!(self.mechanism.pair(pair).kind, PairKind::Transmission(_)) {
            return self.transmission_moment(pair, link);
        }
        // what replaces a contact bears no couple
        if matches!(self.mechanism.pair(pair).kind, PairKind::Contact { .. }) {
            return self.friction_couple(pair, link);
        }
        let couples =
            self.slots(pair, link).map(|(slot, sign)| self.state.forces.reactions[slot].couple * sign);
        couples.sum::<f64>() + self.friction_couple(pair, link) + self.stop_torque(pair, link)
    }

    /// Slots of reactions that act on a link in a pair, with their signs.
    pub(super) fn slots(&self, pair: PairId, link: LinkId) -> impl Iterator<Item = (usize, f64)> + '_ {
        // of a pin in a slot: what the block that stands for it exchanges with the slot, without an effort along it
        let in_slot = match &self.mechanism.pair(pair).kind {
            PairKind::Slot(g) => self.block(pair).map(|block| (g.slider, block)),
            _ => None,
        };
        let body = match in_slot {
            Some((pin, block)) if pin == link => block,
            // a weld carries the part itself
            _ if matches!(self.mechanism.pair(pair).kind, PairKind::Weld { .. }) => BodyId(link.index()),
            _ => self.structure.replaced.body_of(link),
        };
        self.plan.reactions_of.places(pair).iter().filter_map(move |&slot| {
            let joint = &self.plan.reactions[slot];
            if in_slot.is_some() && !joint.prismatic {
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

    /// The imaginary block of a pin in a slot.
    pub(super) fn block(&self, pair: PairId) -> Option<BodyId> {
        let replaced = &self.structure.replaced;
        replaced.joints_of(pair).find_map(|j| match replaced.joint(j).kind {
            JointKind::Prismatic { slider, .. } => Some(slider),
            JointKind::Revolute(_) | JointKind::Weld { .. } | JointKind::Law(_) => None,
        })
    }

    fn normal(&self, pair: PairId, link: LinkId) -> f64 {
        let force = self.reaction(pair, link);
        match &self.mechanism.pair(pair).kind {
            PairKind::Prismatic(g) | PairKind::Slot(g) => force.dot(self.line_of(pair, g).perp()),
            PairKind::Contact { first, .. } => {
                let Some((_, into_first)) = self.contact_normal(pair) else { return f64::NAN };
                force.dot(if first.link == link { into_first } else { -into_first })
            }
            PairKind::Revolute(_)
            | PairKind::Cylinder { .. }
            | PairKind::Weld { .. }
            | PairKind::Transmission(_) => f64::NAN,
        }
    }

    /// Place of a contact and the common normal into the first link.
    #[must_use]
    pub fn contact_normal(&self, pair: PairId) -> Option<(Vec2, Vec2)> {
        super::contact_normal::normal(self, pair)
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
    pub(super) fn line_offset(&self, pair: PairId) -> f64 {
        let Some(g) = self.guide(pair) else { return f64::NAN };
        let normal = self.reaction(pair, g.slider).dot(self.along(&g).perp());
        self.displacement(pair) + self.moment(pair, g.slider) / normal
    }
}
