//! Structural groups: what belongs to one, and which kind it is.

use super::effort::{Effort, EffortKind};
use super::joint::{BodyId, GroupJoint, JointId, JointKind, Replaced};
use crate::model::LinkId;

/// A structural group: bodies that are solved together.
#[derive(Clone, Debug)]
pub struct Group {
    /// The name given by a `group` statement.
    pub name: Option<String>,
    /// Its bodies; those of a dyad in the order of its kind.
    pub bodies: Vec<BodyId>,
    /// Its joints; those of a dyad in the order outer, inner, outer.
    pub joints: Vec<GroupJoint>,
    /// Drives or efforts inside it: indices into [`super::Structure::drives`] or `efforts`.
    pub efforts: Vec<usize>,
    /// Laws inside it; on the side of forces, those whose multipliers are found in it.
    pub laws: Vec<JointId>,
    pub kind: GroupKind,
    /// Class after Artobolevsky: I for a driven link, II for a dyad, III and higher for the rest.
    pub class: u8,
    /// Order: the number of outer joints.
    pub order: usize,
}

/// What belongs to a group beside its bodies and joints.
#[derive(Clone, Debug, Default)]
pub(super) struct Inside {
    pub efforts: Vec<usize>,
    pub laws: Vec<JointId>,
}

/// How a group is solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GroupKind {
    /// One body with a lower pair and a drive (an effort).
    Driven,
    /// One body without pairs that drives or starts place: a point of it, and its angle.
    Free,
    /// Two bodies and three lower pairs.
    Dyad(Dyad),
    /// A dyad RRR or RRP one or two of whose links are pairs of bodies with a driven joint (an effort) between them, as
    /// barrel and rod of a cylinder. Bodies: the two that carry the outer joints, then the far halves; joints: outer,
    /// inner, outer, then the driven ones, each counted on the far half.
    DrivenLegs(Dyad),
    /// One body between two prismatic pairs, its angle fixed by either.
    Translation,
    /// Bodies each on one revolute or prismatic pair, moved by laws between their rates. Bodies in an order in which each
    /// stands on one before it or outside; joints in the same order.
    Train,
    /// A link with three revolutes to bodies each of which depends on one outer pair, at least one of these a revolute.
    /// Joints: outer, outer, outer, inner, inner, inner, leg by leg, those with an outer revolute first.
    Triad,
    /// Anything else, laws of wheels together with closed chains of links among it.
    General,
}

/// The five dyads, by outer, inner and outer pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dyad {
    Rrr,
    Rrp,
    Rpr,
    Prp,
    /// Inner and one outer prismatic.
    Rpp,
}

impl Dyad {
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rrr => "RRR",
            Self::Rrp => "RRP",
            Self::Rpr => "RPR",
            Self::Prp => "PRP",
            Self::Rpp => "RPP",
        }
    }
}

impl Group {
    /// Names the kind and puts bodies and joints in the order of the kind.
    pub(super) fn new(
        bodies: Vec<BodyId>,
        joints: Vec<GroupJoint>,
        Inside { efforts, laws }: Inside,
        all_efforts: &[Effort],
        replaced: &Replaced,
    ) -> Self {
        let order = joints.iter().filter(|j| !j.inner).count();
        let class = super::count::class(&bodies, &joints, &efforts);
        let mut group =
            Self { name: None, bodies, joints, efforts, laws, kind: GroupKind::General, class, order };
        if !group.laws.is_empty() {
            if group.arrange_train(all_efforts, replaced).is_some() {
                group.kind = GroupKind::Train;
            }
            group.order += group.outer_laws(replaced);
            group.class = group.class.max(2);
        } else if group.is_driven(all_efforts, replaced) {
            group.kind = GroupKind::Driven;
        } else if group.is_free(all_efforts) {
            group.kind = GroupKind::Free;
        } else if group.is_translation(replaced) {
            group.kind = GroupKind::Translation;
        } else if let Some(dyad) = group.arrange_dyad(replaced) {
            group.kind = GroupKind::Dyad(dyad);
        } else if let Some(dyad) = group.arrange_driven_legs(all_efforts, replaced) {
            group.kind = GroupKind::DrivenLegs(dyad);
            group.class = 2;
        } else if group.arrange_triad(replaced) {
            group.kind = GroupKind::Triad;
        }
        group
    }

