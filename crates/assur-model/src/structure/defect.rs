//! Which conditions are too many and which freedoms are left, by the rank of the equations of velocity.
//!
//! A condition is one of too many where the others together already say what it says: it is part of a dependency between
//! rows. Dependencies that share a condition form one overconstrained part. A freedom is left where a motion keeps all
//! conditions. The total can agree with both present, so that the count 3n − 2P_L − P_H of the whole decides nothing.

use std::collections::BTreeMap;

use super::echelon::{Echelon, Number, row};
use super::incidence::{Incidence, Owner};
use super::joint::{BodyId, BodyOrigin, JointId, JointKind, Replaced};
use crate::model::PairId;

/// Random numbers of motions begin here.
const MOTIONS: u64 = 1 << 56;

#[derive(Clone, Debug)]
pub(super) struct Defect {
    /// Parts with too many conditions, each overconstrained by itself.
    pub over: Vec<Part>,
    /// Bodies that can still move.
    pub loose: Vec<BodyId>,
    /// How many freedoms and conditions are left over.
    pub fit: Fit,
}

#[derive(Clone, Debug, Default)]
pub(super) struct Part {
    /// Links, the ground among them where a condition touches it.
    pub bodies: Vec<BodyId>,
    /// Pairs as declared, with the number of freedoms each takes.
    pub pairs: Vec<(PairId, usize)>,
    /// Drives or efforts by index: each takes one freedom.
    pub efforts: Vec<usize>,
    /// Freedoms of the links against each other.
    pub freedoms: usize,
    pub surplus: usize,
}

impl Part {
    /// Freedoms that pairs and efforts take.
    pub(super) fn taken(&self) -> usize {
        self.efforts.len() + self.pairs.iter().map(|p| p.1).sum::<usize>()
    }
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Fit {
    /// Freedoms that no condition takes.
    pub missing: usize,
    /// Conditions for which no freedom is left.
    pub surplus: usize,
}

impl Incidence {
    /// What is not determined, if anything.
    pub(super) fn defect(&self, replaced: &Replaced) -> Option<Defect> {
        let echelon = Echelon::of(self.columns(), &self.rows);
        let fit = self.fit_of(&echelon);
        (fit != Fit::default()).then(|| Defect {
            over: self.overconstrained(replaced),
            loose: self.loose(&echelon),
            fit,
        })
    }

    pub(super) fn fit(&self) -> Fit {
        self.fit_of(&Echelon::of(self.columns(), &self.rows))
    }

    fn fit_of(&self, echelon: &Echelon) -> Fit {
        let freedoms: usize = self.capacity.iter().sum();
        Fit { missing: freedoms - echelon.rank(), surplus: self.rows.len() - echelon.rank() }
    }

    /// Bodies that a random motion moves, of all that keep the conditions.
    fn loose(&self, echelon: &Echelon) -> Vec<BodyId> {
        let free = |column: usize| match self.is_freedom(column) {
            true => Number::random(MOTIONS + column as u64),
            false => Number::ZERO,
        };
        self.moved(&echelon.null_vector(free))
    }

    fn moved(&self, velocities: &[Number]) -> Vec<BodyId> {
        (0..self.bodies).filter(|b| is_moved(velocities, *b)).map(BodyId).collect()
    }

    /// Bodies that no drive moves, where everything is determined.
    pub(super) fn unmoved(&self) -> Vec<BodyId> {
        let rates = self.columns();
        let mut echelon = Echelon::new(rates + 1);
        for (owner, terms) in self.owners.iter().zip(&self.rows) {
            // the column of the drives' rates comes first in no row: it is moved below all others
            let mut shifted: Vec<(usize, Number)> = terms.iter().map(|t| (t.0 + 1, t.1)).collect();
            if let Owner::Effort(effort) = owner {
                shifted.push((0, Number::random(MOTIONS + *effort as u64)));
            }
            echelon.add(row(shifted));
        }
        let velocities = echelon.null_vector(|column| match column {
            0 => Number::ONE,
            _ => Number::ZERO,
        });
        let still = |b: &BodyId| !self.is_known(*b) && !is_moved(&velocities[1..], b.0);
        (0..self.bodies).map(BodyId).filter(still).collect()
    }

    fn is_known(&self, body: BodyId) -> bool {
        !self.is_freedom(3 * body.0)
    }

    /// The dependencies between conditions, joined where they share one, or one of a pair.
    fn overconstrained(&self, replaced: &Replaced) -> Vec<Part> {
        let mut part_of: Vec<usize> = (0..self.rows.len()).collect();
        let mut is_dependent = vec![false; self.rows.len()];
        let dependencies = self.dependencies();
        let mut firsts = Vec::new();
        for dependency in &dependencies {
            let mut first = None;
            for condition in (0..self.rows.len()).filter(|c| !dependency[*c].is_zero()) {
                is_dependent[condition] = true;
                let with = root(&part_of, *first.get_or_insert(condition));
                let own = root(&part_of, condition);
                part_of[own.max(with)] = own.min(with);
            }
            firsts.extend(first);
        }
        let pair = |condition: usize| match self.owners[condition] {
            Owner::Joint(joint) => Some(replaced.joint(joint).pair),
            Owner::Effort(_) | Owner::Passive => None,
        };
        let mut first = BTreeMap::new();
        for condition in (0..self.rows.len()).filter(|c| is_dependent[*c]) {
            let Some(pair) = pair(condition) else { continue };
            let with = root(&part_of, *first.entry(pair).or_insert(condition));
            let own = root(&part_of, condition);
            part_of[own.max(with)] = own.min(with);
        }
        let mut parts: Vec<Vec<usize>> = vec![Vec::new(); self.rows.len()];
        for condition in (0..self.rows.len()).filter(|c| is_dependent[*c]) {
            parts[root(&part_of, condition)].push(condition);
        }
        let surplus = |conditions: &[usize]| firsts.iter().filter(|f| conditions.contains(f)).count();
        let parts = parts.iter().filter(|p| !p.is_empty());
        parts.map(|p| Part { surplus: surplus(p), ..self.part(replaced, p) }).collect()
    }

