//! Scalar conditions of joints and drives over the freedoms of the bodies they touch (on the side of forces: scalar
//! unknowns over equations of equilibrium): which freedoms each touches, and its row among the equations of velocity at a
//! random position.

use super::echelon::{Number, Row, row};
use super::effort::{Effort, EffortKind};
use super::generic::{Generic, Split, Vector};
use super::joint::{BodyId, BodyRate, Joint, JointId, JointKind, Replaced};
use super::matching::Condition;
use crate::model::Axis;

/// Random numbers of laws and of efforts along a line begin here.
const LAWS: u64 = 1 << 48;
const LINES: u64 = 1 << 52;

#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Owner {
    Joint(JointId),
    Effort(usize),
    Passive,
}

/// Conditions with their owners, over nodes: two per body (place with two freedoms, angle with one), one per pin of more
/// than two links (two freedoms).
#[derive(Clone)]
pub(super) struct Incidence {
    pub conditions: Vec<Condition>,
    pub owners: Vec<Owner>,
    /// The equations of velocity, one per condition, over the columns of the nodes.
    pub rows: Vec<Row>,
    pub capacity: Vec<usize>,
    pub bodies: usize,
    known: Vec<bool>,
    generic: Generic,
}

/// A term of an equation: body, coefficients of the velocity of its origin and of its angular velocity.
type Term = (BodyId, [Number; 3]);

impl Incidence {
    pub(super) fn new(replaced: &Replaced, efforts: &[Effort]) -> Self {
        Self::of_joints(replaced).with_efforts(replaced, efforts)
    }

    /// The conditions of the joints alone, which both sides have.
    pub(super) fn of_joints(replaced: &Replaced) -> Self {
        let capacity = replaced.bodies.iter().flat_map(|b| if b.known { [0, 0] } else { [2, 1] }).collect();
        let mut this = Self {
            conditions: Vec::new(),
            owners: Vec::new(),
            rows: Vec::new(),
            capacity,
            bodies: replaced.bodies.len(),
            known: replaced.bodies.iter().map(|b| b.known).collect(),
            generic: Generic::new(replaced),
        };
        for (i, joint) in replaced.joints.iter().enumerate() {
            this.add_joint(replaced, JointId(i), joint);
        }
        for link in &replaced.passive {
            this.add(Owner::Passive, &[(BodyId(link.index()), TURN)], None);
        }
        this
    }

    /// With those of efforts behind them.
    pub(super) fn with_efforts(mut self, replaced: &Replaced, efforts: &[Effort]) -> Self {
        for (i, effort) in efforts.iter().enumerate() {
            self.add_effort(replaced, i, effort);
        }
        self
    }

    /// The first pin that cannot hold.
    pub(super) fn split(&self) -> Option<Split> {
        self.generic.split.first().copied()
    }

    /// The number of columns, those of known bodies (in which no row has a coefficient) among them.
    pub(super) fn columns(&self) -> usize {
        3 * self.bodies + 2 * (self.capacity.len() - 2 * self.bodies)
    }

    /// Whether a column stands for a freedom.
    pub(super) fn is_freedom(&self, column: usize) -> bool {
        self.known.get(column / 3).is_none_or(|known| !known)
    }

    /// The body of a column; `None` for that of a pin.
    pub(super) fn body(&self, column: usize) -> Option<BodyId> {
        (column < 3 * self.bodies).then_some(BodyId(column / 3))
    }

    /// The columns of a node.
    pub(super) fn columns_of(&self, node: usize) -> std::ops::Range<usize> {
        let first = match node.checked_sub(2 * self.bodies) {
            Some(pin) => 3 * self.bodies + 2 * pin,
            None => 3 * (node / 2) + 2 * (node % 2),
        };
        first..first + self.capacity[node]
    }

    /// The nodes of a body, or of a pin that is counted behind the bodies.
    pub(super) fn nodes_of(&self, vertex: usize) -> std::ops::Range<usize> {
        match vertex.checked_sub(self.bodies) {
            Some(pin) => 2 * self.bodies + pin..2 * self.bodies + pin + 1,
            None => 2 * vertex..2 * vertex + 2,
        }
    }

    /// The body of a node, or the number of bodies plus that of the pin.
    pub(super) fn vertex(&self, node: usize) -> usize {
        if node < 2 * self.bodies { node / 2 } else { node - self.bodies }
    }

    fn add(&mut self, owner: Owner, terms: &[Term], pin: Option<(usize, Vector)>) {
        let mut nodes = Vec::with_capacity(2 * terms.len() + 1);
        let mut row_terms = Vec::with_capacity(3 * terms.len() + 2);
        for &(body, [x, y, turn]) in terms.iter().filter(|t| !self.known[t.0.0]) {
            if !(x.is_zero() && y.is_zero()) {
                nodes.push(2 * body.0);
            }
            nodes.push(2 * body.0 + 1);
            row_terms.extend([(3 * body.0, x), (3 * body.0 + 1, y), (3 * body.0 + 2, turn)]);
        }
        if let Some((node, [x, y])) = pin {
            nodes.push(node);
            let first = self.columns_of(node).start;
            row_terms.extend([(first, -x), (first + 1, -y)]);
        }
        self.conditions.push(Condition { nodes });
        self.rows.push(row(row_terms));
        self.owners.push(owner);
    }

