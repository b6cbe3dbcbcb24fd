//! Groups that are solved as a whole: their equations as a matrix, the solution, equilibrium of every link with it.

use super::train::scale_of;
use crate::course::Derivation;
use crate::document::{Block, text};
use crate::system::System;
use crate::words::{Message, say};
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_model::model::LinkId;
use assur_model::structure::{EffortKind, JointKind};
use assur_position::position::{Action, Origin};

/// What acts on a body, in letters.
#[derive(Clone)]
struct Lettered {
    action: Action,
    parts: [Expr; 2],
    couple: Expr,
    /// As the list has it, and not the opposite.
    first: bool,
}

impl Lettered {
    /// It, and what acts on the body that does it.
    fn sides(self) -> impl Iterator<Item = Self> {
        let back = self.action.opposite().map(|action| Self {
            action,
            parts: self.parts.clone().map(|part| -part),
            couple: -self.couple.clone(),
            first: false,
        });
        std::iter::once(self).chain(back)
    }
}

impl Derivation<'_> {
    /// A group that is solved as a whole: its equations of equilibrium as a matrix, the solution, and what is left of each
    /// equation. Whether it is all there.
    pub(super) fn force_together(&mut self, index: usize) -> bool {
        let before = self.blocks.len();
        self.values_of(index);
        let laws = self.laws_inside(index);
        let after = self.blocks.len();
        let group = &self.structure().forces[index];
        let sums = self.equilibrium(index);
        let Some(sums) = sums else {
            let kind = self.group_kind(group);
            let words = say(self.language, Message::ForcesStated, &[vec![text(kind)]]);
            self.insert(before, vec![Block::Paragraph(words)]);
            return false;
        };
        let check = say(self.language, Message::TogetherForces, &[]);
        self.insert(after, vec![Block::Paragraph(check)]);
        let mut unknowns = self.unknowns_inside(index);
        unknowns.extend(laws);
        let own = self.equations.iter().filter(|(place, _)| *place >= before);
        let defined = own.map(|(_, e)| (e.left.name.clone(), e.right.clone())).collect();
        let count = vec![text(sums.len().to_string())];
        let known = vec![text(unknowns.len().to_string())];
        let mut blocks =
            vec![Block::Paragraph(say(self.language, Message::EquationsTogether, &[count, known]))];
        let system = System { unknowns: &unknowns, defined };
        blocks.push(Block::Table(system.table(&sums)));
        self.solutions.extend(unknowns);
        blocks.push(Block::Paragraph(say(self.language, Message::SolutionIs, &[])));
        self.insert(before, blocks);
        true
    }

    /// The forces of the transmissions of a group, on all bodies; their letters.
    fn laws_inside(&mut self, index: usize) -> Vec<Name> {
        let mut names = Vec::new();
        for law in self.structure().forces[index].laws.clone() {
            let before = &self.structure().replaced.joints[..law.0];
            let slot = before.iter().filter(|j| matches!(j.kind, JointKind::Law(_))).count();
            let (name, unit) = self.law_name(slot);
            let scale = scale_of(self.scene.model.plan.laws[slot].force);
            let value = self.state().forces.law_forces[slot].multiplier * scale;
            let force = self.stated(name.clone(), value, unit);
            self.pass_on(slot, &force, &[]);
            names.push(name);
        }
        names
    }

    /// The unknowns of a group: efforts, then reactions.
    fn unknowns_inside(&self, index: usize) -> Vec<Name> {
        let group = &self.structure().forces[index];
        let efforts = group.efforts.iter().map(|&slot| self.effort_name(slot, self.is_force(slot)));
        let found: Vec<Expr> = efforts.filter_map(|name| self.found.get(&name).cloned()).collect();
        let plan = self.scene.model.plan;
        let slots = group.joints.iter().filter_map(|joint| {
            plan.reactions
                .iter()
                .position(|r| r.joint == joint.joint && r.body == joint.body && r.base == joint.base)
        });
        let mut all = found;
        for slot in slots {
            if let Some(([x, y], couple)) = self.free.stated[slot].clone() {
                all.extend([x, y, couple]);
            }
        }
        let mut names: Vec<Name> = Vec::new();
        for unknown in all {
            unknown.visit(&mut |q| {
                if !q.given && q.unit != Unit::Angle && !names.contains(&q.name) {
                    names.push(q.name.clone());
                }
            });
        }
        names
    }

    /// The equations of equilibrium of a group with the values found, link by link, with what is left of each.
    fn equilibrium(&mut self, index: usize) -> Option<Vec<(Name, Expr)>> {
        let group = &self.structure().forces[index];
        let mut acts = self.reactions_inside(index)?;
        for &slot in &group.efforts {
            let own = self.effort_inside(slot)?;
            // the coordinates of its places come before the sums
            for Lettered { action, .. } in own.iter().filter(|own| own.couple.is_zero() && own.first) {
                self.place_of(action.on, action.at);
            }
            acts.extend(own);
        }
        let mut sums = Vec::new();
        for body in group.bodies.iter().map(|b| b.0) {
            let label = self.label(body);
            self.say(Message::EquilibriumOf, &[vec![text(&*label)]]);
            for (i, axis) in ["x", "y"].into_iter().enumerate() {
                let listed = self.free.forces[body].iter().map(|f| f.parts[i].clone());
                let own = acts.iter().filter(|a| a.action.on == body).map(|a| a.parts[i].clone());
                let sum = Expr::sum(listed.chain(own));
                if !sum.is_zero() {
                    let name = Name::new("ΣF", &format!("{label}{axis}"));
                    self.confirm(name.clone(), 0.0, Unit::Force, sum.clone());
                    sums.push((name, sum));
                }
            }
            let reference = self.bodies[body].as_ref().map_or_else(Vec2::zero, |b| b.reference);
            let listed = self.moment_about(body, reference);
            let moments: Vec<Expr> =
                acts.iter().filter(|a| a.action.on == body).map(|a| self.moment_of(a, reference)).collect();
            let sum = Expr::sum(std::iter::once(listed).chain(moments));
            if !sum.is_zero() {
                let point = self.point_name(body, reference);
                let name = Name::new("ΣM", &format!("{label},{point}"));
                self.confirm(name.clone(), 0.0, Unit::Torque, sum.clone());
                sums.push((name, sum));
            }
        }
        Some(sums)
    }

    /// What the efforts of a group do to bodies of later groups.
    pub(super) fn efforts_on_others(&mut self, index: usize) {
        let group = &self.structure().forces[index];
        let inside: Vec<usize> = group.bodies.iter().map(|b| b.0).collect();
        group.efforts.iter().for_each(|&slot| self.effort_on_others(slot, &inside));
    }

    /// What an effort does to other bodies than these.
    pub(super) fn effort_on_others(&mut self, slot: usize, inside: &[usize]) {
        for Lettered { action, parts, couple, .. } in self.effort_inside(slot).unwrap_or_default() {
            if action.on == 0 || inside.contains(&action.on) {
                continue;
            }
            let action = Action { by: None, ..action };
            if !parts.iter().all(Expr::is_zero) {
                self.put_force(&action, &self.effort_name(slot, true), &parts, &[Vec::new(), Vec::new()]);
            }
            if !couple.is_zero() {
                self.put_couple(&action, &couple);
            }
        }
    }

    /// The moment of what acts about a point of its body.
    fn moment_of(&mut self, Lettered { action, parts, couple, .. }: &Lettered, about: Vec2) -> Expr {
        let moved = self.moved(action.on);
        let at = (action.at - moved.p).turned_back(moved.u);
        let arm = action.at - moved.position(about);
        let [fx, fy] = parts.clone();
        let moment = if arm.norm() <= self.tiny || parts.iter().all(Expr::is_zero) {
            Expr::ZERO
        } else {
            let [x, y] = self.position(action.on, at);
            let [from_x, from_y] = self.position(action.on, about);
            let (dx, dy) = (x - from_x, y - from_y);
            dx * fy - dy * fx
        };
        moment + couple.clone()
    }

    fn reactions_inside(&mut self, index: usize) -> Option<Vec<Lettered>> {
        let group = &self.structure().forces[index];
        let replaced = &self.structure().replaced;
        let own = |slot: usize| group.bodies.contains(&replaced.body_of(LinkId::at(slot)));
        let mut all = Vec::new();
        for joint in &group.joints {
            let same = |r: &assur_model::structure::GroupJoint| {
                r.joint == joint.joint && r.body == joint.body && r.base == joint.base
            };
            let slot = self.scene.model.plan.reactions.iter().position(same)?;
            let (parts, couple) = self.free.stated[slot].clone()?;
            let action = self.scene.view().actions_from(Origin::Reaction(slot)).pop()?;
            let body = match self.structure().replaced.joint(joint.joint).kind {
                JointKind::Prismatic { slider, .. } => slider.0,
                JointKind::Revolute(_) | JointKind::Weld { .. } | JointKind::Law(_) => action.on,
            };
            self.place_of(body, action.at);
            all.extend(
                Lettered { action, parts, couple, first: true }.sides().filter(|side| own(side.action.on)),
            );
        }
        Some(all)
    }

    /// The coordinates of a place of a body.
    fn place_of(&mut self, body: usize, at: Vec2) {
        let moved = self.moved(body);
        self.position(body, (at - moved.p).turned_back(moved.u));
    }

    /// What an effort does at its places; none where it is not found.
    fn effort_inside(&mut self, slot: usize) -> Option<Vec<Lettered>> {
        let places: Vec<EffortKind> = self.structure().efforts[slot].places().collect();
        let actions = self.scene.view().actions_from(Origin::Effort(slot));
        let mut all = Vec::new();
        for (kind, action) in places.iter().zip(&actions) {
            let angle = match *kind {
                EffortKind::Line(body) => Some(self.line_of_effort(slot, body.0).1),
                EffortKind::Coordinate(joint) => Some(self.guide_of_coordinate(joint)?.3),
                EffortKind::Angle(_) | EffortKind::RelativeAngle { .. } => None,
                EffortKind::Point(_) | EffortKind::Place(..) => return None,
            };
            let value = self.found.get(&self.effort_name(slot, angle.is_some())).cloned()?;
            let (parts, couple) = match angle {
                Some(angle) => ([value.clone() * angle.cos(), value * angle.sin()], Expr::ZERO),
                None => ([Expr::ZERO, Expr::ZERO], value),
            };
            all.extend(Lettered { action: *action, parts, couple, first: true }.sides());
        }
        (places.len() == actions.len()).then_some(all)
    }
}
