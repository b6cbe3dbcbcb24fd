//! Closure of all joints, the laws of transmissions and cams, and the drives, as scalar equations of the bodies' poses, and
//! to which group each belongs. `position::equation` has what they come to.

use super::planned::Plan;
use super::step::Anchor;
use crate::math::Vec2;
use crate::model::Mechanism;
use crate::structure::{BodyId, BodyRate, EffortKind, EffortSource, JointId, JointKind, Structure};

/// A scalar equation g = 0.
#[derive(Clone, Debug)]
pub enum Equation {
    /// Two points coincide along an axis of the ground.
    Together { a: Anchor, b: Anchor, axis: Vec2 },
    /// Direction b of a body is direction a of another, turned by the angle of a drive if there is one.
    Turned { a: (usize, Vec2), b: (usize, Vec2), drive: Option<usize> },
    /// A point keeps a distance from a line, on either side, m.
    Beside(GuideRow, f64),
    /// A point is on a line where a drive says.
    Driven(GuideRow, usize),
    /// The sum of coordinates times coefficients is a constant.
    Law(Vec<(Coordinate, f64)>, f64),
    /// The follower of a designed cam has the lift of its law: index into [`Plan::cams`].
    Cam(usize),
    /// A pin is on the line of its slot, or the wheel rests: index into [`Plan::genevas`].
    Geneva(usize),
}

/// A point of one body measured along a direction of another, or across it.
#[derive(Clone, Copy, Debug)]
pub struct GuideRow {
    pub point: Anchor,
    /// Where the line begins.
    pub line: Anchor,
    pub along: Vec2,
    pub across: bool,
}

/// A variable of a law.
#[derive(Clone, Copy, Debug)]
pub enum Coordinate {
    /// The angle of a body.
    Turn(usize),
    /// The coordinate of a prismatic joint.
    Slide(GuideRow),
}

/// The bodies of a group and the equations from which their rates of any order follow, those of earlier groups being known.
#[derive(Clone, Debug)]
pub struct RateGroup {
    /// Three columns each.
    pub bodies: Vec<usize>,
    /// Each with those bodies of the group that it speaks of, by their places in `bodies`.
    pub equations: Vec<(Equation, Vec<usize>)>,
}

const X_AXIS: Vec2 = Vec2::new(1.0, 0.0);

/// All equations of a mechanism.
#[must_use]
pub fn equations(mechanism: &Mechanism, structure: &Structure, plan: &Plan) -> Vec<Equation> {
    let mut all = Vec::new();
    let mut laws = plan.laws.iter();
    let solved = |body| structure.motion.iter().position(|group| group.bodies.contains(&body));
    for joint in structure.replaced.joints.iter().filter(|j| !mechanism.is_by_law(j.pair)) {
        match &joint.kind {
            JointKind::Revolute(members) => {
                // all meet the one that is known first
                let Some(hub) = members.iter().min_by_key(|(body, _)| solved(*body)) else { continue };
                let pin = |member: &(BodyId, Vec2)| Anchor { body: member.0.0, at: member.1 };
                let a = pin(hub);
                for b in members.iter().filter(|member| member.0 != hub.0).map(pin) {
                    let axes = [X_AXIS, X_AXIS.perp()];
                    all.extend(axes.map(|axis| Equation::Together { a, b, axis }));
                }
            }
            JointKind::Prismatic { slider, direction, guide, along, offset, angle_redundant, .. } => {
                if !angle_redundant {
                    let (a, b) = ((guide.0, *along), (slider.0, *direction));
                    all.push(Equation::Turned { a, b, drive: None });
                }
                all.extend(row(&joint.kind, true).map(|row| Equation::Beside(row, *offset)));
            }
            JointKind::Weld { .. } => {}
            JointKind::Law(terms) => {
                let terms = terms.iter().filter_map(|(rate, c)| Some((coordinate(structure, *rate)?, *c)));
                all.push(Equation::Law(terms.collect(), laws.next().map_or(0.0, |law| law.constant)));
            }
        }
    }
    let turned = |a: usize, b: usize| Equation::Turned { a: (a, X_AXIS), b: (b, X_AXIS), drive: None };
    all.extend(structure.replaced.passive.iter().map(|link| turned(0, link.index())));
    let driven = |[a, b]: [usize; 2], [first, second]: [Vec2; 2], drive| Equation::Turned {
        a: (a, first),
        b: (b, second),
        drive: Some(drive),
    };
    for drive in &structure.drives {
        let EffortSource::Drive(id) = drive.source else { continue };
        match drive.kind {
            EffortKind::Angle(body) => all.push(driven([0, body.0], drive.axes, id.index())),
            EffortKind::RelativeAngle { first, second, .. } => {
                all.push(driven([first.0, second.0], drive.axes, id.index()));
            }
            EffortKind::Coordinate(joint) => {
                let row = row_of(structure, joint);
                all.extend(row.map(|row| Equation::Driven(row, id.index())));
            }
            EffortKind::Place(body, at, axis) => {
                let point = Anchor { body: body.0, at };
                let line = Anchor { body: 0, at: Vec2::zero() };
                let row = GuideRow { point, line, along: axis.unit(), across: false };
                all.push(Equation::Driven(row, id.index()));
            }
            EffortKind::Line(_) | EffortKind::Point(_) => {}
        }
    }
    all.extend((0..plan.cams.len()).map(Equation::Cam));
    all.extend((0..plan.genevas.len()).map(Equation::Geneva));
    all
}