    fn is_driven(&self, efforts: &[Effort], replaced: &Replaced) -> bool {
        let ([_], [joint], [effort]) =
            (self.bodies.as_slice(), self.joints.as_slice(), self.efforts.as_slice())
        else {
            return false;
        };
        if let JointKind::Prismatic { offset, .. } = replaced.joint(joint.joint).kind
            && offset > 0.0
        {
            return false;
        }
        match efforts[*effort].only() {
            Some(EffortKind::Angle(_)) => !joint.prismatic,
            Some(EffortKind::RelativeAngle { joint: j, .. } | EffortKind::Coordinate(j)) => j == joint.joint,
            Some(EffortKind::Line(_)) => true,
            Some(EffortKind::Point(_) | EffortKind::Place(..)) | None => false,
        }
    }

    /// On the side of motion: both coordinates of one point, and the angle unless it turns nothing.
    fn is_free(&self, efforts: &[Effort]) -> bool {
        let mut points = self.efforts.iter().filter_map(|&effort| match efforts[effort].kind {
            EffortKind::Place(_, at, _) => Some(at),
            _ => None,
        });
        let is_angle = |effort: &usize| {
            matches!(efforts[*effort].kind, EffortKind::Angle(_)) && !efforts[*effort].is_aside()
        };
        let angles = self.efforts.iter().filter(|effort| is_angle(effort)).count();
        let one_point = points.next().is_some_and(|first| points.next() == Some(first));
        self.bodies.len() == 1 && self.joints.is_empty() && one_point && self.efforts.len() == 2 + angles
    }

    fn is_translation(&self, replaced: &Replaced) -> bool {
        let ([_], [a, b], []) = (self.bodies.as_slice(), self.joints.as_slice(), self.efforts.as_slice())
        else {
            return false;
        };
        let redundant = |j: &GroupJoint| {
            matches!(replaced.joint(j.joint).kind, JointKind::Prismatic { angle_redundant: true, .. })
        };
        a.prismatic && b.prismatic && (redundant(a) || redundant(b))
    }

    fn arrange_dyad(&mut self, replaced: &Replaced) -> Option<Dyad> {
        if self.bodies.len() != 2 || self.joints.len() != 3 || !self.efforts.is_empty() {
            return None;
        }
        let redundant = |j: &GroupJoint| {
            matches!(replaced.joint(j.joint).kind, JointKind::Prismatic { angle_redundant: true, .. })
        };
        if self.joints.iter().any(redundant) {
            return None;
        }
        let inner = *self.joints.iter().find(|j| j.inner)?;
        let outer: Vec<GroupJoint> = self.joints.iter().filter(|j| !j.inner).copied().collect();
        let [mut first, mut second] = outer.try_into().ok()?;
        if first.body == second.body {
            return None;
        }
        if first.prismatic && !second.prismatic {
            std::mem::swap(&mut first, &mut second);
        }
        let dyad = match (first.prismatic, inner.prismatic, second.prismatic) {
            (false, false, false) => Dyad::Rrr,
            (false, false, true) => Dyad::Rrp,
            (false, true, false) => Dyad::Rpr,
            (true, false, true) => Dyad::Prp,
            (false, true, true) => Dyad::Rpp,
            _ => return None,
        };
        self.bodies = vec![first.body, second.body];
        self.joints = vec![first, inner, second];
        Some(dyad)
    }

