//! The sizes of answers at a position, and what of a position they follow from.

use super::pose_answers::PoseAnswers;
use super::sizes::Sizes;
use crate::model::{
    AlongLink, Cut, Internal, InternalPart, LinkId, LoadId, LoadKind, Mechanism, PairId, PairKind, Query,
    Rate,
};
use crate::plan::LoadStep;
use crate::structure::{EffortKind, EffortSource};

impl Sizes {
    /// Looks at a position. Its quantities are known.
    pub(crate) fn update_max(&mut self, at: &PoseAnswers<'_>) {
        // loads are those at speeds that there are
        let alone = std::mem::take(&mut self.alone);
        self.look_at_motion(at);
        self.look_at_quantities(at);
        if !at.plan.loads.is_empty() {
            self.look_at_forces(at);
            self.look_at_quantities(at);
        }
        self.alone = alone;
    }

    fn look_at_motion(&mut self, at: &PoseAnswers<'_>) {
        let bodies = &at.state.motion.bodies;
        self.length = self.length.max(of_transmissions(at.mechanism));
        for (i, link) in at.mechanism.links.iter().enumerate() {
            let body = &bodies[LinkId::at(i).index()];
            let points = link.points.iter().map(|p| p.at).chain([crate::math::Vec2::zero()]);
            for point in points {
                self.length = self.length.max(point.norm()).max(body.position(point).norm());
            }
        }
        for body in bodies {
            self.turning = self.turning.max(body.omega.abs());
            self.speeding = self.speeding.max(body.alpha.abs());
            self.moving = self.moving.max(body.v.norm());
            self.gaining = self.gaining.max(body.a.norm());
        }
    }

    fn look_at_quantities(&mut self, at: &PoseAnswers<'_>) {
        self.quantities.clear();
        for quantity in &at.mechanism.quantities {
            let size = at.size(&quantity.expr, self);
            self.quantities.push(size);
        }
    }

    fn look_at_forces(&mut self, at: &PoseAnswers<'_>) {
        // what depends on forces has no other size here than its own: it would grow from look to look
        let before = (std::mem::take(&mut self.force), std::mem::take(&mut self.moment));
        let (mut force, mut moment) = (0.0, 0.0);
        let (mut inertia_force, mut inertia_moment) = (0.0, 0.0);
        for load in &at.plan.loads {
            match load {
                LoadStep::Mass { mass, moment_of_inertia, weight, inertia, .. } => {
                    force += weight.norm();
                    if *inertia {
                        inertia_force += mass * self.acceleration();
                        inertia_moment += moment_of_inertia * self.speeding();
                    }
                }
                LoadStep::Force { force: applied, .. } => force += applied.norm(),
                LoadStep::Torque { torque, .. } => moment += torque.abs(),
                LoadStep::Spring { stiffness, free_length, damping, .. } => {
                    force += stiffness * (self.length + free_length) + damping.unwrap_or(0.0) * self.speed();
                }
                LoadStep::Evaluated(id) if at.is_torque(*id) => moment += at.load_size(*id, self),
                LoadStep::Evaluated(id) => force += at.load_size(*id, self),
            }
        }
        self.applied = self.applied.max(force + self.over_length(moment));
        let reactions = &at.state.forces.reactions;
        force =
            reactions.iter().fold(force + inertia_force, |most, reaction| most.max(reaction.force.norm()));
        self.force = before.0.max(force);
        self.moment = before.1.max(moment + inertia_moment);
    }
}

/// Radii of wheels, and how far sliders go for a radian of what moves them, m: by these torques and forces go over into each other,
/// however near to the origin all bodies are.
fn of_transmissions(mechanism: &Mechanism) -> f64 {
    let known = mechanism.wheels.iter().filter(|wheel| !wheel.open).map(|wheel| wheel.radius.abs());
    let transmissions = mechanism.pairs.iter().filter_map(|pair| match &pair.kind {
        PairKind::Transmission(transmission) => Some(transmission),
        _ => None,
    });
    let travel = transmissions.flat_map(|transmission| &transmission.laws).flat_map(|law| {
        let slides = law.terms.iter().filter(|term| matches!(term.0, Rate::Slide(_)));
        let slide = slides.fold(0.0_f64, |most, term| most.max(term.1.abs()));
        let turns = law.terms.iter().filter(|term| matches!(term.0, Rate::Turn(_)));
        turns.filter(move |_| slide > 0.0).map(move |term| term.1.abs() / slide)
    });
    known.chain(travel).fold(0.0, f64::max)
}