/// The equations of each group, in the order of solution; `None` where one has not as many as unknowns.
#[must_use]
pub fn rate_groups(mechanism: &Mechanism, structure: &Structure, plan: &Plan) -> Option<Vec<RateGroup>> {
    let mut place = vec![None; plan.bodies];
    let mut groups: Vec<RateGroup> = Vec::with_capacity(structure.motion.len());
    for (index, group) in structure.motion.iter().enumerate() {
        let bodies: Vec<usize> = group.bodies.iter().map(|b| b.0).filter(|b| !plan.is_block(*b)).collect();
        bodies.iter().enumerate().for_each(|(i, &body)| place[body] = Some((index, i)));
        groups.push(RateGroup { bodies, equations: Vec::new() });
    }
    for equation in equations(mechanism, structure, plan) {
        let of: Vec<(usize, usize)> = equation.bodies(plan).iter().filter_map(|b| place[*b]).collect();
        // it belongs to the group that is solved last
        let last = of.iter().map(|(group, _)| *group).max()?;
        let own = of.iter().filter(|(group, _)| *group == last).map(|(_, i)| *i).collect();
        groups[last].equations.push((equation, own));
    }
    groups.iter().all(|group| group.equations.len() == 3 * group.bodies.len()).then_some(groups)
}

impl Equation {
    /// The bodies that it speaks of.
    #[must_use]
    pub fn bodies(&self, plan: &Plan) -> Vec<usize> {
        let mut bodies = match self {
            Self::Together { a, b, .. } => vec![a.body, b.body],
            Self::Turned { a, b, .. } => vec![a.0, b.0],
            Self::Beside(row, _) | Self::Driven(row, _) => row.bodies().to_vec(),
            Self::Law(terms, _) => {
                let of = |coordinate: &Coordinate| match coordinate {
                    Coordinate::Turn(body) => vec![*body],
                    Coordinate::Slide(row) => row.bodies().to_vec(),
                };
                terms.iter().flat_map(|t| of(&t.0)).collect()
            }
            Self::Cam(cam) => {
                let contact = &plan.cams[*cam].contact;
                [contact.frame, contact.disk, contact.follower].map(|link| link.index()).to_vec()
            }
            Self::Geneva(wheel) => {
                let pair = &plan.genevas[*wheel].pair;
                [pair.frame, pair.crank, pair.wheel].map(|link| link.index()).to_vec()
            }
        };
        bodies.sort_unstable();
        bodies.dedup();
        bodies
    }
}

impl GuideRow {
    const fn bodies(&self) -> [usize; 2] {
        [self.point.body, self.line.body]
    }
}

impl Plan {
    /// Whether a body stands for the contact with a designed cam or for the pin of a Geneva wheel: it is placed by them.
    #[must_use]
    pub fn is_block(&self, body: usize) -> bool {
        self.cams.iter().any(|step| step.block == body) || self.genevas.iter().any(|step| step.block == body)
    }
}

/// The point of a prismatic joint measured along its line, or across it.
fn row(kind: &JointKind, across: bool) -> Option<GuideRow> {
    match *kind {
        JointKind::Prismatic { slider, point, guide, through, along, .. } => Some(GuideRow {
            point: Anchor { body: slider.0, at: point },
            line: Anchor { body: guide.0, at: through },
            along,
            across,
        }),
        JointKind::Revolute(_) | JointKind::Weld { .. } | JointKind::Law(_) => None,
    }
}

/// The coordinate of a prismatic joint.
fn row_of(structure: &Structure, joint: JointId) -> Option<GuideRow> {
    row(&structure.replaced.joint(joint).kind, false)
}

fn coordinate(structure: &Structure, rate: BodyRate) -> Option<Coordinate> {
    match rate {
        BodyRate::Slide(joint) => row_of(structure, joint).map(Coordinate::Slide),
        BodyRate::Turn(body) => Some(Coordinate::Turn(body.0)),
    }
}
