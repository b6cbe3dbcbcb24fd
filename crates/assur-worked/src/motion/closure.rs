//! Groups that are solved as a whole: every hinge closes with the values found, in positions, velocities and accelerations.

use super::Stage;
use crate::course::Derivation;
use crate::document::{Block, text};
use crate::system::System;
use crate::words::{Message, say};
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_model::model::{Axis, DriveTarget};
use assur_model::structure::{EffortKind, EffortSource, JointId, JointKind};

impl Derivation<'_> {
    /// The equations of a group's hinges with what is left of each.
    pub(super) fn closure(&mut self, stage: Stage, index: usize) -> Vec<(Name, Expr)> {
        let mut equations = Vec::new();
        let group = &self.structure().motion[index];
        let on_rim = group.bodies.iter().any(|b| self.structure().replaced.bodies[b.0].on_rim);
        let by_law = |joint: &&assur_model::structure::GroupJoint| {
            !self.scene.mechanism().is_by_law(self.structure().replaced.joint(joint.joint).pair)
        };
        let joints: Vec<_> = group.joints.iter().filter(by_law).copied().collect();
        if on_rim || joints.is_empty() {
            return equations;
        }
        let mut said = false;
        for joint in joints {
            let kind = self.structure().replaced.joint(joint.joint).kind.clone();
            if let JointKind::Prismatic { .. } = kind {
                for (name, unit, left) in self.slides(stage, joint.joint) {
                    if !said {
                        self.say(Message::Closes, &[]);
                        said = true;
                    }
                    self.confirm(name.clone(), 0.0, unit, left.clone());
                    equations.push((name, left));
                }
                continue;
            }
            let JointKind::Revolute(members) = &kind else { continue };
            let place = |body| members.iter().find(|(b, _)| *b == body).map(|(_, at)| *at);
            let (Some(here), Some(there)) = (place(joint.body), place(joint.base)) else { continue };
            let one = self.through(stage, joint.body.0, here);
            let two = self.through(stage, joint.base.0, there);
            let (Some(one), Some(two)) = (one, two) else { continue };
            let point = self.point_name(joint.body.0, here);
            for (axis, (a, b)) in ["x", "y"].into_iter().zip(one.into_iter().zip(two)) {
                let left = a - b;
                if left.is_zero() {
                    continue;
                }
                if !said {
                    self.say(Message::Closes, &[]);
                    said = true;
                }
                let (letter, unit) = match stage {
                    Stage::Positions => ("Δ", Unit::Length),
                    Stage::Velocities => ("Δv", Unit::Velocity),
                    Stage::Accelerations => ("Δa", Unit::Acceleration),
                };
                let name = Name::new(letter, &format!("{point}{axis}"));
                self.confirm(name.clone(), 0.0, unit, left.clone());
                equations.push((name, left));
            }
        }
        equations
    }

    /// A group whose hinges close together: velocities and accelerations are the solution of linear equations.
    pub(super) fn closing(&mut self, stage: Stage, index: usize) {
        let before = self.blocks.len();
        self.stated_motion(stage, index);
        let after = self.blocks.len();
        let mut equations = self.closure(stage, index);
        equations.extend(self.conditions(stage, index));
        let own = before..after;
        let lines = self.lines.iter().filter(|(place, _)| own.contains(place) || *place >= after);
        let unknowns: Vec<Name> = lines.map(|(_, name)| name.clone()).collect();
        if stage == Stage::Positions {
            return;
        }
        let own = self.equations.iter().filter(|(place, _)| *place >= before);
        let defined = own.map(|(_, e)| (e.left.name.clone(), e.right.clone())).collect();
        let system = System { unknowns: &unknowns, defined };
        let equations = system.kept(equations);
        if equations.is_empty() || equations.len() != unknowns.len() {
            return;
        }
        let count = vec![text(unknowns.len().to_string())];
        let mut blocks = vec![Block::Paragraph(say(self.language, Message::RatesTogether, &[count]))];
        blocks.push(Block::Table(system.table(&equations)));
        self.solutions.extend(unknowns);
        blocks.push(Block::Paragraph(say(self.language, Message::SolutionIs, &[])));
        self.insert(before, blocks);
    }

    /// What a group keeps besides its hinges and guides: laws of transmissions, drives inside it, links whose own turn is nothing.
    fn conditions(&mut self, stage: Stage, index: usize) -> Vec<(Name, Expr)> {
        let order = match stage {
            Stage::Positions => return Vec::new(),
            Stage::Velocities => 0,
            Stage::Accelerations => 1,
        };
        let (letter, unit) = [("Δω", Unit::AngularVelocity), ("Δα", Unit::AngularAcceleration)][order];
        let group = &self.structure().motion[index];
        let mut left = Vec::new();
        for law in &group.laws {
            let pair = self.structure().replaced.joint(*law).pair;
            let name = Name::new("ε", &self.scene.mechanism().pair(pair).name);
            left.push((name.marked(["", "a"][order]), Unit::One, self.law_sum(order, *law, &[])));
        }
        for &effort in &group.efforts {
            let drive = &self.structure().drives[effort];
            let EffortSource::Drive(id) = drive.source else { continue };
            let input = self.state().motion.inputs[id.index()];
            if let EffortKind::Place(body, at, axis) = drive.kind {
                let value = [input.rate, input.acceleration][order];
                left.extend(self.driven_place(stage, (body.0, at), axis, value));
                continue;
            }
            let (label, turning) = match drive.kind {
                EffortKind::Angle(body) => (self.label(body.0), self.rate_of_body(body.0, order)),
                EffortKind::RelativeAngle { first, second, .. } => (
                    format!("{},{}", self.label(second.0), self.label(first.0)),
                    self.rate_of_body(second.0, order) - self.rate_of_body(first.0, order),
                ),
                _ => continue,
            };
            let given = Name::new(["ω", "α"][order], &label).marked("∗");
            let given = self.given(given, [input.rate, input.acceleration][order], unit);
            left.push((Name::new(letter, &label).marked("∗"), unit, turning - given));
        }
        for link in &self.structure().passive {
            let body = link.index();
            if group.bodies.iter().any(|b| b.0 == body) {
                left.push((Name::new(letter, &self.label(body)), unit, self.rate_of_body(body, order)));
            }
        }
        left.retain(|(_, _, sum)| !sum.is_zero());
        for (name, unit, sum) in &left {
            self.confirm(name.clone(), 0.0, *unit, sum.clone());
        }
        left.into_iter().map(|(name, _, sum)| (name, sum)).collect()
    }

    /// A driven coordinate of a point moves as the drive says.
    fn driven_place(
        &mut self,
        stage: Stage,
        (body, at): (usize, Vec2),
        axis: Axis,
        value: f64,
    ) -> Option<(Name, Unit, Expr)> {
        let (letters, unit) = match stage {
            Stage::Positions => return None,
            Stage::Velocities => (["v", "Δv"], Unit::Velocity),
            Stage::Accelerations => (["a", "Δa"], Unit::Acceleration),
        };
        let [x, y] = self.through(stage, body, at)?;
        let point = self.point_name(body, at);
        let [given, left] = letters.map(|letter| Name::new(letter, &point).and(axis.name()).marked("∗"));
        let given = self.given(given, value, unit);
        Some((left, unit, if axis == Axis::X { x } else { y } - given))
    }

    /// A slider turns with its guide, and its point moves along it.
    fn slides(&mut self, stage: Stage, joint: JointId) -> Vec<(Name, Unit, Expr)> {
        let joint = self.structure().replaced.joint(joint);
        let pair = joint.pair;
        let JointKind::Prismatic { slider, point, guide, along, .. } = joint.kind.clone() else {
            return Vec::new();
        };
        let (order, letter, units) = match stage {
            Stage::Positions => return Vec::new(),
            Stage::Velocities => (0, "v", [Unit::Velocity, Unit::AngularVelocity]),
            Stage::Accelerations => (1, "a", [Unit::Acceleration, Unit::AngularAcceleration]),
        };
        let own = self.direction_given(along, || Name::new("λ", &self.label(slider.0)));
        let Some(base) = self.bodies[guide.0].clone() else { return Vec::new() };
        let angle = base.angle.plus(&own);
        let moved = self.moved(guide.0);
        let at = (self.moved(slider.0).position(point) - moved.p).turned_back(moved.u);
        let one = self.through(stage, slider.0, point);
        let two = self.through(stage, guide.0, at);
        let (Some([x, y]), Some([u, w])) = (one, two) else { return Vec::new() };
        let label = format!("{},{}", self.label(slider.0), self.label(guide.0));
        let (one_state, two_state) = (*self.moved(slider.0), *self.moved(guide.0));
        let d = along.turned(two_state.u);
        let v = (one_state.velocity(point) - two_state.velocity(at)).dot(d);
        // what turns with the guide is across it
        let a = (one_state.acceleration(point) - two_state.acceleration(at)).dot(d);
        let speed = |course: &mut Self, order: usize| {
            let value = [v, a][order];
            let unit = [Unit::Velocity, Unit::Acceleration][order];
            let drives = &course.scene.mechanism().drives;
            if drives.iter().any(|drive| drive.target == DriveTarget::Pair(pair)) {
                return course.given(Name::new(["v", "a"][order], &label), value, unit);
            }
            course.stated(Name::new(["v", "a"][order], &label), value, unit)
        };
        let mut along = [angle.cos(), angle.sin()].map(|c| (c, Expr::ZERO));
        if order == 1 {
            let v = speed(self, 0);
            let coriolis = Expr::Int(2) * base.rates[0].clone() * v;
            along[0].1 = -(coriolis.clone() * angle.sin());
            along[1].1 = coriolis * angle.cos();
        }
        let rate = speed(self, order);
        let [(c, more_x), (s, more_y)] = along;
        let mut rows = vec![
            (format!("{label},x"), units[0], x - u - rate.clone() * c - more_x),
            (format!("{label},y"), units[0], y - w - rate * s - more_y),
        ];
        let turning = self.bodies[slider.0].as_ref().map_or(Expr::ZERO, |b| b.rates[order].clone());
        rows.push((label, units[1], turning - base.rates[order].clone()));
        let named = |(index, unit, left): (String, Unit, Expr)| {
            let letter = if unit == units[0] { letter } else { ["ω", "α"][order] };
            (Name::new(&format!("Δ{letter}"), &index), unit, left)
        };
        rows.into_iter().filter(|row| !row.2.is_zero()).map(named).collect()
    }

    /// A point by the motion of one body alone.
    fn through(&mut self, stage: Stage, body: usize, at: Vec2) -> Option<[Expr; 2]> {
        let known = self.bodies[body].clone()?;
        if body == 0 {
            return Some(match stage {
                Stage::Positions => self.position(0, at),
                _ => [Expr::ZERO, Expr::ZERO],
            });
        }
        let d = at - known.reference;
        let from = match stage {
            Stage::Positions => self.position(body, known.reference),
            Stage::Velocities => self.velocity(body, known.reference),
            Stage::Accelerations => self.acceleration(body, known.reference),
        };
        if d.norm() <= self.tiny {
            return Some(from);
        }
        let (length, angle) = self.line_of(body, known.reference, at);
        let [x, y] = from;
        let [omega, alpha] = known.rates;
        let (along, across) = (length.clone() * angle.cos(), length * angle.sin());
        Some(match stage {
            Stage::Positions => [x + along, y + across],
            Stage::Velocities => [x - omega.clone() * across, y + omega * along],
            Stage::Accelerations => {
                let square = omega.squared();
                [
                    x - square.clone() * along.clone() - alpha.clone() * across.clone(),
                    y - square * across + alpha * along,
                ]
            }
        })
    }
}
