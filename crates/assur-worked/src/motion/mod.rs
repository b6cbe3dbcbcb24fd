//! Positions, velocities and accelerations, group by group.

mod cam;
mod cam_normal;
mod cam_turned;
mod closure;
mod cylinder;
mod driven;
mod driven_legs;
mod general;
mod geneva;
mod guide;
mod legs;
mod lift;
mod prp;
mod rpp;
mod rpr;
mod rrp;
mod rrr;
mod stated;
mod train;
mod train_places;
mod triangle;
mod whole;
mod willis;

use crate::course::{Body, Derivation};
use crate::document::{Line, Term, letter, text};
use crate::words::Message;
use assur_formula::{Expr, Name};
use assur_math::math::Vec2;
use assur_model::structure::JointKind;
use assur_position::plan::{Anchor, Arm, Leg, MotionStep};

/// Which part of motion is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    Positions,
    /// How fast they move.
    Velocities,
    Accelerations,
}

/// The place of a pin in its body's frame.
pub fn pin(arm: &Arm) -> Vec2 {
    arm.unwrap_or_else(Vec2::zero)
}

/// The inner pin of a leg.
pub fn end(leg: &Leg) -> Vec2 {
    pin(&leg.pin) + leg.direction * leg.length
}

impl Derivation<'_> {
    /// A stage of motion for all groups, in order.
    pub fn motion(&mut self, stage: Stage) {
        let plan = self.scene.model.plan;
        self.parts(stage, None);
        for (index, step) in plan.motion.iter().enumerate() {
            if self.is_alone(index) {
                continue;
            }
            self.group_heading(index);
            let derived = self.step(stage, index, step);
            self.parts(stage, Some(index));
            if stage == Stage::Positions {
                self.counts.motion[usize::from(!derived)] += 1;
            }
        }
    }

    /// The links that move with others to which they are welded, from those whose frames bodies have outwards.
    fn parts(&mut self, stage: Stage, after: Option<usize>) {
        let plan = self.scene.model.plan;
        for joint in &self.structure().replaced.joints {
            let JointKind::Weld { part, at, base, .. } = joint.kind else { continue };
            if !plan.parts.iter().any(|planned| planned.part == part.0 && planned.after == after) {
                continue;
            }
            let Some(holder) = self.bodies[base.0].clone() else { continue };
            if stage == Stage::Positions {
                let (own, other) = (self.label(part.0), self.label(base.0));
                let pair = self.scene.mechanism().pair(joint.pair).name.clone();
                self.say(Message::WeldedTo, &[vec![text(&*own)], vec![text(&*other)], vec![text(pair)]]);
                let turn = self.moved(part.0).u.turned_back(self.moved(base.0).u);
                let turn = self.direction_given(turn, || Name::new("φ", &format!("{own},{other}")));
                let angle = holder.angle.plus(&turn);
                self.bodies[part.0] = Some(Body { reference: at, angle, rates: holder.rates });
            } else {
                let [omega, alpha] = holder.rates;
                self.set_rate(part.0, 0, omega);
                self.set_rate(part.0, 1, alpha);
            }
        }
    }

    /// A heading per group where there is more than one.
    fn group_heading(&mut self, index: usize) {
        let group = &self.structure().motion[index];
        let labels: Vec<String> = group.bodies.iter().map(|b| self.label(b.0)).collect();
        let labels = labels.join(", ");
        let several = self.scene.model.plan.motion.len() > 1 || group.bodies.len() > 1;
        let message = if several && group.efforts.is_empty() { Message::GroupOf } else { Message::LinkOf };
        let line = crate::words::say(self.language, message, &[vec![text(labels)]]);
        let words = crate::course::plain(&line);
        self.heading(3, words);
    }

    /// Whether a group has no bodies of its own to write of.
    fn is_alone(&self, index: usize) -> bool {
        self.structure().motion.get(index).is_none_or(|group| group.bodies.is_empty())
    }

    fn step(&mut self, stage: Stage, index: usize, step: &MotionStep) -> bool {
        match step {
            // of another axis than that of the body: as the solver has it
            MotionStep::Turn { ahead: Some(_), .. } => {
                self.stated_motion(stage, index);
                return false;
            }
            MotionStep::Turn { body, base, pin, drive, relative, sign, .. } => {
                self.turn(stage, *body, base, *pin, *drive, relative.then_some(*sign));
            }
            MotionStep::Shift { slide, drive, .. } => self.shift(stage, slide, *drive),
            MotionStep::Free { body, at, place, turn, .. } => {
                self.free(stage, (*body, at.unwrap_or_default()), *place, *turn);
            }
            MotionStep::Rrr { legs, .. } => self.rrr(stage, legs),
            MotionStep::Rrp { branch, leg, slide, pin, .. } => self.rrp(stage, *branch, leg, slide, *pin),
            MotionStep::Rpr { branch, bases, pins, slide, .. } => {
                self.rpr(stage, *branch, bases, *pins, slide);
            }
            MotionStep::Prp { branch, slides, pins, .. } => self.prp(stage, *branch, slides, *pins),
            MotionStep::Rpp { branch, base, pin, inner, outer } => {
                self.rpp(stage, *branch, base, *pin, [inner, outer]);
            }
            MotionStep::Translation { branch, slides } => self.translation(stage, *branch, slides),
            MotionStep::Train { train, .. } => self.train(stage, index, *train),
            MotionStep::Cam { cam, .. } => {
                self.cam(stage, &self.scene.model.plan.cams[*cam]);
            }
            MotionStep::CamTurned { cam, .. } => {
                self.cam_turned(stage, &self.scene.model.plan.cams[*cam]);
            }
            MotionStep::Geneva { branch, geneva } => {
                self.geneva(stage, *branch, &self.scene.model.plan.genevas[*geneva]);
            }
            MotionStep::DrivenRrr { legs, .. } if stage == Stage::Positions => {
                if !self.on_cylinder(legs) {
                    self.driven_rrr(legs);
                }
            }
            MotionStep::DrivenRrp { branch, leg, slide, pin, .. } if stage == Stage::Positions => {
                self.driven_rrp(*branch, leg, slide, *pin);
            }
            MotionStep::Triad { .. } | MotionStep::General { .. }
                if stage == Stage::Positions && self.whole(index, step) => {}
            MotionStep::DrivenRrr { .. }
            | MotionStep::DrivenRrp { .. }
            | MotionStep::Triad { .. }
            | MotionStep::General { .. } => {
                self.closing(stage, index);
                return false;
            }
        }
        true
    }

    /// Where an anchor is.
    fn anchor(&mut self, anchor: &Anchor) -> [Expr; 2] {
        self.position(anchor.body, anchor.at)
    }

    /// A term of a vector equation.
    pub(crate) fn term(&self, sign: &'static str, name: Name, magnitude: Line, direction: Line) -> Term {
        Term { sign, name: name.arrow(), magnitude, direction }
    }

    /// The velocity or acceleration of a point as a term: what it is large.
    fn absolute(&mut self, stage: Stage, sign: &'static str, anchor: &Anchor) -> Option<Term> {
        let order = if stage == Stage::Velocities { 1 } else { 2 };
        let parts = if order == 1 {
            self.velocity(anchor.body, anchor.at)
        } else {
            self.acceleration(anchor.body, anchor.at)
        };
        if parts.iter().all(Expr::is_zero) {
            return None;
        }
        let name = Name::new(["", "v", "a"][order], &self.point_name(anchor.body, anchor.at));
        let [x, y] = parts;
        let known = self.found.contains_key(&name);
        let magnitude = if known {
            self.found.get(&name).map(crate::course::cell).unwrap_or_default()
        } else {
            let unit = if order == 1 { "m/s" } else { "m/s²" };
            let size = libm::hypot(x.value(), y.value());
            vec![text(format!("{} {unit}", assur_formula::with_digits(size, 5).text()))]
        };
        let direction = vec![text(format!("{}°", heading_of(&x, &y)))];
        Some(self.term(sign, name, magnitude, direction))
    }
}

/// The direction of a vector in degrees.
pub(crate) fn heading_of(x: &Expr, y: &Expr) -> String {
    let noise = 1e-10 * x.scale().max(y.scale());
    let clear = |v: f64| if v.abs() <= noise { 0.0 } else { v };
    let angle = libm::atan2(clear(y.value()), clear(x.value())).to_degrees();
    assur_formula::with_decimals(angle, 2).text()
}

/// ⊥ AB
pub(crate) fn across(from: &str, to: &str) -> Line {
    vec![text(format!("⊥ {}", crate::course::joined(from, to)))]
}

/// A → B
pub(crate) fn towards(from: &str, to: &str) -> Line {
    vec![text(format!("{from} → {to}"))]
}

/// ?
pub(crate) fn unknown() -> Line {
    vec![text("?")]
}

/// A product of letters as a cell.
pub(crate) fn formula(expr: &Expr) -> Line {
    vec![crate::document::Inline::Math(assur_formula::letters(expr))]
}

/// A letter in a sentence.
pub(crate) fn of(name: &Name) -> Line {
    vec![letter(name)]
}
