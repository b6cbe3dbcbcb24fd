//! The unknown forces: what a unit of each does to the bodies.

use super::contact::friction_line;
use super::motion::Motion;
use super::unit;
use crate::math::{Double, Scalar, V2, Vec2};
use crate::plan::{Guide, LawSite, PlannedLaw};
use crate::position::{BodyState, Model, State};
use crate::structure::{BodyOrigin, EffortKind, JointKind};

type D = Double;

/// What an unknown is, and where its value is kept.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    /// A component of the force in a hinge, by slot, or the normal force of a guide: along this direction.
    Force(usize, V2<D>),
    /// The couple in a guide, by slot.
    Couple(usize),
    Effort(usize),
    /// The multiplier of a law.
    Multiplier(usize),
    /// The effort of friction of an element.
    Friction(usize),
    /// What holds a link whose rotation changes nothing: nothing.
    Passive,
}

/// A unit of an unknown: on bodies the force and the moment about their origins.
pub(super) struct Unknown {
    pub kind: Kind,
    pub on: Vec<(usize, V2<D>, D)>,
}

/// Collects what a unit does.
struct Unit<'a> {
    bodies: &'a [BodyState<D>],
    on: Vec<(usize, V2<D>, D)>,
}

impl<'a> Unit<'a> {
    fn new(bodies: &'a [BodyState<D>]) -> Self {
        Self { bodies, on: Vec::new() }
    }

    fn force(mut self, body: usize, base: usize, p: V2<D>, force: V2<D>) -> Self {
        self.act(body, p, force, D::zero());
        self.act(base, p, -force, D::zero());
        self
    }

    fn couple(mut self, body: usize, base: usize, couple: D) -> Self {
        self.on.push((body, V2::zero(), couple));
        self.on.push((base, V2::zero(), -couple));
        self
    }

    fn act(&mut self, body: usize, p: V2<D>, force: V2<D>, couple: D) {
        self.on.push((body, force, (p - self.bodies[body].p).cross(force) + couple));
    }

    fn of(self, kind: Kind) -> Unknown {
        Unknown { kind, on: self.on }
    }
}

/// All unknown forces; `None` where a contact of the state has no normal.
pub(super) fn unknowns(model: &Model<'_>, state: &State, motion: &Motion<'_>) -> Option<Vec<Unknown>> {
    let bodies = motion.bodies.as_slice();
    let unit = || Unit::new(bodies);
    let mut all = reactions(model, bodies);
    for link in &model.structure.passive {
        all.push(unit().couple(link.index(), 0, D::one()).of(Kind::Passive));
    }
    for (slot, effort) in model.structure.efforts.iter().enumerate() {
        let mut on = unit();
        for kind in effort.places() {
            match kind {
                EffortKind::Angle(body) => on = on.couple(body.0, 0, D::one()),
                EffortKind::RelativeAngle { first, second, .. } => {
                    on = on.couple(second.0, first.0, D::one())
                }
                EffortKind::Line(body) => {
                    let line = model.plan.lines.iter().find(|line| line.effort == slot)?;
                    let along = super::unit(line.along);
                    let along = line.frame.map_or(along, |f| along.turned(bodies[f].u));
                    on.act(body.0, bodies[line.body].position(line.at), along, D::zero());
                }
                EffortKind::Coordinate(joint) => {
                    let JointKind::Prismatic { slider, point, direction, guide, .. } =
                        model.structure.replaced.joint(joint).kind
                    else {
                        return None;
                    };
                    let body = &bodies[slider.0];
                    let along = super::unit(direction).turned(body.u);
                    on = on.force(slider.0, guide.0, body.position(point), along);
                }
                EffortKind::Point(_) | EffortKind::Place(..) => {}
            }
        }
        if matches!(effort.kind, EffortKind::Point(_)) {
            continue;
        }
        all.push(on.of(Kind::Effort(slot)));
    }
    for (slot, law) in model.plan.laws.iter().enumerate() {
        all.push(of_law(bodies, state, law, slot).of(Kind::Multiplier(slot)));
    }
    for (index, element) in model.plan.friction.iter().enumerate() {
        let unit = match friction_line(element, state, motion)? {
            None => unit().couple(element.through, element.base, D::one()),
            Some((p, along)) => unit().force(element.through, element.base, p, along),
        };
        all.push(unit.of(Kind::Friction(index)));
    }
    Some(all)
}