impl PoseAnswers<'_> {
    /// Of the answer to a question; of a vector that of its components.
    pub(super) fn query_size(&self, query: &Query, sizes: &Sizes) -> f64 {
        let itself = || self.query(query).magnitude();
        let (length, of_pair) = (sizes.length, |pair: PairId, turn: f64| self.of_pair(pair, turn, sizes));
        match query {
            Query::Position(_) => length,
            Query::Velocity(_) | Query::Sliding(_) => sizes.speed(),
            Query::Acceleration(_) | Query::Coriolis(_) => sizes.acceleration(),
            Query::Jerk(_) => sizes.acceleration() * sizes.turning() + itself(),
            Query::CurvatureRadius(p) | Query::CurvatureCentre(p) => self.curvature_size(p, sizes),
            Query::AngularJerk(_) => sizes.speeding() * sizes.turning() + itself(),
            Query::RelativeJerk(pair) => of_pair(*pair, sizes.speeding() * sizes.turning()) + itself(),
            // an angle is that of a direction and whole turns
            Query::Angle(_) | Query::TransmissionAngle(_) | Query::PressureAngle(_) => 1.0 + itself(),
            Query::Displacement(pair) | Query::Travel(pair) => of_pair(*pair, 1.0) + itself(),
            Query::Omega(_) | Query::Turning(..) => sizes.turning(),
            Query::Alpha(_) => sizes.speeding(),
            Query::RelativeVelocity(pair) => of_pair(*pair, sizes.turning()),
            Query::RelativeAcceleration(pair) => of_pair(*pair, sizes.speeding()),
            Query::LinkDirection(_) | Query::Efficiency => 1.0,
            Query::LineOffset(_) | Query::InertiaArm(_) => length + itself(),
            Query::InertiaForce(link) => {
                self.mechanism.link(*link).mass.map_or(0.0, |m| m.mass * sizes.acceleration())
            }
            Query::InertiaTorque(link) => {
                self.mechanism.link(*link).mass.map_or(0.0, |m| m.inertia * sizes.speeding())
            }
            Query::Reaction(..)
            | Query::Axial(_)
            | Query::Normal(..)
            | Query::Friction(..)
            | Query::ContactForce(..)
            | Query::TangentialForce(..)
            | Query::ToothForce(..)
            | Query::Tension(..)
            | Query::TightSide(_)
            | Query::SlackSide(_) => sizes.all_force(),
            Query::Internal(Internal { at: Cut::Extreme(AlongLink { place: true, .. }), .. }) => length,
            Query::Internal(Internal { part: InternalPart::Moment, .. }) | Query::Moment(..) => {
                sizes.all_moment()
            }
            Query::Internal(_) => sizes.all_force(),
            Query::StopEffort(stop) => match self.mechanism.stops.get(*stop) {
                Some(stop) if stop.turns => sizes.all_moment(),
                _ => sizes.all_force(),
            },
            Query::StopsEffort(pair) => {
                let own = self.mechanism.stops.iter().find(|stop| stop.pair == *pair);
                if own.is_some_and(|stop| stop.turns) { sizes.all_moment() } else { sizes.all_force() }
            }
            Query::Balance(id) => self.effort_size(EffortSource::Balance(*id), sizes),
            Query::Effort(id) => self.effort_size(EffortSource::Drive(*id), sizes),
            Query::Load(id) => self.load_size(*id, sizes),
            Query::LoadPower(id) if self.is_torque(*id) => self.load_size(*id, sizes) * sizes.turning(),
            Query::LoadPower(id) => self.load_size(*id, sizes) * sizes.speed(),
            Query::FrictionPower(_) | Query::BalancePower(_) | Query::EffortPower(_) => sizes.power(),
            Query::SpringPower(spring) => {
                let spring = &self.mechanism.springs[*spring];
                let force = spring.stiffness * (length + spring.free_length);
                (force + spring.damping * sizes.speed()) * sizes.speed()
            }
            Query::Impulse(_) => itself(),
            Query::Work(_) => sizes.all_moment() + itself(),
            Query::Flywheel(..) => itself(),
            Query::Cycle(which) => self.statics.cycles.get(*which).map_or(0.0, |c| c.size).max(itself()),
            // sums of what has one sign, or of what is given
            Query::KineticEnergy
            | Query::PotentialEnergy
            | Query::TorsionEnergy(..)
            | Query::EventTime(..)
            | Query::EventDrive(..)
            | Query::EventCount(_)
            | Query::Period
            | Query::Time
            | Query::Critical(_)
            | Query::Capacity(_)
            | Query::Stroke(_)
            | Query::TimeRatio(_)
            | Query::Dead(..)
            | Query::StaticSubstitution(..)
            | Query::DynamicSubstitution(..) => itself(),
            Query::Vibration(..) => itself(),
            Query::In(_) | Query::Locked | Query::Stable | Query::Slips(_) => 0.0,
        }
    }

    /// `turn` where the coordinate of a pair is an angle, and as much times the lengths where it is a length.
    fn of_pair(&self, pair: PairId, turn: f64, sizes: &Sizes) -> f64 {
        match self.mechanism.pair(pair).kind {
            PairKind::Revolute(_) | PairKind::Weld { .. } | PairKind::Transmission(_) => turn,
            PairKind::Prismatic(_)
            | PairKind::Slot(_)
            | PairKind::Cylinder { .. }
            | PairKind::Contact { .. } => turn * sizes.length,
        }
    }

    fn effort_size(&self, source: EffortSource, sizes: &Sizes) -> f64 {
        let effort = self.structure.efforts.iter().find(|effort| effort.source == source);
        match effort.map(|effort| effort.kind) {
            Some(EffortKind::Angle(_) | EffortKind::RelativeAngle { .. }) => sizes.all_moment(),
            _ => sizes.all_force(),
        }
    }

    fn load_size(&self, id: LoadId, sizes: &Sizes) -> f64 {
        self.mechanism.loads.get(id.index()).map_or(0.0, |load| self.size(load.value(), sizes))
    }

    /// Whether a load is a torque.
    fn is_torque(&self, id: LoadId) -> bool {
        match self.mechanism.loads.get(id.index()).map(|load| &load.kind) {
            Some(LoadKind::Torque { .. }) => true,
            Some(LoadKind::InPair { pair, .. }) => {
                matches!(self.mechanism.pair(*pair).kind, PairKind::Revolute(_) | PairKind::Transmission(_))
            }
            _ => false,
        }
    }
}
