//! Closure of all joints, the laws of transmissions and cams, and the drives, as scalar equations g = 0 of the bodies'
//! poses. Every equation is written once, with its derivatives by time: its gradient is what unit rates of its bodies
//! make of ġ.

use super::cam::CamLaw;
use super::geneva;
use super::jet::{Jet, Moving, unit};
use crate::math::{Double, Scalar, V2, Vec2};
use crate::position::{BodyState, DriveInput, Model, State};
use crate::structure::{BodyRate, EffortKind, EffortSource, JointId, JointKind};

pub(super) enum Constraint<'a> {
    /// Two points coincide along an axis of the ground.
    Together { a: (usize, Vec2), b: (usize, Vec2), axis: Vec2 },
    /// Direction b is direction a turned by a known angle.
    Turned { a: (usize, V2<Double>), b: (usize, V2<Double>), by: Moving },
    /// A point is where a known distance says, along a direction of another body.
    Along(GuideRow, Jet),
    /// The sum of coordinates times coefficients is a constant.
    Law(Vec<(Coordinate, Double)>, Double),
    /// The follower of a designed cam has the lift of its law.
    Cam(CamLaw<'a>),
}

/// A point of one body measured along a direction of another.
pub(super) struct GuideRow {
    pub slider: usize,
    pub point: Vec2,
    pub guide: usize,
    pub through: Vec2,
    pub direction: V2<Double>,
}

/// What a law speaks of.
pub(super) enum Coordinate {
    /// The angle of a body, counted from a direction near its own.
    Turn { body: usize, angle: f64, near: V2<Double> },
    /// The coordinate of a prismatic joint.
    Slide(GuideRow),
}

impl GuideRow {
    fn jet(&self, bodies: &[BodyState<Double>]) -> Jet {
        let guide = &bodies[self.guide];
        let apart = Moving::point(&bodies[self.slider], self.point).less(Moving::point(guide, self.through));
        apart.dot(Moving::axis(guide, self.direction))
    }
}

impl Coordinate {
    fn jet(&self, bodies: &[BodyState<Double>]) -> Jet {
        match self {
            Self::Slide(guide) => guide.jet(bodies),
            Self::Turn { body, angle, near } => {
                let body = &bodies[*body];
                let sine = near.cross(body.u);
                // the next term of the arc is the fifth power
                let left = sine + sine * sine * sine / Double::of(6.0);
                Jet { value: Double::of(*angle) + left, rate: body.omega, second: body.alpha }
            }
        }
    }
}

impl Constraint<'_> {
    /// The equation's left side with its derivatives by time.
    pub(super) fn jet(&self, bodies: &[BodyState<Double>]) -> Jet {
        match self {
            Self::Together { a, b, axis } => {
                let apart = Moving::point(&bodies[b.0], b.1).less(Moving::point(&bodies[a.0], a.1));
                let axis = V2::of(*axis);
                apart.dot(Moving::turning(axis, Double::zero(), Double::zero()))
            }
            Self::Turned { a, b, by } => {
                let from = Moving::axis(&bodies[a.0], a.1);
                let (omega, alpha) = (bodies[a.0].omega, bodies[a.0].alpha);
                let value = by.value.turned(from.value);
                let rate = by.value.cross(by.rate);
                let second = by.value.cross(by.second);
                let target = Moving::turning(value, omega + rate, alpha + second);
                target.cross(Moving::axis(&bodies[b.0], b.1))
            }
            Self::Along(guide, law) => guide.jet(bodies).less(*law),
            Self::Law(terms, constant) => {
                terms.iter().fold(Jet::constant(-*constant), |sum, (coordinate, c)| {
                    sum.plus(coordinate.jet(bodies).times(*c))
                })
            }
            Self::Cam(law) => law.jet(bodies),
        }
    }

    /// The bodies that it speaks of.
    pub(super) fn bodies(&self) -> Vec<usize> {
        match self {
            Self::Together { a: (a, _), b: (b, _), .. } | Self::Turned { a: (a, _), b: (b, _), .. } => {
                vec![*a, *b]
            }
            Self::Along(guide, _) => vec![guide.slider, guide.guide],
            Self::Law(terms, _) => {
                let of = |c: &Coordinate| match c {
                    Coordinate::Turn { body, .. } => vec![*body],
                    Coordinate::Slide(guide) => vec![guide.slider, guide.guide],
                };
                let mut bodies: Vec<usize> = terms.iter().flat_map(|t| of(&t.0)).collect();
                bodies.sort_unstable();
                bodies.dedup();
                bodies
            }
            Self::Cam(law) => law.bodies(),
        }
    }
}

