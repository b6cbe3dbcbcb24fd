//! What friction makes of a position: forces along the sliding, powers lost, efficiency.

use super::pose_answers::PoseAnswers;
use super::sharing::{common, sizes};
use crate::model::{LinkId, PairId, PairKind};
use crate::plan::{FrictionElement, FrictionLaw};
use crate::structure::BodyId;

/// Useful power less than this part of the power put in is rounding.
const NOTHING: f64 = 1e-13;

/// Friction between two links at a position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairFriction {
    pub pair: PairId,
    /// The link on which the effort acts.
    pub on: LinkId,
    pub from: LinkId,
    /// It turns: speed in rad/s, effort in N m; otherwise m/s and N.
    pub turns: bool,
    /// Radius of the friction circle, m, or coefficient.
    pub factor: f64,
    /// Velocity of `on` against `from`, in the sense in which the effort counts.
    pub speed: f64,
    /// What presses: force in the hinge, normal force, or the sum of those at two ends; N, ≥ 0.
    pub normal: f64,
    /// Friction torque or force on `on`.
    pub effort: f64,
    /// Power lost, W, ≥ 0.
    pub power: f64,
}

impl PoseAnswers<'_> {
    /// Friction of all pairs that have any, in the order in which forces are found; NaN what is not determined.
    #[must_use]
    pub fn pair_frictions(&self) -> Vec<PairFriction> {
        let Some(both) = self.both() else { return self.frictions() };
        let sizes = sizes(&both);
        let [mut here, there] = both.map(|view| view.frictions());
        for (own, other) in here.iter_mut().zip(there) {
            let size = if own.turns { sizes.all_moment() } else { sizes.all_force() };
            own.effort = common([own.effort, other.effort], size);
            own.normal = common([own.normal, other.normal], sizes.all_force());
        }
        here
    }

    fn frictions(&self) -> Vec<PairFriction> {
        let one = |(i, element): (usize, &FrictionElement)| {
            let (effort, speed) = (self.state.forces.frictions[i], self.state.sliding_speed(element));
            let still = self.state.forces.senses[i] == 0.0;
            let factor = element.kind.factor();
            let measured = self.state.measured(self.plan, element);
            PairFriction {
                pair: element.pair,
                on: self.held_by(element.pair, element.body),
                from: self.held_by(element.pair, element.base),
                turns: element.kind.turns(),
                factor,
                speed: if still { 0.0 } else { speed },
                normal: match element.kind {
                    FrictionLaw::BothEnds { .. } => measured.x.abs() + measured.y.abs(),
                    _ => measured.norm(),
                },
                effort,
                power: if still { 0.0 } else { -effort * speed },
            }
        };
        self.plan.friction.iter().enumerate().map(one).collect()
    }

    /// The elements of friction of a pair with their values: torque or force on the element's body.
    pub(super) fn elements(&self, pair: PairId) -> impl Iterator<Item = (&FrictionElement, f64)> + '_ {
        let places = self.plan.friction_of.places(pair).iter();
        places.filter_map(|&i| Some((&self.plan.friction[i], *self.state.forces.frictions.get(i)?)))
    }

    /// The link by which a pair holds a body.
    fn held_by(&self, pair: PairId, body: usize) -> LinkId {
        LinkId::at(self.structure.replaced.held_by(self.mechanism, pair, BodyId(body)).0)
    }

    /// Friction force on a link along the line of a pair; for a contact along the tangent, which is the common normal
    /// into the link turned by −90°.
    pub(super) fn friction(&self, pair: PairId, link: LinkId) -> f64 {
        let force = self.friction_force(pair, link);
        match &self.mechanism.pair(pair).kind {
            PairKind::Prismatic(g) | PairKind::Slot(g) => force.dot(self.along(g)),
            PairKind::Contact { first, .. } => {
                let Some((_, into_first)) = self.contact_normal(pair) else { return f64::NAN };
                let n = if first.link == link { into_first } else { -into_first };
                -force.dot(n.perp())
            }
            PairKind::Revolute(_)
            | PairKind::Cylinder { .. }
            | PairKind::Weld { .. }
            | PairKind::Transmission(_) => f64::NAN,
        }
    }

    /// Friction force on a link in a pair, N, in ground axes; null in a revolute, whose friction is a couple.
    pub(super) fn friction_force(&self, pair: PairId, link: LinkId) -> crate::math::Vec2 {
        let mut sum = crate::math::Vec2::zero();
        let body = self.structure.replaced.body_of(link).0;
        for (element, value) in self.elements(pair) {
            let Some(line) = self.state.friction_line(element) else { continue };
            if element.body == body {
                sum += line.1 * value;
            } else if element.base == body {
                sum -= line.1 * value;
            }
        }
        sum
    }

    /// Friction couple on a link in a revolute, or against the rolling of a contact, N m.
    pub(super) fn friction_couple(&self, pair: PairId, link: LinkId) -> f64 {
        let body = self.structure.replaced.body_of(link).0;
        let couples = self.elements(pair).filter(|(e, _)| e.kind.turns());
        couples
            .map(|(e, x)| {
                if e.body == body {
                    x
                } else if e.base == body {
                    -x
                } else {
                    0.0
                }
            })
            .sum()
    }

    /// Power lost in a pair, W, ≥ 0.
    pub(super) fn friction_power(&self, pair: PairId) -> f64 {
        if let Some(load) = self.load_of_clutch(pair) {
            return -self.load_power(load);
        }
        self.elements(pair).map(|(e, x)| -x * self.state.sliding_speed(e)).sum()
    }

    /// Ideal over actual power of the efforts where they drive without friction, actual over ideal where they resist. Zero
    /// where no finite effort moves the mechanism.
    #[must_use]
    pub fn efficiency(&self) -> f64 {
        if self.frictionless.is_none() {
            return 1.0;
        }
        if self.state.forces.locked {
            return 0.0;
        }
        let (ideal, actual) = (self.without_friction().power_of_efforts(), self.power_of_efforts());
        if self.overcomes_friction_alone() {
            return 0.0;
        }
        if ideal > 0.0 { ideal / actual } else { actual / ideal }
    }

    /// The efforts drive, and without friction they would have nothing to do: a shaft that turns under a load at rest.
    #[must_use]
    pub fn overcomes_friction_alone(&self) -> bool {
        let ideal = self.without_friction();
        let (power, actual) = (ideal.power_of_efforts(), self.power_of_efforts());
        // near locking all forces grow, but not what rounding leaves of those without friction
        let most =
            |view: &Self| view.state.forces.reactions.iter().map(|r| r.force.norm()).fold(0.0, f64::max);
        let growth = (most(self) / most(&ideal)).max(1.0);
        !self.state.forces.locked && actual > 0.0 && power.abs() * growth <= NOTHING * actual
    }

    /// Power of all unknown efforts, W.
    #[must_use]
    pub fn power_of_efforts(&self) -> f64 {
        self.structure.efforts.iter().map(|e| self.effort_power(e.source)).sum()
    }

    /// The same position without friction.
    #[must_use]
    pub fn without_friction(&self) -> Self {
        let (state, quantities) = self.frictionless.unwrap_or((self.state, self.quantities));
        Self {
            state,
            quantities,
            ideal: true,
            other: self.other.filter(|_| self.frictionless.is_none()),
            ..*self
        }
    }
}
