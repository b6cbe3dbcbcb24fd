//! Groups whose reactions are stated, not derived.

use crate::course::Derivation;
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_model::model::Bearing;
use assur_model::structure::JointKind;

impl Derivation<'_> {
    /// The reactions of a group as the solver found them.
    pub(super) fn stated_forces(&mut self, index: usize) {
        let group = &self.structure().forces[index];
        let kind = self.group_kind(group);
        self.say(Message::ForcesStated, &[vec![text(kind)]]);
        self.values_of(index);
    }

    /// The efforts and reactions of a group as the solver found them.
    pub(super) fn values_of(&mut self, index: usize) {
        let group = &self.structure().forces[index];
        for &slot in &group.efforts {
            let force = self.is_force(slot);
            let name = self.effort_name(slot, force);
            let unit = if force { Unit::Force } else { Unit::Torque };
            self.stated(name, self.state().forces.efforts[slot], unit);
        }
        self.efforts_on_others(index);
        self.stated_reactions(index);
    }

    /// The reactions in the joints of a group as the solver found them; not of bearings whose place is open.
    pub(super) fn stated_reactions(&mut self, index: usize) {
        let group = &self.structure().forces[index];
        let plan = self.scene.model.plan;
        let forces = &self.state().forces;
        let large = forces.reactions.iter().map(|r| r.force.norm()).fold(0.0, f64::max);
        for joint in &group.joints {
            let pair = self.structure().replaced.joint(joint.joint).pair;
            if self.scene.mechanism().pair(pair).bearing == Some(Bearing::Open) {
                continue;
            }
            let found = plan
                .reactions
                .iter()
                .position(|r| r.joint == joint.joint && r.body == joint.body && r.base == joint.base);
            let Some(slot) = found else { continue };
            let reaction = self.state().forces.reactions[slot];
            let name = self.reaction_name(joint.base.0, joint.body.0);
            let parts = match self.structure().replaced.joint(joint.joint).kind {
                JointKind::Prismatic { slider, direction, .. } => {
                    self.normal_of(slider.0, direction, &name, reaction.force, large)
                }
                _ => {
                    let parts = [
                        self.stated_of(name.and("x"), reaction.force.x, Unit::Force, large),
                        self.stated_of(name.and("y"), reaction.force.y, Unit::Force, large),
                    ];
                    self.magnitude(name.clone(), &parts);
                    parts
                }
            };
            let couple = if joint.prismatic {
                self.stated_of(
                    Name::new("M", &name.sub),
                    reaction.couple,
                    Unit::Torque,
                    large * self.tiny * 1e9,
                )
            } else {
                Expr::ZERO
            };
            self.free.stated[slot] = Some((parts.clone(), couple.clone()));
            if joint.inner {
                self.free.reactions[slot] = Some(name);
            } else {
                self.carry(slot, &parts, &couple);
            }
        }
    }

    /// The normal force of a guide, and its components.
    fn normal_of(&mut self, slider: usize, along: Vec2, name: &Name, force: Vec2, large: f64) -> [Expr; 2] {
        let own = self.direction_given(along, || Name::new("λ′", &self.label(slider)));
        let angle = self.bodies[slider].as_ref().map_or(own.clone(), |b| b.angle.plus(&own));
        let d = along.turned(self.moved(slider).u);
        let normal = self.stated_of(name.clone(), d.perp().dot(force), Unit::Force, large);
        [-(normal.clone() * angle.sin()), normal * angle.cos()]
    }
}