/// All equations of a mechanism, assembled as a state is.
pub(super) fn constraints<'a>(model: &Model<'a>, state: &State) -> Option<Vec<Constraint<'a>>> {
    let mut all = Vec::new();
    let mut laws = model.plan.laws.iter();
    let replaced = &model.structure.replaced;
    for joint in replaced.joints.iter().filter(|j| !model.mechanism.is_by_law(j.pair)) {
        match &joint.kind {
            JointKind::Revolute(members) => {
                let mut members = members.iter().map(|(body, at)| (body.0, *at));
                let a = members.next()?;
                for b in members {
                    let axes = [Vec2::new(1.0, 0.0), Vec2::new(0.0, 1.0)];
                    all.extend(axes.map(|axis| Constraint::Together { a, b, axis }));
                }
            }
            JointKind::Prismatic { .. } => prismatic(&joint.kind, state, &mut all),
            JointKind::Law(terms) => {
                let terms = terms.iter().filter(|t| !matches!(t.0, BodyRate::Turn(b) if b.0 == 0));
                let of =
                    |(rate, c): &(BodyRate, f64)| Some((coordinate(model, state, *rate)?, Double::of(*c)));
                let constant = Double::of(laws.next()?.constant);
                all.push(Constraint::Law(terms.map(of).collect::<Option<_>>()?, constant));
            }
        }
    }
    let x_axis = V2::new(Double::one(), Double::zero());
    for link in &replaced.passive {
        let by = Moving::turning(x_axis, Double::zero(), Double::zero());
        all.push(Constraint::Turned { a: (0, x_axis), b: (link.index(), x_axis), by });
    }
    for drive in &model.structure.drives {
        let EffortSource::Drive(id) = drive.source else { continue };
        let input = &state.motion.inputs[id.index()];
        match drive.kind {
            EffortKind::Angle(body) => all.push(driven((0, x_axis), (body.0, x_axis), input)),
            EffortKind::RelativeAngle { first, second, .. } => {
                all.push(driven((first.0, x_axis), (second.0, x_axis), input));
            }
            EffortKind::Coordinate(joint) => all.push(Constraint::Along(guide(model, joint)?, law(input))),
            EffortKind::Line(_) | EffortKind::Point(_) => {}
        }
    }
    all.extend(model.plan.cams.iter().map(|step| Constraint::Cam(CamLaw::new(step))));
    all.extend(model.plan.genevas.iter().map(|step| geneva::constraint(step, state)));
    Some(all)
}

fn driven<'a>(a: (usize, V2<Double>), b: (usize, V2<Double>), input: &DriveInput) -> Constraint<'a> {
    let (rate, second) = (Double::of(input.rate), Double::of(input.acceleration));
    Constraint::Turned { a, b, by: Moving::turning(Double::direction(input.value), rate, second) }
}

fn law(input: &DriveInput) -> Jet {
    let of = Double::of;
    Jet { value: of(input.value), rate: of(input.rate), second: of(input.acceleration) }
}

/// The conditions on angle and distance of a prismatic joint.
fn prismatic(kind: &JointKind, state: &State, all: &mut Vec<Constraint<'_>>) {
    let JointKind::Prismatic {
        slider, point, direction, guide, through, along, offset, angle_redundant, ..
    } = kind
    else {
        return;
    };
    let (s, g) = (&state.motion.bodies[slider.0], &state.motion.bodies[guide.0]);
    if !angle_redundant {
        let by = Moving::turning(V2::new(Double::one(), Double::zero()), Double::zero(), Double::zero());
        let (a, b) = ((guide.0, unit(*along)), (slider.0, unit(*direction)));
        all.push(Constraint::Turned { a, b, by });
    }
    let height = along.turned(g.u).cross(s.position(*point) - g.position(*through));
    let side = if height < 0.0 { -offset } else { *offset };
    let normal = unit(*along).perp();
    let guide =
        GuideRow { slider: slider.0, point: *point, guide: guide.0, through: *through, direction: normal };
    all.push(Constraint::Along(guide, Jet::constant(Double::of(side))));
}

/// The coordinate of a prismatic joint.
fn guide(model: &Model<'_>, joint: JointId) -> Option<GuideRow> {
    match model.structure.replaced.joint(joint).kind {
        JointKind::Prismatic { slider, point, guide, through, along, .. } => {
            Some(GuideRow { slider: slider.0, point, guide: guide.0, through, direction: unit(along) })
        }
        JointKind::Revolute(_) | JointKind::Law(_) => None,
    }
}

fn coordinate(model: &Model<'_>, state: &State, rate: BodyRate) -> Option<Coordinate> {
    Some(match rate {
        BodyRate::Slide(joint) => Coordinate::Slide(guide(model, joint)?),
        BodyRate::Turn(body) => {
            let angle = state.motion.bodies[body.0].turned;
            Coordinate::Turn { body: body.0, angle, near: Double::direction(angle) }
        }
    })
}
