//! Loads and efforts as they act at a position, and their powers.

use super::pose_answers::PoseAnswers;
use crate::math::Vec2;
use crate::model::{BalanceKind, Expr, LinkId, LoadId, LoadKind, Place, Query, Value};
use crate::position::{Action, Against, STILL};
use crate::structure::EffortSource;

impl PoseAnswers<'_> {
    fn effort_slot(&self, source: EffortSource) -> Option<usize> {
        self.structure.efforts.iter().position(|e| e.source == source)
    }

    /// Value of an unknown effort, by its place; NaN where it is not determined.
    #[must_use]
    pub fn effort(&self, slot: usize) -> f64 {
        self.structure.efforts.get(slot).map_or(f64::NAN, |effort| {
            self.scalar(&Expr::Query(match effort.source {
                EffortSource::Balance(id) => Query::Balance(id),
                EffortSource::Drive(id) => Query::Effort(id),
            }))
        })
    }

    pub(super) fn effort_of(&self, source: EffortSource) -> f64 {
        self.effort_slot(source).map_or(f64::NAN, |slot| self.state.forces.efforts[slot])
    }

    /// Power of an unknown effort, W.
    #[must_use]
    pub fn effort_power(&self, source: EffortSource) -> f64 {
        use crate::structure::EffortKind;
        let Some(slot) = self.effort_slot(source) else { return f64::NAN };
        let value = self.state.forces.efforts[slot];
        let power = |kind| match kind {
            EffortKind::Angle(body) => value * self.state.motion.bodies[body.0].omega,
            EffortKind::RelativeAngle { first, second, .. } => {
                value * (self.state.motion.bodies[second.0].omega - self.state.motion.bodies[first.0].omega)
            }
            EffortKind::Coordinate(joint) => {
                value * self.relative_velocity(self.structure.replaced.joint(joint).pair)
            }
            EffortKind::Line(body) => {
                let (at, n) = self.state.forces.lines[slot];
                let b = &self.state.motion.bodies[body.0];
                value * (b.v + (at - b.p).perp() * b.omega).dot(n)
            }
            EffortKind::Point(_) | EffortKind::Place(..) => f64::NAN,
        };
        self.structure.efforts[slot].places().map(power).sum()
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
    pub(super) fn load(&self, index: usize) -> Value {
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
            LoadKind::ForceAgainstMotion { value, .. } => Value::Vector(self.against_motion(index, value)),
            LoadKind::Torque { value, against_motion: true, .. }
            | LoadKind::InPair { value, against_motion: true, .. } => {
                Value::Scalar(self.against_motion(index, value).x)
            }
            LoadKind::Torque { value, .. } | LoadKind::InPair { value, .. } => {
                Value::Scalar(self.scalar(value))
            }
        }
    }

    /// What a load against the motion is, in the sense that a run says or else its velocity.
    fn against_motion(&self, index: usize, value: &Expr) -> Vec2 {
        let Against { part, held } = self.part_against(index);
        if part == Vec2::zero() { held } else { part * self.scalar(value) + held }
    }

    /// How a load against the motion acts.
    pub(super) fn part_against(&self, index: usize) -> Against {
        let said = self.state.motion.against.get(index).copied();
        said.unwrap_or_else(|| Against { part: self.against_velocity(index), held: Vec2::zero() })
    }

    /// The value of a load against the motion: null where its condition does not hold.
    pub(crate) fn magnitude(&self, index: usize) -> f64 {
        let load = &self.mechanism.loads[index];
        let acts = load.when.as_ref().is_none_or(|when| self.truth(when));
        if acts { self.scalar(load.value()) } else { 0.0 }
    }

    /// What the value of a load against the motion is multiplied by at these velocities: nothing where what it acts on rests.
    pub(crate) fn against_velocity(&self, index: usize) -> Vec2 {
        match &self.mechanism.loads[index].kind {
            LoadKind::ForceAgainstMotion { on, at, .. } => {
                let p = self.place(*on, at);
                let body = self.body(*on);
                let v = body.v + (p - body.p).perp() * body.omega;
                let direction = v.unit().filter(|_| v.norm() > STILL * self.fastest().0);
                direction.map_or(Vec2::zero(), |d| -d)
            }
            LoadKind::Torque { on, against_motion: true, .. } => self.against_rate(self.body(*on).omega),
            LoadKind::InPair { pair, against_motion: true, .. } => {
                let against = self.against_rate(self.state.coordinate_rate(&self.model(), *pair));
                if self.runs_free(*pair) { Vec2::zero() } else { against }
            }
            _ => Vec2::zero(),
        }
    }

    pub(super) fn against_rate(&self, omega: f64) -> Vec2 {
        let rests = omega.abs() <= STILL * self.fastest().1;
        Vec2::new(if rests { 0.0 } else { -omega.signum() }, 0.0)
    }

    /// The greatest velocity and the greatest angular velocity, each at least what the other makes of it over the size of
    /// the mechanism: where all links only shift, their angular velocities are rounding.
    pub(super) fn fastest(&self) -> (f64, f64) {
        let most = |of: fn(&crate::position::BodyState) -> f64| {
            self.state.motion.bodies.iter().map(of).fold(0.0, f64::max)
        };
        let (v, omega, size) = (most(|b| b.v.norm()), most(|b| b.omega.abs()), most(|b| b.p.norm()));
        if size > 0.0 { (v.max(omega * size), omega.max(v / size)) } else { (v, omega) }
    }

    pub(super) fn load_power(&self, index: usize) -> f64 {
        self.load_action(LoadId::at(index)).map_or(f64::NAN, |action| self.power(&action))
    }

    /// The power of what acts on a body, and of the opposite on the body that does it.
    fn power(&self, action: &Action) -> f64 {
        let rates = |slot: usize| {
            let body = &self.state.motion.bodies[slot];
            (body.v + (action.at - body.p).perp() * body.omega, body.omega)
        };
        let (v, omega) = rates(action.on);
        let (w, psi) = action.by.map_or_else(Default::default, rates);
        action.force.dot(v - w) + action.couple * (omega - psi)
    }
}