    /// Takes the driven joints out, each with the body after it, and looks whether a dyad is left.
    fn arrange_driven_legs(&mut self, efforts: &[Effort], replaced: &Replaced) -> Option<Dyad> {
        let driven: Vec<JointId> = self
            .efforts
            .iter()
            .map(|&e| match efforts[e].only()? {
                EffortKind::RelativeAngle { joint, .. } | EffortKind::Coordinate(joint) => Some(joint),
                EffortKind::Angle(_) | EffortKind::Line(_) | EffortKind::Point(_) | EffortKind::Place(..) => {
                    None
                }
            })
            .collect::<Option<_>>()?;
        let (inside, rest): (Vec<GroupJoint>, Vec<GroupJoint>) =
            self.joints.iter().partition(|j| driven.contains(&j.joint));
        if driven.is_empty() || inside.len() != driven.len() || inside.iter().any(|j| !j.inner) {
            return None;
        }
        let (outer, inner): (Vec<GroupJoint>, Vec<GroupJoint>) = rest.iter().partition(|j| !j.inner);
        let ([first, second], [middle]) = (outer.as_slice(), inner.as_slice()) else { return None };
        let simple = |j: &GroupJoint| match replaced.joint(j.joint).kind {
            JointKind::Prismatic { angle_redundant, offset, .. } => !angle_redundant && offset == 0.0,
            JointKind::Revolute(_) | JointKind::Weld { .. } | JointKind::Law(_) => true,
        };
        if middle.prismatic || first.prismatic && second.prismatic || !self.joints.iter().all(simple) {
            return None;
        }
        let (first, second) = if first.prismatic { (second, first) } else { (first, second) };
        let mut bodies = vec![first.body, second.body];
        let mut joints = vec![*first, *middle, *second];
        for joint in inside {
            let root = bodies.iter().take(2).copied().find(|b| [joint.body, joint.base].contains(b))?;
            let far = if joint.body == root { joint.base } else { joint.body };
            if bodies.contains(&far) || second.prismatic && root == second.body {
                return None;
            }
            bodies.push(far);
            joints.push(GroupJoint { body: far, base: root, ..joint });
        }
        let ends = [middle.body, middle.base];
        let holds = |root: BodyId| {
            let far = joints[3..].iter().find(|j| j.base == root).map(|j| j.body);
            ends.contains(&far.unwrap_or(root))
        };
        let complete = bodies.len() == self.bodies.len() && first.body != second.body;
        if !complete || !holds(first.body) || !holds(second.body) {
            return None;
        }
        let dyad = if second.prismatic { Dyad::Rrp } else { Dyad::Rrr };
        self.bodies = bodies;
        self.joints = joints;
        Some(dyad)
    }

    /// Whether it is a dyad of a link and a block, and nothing else.
    #[must_use]
    pub fn is_dyad_of(&self, link: LinkId, block: usize) -> bool {
        let mut others = self.bodies.iter().filter(|b| b.0 != block);
        matches!(self.kind, GroupKind::Dyad(_))
            && others.next().is_some_and(|b| b.0 == link.index())
            && others.next().is_none()
    }

    /// How many laws join the group to bodies outside it.
    fn outer_laws(&self, replaced: &Replaced) -> usize {
        let outer = |law: &&JointId| match &replaced.joint(**law).kind {
            JointKind::Law(terms) => {
                let bodies = replaced.bodies_of_law(terms);
                bodies.iter().any(|b| !self.bodies.contains(b))
            }
            _ => false,
        };
        self.laws.iter().filter(outer).count()
    }

