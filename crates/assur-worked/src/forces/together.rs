//! Groups that are solved as a whole: their equations as a matrix, the solution, equilibrium of every link with it.

use super::acting::{Couple, Force};
use super::train::scale_of;
use crate::course::Course;
use crate::document::{Block, text};
use crate::system::System;
use crate::words::{Message, say};
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_model::structure::{EffortKind, JointKind};

/// A force on a body at a place, and a couple.
struct Acts {
    body: usize,
    place: Vec2,
    parts: [Expr; 2],
    couple: Expr,
}

impl Course<'_> {
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
            if let Some(([x, y], couple)) = self.acting.stated[slot].clone() {
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
            acts.extend(self.effort_inside(slot)?);
        }
        let mut sums = Vec::new();
        for body in group.bodies.iter().map(|b| b.0) {
            let label = self.label(body);
            self.say(Message::EquilibriumOf, &[vec![text(&*label)]]);
            for (i, axis) in ["x", "y"].into_iter().enumerate() {
                let listed = self.acting.forces[body].iter().map(|f| f.parts[i].clone());
                let own = acts.iter().filter(|a| a.body == body).map(|a| a.parts[i].clone());
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
                acts.iter().filter(|a| a.body == body).map(|a| self.moment_of(a, reference)).collect();
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
        for &slot in &group.efforts {
            for acts in self.effort_inside(slot).unwrap_or_default() {
                let body = acts.body;
                if body == 0 || group.bodies.iter().any(|b| b.0 == body) {
                    continue;
                }
                let moved = self.moved(body);
                let at = (acts.place - moved.p).turned_back(moved.u);
                if !acts.parts.iter().all(Expr::is_zero) {
                    let (name, known) = (self.effort_name(slot, true), [Vec::new(), Vec::new()]);
                    let force = Force { name, at, parts: acts.parts, known, load: false, rubs: false };
                    self.acting.forces[body].push(force);
                }
                if !acts.couple.is_zero() {
                    self.acting.couples[body].push(Couple { value: acts.couple, load: false, rubs: false });
                }
            }
        }
    }

    /// The moment of a reaction about a point of its body.
    fn moment_of(&mut self, acts: &Acts, about: Vec2) -> Expr {
        let moved = self.moved(acts.body);
        let at = (acts.place - moved.p).turned_back(moved.u);
        let arm = acts.place - moved.position(about);
        let [fx, fy] = acts.parts.clone();
        let moment = if arm.norm() <= self.tiny {
            Expr::ZERO
        } else {
            let [x, y] = self.position(acts.body, at);
            let [from_x, from_y] = self.position(acts.body, about);
            let (dx, dy) = (x - from_x, y - from_y);
            dx * fy - dy * fx
        };
        moment + acts.couple.clone()
    }

    fn reactions_inside(&mut self, index: usize) -> Option<Vec<Acts>> {
        let group = &self.structure().forces[index];
        let own = |body: usize| group.bodies.iter().any(|b| b.0 == body);
        let mut acts = Vec::new();
        for joint in &group.joints {
            let same = |r: &assur_model::structure::GroupJoint| {
                r.joint == joint.joint && r.body == joint.body && r.base == joint.base
            };
            let slot = self.scene.model.plan.reactions.iter().position(same)?;
            let (parts, couple) = self.acting.stated[slot].clone()?;
            let (body, at) = match &self.structure().replaced.joint(joint.joint).kind {
                JointKind::Revolute(members) => {
                    members.iter().find(|(b, _)| *b == joint.body).map(|(b, p)| (b.0, *p))?
                }
                JointKind::Prismatic { slider, point, .. } => (slider.0, *point),
                JointKind::Law(_) => return None,
            };
            let place = self.moved(body).position(at);
            self.position(body, at);
            for (body, sign) in [(joint.body.0, 1), (joint.base.0, -1)] {
                if !own(body) {
                    continue;
                }
                let signed = |x: Expr| if sign > 0 { x } else { -x };
                let [x, y] = parts.clone();
                acts.push(Acts {
                    body,
                    place,
                    parts: [signed(x), signed(y)],
                    couple: signed(couple.clone()),
                });
            }
        }
        Some(acts)
    }

    fn effort_inside(&mut self, slot: usize) -> Option<Vec<Acts>> {
        let places: Vec<EffortKind> = self.structure().efforts[slot].places().collect();
        let mut acts = Vec::new();
        for kind in places {
            acts.extend(self.effort_at(slot, kind)?);
        }
        Some(acts)
    }

    /// What an effort does at one of its places.
    fn effort_at(&mut self, slot: usize, kind: EffortKind) -> Option<Vec<Acts>> {
        let none = [Expr::ZERO, Expr::ZERO];
        let torque = |course: &Self| course.found.get(&course.effort_name(slot, false)).cloned();
        let acts =
            |body: usize, place: Vec2, parts: [Expr; 2], couple: Expr| Acts { body, place, parts, couple };
        match kind {
            EffortKind::Angle(body) => {
                let value = torque(self)?;
                Some(vec![acts(body.0, self.moved(body.0).p, none, value)])
            }
            EffortKind::RelativeAngle { first, second, .. } => {
                let value = torque(self)?;
                let (a, b) = (self.moved(first.0).p, self.moved(second.0).p);
                Some(vec![acts(second.0, b, none.clone(), value.clone()), acts(first.0, a, none, -value)])
            }
            EffortKind::Line(body) => {
                let value = self.found.get(&self.effort_name(slot, true)).cloned()?;
                let (at, angle, _) = self.line_of_effort(slot, body.0);
                self.position(body.0, at);
                let parts = [value.clone() * angle.cos(), value * angle.sin()];
                Some(vec![acts(body.0, self.moved(body.0).position(at), parts, Expr::ZERO)])
            }
            EffortKind::Coordinate(joint) => {
                let value = self.found.get(&self.effort_name(slot, true)).cloned()?;
                let (slider, point, guide, angle) = self.guide_of_coordinate(joint)?;
                let parts = [value.clone() * angle.cos(), value * angle.sin()];
                let place = self.moved(slider.0).position(point);
                self.position(slider.0, point);
                let back = parts.clone().map(|p| -p);
                Some(vec![acts(slider.0, place, parts, Expr::ZERO), acts(guide.0, place, back, Expr::ZERO)])
            }
            EffortKind::Point(_) => None,
        }
    }
}
