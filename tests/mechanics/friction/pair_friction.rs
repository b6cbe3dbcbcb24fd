//! Friction between two links of a pair, with its motion from the reference and its effort as a load.

use crate::support::equilibrium::{Forces, Outside};
use crate::support::reference::Reference;
use assur::internals::math::Vec2;
use assur::internals::model::{
    Expr, Friction, LinkId, Load, LoadKind, Mechanism, PairId, PairKind, Place, Value,
};
use assur::internals::source::Span;

/// Slower velocities are none.
const STILL: f64 = 1e-12;

/// Friction between two links of a pair.
#[derive(Debug)]
pub struct PairFriction {
    /// The pair.
    pub pair: PairId,
    /// Its effort is positive on this link.
    pub on: LinkId,
    /// The other link.
    pub from: LinkId,
    /// What it acts by.
    pub kind: Kind,
    /// Coefficient, or radius of the friction circle.
    pub factor: f64,
    /// Velocity of the first link relative to the second.
    pub speed: f64,
}

/// How friction acts, and by which forces.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// Torque about a hinge, by the magnitude of its force.
    Hinge,
    /// Force along a direction, by the force across it.
    Along(Vec2),
    /// The same by the forces at two ends.
    Ends(Vec2, [f64; 2]),
    /// Force along the tangent of a contact at a place.
    Contact(Vec2, Vec2),
}

impl PairFriction {
    /// Sense of the relative motion: ±1, or 0 where there is none.
    pub fn sense(&self) -> f64 {
        if self.speed.abs() < STILL { 0.0 } else { self.speed.signum() }
    }

    /// Whether it slides more slowly than that, though not at rest.
    pub fn is_slower(&self, speed: f64) -> bool {
        (STILL..speed).contains(&self.speed.abs())
    }

    /// −s ρ.
    pub fn weight(&self) -> f64 {
        -self.sense() * self.factor
    }

    /// Numbers of which its law adds the magnitudes; of a hinge the two of a vector.
    pub fn measures(&self, forces: &Forces) -> [f64; 2] {
        let on = forces.reactions.iter().find(|r| r.pair == self.pair && r.link == self.on);
        let (force, couple) = on.map_or((Vec2::zero(), f64::NAN), |r| (r.force, r.couple));
        match self.kind {
            Kind::Hinge => [force.x, force.y],
            Kind::Along(d) | Kind::Contact(_, d) => [d.cross(force), 0.0],
            Kind::Ends(d, [a, b]) => {
                let normal = d.cross(force);
                [(couple - normal * b) / (a - b), (normal * a - couple) / (a - b)]
            }
        }
    }

    /// Whether the equations of all links determine what its law depends on.
    pub fn determined(&self, forces: &Forces) -> bool {
        let on = forces.reactions.iter().find(|r| r.pair == self.pair && r.link == self.on);
        on.is_some_and(|r| r.determined.0 && (r.determined.1 || !matches!(self.kind, Kind::Ends(..))))
    }

    /// Whether that answer is its own, whichever link it is stated for.
    pub fn is_of(&self, r: &assur::internals::solve::PairFriction) -> bool {
        let links = [r.on, r.from];
        r.pair == self.pair && links.contains(&self.on) && links.contains(&self.from)
    }

    /// Whether its pair is a hinge.
    pub fn turns(&self) -> bool {
        matches!(self.kind, Kind::Hinge)
    }
}

/// Every pair that can rub, with the relative velocity from the reference.
pub fn pair_frictions(mechanism: &Mechanism, reference: &Reference) -> Vec<PairFriction> {
    let mut all = Vec::new();
    let omega = |l: LinkId| reference.rates[l.index()].omega;
    let velocity = |link: LinkId, p: Vec2| {
        let body = reference.bodies[link.index()].p;
        body.rate() + (p - body.value()).perp() * omega(link)
    };
    let outside = Outside::new(mechanism, &reference.bodies, &reference.rates);
    for (i, pair) in mechanism.pairs.iter().enumerate() {
        let (id, Some(friction)) = (PairId::at(i), pair.friction) else { continue };
        match (&pair.kind, friction) {
            (PairKind::Revolute(pins), Friction::Circle(factor)) => {
                let from = pins[0].link;
                all.extend(pins[1..].iter().map(|pin| {
                    let speed = omega(pin.link) - omega(from);
                    PairFriction { pair: id, on: pin.link, from, kind: Kind::Hinge, factor, speed }
                }));
            }
            (PairKind::Prismatic(g) | PairKind::Slot(g), friction) => {
                let (slider, guide) =
                    (&reference.bodies[g.slider.index()], &reference.bodies[g.guide.index()]);
                let (p, d) = (slider.point(g.point).value(), guide.axis(g.along).value());
                let speed = (velocity(g.slider, p) - velocity(g.guide, p)).dot(d);
                let (kind, factor) = match (friction, g.contacts) {
                    (Friction::BothEnds(f), Some(ends)) => (Kind::Ends(d, ends), f),
                    (other, _) => (Kind::Along(d), other.coefficient()),
                };
                all.push(PairFriction { pair: id, on: g.slider, from: g.guide, kind, factor, speed });
            }
            (PairKind::Contact { first, second, .. }, Friction::Coefficient(factor)) => {
                let Some((p, n)) = outside.touching[i] else { continue };
                let (on, from, d) = (first.link, second.link, n.perp());
                let speed = (velocity(on, p) - velocity(from, p)).dot(d);
                all.push(PairFriction { pair: id, on, from, kind: Kind::Contact(p, d), factor, speed });
            }
            _ => {}
        }
    }
    all
}

/// The mechanism with its friction as loads of these values.
pub fn loaded(mechanism: &Mechanism, rubs: &[PairFriction], efforts: &[f64]) -> Mechanism {
    let mut out = mechanism.clone();
    let mut load = |kind| {
        out.loads.push(Load { name: None, span: Span::default(), kind, pin: None, spread: None, when: None })
    };
    for (rub, &x) in rubs.iter().zip(efforts) {
        match rub.kind {
            Kind::Hinge => {
                for (on, value) in [(rub.on, x), (rub.from, -x)] {
                    load(LoadKind::Torque {
                        on,
                        at: None,
                        value: Expr::number(value),
                        against_motion: false,
                    });
                }
            }
            Kind::Along(_) | Kind::Ends(..) => {
                load(LoadKind::InPair { pair: rub.pair, value: Expr::number(x), against_motion: false })
            }
            Kind::Contact(p, tangent) => {
                for (on, force) in [(rub.on, tangent * x), (rub.from, tangent * -x)] {
                    let constant = |v| Expr::Constant(Value::Vector(v));
                    let (at, value) = (Place::Ground(constant(p)), constant(force));
                    load(LoadKind::Force { on, at, value, frame: None });
                }
            }
        }
    }
    out
}