    fn add_joint(&mut self, replaced: &Replaced, id: JointId, joint: &Joint) {
        let at = self.generic.point(id);
        match &joint.kind {
            JointKind::Revolute(members) if members.len() < 2 => {}
            JointKind::Revolute(members) => {
                if let [a, b] = members.as_slice() {
                    for axis in AXES {
                        self.add(Owner::Joint(id), &less(a.0, b.0, at, axis), None);
                    }
                    return;
                }
                let pin = self.capacity.len();
                self.capacity.push(2);
                for member in members {
                    for axis in AXES {
                        self.add(Owner::Joint(id), &[(member.0, along(at, axis))], Some((pin, axis)));
                    }
                }
            }
            JointKind::Prismatic { slider, guide, angle_redundant, .. } => {
                if !angle_redundant {
                    self.add(Owner::Joint(id), &[(*slider, TURN), (*guide, NO_TURN)], None);
                }
                let [x, y] = self.generic.direction(id);
                self.add(Owner::Joint(id), &less(*slider, *guide, at, [-y, x]), None);
            }
            JointKind::Weld { .. } => {}
            JointKind::Law(terms) => {
                let terms = self.law(replaced, id, terms);
                self.add(Owner::Joint(id), &terms, None);
            }
        }
    }

    /// A law with random coefficients. Those of a mesh on a carrier stay such that wheels and carrier can turn as one.
    fn law(&self, replaced: &Replaced, id: JointId, terms: &[(BodyRate, f64)]) -> Vec<Term> {
        let sum: f64 = terms.iter().map(|t| t.1).sum();
        let size: f64 = terms.iter().map(|t| t.1.abs()).sum();
        let as_one = terms.len() > 2
            && sum.abs() <= 1e-9 * size
            && terms.iter().all(|t| matches!(t.0, BodyRate::Turn(_)));
        let mut rest = Number::ZERO;
        let mut out = Vec::new();
        for (i, (rate, _)) in terms.iter().enumerate() {
            let last = as_one && i + 1 == terms.len();
            let own = Number::random(LAWS + 64 * id.0 as u64 + i as u64);
            let c = if last { -rest } else { own };
            rest += c;
            match rate {
                BodyRate::Turn(body) => out.push((*body, [Number::ZERO, Number::ZERO, c])),
                BodyRate::Slide(joint) => {
                    let scaled = |t: Term| (t.0, t.1.map(|x| c * x));
                    out.extend(self.slide(replaced, *joint).into_iter().map(scaled));
                }
            }
        }
        out
    }

    /// The rate of the coordinate of a prismatic joint.
    fn slide(&self, replaced: &Replaced, joint: JointId) -> Vec<Term> {
        match replaced.joint(joint).kind {
            JointKind::Prismatic { slider, guide, .. } => {
                less(slider, guide, self.generic.point(joint), self.generic.direction(joint)).to_vec()
            }
            JointKind::Revolute(_) | JointKind::Weld { .. } | JointKind::Law(_) => Vec::new(),
        }
    }

    fn add_effort(&mut self, replaced: &Replaced, index: usize, effort: &Effort) {
        if matches!(effort.kind, EffortKind::Point(_)) {
            return;
        }
        let terms = |kind| match kind {
            EffortKind::Point(_) => Vec::new(),
            EffortKind::Place(body, at, axis) => {
                vec![(body, along(self.generic.place(body, at), AXES[usize::from(axis == Axis::Y)]))]
            }
            EffortKind::Angle(body) => vec![(body, TURN)],
            EffortKind::RelativeAngle { first, second, .. } => vec![(first, NO_TURN), (second, TURN)],
            EffortKind::Coordinate(joint) => self.slide(replaced, joint),
            EffortKind::Line(body) => {
                let seed = LINES + 3 * index as u64;
                vec![(body, [0, 1, 2].map(|k| Number::random(seed + k)))]
            }
        };
        let terms: Vec<Term> = effort.places().flat_map(terms).collect();
        self.add(Owner::Effort(index), &terms, None);
    }
}

const TURN: [Number; 3] = [Number::ZERO, Number::ZERO, Number::ONE];
const NO_TURN: [Number; 3] = [Number::ZERO, Number::ZERO, Number::MINUS_ONE];
const AXES: [Vector; 2] = [[Number::ONE, Number::ZERO], [Number::ZERO, Number::ONE]];

/// The velocity of a point of a body along a direction: v + ω × r.
fn along(at: Vector, [x, y]: Vector) -> [Number; 3] {
    [x, y, at[0] * y - at[1] * x]
}

/// The velocity of the first body at a point along a direction, less that of the second.
fn less(first: BodyId, second: BodyId, at: Vector, direction: Vector) -> [Term; 2] {
    let c = along(at, direction);
    [(first, c), (second, c.map(|x| -x))]
}
