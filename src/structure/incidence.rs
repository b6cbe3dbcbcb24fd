//! Scalar conditions of joints and drives over the freedoms of the bodies they touch (on the side of forces: scalar
//! unknowns over equations of equilibrium).

use super::effort::{Effort, EffortKind};
use super::joint::{BodyId, BodyOrigin, BodyRate, Joint, JointId, JointKind, Replaced};
use super::matching::{Condition, Matching, match_all};
use crate::model::PairId;

/// What does not match.
#[derive(Clone, Debug)]
pub(super) struct Defect {
    /// Bodies and joints (efforts by index) with too many conditions.
    pub over: Part,
    /// Bodies and joints with too few.
    pub under: Part,
    /// How many freedoms and conditions are left over.
    pub fit: Fit,
}

/// Part of a mechanism.
#[derive(Clone, Debug, Default)]
pub(super) struct Part {
    /// Bodies, the imaginary ones among them.
    pub bodies: Vec<BodyId>,
    /// Pairs as declared, with the number of freedoms each takes.
    pub pairs: Vec<(PairId, usize)>,
    /// Drives or efforts by index: each takes one freedom.
    pub efforts: Vec<usize>,
    /// Freedoms of the links (those of imaginary bodies are counted with their pair).
    pub freedoms: usize,
}

impl Part {
    /// Freedoms that pairs and efforts take.
    pub(super) fn taken(&self) -> usize {
        self.efforts.len() + self.pairs.iter().map(|p| p.1).sum::<usize>()
    }
}

/// What a matching leaves over.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Fit {
    /// Freedoms that no condition takes.
    pub missing: usize,
    /// Conditions for which no freedom is left.
    pub surplus: usize,
}

#[derive(Clone, Copy)]
pub(super) enum Owner {
    Joint(JointId),
    Effort(usize),
    Passive,
}

/// Conditions with their owners, over nodes: two per body (place with two freedoms, angle with one), one per pin of more
/// than two links (two freedoms).
pub(super) struct Incidence {
    pub conditions: Vec<Condition>,
    pub owners: Vec<Owner>,
    pub capacity: Vec<usize>,
    bodies: usize,
    /// The joints of the pins of more than two links.
    pins: Vec<JointId>,
}

impl Incidence {
    pub(super) fn new(replaced: &Replaced, efforts: &[Effort]) -> Self {
        let capacity = replaced.bodies.iter().flat_map(|b| if b.known { [0, 0] } else { [2, 1] }).collect();
        let mut this = Self {
            conditions: Vec::new(),
            owners: Vec::new(),
            capacity,
            bodies: replaced.bodies.len(),
            pins: Vec::new(),
        };
        for (i, joint) in replaced.joints.iter().enumerate() {
            this.add_joint(replaced, JointId(i), joint);
        }
        for link in &replaced.passive {
            this.add(Owner::Passive, vec![2 * link.index() + 1]);
        }
        for (i, effort) in efforts.iter().enumerate() {
            this.add_effort(replaced, i, effort);
        }
        this
    }

    fn add(&mut self, owner: Owner, nodes: Vec<usize>) {
        self.conditions.push(Condition { nodes });
        self.owners.push(owner);
    }

    fn place_and_angle(replaced: &Replaced, bodies: &[BodyId]) -> Vec<usize> {
        let unknown = bodies.iter().filter(|b| !replaced.bodies[b.0].known);
        unknown.flat_map(|b| [2 * b.0, 2 * b.0 + 1]).collect()
    }

    fn angles(replaced: &Replaced, bodies: &[BodyId]) -> Vec<usize> {
        bodies.iter().filter(|b| !replaced.bodies[b.0].known).map(|b| 2 * b.0 + 1).collect()
    }