/// Forces and couples of all joints, on the joints' bodies.
fn reactions(model: &Model<'_>, bodies: &[BodyState<D>]) -> Vec<Unknown> {
    let replaced = &model.structure.replaced;
    let mut all = Vec::new();
    for (slot, at) in model.plan.reactions.iter().enumerate() {
        let (body, base) = (at.body.0, at.base.0);
        let joint = replaced.joint(at.joint);
        match &joint.kind {
            JointKind::Revolute(members) => {
                // the block of a cam's contact has its hinge at its origin, wherever on the cam that is
                let block = members
                    .iter()
                    .find(|m| replaced.bodies[m.0.0].origin == BodyOrigin::Imaginary(joint.pair));
                let by_law = model.mechanism.is_by_law(joint.pair);
                let member = members.iter().find(|m| m.0 == at.body);
                let (on, pin) =
                    if by_law { block } else { member }.map_or((body, Vec2::zero()), |m| (m.0.0, m.1));
                let p = bodies[on].position(pin);
                for axis in [Vec2::new(1.0, 0.0), Vec2::new(0.0, 1.0)] {
                    let axis = V2::of(axis);
                    all.push(Unit::new(bodies).force(body, base, p, axis).of(Kind::Force(slot, axis)));
                }
            }
            JointKind::Prismatic { slider, point, direction, angle_redundant, .. } => {
                let on = &bodies[slider.0];
                let normal = unit(*direction).turned(on.u).perp();
                let p = on.position(*point);
                all.push(Unit::new(bodies).force(body, base, p, normal).of(Kind::Force(slot, normal)));
                if !angle_redundant {
                    all.push(Unit::new(bodies).couple(body, base, D::one()).of(Kind::Couple(slot)));
                }
            }
            JointKind::Weld { .. } | JointKind::Law(_) => {}
        }
    }
    all
}

fn along(bodies: &[BodyState<D>], guide: &Guide) -> V2<D> {
    unit(guide.direction).turned(bodies[guide.slider].u)
}

/// What a unit multiplier of a law does, with the losses and in the sense that the state has.
fn of_law<'a>(bodies: &'a [BodyState<D>], state: &State, law: &PlannedLaw, slot: usize) -> Unit<'a> {
    let mut unit = Unit::new(bodies);
    let sides = state.forces.law_forces[slot].sides.map(D::of);
    let coefficient = |term: usize| D::of(law.terms[term].1);
    let effort = |term: usize| match law.efficiency {
        Some(_) => law.with_losses(term, sides),
        None => coefficient(term),
    };
    for (term, (site, _)) in law.terms.iter().enumerate() {
        match site {
            LawSite::Turn(body) => unit.on.push((*body, V2::zero(), effort(term))),
            LawSite::Slide(guide) => {
                let other = if guide.slider == guide.body { guide.base } else { guide.body };
                let force = along(bodies, guide) * effort(term);
                unit = unit.force(guide.slider, other, bodies[guide.slider].position(guide.point), force);
            }
        }
    }
    let Some(meeting) = &law.meeting else { return unit };
    // the force of the teeth replaces the couples by itself at the pitch point and what is left of them
    let links = meeting.links.map(|link| link.index());
    let centres = [0, 1].map(|i| bodies[links[i]].position(meeting.centres[i]));
    let [r_1, r_2] = meeting.radii;
    let between = centres[1] - centres[0];
    let apart = between / between.norm();
    let towards = if meeting.internal && r_1 < r_2 { -apart } else { apart };
    let through = sides[0].abs().min(sides[1].abs());
    let tangential = through * D::of(law.force);
    let sign = if state.forces.law_forces[slot].multiplier < 0.0 { -1.0 } else { 1.0 };
    let inwards = if meeting.internal && r_1 > r_2 { sign } else { -sign };
    let radial = towards * (D::of(inwards * meeting.tangent) * tangential.abs());
    let force = towards.perp() * tangential + radial;
    let p = centres[0] + towards * D::of(r_1);
    let mut bearings = D::zero();
    for (i, force) in [(0, force), (1, -force)] {
        let moment = (p - centres[i]).cross(force);
        unit.act(links[i], p, force, -moment);
        bearings = bearings + moment;
    }
    // what the bearings turn on acts back on what carries them
    if let Some((LawSite::Turn(carrier), _)) = law.terms.get(2) {
        unit.act(*carrier, p, V2::zero(), bearings);
        let rest = (0..3).fold(D::zero(), |sum, term| sum + effort(term));
        unit.on.push((*carrier, V2::zero(), -rest));
    }
    unit
}
