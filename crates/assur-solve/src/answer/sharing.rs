//! Which reactions are open where pairs share by friction what one of them could hold: those of links that hang together with
//! such a pair. The ground bears whatever comes, so that chains which only the ground joins have nothing to do with each other.

use super::PoseAnswers;
use crate::model::PairId;
use crate::structure::{BodyId, BodyRate, EffortKind, JointKind, Structure};

impl PoseAnswers<'_> {
    /// Whether the reaction of a pair depends on how others share what friction holds.
    #[must_use]
    pub fn shares_friction(&self, pair: PairId) -> bool {
        if !self.state.friction_shares() {
            return false;
        }
        let joints = self.structure.replaced.joints_of(pair);
        let bodies: Vec<usize> = joints
            .flat_map(|joint| bodies_of(self.structure, &self.structure.replaced.joint(joint).kind))
            .collect();
        self.shares_friction_among(&bodies)
    }

    /// Whether the forces on a body do.
    #[must_use]
    pub fn shares_friction_on(&self, body: usize) -> bool {
        self.state.friction_shares() && self.shares_friction_among(&[body])
    }

    fn shares_friction_among(&self, bodies: &[usize]) -> bool {
        let chains = Chains::of(self.structure);
        let elements = self.plan.friction.iter().zip(&self.state.motion.grips).filter(|(_, grip)| grip.open);
        let open: Vec<usize> = elements
            .flat_map(|(e, _)| [e.body, e.base, e.through])
            .filter_map(|b| chains.of_body(b))
            .collect();
        bodies.iter().filter_map(|b| chains.of_body(*b)).any(|chain| open.contains(&chain))
    }
}

/// Bodies that pairs and efforts join without the ground: one number for each chain.
struct Chains {
    above: Vec<usize>,
}

impl Chains {
    fn of(structure: &Structure) -> Self {
        let mut chains = Self { above: (0..structure.replaced.bodies.len()).collect() };
        for joint in &structure.replaced.joints {
            chains.join(&bodies_of(structure, &joint.kind));
        }
        for effort in &structure.efforts {
            let bodies: Vec<usize> =
                effort.places().flat_map(|kind| bodies_of_effort(structure, kind)).collect();
            chains.join(&bodies);
        }
        chains
    }

    fn join(&mut self, bodies: &[usize]) {
        let mut chains = bodies.iter().filter_map(|body| self.of_body(*body)).collect::<Vec<_>>().into_iter();
        let Some(first) = chains.next() else { return };
        chains.for_each(|chain| self.above[chain] = first);
    }

    /// The chain of a body; the ground has none.
    fn of_body(&self, body: usize) -> Option<usize> {
        let mut chain = body;
        while self.above[chain] != chain {
            chain = self.above[chain];
        }
        (body != 0).then_some(chain)
    }
}

fn bodies_of(structure: &Structure, kind: &JointKind) -> Vec<usize> {
    match kind {
        JointKind::Revolute(members) => members.iter().map(|(body, _)| body.0).collect(),
        JointKind::Prismatic { slider, guide, .. } => vec![slider.0, guide.0],
        JointKind::Weld { part, base, .. } => vec![part.0, base.0],
        JointKind::Law(terms) => terms
            .iter()
            .flat_map(|(rate, _)| match rate {
                BodyRate::Turn(body) => vec![body.0],
                BodyRate::Slide(joint) => bodies_of(structure, &structure.replaced.joint(*joint).kind),
            })
            .collect(),
    }
}

fn bodies_of_effort(structure: &Structure, kind: EffortKind) -> Vec<usize> {
    match kind {
        EffortKind::Angle(BodyId(body))
        | EffortKind::Line(BodyId(body))
        | EffortKind::Point(BodyId(body))
        | EffortKind::Place(BodyId(body), ..) => {
            vec![body]
        }
        EffortKind::RelativeAngle { first, second, .. } => vec![first.0, second.0],
        EffortKind::Coordinate(joint) => bodies_of(structure, &structure.replaced.joint(joint).kind),
    }
}