    fn add_joint(&mut self, replaced: &Replaced, id: JointId, joint: &Joint) {
        match &joint.kind {
            JointKind::Revolute(members) if members.len() < 2 => {}
            JointKind::Revolute(members) if members.len() > 2 => {
                let pin = self.capacity.len();
                self.capacity.push(2);
                self.pins.push(id);
                for member in members {
                    let mut nodes = Self::place_and_angle(replaced, &[member.0]);
                    nodes.push(pin);
                    self.add(Owner::Joint(id), nodes.clone());
                    self.add(Owner::Joint(id), nodes);
                }
            }
            JointKind::Revolute(_) => {
                let nodes = Self::place_and_angle(replaced, &joint.bodies());
                self.add(Owner::Joint(id), nodes.clone());
                self.add(Owner::Joint(id), nodes);
            }
            JointKind::Prismatic { angle_redundant, .. } => {
                if !angle_redundant {
                    self.add(Owner::Joint(id), Self::angles(replaced, &joint.bodies()));
                }
                self.add(Owner::Joint(id), Self::place_and_angle(replaced, &joint.bodies()));
            }
            JointKind::Law(terms) => {
                let nodes = terms.iter().flat_map(|(rate, _)| match rate {
                    BodyRate::Turn(body) => Self::angles(replaced, &[*body]),
                    BodyRate::Slide(joint) => {
                        Self::place_and_angle(replaced, &replaced.joint(*joint).bodies())
                    }
                });
                self.add(Owner::Joint(id), nodes.collect());
            }
        }
    }

    fn add_effort(&mut self, replaced: &Replaced, index: usize, effort: &Effort) {
        let bodies = effort.bodies(replaced);
        let nodes = match effort.kind {
            EffortKind::Point(_) => return,
            EffortKind::Angle(_) | EffortKind::RelativeAngle { .. } => Self::angles(replaced, &bodies),
            EffortKind::Coordinate(_) | EffortKind::Line(_) => Self::place_and_angle(replaced, &bodies),
        };
        self.add(Owner::Effort(index), nodes);
    }

    /// The body of a node, or the number of bodies plus that of the pin.
    pub(super) fn vertex(&self, node: usize) -> usize {
        if node < 2 * self.bodies { node / 2 } else { node - self.bodies }
    }

    /// What does not match, if anything.
    pub(super) fn defect(&self, replaced: &Replaced, matching: &Matching) -> Option<Defect> {
        let fit = self.fit(matching);
        (fit != Fit::default()).then(|| Defect {
            over: self.part(replaced, matching.overdetermined(&self.conditions)),
            under: self.part(replaced, matching.underdetermined(&self.conditions, &self.capacity)),
            fit,
        })
    }

    fn fit(&self, matching: &Matching) -> Fit {
        Fit {
            missing: self.capacity.iter().zip(&matching.held).map(|(c, held)| c - held.len()).sum(),
            surplus: matching.node_of.iter().filter(|n| n.is_none()).count(),
        }
    }

    fn part(&self, replaced: &Replaced, (conditions, nodes): (Vec<usize>, Vec<usize>)) -> Part {
        let mut part = Part::default();
        let pairs = replaced.joints.iter().map(|j| j.pair.index() + 1).max().unwrap_or(0);
        let mut takes = vec![0_usize; pairs];
        for condition in conditions {
            match self.owners[condition] {
                Owner::Joint(j) => takes[replaced.joint(j).pair.index()] += 1,
                Owner::Effort(e) => part.efforts.push(e),
                Owner::Passive => {}
            }
        }
        let mut seen = vec![false; self.bodies];
        for node in nodes {
            let capacity = self.capacity[node];
            let vertex = self.vertex(node);
            // what pins and imaginary bodies have for themselves is no freedom of the links
            let own = match replaced.bodies.get(vertex).map(|b| b.origin) {
                None => Some(replaced.joint(self.pins[vertex - self.bodies]).pair),
                Some(BodyOrigin::Imaginary(pair)) => Some(pair),
                Some(BodyOrigin::Link(_)) => None,
            };
            match own {
                Some(pair) => takes[pair.index()] = takes[pair.index()].saturating_sub(capacity),
                None => part.freedoms += capacity,
            }
            if vertex < self.bodies && !std::mem::replace(&mut seen[vertex], true) {
                part.bodies.push(BodyId(vertex));
            }
        }
        let taken = takes.into_iter().enumerate().filter(|(_, n)| *n > 0);
        part.pairs = taken.map(|(i, n)| (PairId::at(i), n)).collect();
        part
    }
}

/// What is left over where conditions are matched to freedoms.
pub(super) fn fit(replaced: &Replaced, efforts: &[Effort]) -> Fit {
    let incidence = Incidence::new(replaced, efforts);
    let matching = match_all(&incidence.conditions, &incidence.capacity);
    incidence.fit(&matching)
}