    /// Puts bodies and joints in an order in which each body stands by its one joint on the ground, on a body outside, or
    /// on one before it. `None` where they form a closed chain, or where an effort acts along a line that turns.
    fn arrange_train(&mut self, efforts: &[Effort], replaced: &Replaced) -> Option<()> {
        let simple = |j: &GroupJoint| match replaced.joint(j.joint).kind {
            JointKind::Prismatic { offset, angle_redundant, guide, .. } => {
                offset == 0.0 && !angle_redundant && (guide == j.base || guide == j.body)
            }
            JointKind::Revolute(_) | JointKind::Weld { .. } | JointKind::Law(_) => true,
        };
        let constant = |e: &usize| {
            !matches!(
                efforts[*e].only(),
                None | Some(EffortKind::Line(_) | EffortKind::Point(_) | EffortKind::Place(..))
            )
        };
        if self.joints.len() != self.bodies.len()
            || !self.joints.iter().all(simple)
            || !self.efforts.iter().all(constant)
        {
            return None;
        }
        let mut left = std::mem::take(&mut self.joints);
        let mut placed: Vec<BodyId> = Vec::new();
        while !left.is_empty() {
            let stands = |b: BodyId| !self.bodies.contains(&b) || placed.contains(&b);
            let next = left.iter().position(|j| stands(j.base) != stands(j.body));
            let Some(next) = next else {
                self.joints.extend(left);
                return None;
            };
            let mut joint = left.remove(next);
            if stands(joint.body) {
                std::mem::swap(&mut joint.body, &mut joint.base);
            }
            // sliders measure from a guide that does not turn with the train
            if joint.prismatic && self.bodies.contains(&joint.base) {
                self.joints.push(joint);
                self.joints.extend(left);
                return None;
            }
            placed.push(joint.body);
            self.joints.push(joint);
        }
        self.bodies = placed;
        Some(())
    }

    /// Looks whether three legs carry one body by revolutes.
    fn arrange_triad(&mut self, replaced: &Replaced) -> bool {
        let (inner, mut outer): (Vec<GroupJoint>, Vec<GroupJoint>) =
            self.joints.iter().partition(|j| j.inner);
        let shape = (self.bodies.len(), inner.len(), outer.len(), self.efforts.len());
        let simple = |j: &GroupJoint| match replaced.joint(j.joint).kind {
            JointKind::Prismatic { angle_redundant, offset, .. } => !angle_redundant && offset == 0.0,
            JointKind::Revolute(_) => true,
            JointKind::Weld { .. } | JointKind::Law(_) => false,
        };
        if shape != (4, 3, 3, 0) || inner.iter().any(|j| j.prismatic) || !outer.iter().all(simple) {
            return false;
        }
        outer.sort_by_key(|j| j.prismatic);
        let legs: Vec<BodyId> = outer.iter().map(|j| j.body).collect();
        let Some(&plate) = self.bodies.iter().find(|b| !legs.contains(b)) else { return false };
        let holds = |leg: BodyId| {
            inner.iter().copied().find(|j| [[leg, plate], [plate, leg]].contains(&[j.body, j.base]))
        };
        let held: Vec<GroupJoint> = legs.iter().filter_map(|&leg| holds(leg)).collect();
        let apart = legs[0] != legs[1] && legs[1] != legs[2] && legs[2] != legs[0];
        if held.len() != 3 || !apart || outer[0].prismatic {
            return false;
        }
        self.joints = [outer, held].concat();
        true
    }

    /// The kind as it is printed: `RRR`, `driven`, `translation`, `triad`, `general`.
    #[must_use]
    pub fn kind_name(&self) -> &'static str {
        match self.kind {
            GroupKind::Driven => "driven",
            GroupKind::Free => "free",
            GroupKind::Dyad(dyad) => dyad.name(),
            GroupKind::DrivenLegs(dyad) => dyad.name(),
            GroupKind::Translation => "PP",
            GroupKind::Train => "train",
            GroupKind::Triad => "triad",
            GroupKind::General => "general",
        }
    }

    /// The class in Roman figures.
    #[must_use]
    pub const fn class_name(&self) -> &'static str {
        const ROMAN: [&str; 10] = ["0", "I", "II", "III", "IV", "V", "VI", "VII", "VIII", "IX"];
        if (self.class as usize) < ROMAN.len() { ROMAN[self.class as usize] } else { "X or higher" }
    }
}
