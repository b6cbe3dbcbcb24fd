//! Trusses by the method of joints: pins in an order in which each has at most two unknown forces.

use crate::angle::Angle;
use crate::course::Derivation;
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_model::model::{LinkId, LoadId, LoadKind, PairId, PairKind, Place};
use assur_picture::Kind;
use assur_position::position::Origin;

/// Two directions whose sine is below this are one line.
const ONE_LINE: f64 = 1e-6;

/// A force on the pin of a joint that is sought.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Sought {
    /// A bar, which pulls from its hinge in this joint to its other one.
    Bar(LinkId, [PairId; 2]),
    /// A part of the force of a hinge on the ground: along x (0) or y (1).
    Support(PairId, usize),
    /// The force of a line of the ground on the pin in its slot.
    Roller(PairId),
}

/// A pin with all that acts on it.
#[derive(Debug)]
struct Joint {
    pair: PairId,
    /// A link that ends here, and the place on it.
    at: (LinkId, Vec2),
    forces: Vec<Sought>,
    loads: Vec<LoadId>,
}

impl Joint {
    fn is_fixed(&self) -> bool {
        self.forces.iter().any(|force| matches!(force, Sought::Support(..)))
    }
}

/// One step: the joint, and what its equilibrium gives; or the equilibrium of all bars together.
enum Step {
    Whole { fixed: usize, roller: usize },
    Joint(usize, Vec<Sought>),
}