    /// Combinations of rows that are zero, as many as there are conditions too many.
    fn dependencies(&self) -> Vec<Vec<Number>> {
        let mut transposed = vec![Vec::new(); self.columns()];
        for (condition, terms) in self.rows.iter().enumerate() {
            terms.iter().for_each(|t| transposed[t.0].push((condition, t.1)));
        }
        let transposed: Vec<_> = transposed.into_iter().map(row).collect();
        let echelon = Echelon::of(self.rows.len(), &transposed);
        let free = (0..self.rows.len()).filter(|c| echelon.is_free(*c));
        let unit = |at: usize| move |c: usize| if c == at { Number::ONE } else { Number::ZERO };
        free.map(|f| echelon.null_vector(unit(f))).collect()
    }

    /// The links and pairs of some conditions. Imaginary bodies count with the higher pair that they replace.
    fn part(&self, replaced: &Replaced, conditions: &[usize]) -> Part {
        let mut bodies: Vec<BodyId> = Vec::new();
        let mut pairs: Vec<PairId> = Vec::new();
        let mut part = Part::default();
        let mut passive = 0;
        for &condition in conditions {
            match self.owners[condition] {
                Owner::Joint(joint) => {
                    pairs.push(replaced.joint(joint).pair);
                    bodies.extend(self.bodies_of(replaced, condition, joint));
                }
                Owner::Effort(effort) => {
                    part.efforts.push(effort);
                    bodies.extend(self.touched(condition));
                }
                Owner::Passive => passive += 1,
            }
        }
        pairs.sort_unstable();
        pairs.dedup();
        for joint in replaced.joints.iter().filter(|j| pairs.contains(&j.pair) && !is_pin(&j.kind)) {
            bodies.extend(joint.bodies());
        }
        bodies.sort_unstable();
        bodies.dedup();
        bodies.retain(|b| matches!(replaced.bodies[b.0].origin, BodyOrigin::Link(_)));
        part.pairs = pairs.iter().map(|&pair| (pair, taken(replaced, pair, &bodies))).collect();
        let moving = bodies.iter().filter(|b| !self.is_known(**b)).count();
        // without the ground they can move together
        let together = if moving == bodies.len() { 3 } else { 0 };
        part.freedoms = (3 * moving).saturating_sub(together + passive);
        part.bodies = bodies;
        part
    }

    /// The bodies that a condition of a joint speaks of: of a pin of many links the one member.
    fn bodies_of(&self, replaced: &Replaced, condition: usize, joint: JointId) -> Vec<BodyId> {
        let bodies = replaced.joint(joint).bodies();
        if !is_pin(&replaced.joint(joint).kind) {
            return bodies;
        }
        let own = |o: &Owner| *o == Owner::Joint(joint);
        let first = self.owners.iter().position(own).unwrap_or(condition);
        vec![bodies[(condition - first) / 2]]
    }

    /// The bodies in which the row of a condition has a coefficient; the ground where there is but one.
    fn touched(&self, condition: usize) -> Vec<BodyId> {
        let mut bodies: Vec<BodyId> = self.rows[condition].iter().filter_map(|t| self.body(t.0)).collect();
        bodies.dedup();
        if bodies.len() == 1 {
            bodies.push(BodyId::GROUND);
        }
        bodies
    }
}

fn is_moved(velocities: &[Number], body: usize) -> bool {
    velocities[3 * body..3 * body + 3].iter().any(|x| !x.is_zero())
}

/// A revolute joint of more than two links.
fn is_pin(kind: &JointKind) -> bool {
    matches!(kind, JointKind::Revolute(members) if members.len() > 2)
}

/// Freedoms that a pair takes from some links against each other.
fn taken(replaced: &Replaced, pair: PairId, bodies: &[BodyId]) -> usize {
    let of_pair = replaced.joints.iter().filter(|j| j.pair == pair);
    let conditions = of_pair.map(|joint| match &joint.kind {
        JointKind::Revolute(members) if members.len() > 2 => {
            2 * members.iter().filter(|m| bodies.contains(&m.0)).count().saturating_sub(1)
        }
        JointKind::Revolute(members) => 2 * members.len().saturating_sub(1),
        JointKind::Prismatic { angle_redundant, .. } => 2 - usize::from(*angle_redundant),
        JointKind::Weld { .. } => 0,
        JointKind::Law(_) => 1,
    });
    let conditions: usize = conditions.sum();
    let imaginary = replaced.bodies.iter().filter(|b| b.origin == BodyOrigin::Imaginary(pair)).count();
    conditions.saturating_sub(3 * imaginary)
}

fn root(part_of: &[usize], mut at: usize) -> usize {
    while part_of[at] != at {
        at = part_of[at];
    }
    at
}
