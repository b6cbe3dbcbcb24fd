//! The balance of a link: moments about its hinge, or forces along its guide, give the unknown effort.

use super::loads::quantity_name;
use super::sums::axes_of;
use crate::angle::Angle;
use crate::course::Derivation;
use crate::document::{Line, text};
use crate::motion::{of, pin};
use crate::words::{FrictionMessage, Message};
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_model::model::BalanceKind;
use assur_model::structure::{BodyId, EffortSource, JointId, JointKind};
use assur_position::plan::{EffortLine, Guide, Hinge};
use assur_position::position::Origin;

impl Derivation<'_> {
    /// The letters of an unknown effort.
    pub fn effort_name(&self, slot: usize, force: bool) -> Name {
        match self.structure().efforts[slot].source {
            EffortSource::Balance(id) => quantity_name(&self.scene.mechanism().balances[id.index()].name),
            EffortSource::Drive(id) => {
                let drive = &self.scene.mechanism().drives[id.index()];
                let index = match drive.target {
                    assur_model::model::DriveTarget::Link(link) => self.scene.link_label(link).to_owned(),
                    _ => drive.name.clone(),
                };
                Name::new(if force { "F" } else { "M" }, &format!("d{index}"))
            }
        }
    }

    /// Whether an effort is that of a coordinate which follows from the loads.
    pub(super) fn has_no_effort(&self, slot: usize) -> bool {
        matches!(self.structure().efforts[slot].source, EffortSource::Drive(id) if self.is_free(id.index()))
    }

    /// Where an unknown force acts, in the frame of its body, and its direction.
    pub(super) fn line_of_effort(&self, slot: usize, body: usize) -> (Vec2, Angle, Vec2) {
        let (place, along) = self.state().forces.lines[slot];
        let moved = self.moved(body);
        let at = (place - moved.p).turned_back(moved.u);
        let name = || Name::new("β", &self.effort_name(slot, true).sub);
        let turning = match self.structure().efforts[slot].source {
            EffortSource::Balance(id) => match &self.scene.mechanism().balances[id.index()].kind {
                BalanceKind::Force { along, frame: Some(frame), .. } => Some((*along, frame.index())),
                _ => None,
            },
            EffortSource::Drive(_) => None,
        };
        let angle = match turning {
            Some((own, frame)) => {
                let own = self.direction_given(own, name);
                self.bodies[frame].as_ref().map_or(own.clone(), |b| b.angle.plus(&own))
            }
            None => self.direction_given(along, name),
        };
        (at, angle, along)
    }

    /// The slider of a coordinate that an effort belongs to, its point, the guide, and the guide's angle.
    pub(super) fn guide_of_coordinate(&mut self, joint: JointId) -> Option<(BodyId, Vec2, BodyId, Angle)> {
        let JointKind::Prismatic { slider, point, guide, along, .. } =
            self.structure().replaced.joint(joint).kind.clone()
        else {
            return None;
        };
        let own = self.direction_given(along, || Name::new("λ", &self.label(slider.0)));
        let angle = self.bodies[guide.0].as_ref().map_or(own.clone(), |b| b.angle.plus(&own));
        Some((slider, point, guide, angle))
    }

    pub(super) fn balance_turn(
        &mut self,
        _index: usize,
        hinge: &Hinge,
        effort: &EffortLine,
        (slot, sign): (usize, f64),
    ) {
        let body = hinge.body;
        self.complete(body);
        let at = pin(&hinge.pin);
        let point = self.point_name(body, at);
        let label: Line = vec![text(self.label(body))];
        let is_force = matches!(effort, EffortLine::Force { .. });
        let name = self.effort_name(slot, is_force);
        let hold = self.hold_in(self.pair_of_reaction(hinge.slot));
        match &hold {
            Some(hold) => self.say(FrictionMessage::HoldTurn, &[label, vec![text(&*point)], of(hold.name())]),
            None => self.say(Message::BalanceTurn, &[label, vec![text(&*point)], of(&name)]),
        }
        let moment = self.without_hold(body, hold.as_ref(), |course| course.moment_about(body, at));
        let value = self.state().forces.efforts[slot];
        let mut pushed = [Expr::ZERO, Expr::ZERO];
        match effort {
            EffortLine::Torque { .. } if hold.is_some() => {
                hold.iter().for_each(|hold| self.found_hold(body, hold, moment.clone()));
            }
            EffortLine::Torque { .. } => {
                let right = if sign < 0.0 { moment.clone() } else { -moment.clone() };
                let begun = self.blocks.len();
                let found = self.equate_or_nothing(&name, value, Unit::Torque, right);
                let own = if sign < 0.0 { -found } else { found };
                self.balanced(begun, &Name::new("ΣM", &point), &(moment + own));
                self.effort_on_others(slot, &[body]);
            }
            EffortLine::Force { line, .. } => {
                let (place, angle, along) = self.line_of_effort(*line, body);
                let (here, there) = (self.position(body, at), self.position(body, place));
                let d = [there[0].clone() - here[0].clone(), there[1].clone() - here[1].clone()];
                let right = d[0].clone() * angle.sin() - d[1].clone() * angle.cos();
                let arm = (self.moved(body).position(place) - self.moved(body).position(at)).cross(along);
                let arm = self.component(Name::new("h", &name.sub_or_letter()), arm, Unit::Length, right);
                let whole = moment.clone() / arm.clone();
                let right = if sign < 0.0 { whole } else { -whole };
                let begun = self.blocks.len();
                let found = self.equate(name.clone(), value, Unit::Force, right);
                let on = if sign < 0.0 { -found } else { found };
                self.balanced(begun, &Name::new("ΣM", &point), &(moment + on.clone() * arm));
                pushed = [on.clone() * angle.cos(), on * angle.sin()];
            }
            EffortLine::Along(_) => {}
        }
        if hold.is_none() {
            self.sense_of_effort(&name, slot, is_force);
        }
        if self.has_open_place(hinge.slot) {
            self.say(Message::PlaceOpen, &[vec![text(point)]]);
            return;
        }
        let value = self.state().forces.reactions[hinge.slot].force;
        let right = [0, 1].map(|i| {
            let loads = Expr::sum(self.free.forces[body].iter().map(|f| f.parts[i].clone()));
            -(loads + pushed[i].clone())
        });
        if right.iter().any(|x| !x.is_zero()) {
            self.say(Message::SumOfLink, &[vec![text(self.label(body))]]);
        }
        let parts = self.reaction_in_sums([hinge.base, body], value, right, body);
        self.carry(hinge.slot, &parts, &Expr::ZERO);
    }

    pub(super) fn balance_shift(
        &mut self,
        _index: usize,
        guide: &Guide,
        effort: &EffortLine,
        (slot, sign): (usize, f64),
    ) {
        let body = guide.body;
        self.complete(body);
        let (way, d) = self.way(guide);
        let name = self.effort_name(slot, true);
        let place = self.moved(guide.slider).position(guide.point);
        let moved = self.moved(body);
        let at = (place - moved.p).turned_back(moved.u);
        let label: Line = vec![text(self.label(body))];
        let hold = self.hold_in(self.pair_of_reaction(guide.slot));
        match &hold {
            Some(hold) => self.say(FrictionMessage::HoldShift, &[label, of(hold.name())]),
            None => self.say(Message::BalanceShift, &[label, of(&name)]),
        }
        let sums = self.without_hold(body, hold.as_ref(), |course| course.sum_of(&[body]));
        let value = self.state().forces.efforts[slot];
        let signed = |x: Expr| if sign < 0.0 { -x } else { x };
        let mut across = way.across(&sums);
        match effort {
            EffortLine::Along(_) if hold.is_some() => {
                hold.iter().for_each(|hold| self.found_hold(body, hold, way.along(&sums)));
            }
            EffortLine::Along(_) => {
                let loads = way.along(&sums);
                let begun = self.blocks.len();
                let found = self.equate_or_nothing(&name, value, Unit::Force, signed(-loads.clone()));
                self.balanced(begun, &Name::new("ΣF", axes_of(&way)[0]), &(loads + signed(found)));
                self.effort_on_others(slot, &[body]);
            }
            EffortLine::Force { line, .. } => {
                let (point, angle, _) = self.line_of_effort(*line, body);
                let lean = angle.minus(&way);
                let loads = way.along(&sums);
                let right = signed(-(loads.clone() / lean.cos()));
                let begun = self.blocks.len();
                let found = self.equate(name.clone(), value, Unit::Force, right);
                let on = signed(found);
                let sum = loads + on.clone() * lean.cos();
                self.balanced(begun, &Name::new("ΣF", axes_of(&way)[0]), &sum);
                across = across + on.clone() * lean.sin();
                let parts = [on.clone() * angle.cos(), on * angle.sin()];
                let known = [Vec::new(), Vec::new()];
                let from = Some(Origin::Effort(slot));
                self.free.forces[body].push(super::Force {
                    name: name.clone(),
                    at: point,
                    parts,
                    known,
                    from,
                });
            }
            EffortLine::Torque { .. } => {}
        }
        if hold.is_none() {
            self.sense_of_effort(&name, slot, true);
        }
        self.say(Message::SumAcrossGuide, &[]);
        let (normal, couple) = self.guide_reaction(guide, -across, d, at);
        self.carry_guide(guide, &way, &normal, &couple, at);
    }

    /// Whether a reaction is in a hinge of a shaft without a place.
    fn has_open_place(&self, slot: usize) -> bool {
        let joint = self.scene.model.plan.reactions[slot].joint;
        let pair = self.structure().replaced.joint(joint).pair;
        self.unplaced[pair.index()]
    }

    /// In which sense an effort acts; a free coordinate has none, and what is zero has no sense.
    fn sense_of_effort(&mut self, name: &Name, slot: usize, force: bool) {
        let is_nothing = |found: &Expr| matches!(found, Expr::Leaf(q) if q.is_nothing());
        if self.found.get(name).is_none_or(is_nothing) && !self.has_no_effort(slot) {
            return;
        }
        let message = match (force, self.state().forces.efforts[slot] < 0.0) {
            _ if self.has_no_effort(slot) => Message::NoEffort,
            (true, true) => Message::ForceAgainstLine,
            (true, false) => Message::ForceAlongLine,
            (false, true) => Message::ActsClockwise,
            (false, false) => Message::ActsCounterClockwise,
        };
        self.say(message, &[of(name)]);
    }
}