impl Derivation<'_> {
    /// The forces of a truss; false where the mechanism is none, or has no joint to go on with.
    pub(super) fn truss(&mut self) -> bool {
        let Some(joints) = self.joints() else { return false };
        let Some(steps) = self.order(&joints) else { return false };
        self.say(Message::MethodOfJoints, &[]);
        for step in steps {
            match step {
                Step::Whole { fixed, roller } => self.whole_truss(&joints, fixed, roller),
                Step::Joint(joint, sought) => self.joint_balance(&joints[joint], &sought),
            }
        }
        let picture = self.pictures(Kind::Axial, Message::AxialForces, "");
        self.cite(Message::SeeAxial, &picture);
        self.figures(picture);
        true
    }

    /// The pins of a mechanism whose links are bars on which nothing acts but loads at their pins.
    fn joints(&self) -> Option<Vec<Joint>> {
        let mechanism = self.scene.mechanism();
        let heavy = mechanism.links.iter().any(|link| link.mass.is_some());
        let others = !mechanism.springs.is_empty() || !mechanism.balances.is_empty() || heavy;
        if mechanism.bars.is_empty() || mechanism.bars.len() + 1 != mechanism.links.len() || others {
            return None;
        }
        self.scene.model.plan.friction.is_empty().then_some(())?;
        let mut joints: Vec<Joint> = Vec::new();
        for (i, pair) in mechanism.pairs.iter().enumerate() {
            let pair_id = PairId::at(i);
            let PairKind::Revolute(pins) = &pair.kind else { continue };
            let mut forces = Vec::new();
            for bar in &mechanism.bars {
                let others = [[bar.from, bar.to], [bar.to, bar.from]];
                forces.extend(
                    others
                        .into_iter()
                        .find(|ends| ends[0] == pair_id)
                        .map(|ends| Sought::Bar(bar.link, ends)),
                );
            }
            // a bar that a second hinge holds in the same place
            let bars = pins.iter().filter(|pin| pin.link != LinkId::GROUND).count();
            (forces.len() == bars).then_some(())?;
            if pins.iter().any(|pin| pin.link == LinkId::GROUND) {
                forces.extend([0, 1].map(|i| Sought::Support(pair_id, i)));
            }
            let at = pins.iter().find(|pin| pin.link != LinkId::GROUND).map(|pin| (pin.link, pin.at))?;
            joints.push(Joint { pair: pair_id, at, forces, loads: Vec::new() });
        }
        let joint_of = |joints: &[Joint], link: LinkId, at: Vec2| {
            joints.iter().position(|joint| mechanism.point_in(joint.pair, link) == Some(at))
        };
        for (i, pair) in mechanism.pairs.iter().enumerate() {
            if let PairKind::Slot(slot) = &pair.kind {
                (slot.guide == LinkId::GROUND).then_some(())?;
                let joint = joint_of(&joints, slot.slider, slot.point)?;
                joints[joint].forces.push(Sought::Roller(PairId::at(i)));
            }
        }
        for (i, load) in mechanism.loads.iter().enumerate() {
            let LoadKind::Force { on, at: Place::Local(at), .. } = &load.kind else { return None };
            (*on != LinkId::GROUND).then_some(())?;
            let joint = joint_of(&joints, *on, *at)?;
            joints[joint].loads.push(LoadId::at(i));
        }
        Some(joints)
    }

    /// Joints with at most two unknown forces, one after another; the truss as a whole where no joint is left that has so few.
    fn order(&self, joints: &[Joint]) -> Option<Vec<Step>> {
        let same = |a: &Sought, b: &Sought| match (a, b) {
            (Sought::Bar(one, _), Sought::Bar(other, _)) => one == other,
            _ => a == b,
        };
        let mut known: Vec<Sought> = Vec::new();
        let mut steps = Vec::new();
        let mut whole = false;
        loop {
            let unknown = |joint: &Joint| -> Vec<Sought> {
                joint.forces.iter().filter(|force| !known.iter().any(|k| same(k, force))).copied().collect()
            };
            let open: Vec<(usize, Vec<Sought>)> =
                joints.iter().map(unknown).enumerate().filter(|(_, u)| !u.is_empty()).collect();
            if open.is_empty() {
                return Some(steps);
            }
            let next = open.into_iter().find(|(_, sought)| match sought.as_slice() {
                [_] => true,
                [a, b] => self.direction(a).cross(self.direction(b)).abs() > ONE_LINE,
                _ => false,
            });
            match next {
                Some((joint, sought)) => {
                    known.extend(&sought);
                    steps.push(Step::Joint(joint, sought));
                }
                None if !whole => {
                    whole = true;
                    let (fixed, roller) = self.hinge_and_roller(joints)?;
                    known.extend(joints[fixed].forces.iter().filter(|f| matches!(f, Sought::Support(..))));
                    known.extend(joints[roller].forces.iter().filter(|f| matches!(f, Sought::Roller(_))));
                    steps.push(Step::Whole { fixed, roller });
                }
                None => return None,
            }
        }
    }

    /// The joints of one hinge and one roller that carry the truss.
    fn hinge_and_roller(&self, joints: &[Joint]) -> Option<(usize, usize)> {
        let fixed: Vec<usize> = (0..joints.len()).filter(|i| joints[*i].is_fixed()).collect();
        let rollers = |joint: &Joint| joint.forces.iter().filter(|f| matches!(f, Sought::Roller(_))).count();
        let rolling: Vec<usize> = (0..joints.len()).filter(|i| rollers(&joints[*i]) > 0).collect();
        let ([fixed], [roller]) = (fixed.as_slice(), rolling.as_slice()) else { return None };
        (rollers(&joints[*roller]) == 1 && fixed != roller).then_some((*fixed, *roller))
    }

    /// Where the force of this name pulls the pin, in ground axes.
    fn direction(&self, sought: &Sought) -> Vec2 {
        match sought {
            Sought::Bar(link, ends) => {
                let [from, to] = self.ends(*link, *ends);
                (to - from).turned(self.moved(link.index()).u) / (to - from).norm()
            }
            Sought::Support(_, 0) => Vec2::new(1.0, 0.0),
            Sought::Support(..) => Vec2::new(0.0, 1.0),
            Sought::Roller(pair) => self.normal(*pair),
        }
    }

    fn ends(&self, link: LinkId, ends: [PairId; 2]) -> [Vec2; 2] {
        ends.map(|pair| self.scene.mechanism().point_in(pair, link).unwrap_or_default())
    }

    fn normal(&self, pair: PairId) -> Vec2 {
        match &self.scene.mechanism().pair(pair).kind {
            PairKind::Slot(slot) => slot.along.perp(),
            _ => Vec2::zero(),
        }
    }

    /// Its angle, its letters, and its value.
    fn sought_letters(&self, sought: &Sought) -> (Angle, Name, f64) {
        let mechanism = self.scene.mechanism();
        let view = self.scene.view();
        match sought {
            Sought::Bar(link, ends) => {
                let [from, to] = self.ends(*link, *ends);
                let name = Name::new("N", &self.label(link.index()));
                (self.line_of(link.index(), from, to).1, name, view.axial(*link))
            }
            Sought::Support(pair, i) => {
                let name = Name::new(["X", "Y"][*i], &mechanism.pair(*pair).name);
                let force = -view.reaction(*pair, LinkId::GROUND);
                let angle = self.direction_given(self.direction(sought), || name.clone());
                (angle, name, [force.x, force.y][*i])
            }
            Sought::Roller(pair) => {
                let name = &mechanism.pair(*pair).name;
                let normal = self.normal(*pair);
                let angle = self.direction_given(normal, || Name::new("β", name));
                let force = -view.reaction(*pair, LinkId::GROUND).dot(normal);
                (angle, Name::new("R", name), force)
            }
        }
    }

    /// The equilibrium of a pin.
    fn joint_balance(&mut self, joint: &Joint, sought: &[Sought]) {
        let point = self.point_name(joint.at.0.index(), joint.at.1);
        self.say(Message::JointOf, &[vec![text(point.clone())]]);
        let mut sum = self.loads_of(joint);
        for force in joint.forces.iter().filter(|force| !sought.contains(force)) {
            let (angle, name, _) = self.sought_letters(force);
            let Some(known) = self.found.get(&name).cloned() else { continue };
            sum[0] = sum[0].clone() + known.clone() * angle.cos();
            sum[1] = sum[1].clone() + known * angle.sin();
        }
        let [x, y] = sum;
        let q = Name::new("Q", &point);
        let (vx, vy) = (x.value(), y.value());
        let q_parts =
            [self.component(q.and("x"), vx, Unit::Force, x), self.component(q.and("y"), vy, Unit::Force, y)];
        let begun = self.blocks.len();
        match sought {
            [Sought::Support(..), Sought::Support(..)] => {
                for (force, q) in sought.iter().zip(q_parts.clone()) {
                    let (_, name, value) = self.sought_letters(force);
                    self.equate(name, value, Unit::Force, -q);
                }
            }
            [one] => {
                let (angle, name, value) = self.sought_letters(one);
                self.equate(name, value, Unit::Force, -angle.along(&q_parts));
            }
            [one, two] => {
                let (p, name, value) = self.sought_letters(one);
                let (q, second, other) = self.sought_letters(two);
                let between = p.minus(&q);
                let first = self.equate(name, value, Unit::Force, -(q.across(&q_parts) / between.sin()));
                let right = -(first * between.cos()) - q.along(&q_parts);
                self.equate(second, other, Unit::Force, right);
            }
            _ => {}
        }
        let mut sums = q_parts;
        for force in sought {
            let (angle, name, _) = self.sought_letters(force);
            let Some(found) = self.found.get(&name).cloned() else { continue };
            let [x, y] = sums;
            sums = [x + found.clone() * angle.cos(), y + found * angle.sin()];
        }
        for (axis, sum) in ["y", "x"].into_iter().zip(sums.iter().rev()) {
            self.balanced(begun, &Name::new("ΣF", axis), sum);
        }
    }

    /// The loads on a pin.
    fn loads_of(&self, joint: &Joint) -> [Expr; 2] {
        let of = |i: usize| {
            let forces = self.free.forces.iter().flatten();
            let own =
                forces.filter(|force| joint.loads.iter().any(|load| force.from == Some(Origin::Load(*load))));
            Expr::sum(own.map(|force| force.parts[i].clone()))
        };
        [of(0), of(1)]
    }

    /// The forces of the supports, from the equilibrium of all bars together.
    fn whole_truss(&mut self, joints: &[Joint], fixed: usize, roller: usize) {
        let hinge = joints[fixed].at;
        let point = self.point_name(hinge.0.index(), hinge.1);
        self.say(Message::WholeTruss, &[vec![text(&*point)]]);
        let mut moment = Expr::ZERO;
        let mut sum = [Expr::ZERO, Expr::ZERO];
        for joint in joints.iter().filter(|joint| !joint.loads.is_empty()) {
            let [x, y] = self.arm_from(hinge, joint.at);
            let [fx, fy] = self.loads_of(joint);
            moment = moment + x * fy.clone() - y * fx.clone();
            sum = [sum[0].clone() + fx, sum[1].clone() + fy];
        }
        let Some(force) = joints[roller].forces.iter().find(|f| matches!(f, Sought::Roller(_))) else {
            return;
        };
        let (angle, name, value) = self.sought_letters(force);
        let arm = self.arm_from(hinge, joints[roller].at);
        let lever = arm[0].clone() * angle.sin() - arm[1].clone() * angle.cos();
        let begun = self.blocks.len();
        let found = self.equate(name, value, Unit::Force, -(moment.clone() / lever.clone()));
        self.balanced(begun, &Name::new("ΣM", &point), &(moment + found.clone() * lever));
        let parts = [found.clone() * angle.cos(), found * angle.sin()];
        let supports = joints[fixed].forces.iter().filter(|f| matches!(f, Sought::Support(..)));
        for (((support, sum), part), axis) in supports.zip(sum).zip(parts).zip(["x", "y"]) {
            let (_, name, value) = self.sought_letters(support);
            let begun = self.blocks.len();
            let found = self.equate(name, value, Unit::Force, -sum.clone() - part.clone());
            self.balanced(begun, &Name::new("ΣF", axis), &(found + sum + part));
        }
    }

    /// The way from one pin to another.
    fn arm_from(&mut self, from: (LinkId, Vec2), to: (LinkId, Vec2)) -> [Expr; 2] {
        let [x0, y0] = self.position(from.0.index(), from.1);
        let [x, y] = self.position(to.0.index(), to.1);
        [x - x0, y - y0]
    }

    /// The force of a pin of a truss on a bar or on the ground, from the forces of its joint.
    pub(crate) fn reaction_in_truss(&self, pair: PairId, link: LinkId) -> Option<[Expr; 2]> {
        let mut forces = Vec::new();
        let of = |sought: Sought| {
            let (angle, name, _) = self.sought_letters(&sought);
            let force = self.found.get(&name)?.clone();
            Some([force.clone() * angle.cos(), force * angle.sin()])
        };
        match &self.scene.mechanism().pair(pair).kind {
            PairKind::Slot(slot) if slot.guide == LinkId::GROUND => forces.push(of(Sought::Roller(pair))?),
            PairKind::Revolute(_) if link == LinkId::GROUND => {
                forces.push(of(Sought::Support(pair, 0))?);
                forces.push(of(Sought::Support(pair, 1))?);
            }
            PairKind::Revolute(_) => {
                let bar = self.scene.mechanism().bars.iter().find(|bar| bar.link == link)?;
                let ends =
                    [[bar.from, bar.to], [bar.to, bar.from]].into_iter().find(|ends| ends[0] == pair)?;
                forces.push(of(Sought::Bar(link, ends))?);
            }
            _ => return None,
        }
        let sum = |i: usize| Expr::sum(forces.iter().map(|force| force[i].clone()));
        let on_pin = [sum(0), sum(1)];
        let on_slider =
            matches!(self.scene.mechanism().pair(pair).kind, PairKind::Slot(_)) && link != LinkId::GROUND;
        Some(if on_slider { on_pin } else { on_pin.map(|part| -part) })
    }
}
