//! Positions of dyads whose links hold a driven joint: at one position such a link is stiff, from its outer hinge A to the inner one C,
//! whose place in the axes of its first body is that of the driven joint.

use super::Stage;
use super::pin;
use super::rrp::Reached;
use super::triangle::Triangle;
use crate::angle::Angle;
use crate::course::{Derivation, joined};
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_model::structure::{JointKind, Structure};
use assur_position::plan::{Arm, DrivenJoint, DrivenLeg, Slide};

/// A link of one or two bodies as a stiff one, at this position.
struct Stiff {
    /// The names of its ends, the outer one first.
    ends: [String; 2],
    length: Expr,
    /// Its direction in the axes of its first body.
    own: Angle,
}

impl Derivation<'_> {
    /// Dyad RRR with driven joints inside its links.
    pub(super) fn driven_rrr(&mut self, legs: &[DrivenLeg; 2]) {
        let inner = legs.each_ref().map(|leg| self.inner_of(leg, legs));
        let stiff = [0, 1].map(|i| self.stiff(&legs[i], inner[i]));
        let [a, b] = [0, 1].map(|i| self.position(legs[i].base.body, legs[i].base.at));
        let [p, q] = [0, 1].map(|i| self.moved(legs[i].body).position(pin(&legs[i].pin)));
        let end = self.moved(inner[0].0).position(inner[0].1);
        let left = (q - p).cross(end - p) > 0.0;
        let corners = [&*stiff[0].ends[0], &*stiff[1].ends[0], &*stiff[0].ends[1]];
        let sides = [&stiff[0].length, &stiff[1].length];
        let sum = self.side_of_triangle(&Triangle { corners, outer: [&a, &b], sides, left });
        let line = self.place_stiff(&legs[0], &stiff[0], sum);
        let length = stiff[0].length.clone();
        let right = [a[0].clone() + length.clone() * line.cos(), a[1].clone() + length * line.sin()];
        let c = self.coordinates(&stiff[0].ends[1], end, right);
        let d = [c[0].clone() - b[0].clone(), c[1].clone() - b[1].clone()];
        let index = joined(&stiff[1].ends[0], &stiff[1].ends[1]);
        let delta = self.direction_of(Name::new("δ", &index), &d, &index);
        self.place_stiff(&legs[1], &stiff[1], delta);
        legs.iter().for_each(|leg| self.follow(leg));
    }

    /// Dyad RRP with a driven joint inside its link.
    pub(super) fn driven_rrp(&mut self, branch: usize, leg: &DrivenLeg, slide: &Slide, arm: Arm) {
        let end = self.hinge_with(last(leg), slide.body, pin(&arm));
        let stiff = self.stiff(leg, (last(leg), end));
        let a = self.position(leg.base.body, leg.base.at);
        let value = self.moved(last(leg)).position(end);
        let from_outer = value - self.moved(leg.body).position(pin(&leg.pin));
        let Reached { angle, guide, origin, offset } =
            self.reaches_guide(branch, (slide, pin(&arm)), &a, &stiff.length, from_outer);
        let line = self.place_stiff(leg, &stiff, angle);
        let length = stiff.length.clone();
        let right = [a[0].clone() + length.clone() * line.cos(), a[1].clone() + length * line.sin()];
        self.on_guide(&stiff.ends[1], value, right, &guide, &origin, &offset);
        self.slider(slide, pin(&arm));
        self.follow(leg);
    }

    /// The body of a leg with the inner hinge, and the place of that in its frame.
    fn inner_of(&self, leg: &DrivenLeg, legs: &[DrivenLeg; 2]) -> (usize, Vec2) {
        let bodies = legs.each_ref().map(last);
        let own = last(leg);
        let at = hinge_of(self.structure(), bodies).map(|places| places[usize::from(bodies[0] != own)]);
        (own, at.unwrap_or_else(Vec2::zero))
    }

    /// The place in the frame of a body of a hinge that is known in the frame of another.
    fn hinge_with(&self, body: usize, other: usize, at: Vec2) -> Vec2 {
        let found = self.at_hinge(other, at).into_iter().find(|(b, _)| *b == body);
        found.map_or_else(Vec2::zero, |(_, place)| place)
    }

    /// A leg as a stiff link: its length and its direction in the axes of its first body.
    fn stiff(&mut self, leg: &DrivenLeg, (body, inner): (usize, Vec2)) -> Stiff {
        let from = pin(&leg.pin);
        let ends = [self.point_name(leg.body, from), self.point_name(body, inner)];
        let index = joined(&ends[0], &ends[1]);
        let Some(joint) = &leg.joint else {
            let own = self.direction_given(inner - from, || Name::new("γ", &index));
            return Stiff { length: self.length(&ends[0], &ends[1], (inner - from).norm()), own, ends };
        };
        let labels = [leg.body, body].map(|b| vec![text(self.label(b))]);
        let [one, two] = labels;
        self.say(Message::StiffLink, &[one, two, vec![text(&*ends[1])], vec![text(&*ends[0])]]);
        let right = match joint {
            DrivenJoint::Turn { base, drive, sign, .. } => {
                let between = self.point_name(leg.body, base.at);
                let degrees = sign * self.state().motion.inputs[*drive].value.to_degrees();
                let turn = Angle::of(self.relative_part(body, leg.body, degrees));
                let first = self.arm_in_frame([&ends[0], &between], base.at - from, &Angle::ZERO);
                let hinge = self.hinge_with(body, leg.body, base.at);
                let second = self.arm_in_frame([&between, &ends[1]], inner - hinge, &turn);
                [0, 1].map(|i| first[i].clone() + second[i].clone())
            }
            DrivenJoint::Shift { slide, drive } => {
                let along = self.driven_way(slide, *drive);
                let guide = self.direction_given(slide.along, || Name::new("λ", &self.label(slide.body)));
                let to = (inner - slide.point).turned_back(slide.direction).turned(slide.along);
                let rest = self.given_in_frame(&ends[1], slide.origin - from + to);
                [rest[0].clone() + along.clone() * guide.cos(), rest[1].clone() + along * guide.sin()]
            }
        };
        let moved = self.moved(leg.body);
        let value = (self.moved(body).position(inner) - moved.position(from)).turned_back(moved.u);
        let [right_x, right_y] = right;
        let d = [
            self.component(Name::new("ξ", &ends[1]), value.x, Unit::Length, right_x),
            self.component(Name::new("η", &ends[1]), value.y, Unit::Length, right_y),
        ];
        let length = self.distance(Name::new("l", &index), &d);
        let own = Angle::of(self.direction_of(Name::new("γ", &index), &d, &index));
        Stiff { ends, length, own }
    }

    /// A vector of a body in the axes of another, against which the body is turned.
    fn arm_in_frame(&mut self, ends: [&str; 2], arm: Vec2, turn: &Angle) -> [Expr; 2] {
        let length = self.length(ends[0], ends[1], arm.norm());
        let own = self.direction_given(arm, || Name::new("γ", &joined(ends[0], ends[1])));
        let angle = turn.plus(&own);
        [length.clone() * angle.cos(), length * angle.sin()]
    }

    /// Where a point stands in the axes of a link at the coordinate 0.
    fn given_in_frame(&mut self, point: &str, at: Vec2) -> [Expr; 2] {
        let index = format!("{point},0");
        [("ξ", at.x), ("η", at.y)].map(|(letter, x)| {
            let x = if x.abs() <= self.tiny { 0.0 } else { x };
            self.given(Name::new(letter, &index), x, Unit::Length)
        })
    }

    /// The first body of a leg whose line from end to end has this direction.
    fn place_stiff(&mut self, leg: &DrivenLeg, stiff: &Stiff, direction: Expr) -> Angle {
        let index = joined(&stiff.ends[0], &stiff.ends[1]);
        self.line_and_body(leg.body, pin(&leg.pin), &stiff.own, &index, direction)
    }

    /// The body behind the driven joint of a leg.
    fn follow(&mut self, leg: &DrivenLeg) {
        match &leg.joint {
            None => {}
            Some(DrivenJoint::Shift { slide, drive }) => self.shift(Stage::Positions, slide, *drive),
            Some(DrivenJoint::Turn { base, body, pin, drive, sign, .. }) => {
                self.turn(Stage::Positions, *body, base, *pin, *drive, Some(*sign));
            }
        }
    }
}

/// The body of a leg that has the inner hinge.
fn last(leg: &DrivenLeg) -> usize {
    match &leg.joint {
        None => leg.body,
        Some(DrivenJoint::Turn { body, .. }) => *body,
        Some(DrivenJoint::Shift { slide, .. }) => slide.body,
    }
}

/// The places of a hinge of two bodies in their frames.
pub(super) fn hinge_of(structure: &Structure, bodies: [usize; 2]) -> Option<[Vec2; 2]> {
    structure.replaced.joints.iter().find_map(|joint| {
        let JointKind::Revolute(members) = &joint.kind else { return None };
        let at = |body: usize| members.iter().find(|(b, _)| b.0 == body).map(|(_, at)| *at);
        Some([at(bodies[0])?, at(bodies[1])?])
    })
}
